#pragma once

#include <cstdint>
#include <vector>

#include "chain/chain_run.h"

namespace ew::stitching {

/// What is registered elastically of two views: their overlap and so much around it, for motions and for windows of local means.
inline constexpr double kAroundOverlap_mm = 20.0;

/// How many pairs are registered beside each other, and what they take then: as many as there are threads and room.
struct Beside {
  int pairs = 1;
  std::uint64_t bytes = 0;
};
/// @param each what each pair takes
[[nodiscard]] Beside besideEachOther_bytes(const ChainRun& run, std::vector<std::uint64_t> each);

/// Of bending a pair: its parts of both views, and registering these.
[[nodiscard]] std::uint64_t warpBytes(const Grid& fixed, const Grid& moving, const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                                      const registration::ElasticOptions& options);

/// At the peak of a step, with all inputs in memory: by what is known so far about grids and poses.
[[nodiscard]] std::uint64_t peakOf(const ChainRun& run, Step step);

/// Notes what a step is going to take. @error tooLarge (more than ChainOptions::maxBytes)
[[nodiscard]] Result<void> checkMemory(ChainRun& run, Step step);

}  // namespace ew::stitching
