#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/volume.h"
#include "ew/registration/verdict.h"

namespace ew::stitching {

/// A box of voxels: from `begin` to before `end`.
struct VoxelBox {
  glm::ivec3 begin{0};
  glm::ivec3 end{0};
  [[nodiscard]] glm::ivec3 size() const { return end - begin; }
  bool operator==(const VoxelBox&) const = default;
};

/// What two volumes both cover at a transform, looked for at places about 3 mm apart.
struct Overlap {
  glm::dvec3 centre_mm{0.0};  ///< its middle, in the fixed frame
  VoxelBox fixed;             ///< the least boxes of voxels around it
  VoxelBox moving;
};
/// @param fixedToMoving rigid
/// @return nothing when they do not meet
[[nodiscard]] std::optional<Overlap> overlapOf(const Volume& fixed, const Volume& moving,
                                               const Transform<frame::Moving, frame::Fixed>& fixedToMoving);

/// A box widened by so much on all sides, inside the grid.
[[nodiscard]] VoxelBox widened(const VoxelBox& box, const Grid& grid, double by_mm);

/// Boxes that hold what the boxes of two grids share at a transform, widened: never smaller than what overlapOf finds, known without
/// voxels.
/// @return empty boxes (size 0) when they do not meet
[[nodiscard]] std::pair<VoxelBox, VoxelBox> sharedBoxes(const Grid& fixed, const Grid& moving,
                                                        const Transform<frame::Moving, frame::Fixed>& fixedToMoving, double by_mm);

/// Whether two boxes at their places meet when each is `margin_mm` larger: by the separating axes of their faces and edges.
[[nodiscard]] bool boxesMeet(const Grid& a, const Grid& b, double margin_mm);

/// The grid of a box of voxels: each keeps its place.
[[nodiscard]] Grid gridOf(const Grid& grid, const VoxelBox& box);

/// A part of a view with its own voxels. What input() gives lives as long as this.
struct PartOfView {
  Volume volume;
  std::vector<float> confidence;  ///< 0..1; empty: 1 wherever covered
  std::optional<Beams> beams;
  [[nodiscard]] registration::Input input() const { return {&volume, confidence, beams}; }
};
struct ViewData;
[[nodiscard]] PartOfView partOf(const ViewData& view, const VoxelBox& box);

}  // namespace ew::stitching
