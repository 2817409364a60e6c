#pragma once

#include <span>

#include "ew/core/volume.h"

namespace ew {

/// What levelsAt gives where a volume shows nothing.
inline constexpr float kNothingSeen = -1.0F;

/// Echo levels at any points of a volume that may have gaps: a plane of it, a plane seen through a deformation. Linear between voxel
/// centres by the arithmetic of sliceLinear, not rounded to grey levels, on every machine the same. Unlike there a volume ends at its
/// outermost voxel centres, and absent voxels take no part: black beside the beam is no tissue. Nothing is seen where the nearest voxel is
/// absent (of two as near the one with the higher index counts), so what is covered neither grows nor shrinks. Constants are exact.
/// @param points_voxel anything, NaN included; rounding errors of 1e-6 voxel beyond the outermost centres are forgiven
/// @param level one per point: 0 .. 255, or kNothingSeen
void levelsAt(const Volume& volume, std::span<const glm::dvec3> points_voxel, std::span<float> level);

}  // namespace ew
