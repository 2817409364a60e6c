#pragma once

#include <optional>
#include <span>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/beams.h"

namespace ew {

// What the frames of a sweep say about themselves: how fine a volume they carry, how far their holes reach, which way their beams go.

/// How far the middles of successive frames lie apart, in the middle of the sweep (the median); 0 for fewer than two frames.
[[nodiscard]] double frameDistance_mm(std::span<const TrackedFrame> frames);

/// The voxel that the frames carry: max(2 pixels, 0.6 of their distance), within 0.3 to 1 mm, rounded to 0.05 mm so that a name for it is
/// short; 1 mm without a frame. Finer voxels would mostly be holes or copies of one another.
[[nodiscard]] double carriedSpacing_mm(std::span<const TrackedFrame> frames);

/// How far apart measured voxels may lie for what is between them to be a hole of the sweep and not the outside of it:
/// max(3 voxels, 2.5 times the distance of the frames), which bridges a frame that is missing.
[[nodiscard]] double usualFillReach_mm(std::span<const TrackedFrame> frames, double spacing_mm);

/// The beams of all frames together: their columns, or with a fan all that leave its apex, whose way is given by the pair of its places
/// that lie farthest apart, found from the first. Empty when the frames look in all directions.
/// @param frames at least one
[[nodiscard]] std::optional<Beams> beamsOf(std::span<const TrackedFrame> frames, const Clip& clip);

}  // namespace ew
