#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <string>
#include <vector>

#include "ew/registration/landmarks.h"

namespace ew::registration::test {

inline Transform<frame::Moving, frame::Fixed> rigid(double angle_rad, const glm::dvec3& axis, const glm::dvec3& shift_mm) {
  return {glm::rotate(glm::translate(glm::dmat4(1.0), shift_mm), angle_rad, glm::normalize(axis))};
}

/// Pairs named p0, p1 … whose places are moved exactly.
inline std::vector<LandmarkPair> pairsOf(const std::vector<glm::dvec3>& fixed,
                                         const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
  std::vector<LandmarkPair> pairs;
  for (const glm::dvec3& p : fixed) pairs.push_back({"p" + std::to_string(pairs.size()), p, carried(fixedToMoving, p)});
  return pairs;
}

/// Places scattered in a box of 100 mm.
inline std::vector<glm::dvec3> scattered(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 draw(seed);
  std::uniform_real_distribution<double> side(-50.0, 50.0);
  std::vector<glm::dvec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = side(draw);
    const double y = side(draw);
    places.emplace_back(x, y, side(draw));
  }
  return places;
}

inline double worst(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b,
                    const std::vector<glm::dvec3>& places) {
  double most = 0.0;
  for (const auto& p : places) most = std::max(most, glm::length(carried(a, p) - carried(b, p)));
  return most;
}

}  // namespace ew::registration::test
