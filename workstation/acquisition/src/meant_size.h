#pragma once

#include <span>

#include "clip_spans.h"
#include "ew/acquisition/reconstruct.h"

namespace ew {

/// What there is to ask about sizes that can hardly be meant, as a sentence: a pixel below 0.005 mm or above 5 mm, as of a matrix in
/// another unit than mm; an image of a hundred pixels and more that would be one or two voxels across. Empty where there is nothing to ask.
/// @param frames  with their poses, in mm; at least one
/// @param clipped the part of an image that is used
[[nodiscard]] Message questionAboutSize(std::span<const TrackedFrame> frames, const ClipRectangle& clipped, double spacing_mm);

/// What there is to ask about poses that can hardly be meant, as a sentence: three frames and more that move, but by less than half a
/// voxel, or ten large ones that stay within two voxels, as of poses in metres; three and more of which neighbours lie, in the median,
/// more than 50 voxels and more than the image apart, as of poses in micrometres. Empty where there is nothing to ask.
/// @param frames  as above, placed by a tracker
/// @param clipped as above
[[nodiscard]] Message questionAboutMovement(std::span<const TrackedFrame> frames, const ClipRectangle& clipped, double spacing_mm);

}  // namespace ew
