#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/probe.h"

namespace ew {

/// What a probe sees of its plane: the fan down to a depth, without what steering and trapezoids add.
struct Fan {
  Probe probe;
  double depth_mm = 100.0;  ///< along the lines, from the face
  bool operator==(const Fan&) const = default;
};

/// Where a point of the image plane lies on the face: -1 at its -x end, 1 at its +x end; nothing for a point outside of the fan.
/// @param p_mm lateral and axial, in the probe's frame
[[nodiscard]] std::optional<double> placeInFan(const Fan& fan, const glm::dvec2& p_mm);

/// The voxels of one label, in blocks of at most 8 x 8 x 8 for quick questions.
class OrganVoxels {
 public:
  struct Block {
    glm::dvec3 middle_mm{0.0};  ///< world
    double radius_mm = 0.0;     ///< of the ball about it that holds the voxels' centres
    std::size_t first = 0;      ///< in centres_mm()
    std::size_t end = 0;
  };
  /// Which voxels of a block are the organ's: a bit for each, in 8 layers along k of 8 x 8, i varying fastest.
  struct BlockMask {
    glm::dvec3 corner_mm{0.0};  ///< world: the centre of its voxel (0, 0, 0)
    std::array<std::uint64_t, 8> layers{};
    std::array<std::uint16_t, 8> before{};  ///< of the organ's voxels in the layers before: they lie in centres_mm() in this order
  };

  OrganVoxels() = default;
  /// @param labels `echo` holds a label for each voxel; the grid is placed in the world
  OrganVoxels(const Volume& labels, int label) : OrganVoxels(labels, labels.grid, label) {}
  /// The same where the labels were placed elsewhere. @param placed of the labels' own dims
  OrganVoxels(const Volume& labels, const Grid& placed, int label);

  [[nodiscard]] bool empty() const { return centres_mm_.empty(); }
  [[nodiscard]] std::size_t count() const { return centres_mm_.size(); }
  /// Block by block, world.
  [[nodiscard]] const std::vector<glm::vec3>& centres_mm() const { return centres_mm_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// One for each block.
  [[nodiscard]] const std::vector<BlockMask>& masks() const { return masks_; }
  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// Mean of the voxels' centres.
  [[nodiscard]] glm::dvec3 middle_mm() const { return middle_mm_; }

 private:
  Grid grid_;
  std::vector<glm::vec3> centres_mm_;
  std::vector<Block> blocks_;
  std::vector<BlockMask> masks_;
  glm::dvec3 middle_mm_{0.0};
};

/// Distance of a point from the organ: from the nearest of its voxels as a box, 0 inside. Infinity of an empty organ.
[[nodiscard]] double distanceTo_mm(const OrganVoxels& organ, const glm::dvec3& p_world_mm);

/// What of an organ an image shows.
struct OrganSection {
  double area_mm2 = 0.0;  ///< of the organ within the fan; 0: it is not shown
  glm::dvec2 inside_mm{
      0.0};  ///< of the points well inside (3 mm from its rim, or as deep as there are) that nearest to its middle; probe x, y
};

/// The label volume is sampled at its nearest voxels, on a raster of `step_mm` over the fan.
/// @param labels as OrganVoxels has them
[[nodiscard]] OrganSection sectionOf(const Volume& labels, int label, const Fan& fan, const Pose& pose, double step_mm = 1.5);

/// The area of the whole fan on the same raster.
[[nodiscard]] double areaOf_mm2(const Fan& fan, double step_mm = 1.5);

}  // namespace ew
