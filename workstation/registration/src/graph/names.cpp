#include "graph/names.h"

namespace ew::registration::graph {

Message nameOfNode(std::span<const GraphNode> nodes, std::size_t node) {
  return nodes[node].name.empty() ? say<"subvolume %1">(node + 1) : say<"'%1'">(nodes[node].name);
}

Message nameOfEdge(std::span<const GraphNode> nodes, const GraphEdge& edge) {
  return say<"%1 with %2">(nameOfNode(nodes, edge.fixed), nameOfNode(nodes, edge.moving));
}

Message nameOfPrior(std::span<const GraphNode> nodes, std::size_t node) { return say<"the tracker's pose of %1">(nameOfNode(nodes, node)); }

}  // namespace ew::registration::graph
