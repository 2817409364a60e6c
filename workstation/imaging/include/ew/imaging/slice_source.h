#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/imaging/layout_choice.h"

namespace ew {

class FrameStack;

/// Voxels as the slicers read them, in one layout or in both; someone else owns the memory. Images are the same from both.
struct SliceSource {
  const std::uint8_t* voxels = nullptr;
  Grid grid;
  VoxelLayout layout = VoxelLayout::linear;  ///< of `voxels`
  const std::uint8_t* bricks = nullptr;      ///< the same voxels in bricks, for the slices of `choice`; null: every slice reads `voxels`
  LayoutChoice choice;
  /// The recorded images that the voxels were made of, among these voxels: then slices read them; null: there are none.
  const FrameStack* frames = nullptr;

  SliceSource() = default;
  SliceSource(const VolumeView<const std::uint8_t>& volume) : voxels(volume.data), grid(volume.grid) {}
  [[nodiscard]] bool empty() const { return voxels == nullptr || grid.voxelCount() == 0; }
  /// In the one layout that `choice` names for such slices.
  [[nodiscard]] SliceSource inLayoutFor(const SliceClass& slice) const;
};

/// A copy of a volume in bricks, and of coarser levels for zooming out when asked for: level n halves level n - 1 by means of 2 x 2 x 2
/// voxels.
class BrickVolume {
 public:
  /// The finest level, with `grid` in place of the volume's own place in the world (same dims).
  [[nodiscard]] SliceSource source(const Grid& placed) const;
  /// The level whose voxels are as large as the largest that do not exceed `pixel_mm`; the finest when there is no such level.
  [[nodiscard]] SliceSource sourceFor(const Grid& placed, double pixel_mm) const;
  [[nodiscard]] int levels() const { return bricks_.empty() ? 0 : 1 + static_cast<int>(coarser_.size()); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  glm::ivec3 dims_{0};
  std::vector<std::uint8_t> bricks_;                ///< the finest level, in large pages
  std::vector<std::vector<std::uint8_t>> coarser_;  ///< in rows
  friend Result<BrickVolume> bricksOf(const VolumeView<const std::uint8_t>&, int levels, int threads, Progress&);
};

/// @param levels >= 1: the finest in bricks, and levels - 1 coarser ones
/// @error cancelled (within 0.1 s), tooLarge (no memory)
[[nodiscard]] Result<BrickVolume> bricksOf(const VolumeView<const std::uint8_t>& volume, int levels, int threads, Progress& progress);

/// Rows, and bricks made of them: each slice reads what `choice` says (timeLayouts makes one).
[[nodiscard]] SliceSource inBothLayouts(const VolumeView<const std::uint8_t>& rows, const BrickVolume& bricks, const LayoutChoice& choice);

/// Bytes that bricksOf holds for a volume of these dims.
[[nodiscard]] std::uint64_t bricksForecast_bytes(const glm::ivec3& dims, int levels);

}  // namespace ew
