#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "clip_spans.h"
#include "ew/acquisition/reconstruct.h"

namespace ew {

/// The voxels to work on: voxelCount() values each; `source` may be null.
struct SweepTarget {
  Grid grid;
  std::uint8_t* echo = nullptr;
  std::uint8_t* coverage = nullptr;
  std::uint16_t* source = nullptr;
};

/// Fills absent voxels between successive frames, as ReconstructOptions::fillMethod says for `sweep`.
/// The grid is aligned with the world.
/// @return the number of voxels filled
/// @error tooLarge (no memory), cancelled
[[nodiscard]] Result<std::size_t> fillBetweenFrames(std::span<const TrackedFrame> frames, const ClipSpans& clip,
                                                    const ReconstructOptions& options, const SweepTarget& target, Progress& progress);

/// Gives every measured voxel what the frames that pass through it show at its centre, as Interpolation::centred says.
/// @error tooLarge (no memory), cancelled
[[nodiscard]] Result<void> centreMeasured(std::span<const TrackedFrame> frames, const ClipSpans& clip, const ReconstructOptions& options,
                                          const SweepTarget& target, Progress& progress);

/// Bytes either of them needs beside the volume.
[[nodiscard]] std::uint64_t forecastSweepBytes(const Grid& grid, const ReconstructOptions& options);

}  // namespace ew
