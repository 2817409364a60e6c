#pragma once

#include <algorithm>
#include <cmath>

#include "ew/labelling/labels.h"

namespace ew::labelling {

inline VoxelBox clipped(const VoxelBox& box, const Grid& grid) {
  return {glm::clamp(box.first, glm::ivec3(0), grid.dims), glm::clamp(box.end, glm::ivec3(0), grid.dims)};
}

/// The box of voxels whose centres may lie within `reach` voxels (along each axis) of any of the points.
/// @param points_voxel at least one
inline VoxelBox boxAround(std::span<const glm::dvec3> points_voxel, const glm::dvec3& reach, const Grid& grid) {
  glm::dvec3 lowest = points_voxel.front(), highest = lowest;
  for (const glm::dvec3& p : points_voxel) {
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  // What is not finite or far outside must not overflow an integer.
  const glm::dvec3 dims(grid.dims);
  lowest = glm::clamp(lowest - reach, glm::dvec3(-1.0), dims);
  highest = glm::clamp(highest + reach, glm::dvec3(-1.0), dims);
  return clipped({glm::ivec3(glm::ceil(lowest - 1e-9)), glm::ivec3(glm::floor(highest + 1e-9)) + 1}, grid);
}

/// How many voxels a ball of a millimetre reaches along each axis of the grid.
inline glm::dvec3 voxelsPerMm(const Grid& grid) {
  const glm::dmat3 toVoxel(grid.worldToVoxel().matrix);
  const glm::dmat3 rows = glm::transpose(toVoxel);
  return {glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
}

/// Gives the brush's label to the voxels of a box for which `isIn(p_mm)` holds; p_mm is the voxel's centre.
/// @return the box of what changed
template <class IsIn>
VoxelBox put(Volume& labels, const VoxelBox& box, const Brush& brush, const IsIn& isIn) {
  VoxelBox changed;
  if (box.empty()) return changed;
  const glm::dmat4 toMm = labels.grid.voxelToWorld().matrix;
  const glm::dvec3 alongI(toMm[0]);
  for (int k = box.first.z; k < box.end.z; ++k)
    for (int j = box.first.y; j < box.end.y; ++j) {
      const glm::dvec3 rowAt(toMm * glm::dvec4(0.0, j, k, 1.0));
      std::uint8_t* row = labels.echo.data() + labels.grid.indexOf(0, j, k);
      for (int i = box.first.x; i < box.end.x; ++i) {
        if (row[i] == brush.label || (brush.over && row[i] != *brush.over)) continue;
        if (!isIn(rowAt + static_cast<double>(i) * alongI)) continue;
        row[i] = brush.label;
        changed = joined(changed, {{i, j, k}, {i + 1, j + 1, k + 1}});
      }
    }
  return changed;
}

inline double toSegment_mm(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double at = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + at * along);
}

}  // namespace ew::labelling
