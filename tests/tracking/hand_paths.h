#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "ew/core/frames.h"
#include "ew/tracking/tool_reading.h"

namespace ew::test {

using FacePose = Transform<frame::Tracker, frame::Probe>;

/// What a hand does with a probe, as position and rotation of its face at any time: the truth that filters are measured against.
enum class HandPath { fixed, rests, sweeps, startsAndStops, fans, turnsQuickly };

inline FacePose faceAt(const glm::dvec3& place_mm, const glm::dvec3& turn_rad) {
  const double angle = glm::length(turn_rad);
  const glm::dquat q = angle > 0.0 ? glm::angleAxis(angle, turn_rad / angle) : glm::dquat(1.0, 0.0, 0.0, 0.0);
  FacePose pose{glm::dmat4(glm::mat3_cast(q))};
  pose.matrix[3] = glm::dvec4(place_mm, 1.0);
  return pose;
}

/// Away within `length_s`, back a second later, with the least jerk, every two seconds.
inline double thereAndBack(double time_s, double length_s) {
  const double phase_s = std::fmod(time_s, 2.0);
  const double x = std::clamp(phase_s < 1.0 ? phase_s / length_s : 1.0 - (phase_s - 1.0) / length_s, 0.0, 1.0);
  return x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
}

inline FacePose onPath(HandPath path, double t) {
  constexpr double kTurn = 6.283185307179586;
  // A hand trembles by a tenth of a millimetre at 7 to 9 Hz.
  const glm::dvec3 tremor = 0.1 * glm::dvec3(std::sin(kTurn * 8.3 * t), std::sin(kTurn * 7.1 * t + 1.0), std::sin(kTurn * 9.2 * t + 2.0));
  switch (path) {
    case HandPath::fixed:
      return faceAt(glm::dvec3(0.0), glm::dvec3(0.0));
    case HandPath::rests:
      return faceAt(tremor, 0.002 * tremor);
    case HandPath::sweeps:
      return faceAt(tremor + glm::dvec3(60.0 * std::sin(kTurn * 0.25 * t), 0.0, 0.0), {0.0, 0.0, 0.3 * std::sin(kTurn * 0.2 * t)});
    case HandPath::startsAndStops: {
      const double s = thereAndBack(t, 0.6);
      return faceAt(tremor + glm::dvec3(120.0 * s, 30.0 * s, 0.0), {0.0, 0.2 * s, 0.0});
    }
    case HandPath::fans:
      return faceAt(tremor + glm::dvec3(10.0 * std::sin(kTurn * 1.5 * t), 0.0, 0.0), {0.7 * std::sin(kTurn * 1.2 * t), 0.0, 0.0});
    case HandPath::turnsQuickly:
      return faceAt(tremor, {0.0, 1.5 * thereAndBack(t, 0.25), 0.0});
  }
  return {};
}

/// White noise on a pose, the same along every axis.
class PoseNoise {
 public:
  PoseNoise(double sigma_mm, double sigma_rad, unsigned seed) : sigma_mm_(sigma_mm), sigma_rad_(sigma_rad), random_(seed) {}
  FacePose on(const FacePose& truth) {
    FacePose noisy = truth * renamed<frame::Probe, frame::Probe>(faceAt(glm::dvec3(0.0), sigma_rad_ * any()));
    noisy.matrix[3] += glm::dvec4(sigma_mm_ * any(), 0.0);
    return noisy;
  }
  glm::dvec3 any() { return {normal_(random_), normal_(random_), normal_(random_)}; }

 private:
  double sigma_mm_, sigma_rad_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

inline double apart_mm(const FacePose& a, const FacePose& b) { return glm::distance(glm::dvec3(a.matrix[3]), glm::dvec3(b.matrix[3])); }
inline double apart_rad(const FacePose& a, const FacePose& b) {
  // By the sine of half the angle: the trace has no digits left for small ones.
  double squares = 0.0;
  for (int c = 0; c < 3; ++c) squares += glm::dot(a.matrix[c] - b.matrix[c], a.matrix[c] - b.matrix[c]);
  return 2.0 * std::asin(std::min(std::sqrt(squares / 8.0), 1.0));
}

}  // namespace ew::test
