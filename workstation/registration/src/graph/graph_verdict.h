#pragma once

#include <span>

#include "ew/registration/pose_graph.h"

namespace ew::registration::graph {

/// Sets the verdict and the reason of a result of which everything else is known.
void judge(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, GraphResult& result);

}  // namespace ew::registration::graph
