#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "clip_spans.h"
#include "ew/acquisition/reconstruct.h"

namespace ew {

/// Where the pasted voxels go: voxelCount() values each, zero before; weights and source may be null.
struct PasteTarget {
  Grid grid;
  std::uint8_t* echo = nullptr;
  std::uint8_t* coverage = nullptr;
  float* weights = nullptr;
  std::uint16_t* source = nullptr;
};

/// Pastes every frame into the target. The grid is aligned with the world, of one spacing, and at most kMaxPasteDim voxels along each axis.
/// @return the number of measured voxels
/// @error tooLarge (no memory, or 2^28 pixels in one voxel), cancelled
[[nodiscard]] Result<std::size_t> pasteFrames(std::span<const TrackedFrame> frames, const ClipSpans& clip,
                                              const ReconstructOptions& options, const PasteTarget& target, Progress& progress);

/// Bytes of the sums of all bricks in work at a time.
[[nodiscard]] std::uint64_t pasteScratchBytes(const Grid& grid, const ReconstructOptions& options);

inline constexpr int kMaxPasteDim = 1 << 21;

}  // namespace ew
