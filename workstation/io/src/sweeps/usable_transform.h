#pragma once

#include "ew/io/sequence.h"

namespace ew::detail {

/// Whether a matrix can be part of a chain, whatever its status says: finite, affine, and neither flat nor zero.
[[nodiscard]] bool isUsable(const FrameTransform& transform);

/// What is wrong with a matrix that is not usable, as in "its last row is 1 2 3 1 instead of 0 0 0 1"; empty of one that is.
[[nodiscard]] Message problemOf(const FrameTransform& transform);

/// Of flat images people write 0 in the third column. Where that is all that is wrong with the way from "Image", it is given the thickness
/// of a pixel at right angles to the image, which no pixel of it is moved by.
/// @return whether it was
bool giveThickness(FrameTransform& transform);

}  // namespace ew::detail
