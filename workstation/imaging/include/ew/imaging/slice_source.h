#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// How voxels lie in memory: i, j, k after one another, or in bricks that each fill one line of the cache
/// (timeLayouts tells which is faster; resources/decisions/0013 and 0030 have the figures).
enum class VoxelLayout { linear, bricked };

/// Voxels as the slicers read them; someone else owns the memory.
struct SliceSource {
  const std::uint8_t* voxels = nullptr;
  Grid grid;
  VoxelLayout layout = VoxelLayout::linear;

  SliceSource() = default;
  SliceSource(const VolumeView<const std::uint8_t>& volume) : voxels(volume.data), grid(volume.grid) {}
  [[nodiscard]] bool empty() const { return voxels == nullptr || grid.voxelCount() == 0; }
};

/// A copy of a volume in bricks, and of coarser levels for zooming out when asked for: level n halves level n - 1 by means of 2 x 2 x 2
/// voxels.
class BrickedVolume {
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
  friend Result<BrickedVolume> bricksOf(const VolumeView<const std::uint8_t>&, int levels, int threads, Progress&);
};

/// @param levels >= 1: the finest in bricks, and levels - 1 coarser ones
/// @error cancelled (within 0.1 s), tooLarge (no memory)
[[nodiscard]] Result<BrickedVolume> bricksOf(const VolumeView<const std::uint8_t>& volume, int levels, int threads, Progress& progress);

/// Bytes that bricksOf holds for a volume of these dims.
[[nodiscard]] std::uint64_t bricksForecast_bytes(const glm::ivec3& dims, int levels);

}  // namespace ew
