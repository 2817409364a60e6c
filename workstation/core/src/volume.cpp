#include "ew/core/volume.h"

#include <cmath>
#include <limits>
#include <ostream>

namespace ew {

Transform<frame::World, frame::Voxel> Grid::voxelToWorld() const {
  glm::dmat4 matrix(1.0);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] = glm::dvec4(directions[axis] * spacing_mm[axis], 0.0);
  matrix[3] = glm::dvec4(origin_mm, 1.0);
  return {matrix};
}

std::ostream& operator<<(std::ostream& out, const Grid& grid) {
  return out << grid.dims.x << " x " << grid.dims.y << " x " << grid.dims.z << " voxels of " << grid.spacing_mm.x << " x "
             << grid.spacing_mm.y << " x " << grid.spacing_mm.z << " mm at (" << grid.origin_mm.x << ", " << grid.origin_mm.y << ", "
             << grid.origin_mm.z << ") mm";
}

Grid placed(const Grid& grid, const Transform<frame::World, frame::File>& fileToWorld) {
  Grid moved = grid;
  moved.origin_mm = carried(fileToWorld, grid.origin_mm);
  moved.directions = glm::dmat3(fileToWorld.matrix) * grid.directions;
  return moved;
}

Bounds boundsOf(const Grid& grid) {
  const auto voxelToWorld = grid.voxelToWorld();
  Bounds bounds{glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity())};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 ijk((corner & 1) ? grid.dims.x - 1 : 0, (corner & 2) ? grid.dims.y - 1 : 0, (corner & 4) ? grid.dims.z - 1 : 0);
    const auto p_world = voxelToWorld * Point<frame::Voxel>{ijk};
    bounds.lowest_mm = glm::min(bounds.lowest_mm, p_world.at);
    bounds.highest_mm = glm::max(bounds.highest_mm, p_world.at);
  }
  return bounds;
}

Result<void> checkGrid(const Grid& grid) {
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] < 1)
      return failure(ErrorCode::emptyVolume, say<"The volume has no voxels along axis %1; check the file's dimensions.">(axis + 1));
    if (!(grid.spacing_mm[axis] > 0.0) || !std::isfinite(grid.spacing_mm[axis]))
      return failure(ErrorCode::badField,
                     say<"The voxel spacing along axis %1 is not a positive number; check the file's spacing.">(axis + 1));
    if (!std::isfinite(grid.origin_mm[axis]))
      return failure(ErrorCode::badField, say<"The volume's origin is not finite; check the file's offset.">());
  }
  const double voxels = static_cast<double>(grid.dims.x) * grid.dims.y * grid.dims.z;
  if (voxels > std::pow(2.0, 40))
    return failure(ErrorCode::tooLarge, say<"The volume has more voxels than can be handled; use a coarser spacing.">());
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(grid.directions[axis]);
    if (!(std::abs(length - 1.0) < 1e-3))
      return failure(ErrorCode::badField,
                     say<"The direction of axis %1 is not of unit length; check the file's orientation matrix.">(axis + 1));
  }
  if (!(std::abs(glm::determinant(grid.directions)) > 1e-3))
    return failure(ErrorCode::badField,
                   say<"The directions of the volume's axes lie in one plane; check the file's orientation matrix.">());
  return {};
}

}  // namespace ew
