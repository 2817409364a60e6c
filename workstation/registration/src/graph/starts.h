#pragma once

#include <vector>

#include "graph/joints.h"

namespace ew::registration::graph {

/// Poses worth descending from, one per node, the world's last: along a tree of joints that loops confirm, along the trackers' poses, along
/// the best of many trees drawn by lot (the same ones every time); or only the poses given, when the options say so.
[[nodiscard]] std::vector<std::vector<Pose>> startsOf(const Joints& joints);

}  // namespace ew::registration::graph
