#pragma once

#include <span>

#include "ew/core/result.h"
#include "ew/registration/pose_graph.h"

namespace ew::registration::graph {

/// What `solveGraph` refuses, as it says there.
[[nodiscard]] Result<void> checkGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options);

}  // namespace ew::registration::graph
