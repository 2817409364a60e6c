#pragma once

#include <span>

#include "ew/core/message.h"
#include "ew/registration/pose_graph.h"

namespace ew::registration::graph {

/// "'liver left'", or "subvolume 3" of a node without a name.
[[nodiscard]] Message nameOfNode(std::span<const GraphNode> nodes, std::size_t node);
/// "'liver left' with 'liver right'".
[[nodiscard]] Message nameOfEdge(std::span<const GraphNode> nodes, const GraphEdge& edge);
/// "the tracker's pose of 'liver left'".
[[nodiscard]] Message nameOfPrior(std::span<const GraphNode> nodes, std::size_t node);

}  // namespace ew::registration::graph
