#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew::labelling {

/// Voxels from `first` to before `end`.
struct VoxelBox {
  glm::ivec3 first{0};
  glm::ivec3 end{0};
  [[nodiscard]] bool empty() const { return glm::any(glm::greaterThanEqual(first, end)); }
  bool operator==(const VoxelBox&) const = default;
};
/// The smallest box around both; an empty one adds nothing.
[[nodiscard]] VoxelBox joined(const VoxelBox& a, const VoxelBox& b);

/// What becomes of the voxels that an edit meets.
struct Brush {
  std::uint8_t label = 1;                 ///< that they get; 0 erases
  std::optional<std::uint8_t> over = {};  ///< only voxels with this label are changed; empty: all
  bool operator==(const Brush&) const = default;
};

// Labels are a Volume whose `echo` holds a number per voxel, 0 for none, on a grid in the frame of the case's file (before it is placed).
// A voxel belongs to a shape when its centre does; shapes beyond the grid are cut off there. Every edit returns the box outside of which
// nothing changed.

/// A grid for labels of a volume that has none: along the axes of the volume and around all its voxels, isotropic, as fine as the finest
/// spacing of the volume or as `mostVoxels` allow.
[[nodiscard]] Grid labelGridFor(const Grid& volume, std::size_t mostVoxels = std::size_t{12} << 20);

/// A ball drawn along a path: all voxels within radius_mm of the line through `path`; one point gives the ball alone.
/// @param path at least one point; mm of the file. @param radius_mm >= 0
VoxelBox paintBall(Volume& labels, std::span<const glm::dvec3> path, double radius_mm, const Brush& brush);

/// A disc drawn along a path in an image plane: within radius_mm of the path in the plane and within halfThickness_mm of the plane.
/// @param planeToFile rigid; x and y span the plane. @param path at least one point of the plane, mm
VoxelBox paintDisc(Volume& labels, const Transform<frame::File, frame::Probe>& planeToFile, std::span<const glm::dvec2> path,
                   double radius_mm, double halfThickness_mm, const Brush& brush);

/// The inside of a closed contour (even-odd rule) within halfThickness_mm of its plane, bounds included.
/// @param contour points of the plane, mm; the last is joined to the first. Fewer than three fill nothing
VoxelBox fillContour(Volume& labels, const Transform<frame::File, frame::Probe>& planeToFile, std::span<const glm::dvec2> contour,
                     double halfThickness_mm, const Brush& brush);

/// The least half thickness for which every point of a plane of any direction has a voxel within it: half the diagonal of a voxel.
[[nodiscard]] double thinnestHalf_mm(const Grid& grid);

/// How many voxels have a label, and how much they hold.
[[nodiscard]] std::size_t voxelsOf(const Volume& labels, std::uint8_t label);
[[nodiscard]] double volume_ml(const Volume& labels, std::uint8_t label);
/// Around all voxels of a label; empty when there are none.
[[nodiscard]] VoxelBox boxOf(const Volume& labels, std::uint8_t label);

/// Of several pieces of a label (neighbours share a face) the largest stays, the others become 0. Of equal ones the first in memory stays.
/// @error cancelled; then nothing changed
[[nodiscard]] Result<VoxelBox> keepLargest(Volume& labels, std::uint8_t label, Progress& progress);

/// Rounds a label off: where the label, averaged by a Gaussian of sigma_mm, is above one half, it is; elsewhere it is not. It grows into
/// voxels without a label alone, never over others. @param sigma_mm > 0. @error cancelled; then nothing changed
[[nodiscard]] Result<VoxelBox> smooth(Volume& labels, std::uint8_t label, double sigma_mm, Progress& progress);

}  // namespace ew::labelling
