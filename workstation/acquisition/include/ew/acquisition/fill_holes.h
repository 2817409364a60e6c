#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

struct FillOptions {
  double reach_mm = 4.0;                 ///< longest distance between the centres of the two measured voxels a hole lies between
  int threads = 0;                       ///< 0: all cores; the voxels do not depend on it
  std::span<std::uint16_t> source = {};  ///< of every voxel, or empty: a filled one takes that of the nearer end of its shortest bridge
};
inline constexpr int kMaxFillReach_voxels = 256;  ///< along the axis of the finest spacing

struct HoleFillResult {
  Volume volume;
  std::size_t filledVoxels = 0;
};

/// Fills holes between measured voxels; measured and earlier interpolated voxels keep their values. Move the volume in and no copy is made.
/// An absent voxel is a hole when, along at least one of the 13 directions to its neighbours, the next voxels on both sides are measured
/// ones and at most `reach_mm` (Euclidean) apart. So nothing is filled outside the hull of what was measured, and nothing
/// further from it than the reach. Its echo is the mean, over those directions, of the linear interpolation between the two ends, weighted
/// with 1 / distance^12 between them, rounded once; its coverage becomes interpolated. Directions are added in a fixed order, so the voxels
/// are the same however many threads there are.
/// Cost: words of 64 voxels without a measured one are skipped, so empty space costs next to nothing.
/// @param volume with coverage (an empty coverage means that everything is measured: nothing to do)
/// @error badField (reach, or sizes that do not fit the grid), tooLarge (no memory), cancelled
[[nodiscard]] Result<HoleFillResult> fillHoles(Volume volume, const FillOptions& options, Progress& progress);

/// Whether a reach can be used on a grid.
/// @error badField (negative, not finite, more than kMaxFillReach_voxels)
[[nodiscard]] Result<void> checkFillReach(const Grid& grid, double reach_mm);

/// Bytes fillHoles needs beside the volume.
[[nodiscard]] std::uint64_t forecastFillBytes(const Grid& grid, const FillOptions& options);

}  // namespace ew
