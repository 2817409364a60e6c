#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "ew/measurement/caliper.h"

namespace ew::measurement {

/// How uncertain a point is, with the beam's directions.
struct Spread {
  glm::dvec2 place;
  glm::dvec2 pixelVariance;
  glm::dvec2 axial, lateral;  // directions, of the length of the standard deviations
};

/// Of all points of a caliper.
struct Spreads {
  std::vector<Spread> points;
  std::vector<std::size_t> ends;  // of parts
  glm::dvec2 meanWidth_mm{0.0};   // lateral and axial, as standard deviations of the point spread
  bool isOutline = false;         // neighbours are correlated
};
[[nodiscard]] Spreads spreadsOf(const Caliper& caliper, const UncertaintyAt& at);

/// Of two figures of one caliper, from their gradients.
[[nodiscard]] double covarianceWithin(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, const Spreads& spreads);
/// Of figures of two calipers of one image: points that lie on each other are one.
[[nodiscard]] double covarianceBetween(const std::vector<glm::dvec2>& a, const Spreads& ofA, const std::vector<glm::dvec2>& b,
                                       const Spreads& ofB);

}  // namespace ew::measurement
