#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/surface_mesh.h"
#include "ew/core/volume.h"

namespace ew {

/// The implicit body of a mannequin recipe (resources/mannequin/*.json): ellipsoids, tapered capsules, tubes and lofts through
/// cross-sections, blended smoothly in the recipe's order. Symmetric in x; safe to ask from several threads at once.
class BodyShape {
 public:
  virtual ~BodyShape();
  /// Signed distance in mm, negative inside. The sign is exact; the value is first order: right near the surface, an estimate far off.
  [[nodiscard]] virtual double signedDistance_mm(const glm::dvec3& p_world_mm) const = 0;
  /// A box that holds the whole body.
  [[nodiscard]] virtual Bounds bounds() const = 0;
};

/// @error notFound, notReadable, tooLarge (above 8 MiB), badHeader (not JSON), badField (place, value found, value expected), newerFormat
[[nodiscard]] Result<std::unique_ptr<BodyShape>> readBodyShape(const std::filesystem::path& recipe);

/// Unit outward normal of the body at a point on or near its surface, by central differences over 2 x `step_mm`.
[[nodiscard]] glm::dvec3 outwardNormal(const BodyShape& body, const glm::dvec3& p_world_mm, double step_mm = 0.5);

/// Fills `distances_mm` (grid.voxelCount() floats, i fastest) with the signed distance at the grid's voxel centres. Blocks of 4 x 4 x 4
/// voxels that are certainly away from the surface get the distance at their centre instead (its sign holds for every voxel of the block),
/// so a contour at 0 is the same as with every voxel asked. The result does not depend on `threads` (0: one per processor).
/// @error cancelled (within 0.1 s), tooLarge (no memory for the grid), as checkGrid
[[nodiscard]] Result<void> sampleDistance(const BodyShape& body, const Grid& grid, std::vector<float>& distances_mm, int threads,
                                          Progress& progress);

}  // namespace ew
