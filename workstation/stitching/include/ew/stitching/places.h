#pragma once

#include <glm/glm.hpp>

#include "ew/core/volume.h"

namespace ew::stitching {

/// Inverse of a rotation and a translation, exact in the rotation.
[[nodiscard]] inline glm::dmat4 rigidInverse(const glm::dmat4& rigid) {
  const glm::dmat3 back = glm::transpose(glm::dmat3(rigid));
  glm::dmat4 inverse(back);
  inverse[3] = glm::dvec4(-(back * glm::dvec3(rigid[3])), 1.0);
  return inverse;
}

/// Where a matrix takes a point.
[[nodiscard]] inline glm::dvec3 carried(const glm::dmat4& matrix, const glm::dvec3& p) { return glm::dvec3(matrix * glm::dvec4(p, 1.0)); }

/// Centre of a grid, in its own mm.
[[nodiscard]] inline glm::dvec3 middleOf(const Grid& grid) {
  return carried(grid.voxelToWorld().matrix, 0.5 * (glm::dvec3(grid.dims) - 1.0));
}

}  // namespace ew::stitching
