#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "ew/measurement/caliper.h"

namespace ew::measurement::test {

inline Caliper caliper(CaliperKind kind, std::vector<glm::dvec2> points) { return {kind, {{0, std::move(points)}}}; }

/// Points at random, the same for the same seed on every machine.
class Scatter {
 public:
  explicit Scatter(std::uint64_t seed) : engine_(seed) {}
  /// From -size to size.
  double number(double size) { return size * (2.0 * static_cast<double>(engine_() >> 11U) / 9007199254740992.0 - 1.0); }
  glm::dvec2 point(double size) {
    const double x = number(size);
    return {x, number(size)};
  }
  /// Of a normal distribution (Box and Muller), which the standard library leaves to whoever wrote it.
  double normal(double deviation) {
    const double u = 0.5 * (number(1.0) + 1.0), v = number(1.0);
    return deviation * std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(3.14159265358979323846 * v);
  }

 private:
  std::mt19937_64 engine_;
};

/// An outline around a long axis, unevenly.
inline std::vector<glm::dvec2> outlineWithAxis(Scatter& scatter, double size) {
  std::vector<glm::dvec2> points{{-size, 0.1 * size}, {size * 1.05, -0.07 * size}};
  constexpr int kPoints = 23;
  for (int n = 0; n < kPoints; ++n) {
    const double t = 6.283185307179586 * n / kPoints;
    points.push_back(glm::dvec2(size * (1.1 + scatter.number(0.1)) * std::cos(t), 0.5 * size * (1.0 + scatter.number(0.1)) * std::sin(t)));
  }
  return points;
}

/// One caliper of each kind, at random.
inline std::vector<Caliper> oneOfEachKind(std::uint64_t seed) {
  Scatter scatter(seed);
  const auto points = [&](std::size_t count, double size) {
    std::vector<glm::dvec2> made;
    for (std::size_t n = 0; n < count; ++n) made.push_back(scatter.point(size));
    return made;
  };
  std::vector<glm::dvec2> round, outline;
  for (int n = 0; n < 9; ++n) {
    const double t = 6.283185307179586 * (n + scatter.number(0.2)) / 9.0;
    round.push_back(glm::dvec2(45.0 * std::cos(t), 33.0 * std::sin(t)) + scatter.point(2.0) + glm::dvec2(5.0, 80.0));
    outline.push_back((30.0 + scatter.number(6.0)) * glm::dvec2(std::cos(t), std::sin(t)));
  }
  std::vector<Caliper> all{
      caliper(CaliperKind::distance, points(2, 50.0)),
      caliper(CaliperKind::polyLine, points(6, 50.0)),
      caliper(CaliperKind::ellipse, points(4, 50.0)),
      caliper(CaliperKind::fittedEllipse, round),
      caliper(CaliperKind::trace, outline),
      caliper(CaliperKind::angle, points(3, 50.0)),
      caliper(CaliperKind::angle, points(4, 50.0)),
      {CaliperKind::ratio, {{0, points(2, 50.0)}, {0, points(2, 50.0)}}},
      {CaliperKind::ellipsoid, {{0, points(2, 50.0)}, {0, points(2, 50.0)}, {1, points(2, 50.0)}}},
      caliper(CaliperKind::discs, outlineWithAxis(scatter, 40.0)),
      caliper(CaliperKind::slope, {{scatter.number(1.0), scatter.number(50.0)}, {2.0 + scatter.number(0.5), scatter.number(50.0)}}),
      caliper(CaliperKind::interval, {{scatter.number(1.0), 9.0}, {2.0 + scatter.number(0.5), 8.0}}),
      caliper(CaliperKind::depthDistance, {{scatter.number(1.0), 9.0}, {2.0, 30.0 + scatter.number(5.0)}}),
      {CaliperKind::heartRate, {{0, {{scatter.number(1.0), 9.0}, {2.0 + scatter.number(0.5), 8.0}}}}, 3}};
  const auto first = outlineWithAxis(scatter, 40.0);
  all.push_back({CaliperKind::biplane, {{0, first}, {1, outlineWithAxis(scatter, 38.0)}}});
  return all;
}

}  // namespace ew::measurement::test
