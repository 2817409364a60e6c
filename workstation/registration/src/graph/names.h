#pragma once

#include <span>
#include <string>
#include <vector>

#include "ew/registration/pose_graph.h"

namespace ew::registration::graph {

/// "'liver left'", or "subvolume 3" of a node without a name.
[[nodiscard]] std::string nameOfNode(std::span<const GraphNode> nodes, std::size_t node);
/// "'liver left' with 'liver right'".
[[nodiscard]] std::string nameOfEdge(std::span<const GraphNode> nodes, const GraphEdge& edge);
/// "a, b and c"; of more than eight names the rest is counted.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace ew::registration::graph
