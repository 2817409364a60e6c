#include "graph/names.h"

#include <algorithm>

namespace ew::registration::graph {

std::string nameOfNode(std::span<const GraphNode> nodes, std::size_t node) {
  return nodes[node].name.empty() ? "subvolume " + std::to_string(node + 1) : "'" + nodes[node].name + "'";
}

std::string nameOfEdge(std::span<const GraphNode> nodes, const GraphEdge& edge) {
  return nameOfNode(nodes, edge.fixed) + " with " + nameOfNode(nodes, edge.moving);
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  const std::size_t shown = std::min(names.size(), kMost);
  for (std::size_t n = 0; n < shown; ++n) {
    if (n > 0) text += n + 1 == names.size() ? " and " : ", ";
    text += names[n];
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

}  // namespace ew::registration::graph
