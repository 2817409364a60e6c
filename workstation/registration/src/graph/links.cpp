#include "graph/links.h"

#include <algorithm>
#include <numeric>

namespace ew::registration::graph {
namespace {

class Union {
 public:
  explicit Union(std::size_t nodes) : above_(nodes) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    above_[std::max(a, b)] = std::min(a, b);  // the first node of a part leads it
    return a != b;
  }

 private:
  std::vector<std::size_t> above_;
};

struct Neighbour {
  std::size_t node;
  std::size_t link;
};

std::vector<std::vector<Neighbour>> neighboursOf(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts) {
  std::vector<std::vector<Neighbour>> neighbours(nodes);
  for (std::size_t l = 0; l < links.size(); ++l) {
    if (!counts[l]) continue;
    neighbours[links[l].a].push_back({links[l].b, l});
    neighbours[links[l].b].push_back({links[l].a, l});
  }
  return neighbours;
}

}  // namespace

std::vector<int> partsOf(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts) {
  Union parts(nodes);
  for (std::size_t l = 0; l < links.size(); ++l)
    if (counts[l]) parts.join(links[l].a, links[l].b);
  std::vector<int> numberOf(nodes, -1);
  std::vector<int> part(nodes);
  int next = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    int& number = numberOf[parts.find(i)];
    if (number < 0) number = next++;
    part[i] = number;
  }
  return part;
}

std::vector<bool> bridgesOf(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts) {
  // Tarjan 1974: a link of the depth-first tree is a bridge when nothing below it reaches above it.
  const auto neighbours = neighboursOf(nodes, links, counts);
  std::vector<bool> bridge(links.size(), false);
  std::vector<std::size_t> entered(nodes, kNone);
  std::vector<std::size_t> lowest(nodes, kNone);
  std::size_t clock = 0;
  struct Visit {
    std::size_t node;
    std::size_t by;
    std::size_t next = 0;
  };
  std::vector<Visit> stack;
  for (std::size_t root = 0; root < nodes; ++root) {
    if (entered[root] != kNone) continue;
    entered[root] = lowest[root] = clock++;
    stack.push_back({root, kNone});
    while (!stack.empty()) {
      Visit& visit = stack.back();
      if (visit.next < neighbours[visit.node].size()) {
        const auto [node, link] = neighbours[visit.node][visit.next++];
        if (link == visit.by || node == visit.node) continue;
        if (entered[node] == kNone) {
          entered[node] = lowest[node] = clock++;
          stack.push_back({node, link});
        } else {
          lowest[visit.node] = std::min(lowest[visit.node], entered[node]);
        }
        continue;
      }
      const Visit done = visit;
      stack.pop_back();
      if (stack.empty()) continue;
      const std::size_t above = stack.back().node;
      lowest[above] = std::min(lowest[above], lowest[done.node]);
      if (lowest[done.node] > entered[above]) bridge[done.by] = true;
    }
  }
  return bridge;
}

std::vector<std::size_t> pathBetween(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts, std::size_t from,
                                     std::size_t to, std::size_t without) {
  const auto neighbours = neighboursOf(nodes, links, counts);
  std::vector<Neighbour> cameFrom(nodes, {kNone, kNone});
  std::vector<std::size_t> queue{from};
  cameFrom[from] = {from, kNone};
  for (std::size_t head = 0; head < queue.size() && cameFrom[to].node == kNone; ++head)
    for (const auto& [node, link] : neighbours[queue[head]]) {
      if (link == without || cameFrom[node].node != kNone) continue;
      cameFrom[node] = {queue[head], link};
      queue.push_back(node);
    }
  std::vector<std::size_t> path;
  if (cameFrom[to].node == kNone) return path;
  for (std::size_t node = to; node != from; node = cameFrom[node].node) path.push_back(cameFrom[node].link);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<Step> spanningForest(std::size_t nodes, std::span<const Link> links, std::span<const std::size_t> inOrder,
                                 std::span<const std::size_t> roots) {
  Union joined(nodes);
  std::vector<bool> inTree(links.size(), false);
  for (const std::size_t l : inOrder)
    if (joined.join(links[l].a, links[l].b)) inTree[l] = true;
  const auto neighbours = neighboursOf(nodes, links, inTree);
  std::vector<bool> reached(nodes, false);
  std::vector<Step> steps;
  const auto walk = [&](std::size_t root) {
    if (reached[root]) return;
    reached[root] = true;
    steps.push_back({root, kNone, kNone});
    for (std::size_t head = steps.size() - 1; head < steps.size(); ++head) {
      const std::size_t at = steps[head].node;
      for (const auto& [node, link] : neighbours[at]) {
        if (reached[node]) continue;
        reached[node] = true;
        steps.push_back({node, at, link});
      }
    }
  };
  for (const std::size_t root : roots) walk(root);
  for (std::size_t i = 0; i < nodes; ++i) walk(i);
  return steps;
}

}  // namespace ew::registration::graph
