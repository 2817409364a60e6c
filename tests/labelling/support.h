#pragma once

#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <vector>

#include "ew/labelling/labels.h"

namespace ew::labelling::test {

inline constexpr double kPi = std::numbers::pi;

/// Nothing is labelled yet; the grid lies askew in the world when `axis` and `angle_rad` say so.
inline Volume emptyLabels(const glm::ivec3& dims, const glm::dvec3& spacing_mm, double angle_rad = 0.0,
                          const glm::dvec3& axis = {0.3, -0.5, 0.8}) {
  Volume labels;
  labels.grid.dims = dims;
  labels.grid.spacing_mm = spacing_mm;
  labels.grid.directions = glm::dmat3(glm::rotate(glm::dmat4(1.0), angle_rad, glm::normalize(axis)));
  labels.grid.origin_mm = labels.grid.directions * (-0.5 * (glm::dvec3(dims) - 1.0) * spacing_mm);
  labels.echo.assign(labels.grid.voxelCount(), 0);
  return labels;
}

inline Transform<frame::File, frame::Probe> planeAt(const glm::dvec3& at_mm, double angle_rad = 0.0,
                                                    const glm::dvec3& axis = {0.0, 0.0, 1.0}) {
  return {glm::rotate(glm::translate(glm::dmat4(1.0), at_mm), angle_rad, axis)};
}

/// Points of a circle. @param corners of the polygon
inline std::vector<glm::dvec2> circle(double radius_mm, int corners = 90, const glm::dvec2& middle_mm = glm::dvec2(0.0)) {
  std::vector<glm::dvec2> points;
  for (int n = 0; n < corners; ++n) {
    const double at = 2.0 * std::numbers::pi * n / corners;
    points.push_back(middle_mm + radius_mm * glm::dvec2(std::cos(at), std::sin(at)));
  }
  return points;
}

/// Twice what both have, of what they have together: 1 when they are the same.
inline double dice(const Volume& a, std::uint8_t labelOfA, const std::vector<std::uint8_t>& b, std::uint8_t labelOfB) {
  std::size_t both = 0, all = 0;
  for (std::size_t n = 0; n < a.echo.size(); ++n) {
    const bool inA = a.echo[n] == labelOfA, inB = b[n] == labelOfB;
    both += inA && inB ? 1 : 0;
    all += (inA ? 1u : 0u) + (inB ? 1u : 0u);
  }
  return all == 0 ? 1.0 : 2.0 * static_cast<double>(both) / static_cast<double>(all);
}

}  // namespace ew::labelling::test
