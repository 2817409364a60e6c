#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// How far two poses of a probe are from each other, as one length: sqrt(d^2 + (l a)^2), d between the middles of the faces in mm, a the
/// angle of the turn from one to the other in radians, l = 60 mm: about the depth at which one looks, so that a turn counts by how far it
/// carries what is looked at. Ours; no source states one.
[[nodiscard]] double poseDistance_mm(const Transform<frame::World, frame::Probe>& a, const Transform<frame::World, frame::Probe>& b);

struct WarpingPath {
  /// Which pose of the first goes with which of the second: from (0, 0) to the last of both, each step one further in one or both.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  double mean_mm = 0.0;  ///< of poseDistance_mm over the pairs
  /// The place in the second that goes with place `n` of the first: the middle of those that go with it.
  [[nodiscard]] double inSecond(std::size_t n) const;
};

/// Puts two scans on one clock: the pairs whose distances sum to the least (dynamic time warping; Sakoe & Chiba, IEEE Trans. ASSP 26:43,
/// 1978, symmetric with weight 2 on the diagonal, so that a detour does not pay). One byte for each pair of poses.
/// @param first, second poses that are `ok`
/// @param mostBytes of the table
/// @error badUsage (one is empty), tooLarge (with how many bytes it takes), cancelled (within 0.5 s)
[[nodiscard]] Result<WarpingPath> warpTime(std::span<const Pose> first, std::span<const Pose> second, Progress& progress = noProgress(),
                                           std::uint64_t mostBytes = 1ull << 30);

}  // namespace ew
