#pragma once

#include <span>

#include "seam_survey.h"

namespace ew::stitching {

/// What is added to each view's grey levels so that they pass over to those of its neighbours within levelBlend_mm of a seam. Speckle is
/// blended over a few mm, lest it be averaged; differences of level (a shadow of one view, a gain that no depth curve explains) need a
/// longer way not to show. Near a seam the level becomes the mean of the views' local means, each weighted by how much of the surroundings
/// it is shown in, how far inside its own border it is, and how far it is trusted. Who is not trusted still counts where the trusted view
/// is about to end: its shadow then begins softly. Source: the two bands of Burt and Adelson, ACM Trans. Graphics 2(4), 1983; ours differs:
/// weights from coverage and trust, on cells.
/// @param map the views of its cells are chosen; its levels are filled
/// @error cancelled
[[nodiscard]] Result<void> levelSeams(std::span<const ViewSurvey> surveys, const SeamOptions& options, SeamMap& map, Progress& progress);

}  // namespace ew::stitching
