#pragma once

#include "elastic/levels.h"

namespace ew::registration {

/// Where Gauss-Newton could start when the motion is larger than the structures it follows: every shift within `reach_mm` on a lattice of
/// the images' voxels is tried, the local correlation around each node under it becomes a log-likelihood, and the shifts of the nodes
/// are chosen by turns of "best shift near the neighbours' mean" and "mean of the neighbours" while the coupling grows.
/// @return one constant start (the best common shift) and one that varies; either may equal the start from nothing. Empty: cancelled.
[[nodiscard]] std::vector<NodeValues> wideStarts(const LevelImage& fixed, const LevelImage& moving, const AxesTransform& transform,
                                                 const NodeGrid& nodes, double reach_mm, int threads, Progress& progress);

}  // namespace ew::registration
