#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "ew/tracking/tool_reading.h"

namespace ew::test {

/// Chance with a seed, the same on every machine (the standard's distributions are not).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  double normal(double deviation) {  // Box and Muller
    const double u = between(1e-12, 1.0), v = between(0.0, 6.283185307179586);
    return deviation * std::sqrt(-2.0 * std::log(u)) * std::cos(v);
  }
  glm::dvec3 normal3(double deviation) {
    const double x = normal(deviation), y = normal(deviation);
    return {x, y, normal(deviation)};
  }
  glm::dvec3 direction() { return glm::normalize(normal3(1.0)); }

 private:
  std::mt19937_64 engine_;
};

template <class To, class From>
Transform<To, From> anywhere(Dice& dice) {
  Transform<To, From> made{glm::mat4_cast(glm::angleAxis(dice.between(0.0, 3.1), dice.direction()))};
  made.matrix[3] = glm::dvec4(dice.between(-500.0, 500.0), dice.between(-500.0, 500.0), dice.between(-500.0, 500.0), 1.0);
  return made;
}

/// With noise of that deviation per axis.
template <class To, class From>
Transform<To, From> shaken(Transform<To, From> t, Dice& dice, double noise_mm, double noise_rad) {
  const glm::dvec3 by = dice.normal3(noise_rad);
  const double angle = glm::length(by);
  const glm::dvec4 place = t.matrix[3] + glm::dvec4(dice.normal3(noise_mm), 0.0);
  if (angle > 0.0) t.matrix = glm::mat4_cast(glm::angleAxis(angle, by / angle)) * t.matrix;
  t.matrix[3] = place;
  return t;
}

inline ToolReading readingAt(const Transform<frame::Tracker, frame::Tool>& toolToTracker, double time_s) {
  ToolReading reading;
  reading.tool = "probe";
  reading.toolToTracker = toolToTracker;
  reading.device_s = reading.arrival_s = time_s;
  return reading;
}

inline double angleBetween(const glm::dmat4& a, const glm::dmat4& b) {
  const glm::dmat3 between = glm::transpose(glm::dmat3(a)) * glm::dmat3(b);
  return std::acos(glm::clamp(0.5 * (between[0][0] + between[1][1] + between[2][2] - 1.0), -1.0, 1.0));
}

}  // namespace ew::test
