#pragma once

#include <span>

#include "seam_survey.h"

namespace ew::stitching {

/// Labels the cells so that what the labels cost and what the seams between them cost is least together: expansion moves (Boykov, Veksler
/// and Zabih, IEEE Trans. Pattern Anal. Mach. Intell. 23(11), 2001), each the minimum cut of a box, until none lowers the cost.
/// @param forced 1 + the view a cell must take, 0 where free; or empty
/// @error cancelled
[[nodiscard]] Result<void> cutSeams(std::span<const ViewSurvey> surveys, std::span<const std::uint8_t> forced, const SeamOptions& options,
                                    SeamMap& map, Progress& progress);

}  // namespace ew::stitching
