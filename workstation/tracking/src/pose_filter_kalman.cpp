#include <algorithm>

#include "pose_filter_parts.h"

namespace ew::tracking {

namespace {

// Found by the simulated paths of tests/tracking/filter_test.cpp; resources/docs/technician/trackers.md has the figures. A hand that holds
// a probe still trembles by a tenth of a millimetre at about 8 Hz; one that fans it quickly turns at 5 rad/s and stops within a tenth of a
// second.
constexpr ConstantVelocity::Limits kPlaceLimits{.calm = 1.0, .wild = 4e5, .rate = 300.0, .fastest = 5e4, .near = 5.0};
constexpr ConstantVelocity::Limits kTurnLimits{.calm = 5e-4, .wild = 2e2, .rate = 3.0, .fastest = 1500.0, .near = 0.09};

}  // namespace

void ConstantVelocity::begin(double noise) {
  vv = noise * noise;
  vr = 0.0;
  rr = limits.rate * limits.rate;
  power = limits.calm;
  surprise = 1.0;
}

void ConstantVelocity::predict(double dt_s) {
  vv += dt_s * (2.0 * vr + dt_s * (rr + power * dt_s / 3.0));
  vr += dt_s * (rr + 0.5 * power * dt_s);
  rr = rr + power * dt_s;
  // No hand is that fast: without the bound a tracker of few readings would trust any of them.
  const double most = limits.rate * limits.rate * 25.0;
  if (rr > most) {
    const double share = most / rr;
    rr = most;
    vr *= share;
  }
}

double ConstantVelocity::gate(double noise, double dt_s) const {
  constexpr double kSigmas = 8.0;
  return std::max(limits.near, kSigmas * std::sqrt(vv + noise * noise)) + 0.5 * limits.fastest * dt_s * dt_s;
}

ConstantVelocity::Gain ConstantVelocity::update(double innovation, double noise, double dt_s) {
  const double expected = vv + noise * noise;
  const Gain gain{vv / expected, vr / expected};
  // Joseph's form in two dimensions: stays positive whatever the rounding.
  const double keep = 1.0 - gain.value;
  const double noise2 = noise * noise;
  const double vvAfter = keep * keep * vv + gain.value * gain.value * noise2;
  const double vrAfter = keep * (vr - gain.rate * vv) + gain.value * gain.rate * noise2;
  rr = std::max(rr - 2.0 * gain.rate * vr + gain.rate * gain.rate * vv + gain.rate * gain.rate * noise2, 0.0);
  vv = vvAfter;
  vr = vrAfter;

  // Innovations beyond what they should be say that the motion is not as steady as thought. One large one is enough, since a turn must not
  // be followed late; back to calm it goes slowly enough to last from the start of a slide to its end.
  const double ratio = innovation * innovation / (3.0 * expected);
  surprise += 0.25 * (ratio - surprise);
  if (ratio > 6.0)
    power *= 16.0;
  else if (surprise > 1.8)
    power *= 2.0;
  else if (surprise < 1.4)
    power *= std::exp(-dt_s / 0.15);
  power = std::clamp(power, limits.calm, limits.wild);
  return gain;
}

KalmanPose::KalmanPose() {
  place_.limits = kPlaceLimits;
  rotation_.limits = kTurnLimits;
}

void KalmanPose::begin(const PlaceAndTurn& reading, double noise_mm, double noise_rad) {
  now_ = reading;
  speed_ = turning_ = glm::dvec3(0.0);
  place_.begin(noise_mm);
  rotation_.begin(noise_rad);
}

PlaceAndTurn carriedOn(const PlaceAndTurn& p, const glm::dvec3& speed, const glm::dvec3& turning, double dt_s) {
  return {p.place_mm + dt_s * speed, glm::normalize(p.turn * expOf(dt_s * turning))};
}

void KalmanPose::predict(double dt_s) {
  now_ = carriedOn(now_, speed_, turning_, dt_s);
  place_.predict(dt_s);
  rotation_.predict(dt_s);
}

bool KalmanPose::accepts(const PlaceAndTurn& reading, double noise_mm, double noise_rad, double dt_s) const {
  return glm::distance(reading.place_mm, now_.place_mm) <= place_.gate(noise_mm, dt_s) &&
         glm::length(logOf(glm::conjugate(now_.turn) * reading.turn)) <= rotation_.gate(noise_rad, dt_s);
}

void KalmanPose::update(const PlaceAndTurn& reading, double noise_mm, double noise_rad, double dt_s) {
  const glm::dvec3 off_mm = reading.place_mm - now_.place_mm;
  const auto place = place_.update(glm::length(off_mm), noise_mm, dt_s);
  now_.place_mm += place.value * off_mm;
  speed_ += place.rate * off_mm;
  const glm::dvec3 off_rad = logOf(glm::conjugate(now_.turn) * reading.turn);
  const auto rotation = rotation_.update(glm::length(off_rad), noise_rad, dt_s);
  now_.turn = glm::normalize(now_.turn * expOf(rotation.value * off_rad));
  turning_ += rotation.rate * off_rad;
}

}  // namespace ew::tracking
