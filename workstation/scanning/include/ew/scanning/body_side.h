#pragma once

#include <optional>

#include "ew/core/pose.h"

namespace ew {

/// Of the patient, not of whoever looks.
enum class BodySide { right, left };

/// The patient's side on which an image lies: that of the middle of its fan. The midline is x = 0 of the world, as for mannequins and body
/// marks.
/// @param depth_mm of the image
/// @return nothing within `near_mm` of the midline, where an image shows both sides, and for a pose that is no place
[[nodiscard]] std::optional<BodySide> bodySideOf(const Pose& pose, double depth_mm, double near_mm = 8.0);

}  // namespace ew
