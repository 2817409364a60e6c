#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "pose_filter_parts.h"

namespace ew::tracking {

namespace {

// As the authors advise: the lowest cut-off so that a still hand does not jitter, then the slope so that a fast one does not lag.
constexpr double kLowest_hz = 1.5;
constexpr double kSpeedCutoff_hz = 2.0;
constexpr double kSlopePerMm = 0.4;    ///< Hz for each mm/s
constexpr double kSlopePerRad = 20.0;  ///< Hz for each rad/s

/// Share of the new value in a low pass of first order.
double lowPassShare(double cutoff_hz, double dt_s) {
  const double r = glm::two_pi<double>() * cutoff_hz * dt_s;
  return r / (1.0 + r);
}

}  // namespace

void OneEuroPose::begin(const PlaceAndTurn& reading) {
  now_ = reading_ = reading;
  speed_ = turning_ = glm::dvec3(0.0);
  placeShare_ = turnShare_ = 1.0;
  period_s_ = 0.0;
}

void OneEuroPose::update(const PlaceAndTurn& reading, double dt_s) {
  // Speeds from intervals of microseconds are noise: the low pass then takes a share of next to nothing of them.
  constexpr double kShortest_s = 1e-6;
  const double dt = std::max(dt_s, kShortest_s);
  const double speedShare = lowPassShare(kSpeedCutoff_hz, dt);
  speed_ += speedShare * ((reading.place_mm - reading_.place_mm) / dt - speed_);
  turning_ += speedShare * (logOf(glm::conjugate(reading_.turn) * reading.turn) / dt - turning_);
  reading_ = reading;
  placeShare_ = lowPassShare(kLowest_hz + kSlopePerMm * glm::length(speed_), dt);
  turnShare_ = lowPassShare(kLowest_hz + kSlopePerRad * glm::length(turning_), dt);
  period_s_ = dt;
  now_ = {glm::mix(now_.place_mm, reading.place_mm, placeShare_), between(now_, reading, turnShare_).turn};
}

}  // namespace ew::tracking
