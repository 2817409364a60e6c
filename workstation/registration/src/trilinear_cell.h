#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>

#include "ew/core/volume.h"

namespace ew::registration {

/// The eight voxels about a place of a grid.
struct TrilinearCell {
  glm::ivec3 low{0};
  glm::dvec3 share{0.0};  ///< of the way from `low` to the next voxel

  /// Calls visit(index of the voxel, its part of the whole) for each that counts, until one returns false. @return whether none did
  template <class Visit>
  bool visit(const Grid& grid, const Visit& visit) const {
    for (int n = 0; n < 8; ++n) {
      double part = 1.0;
      glm::ivec3 corner = low;
      for (int axis = 0; axis < 3; ++axis) {
        const bool high = (n >> axis & 1) != 0;
        part *= high ? share[axis] : 1.0 - share[axis];
        corner[axis] += high ? 1 : 0;
      }
      if (part >= 1e-9 && !visit(grid.indexOf(corner.x, corner.y, corner.z), part)) return false;
    }
    return true;
  }
};

/// The cell about a place in voxels; none outside of the grid.
inline std::optional<TrilinearCell> cellAt(const Grid& grid, const glm::dvec3& voxel) {
  TrilinearCell cell;
  for (int axis = 0; axis < 3; ++axis) {
    // A single layer of voxels is as thick as it says; otherwise the volume ends at its last centres.
    const double slack = grid.dims[axis] == 1 ? 0.5 : 1e-6;
    if (!(voxel[axis] >= -slack) || !(voxel[axis] <= grid.dims[axis] - 1 + slack)) return std::nullopt;
    const double held = std::clamp(voxel[axis], 0.0, static_cast<double>(grid.dims[axis] - 1));
    cell.low[axis] = std::min(static_cast<int>(held), std::max(grid.dims[axis] - 2, 0));
    cell.share[axis] = held - cell.low[axis];
  }
  return cell;
}

}  // namespace ew::registration
