#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace ew::registration::graph {

inline constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Two nodes that something joins: a pair, a tracker's pose (with the world as the last node).
struct Link {
  std::size_t a = 0;
  std::size_t b = 0;
};

/// Part of each node, numbered from 0 in the order of their first nodes, over the links that count.
std::vector<int> partsOf(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts);

/// Links whose removal would part the nodes they join. Parallel links are none.
std::vector<bool> bridgesOf(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts);

/// The links of a shortest path; empty when there is none or from == to. `without` is not walked.
std::vector<std::size_t> pathBetween(std::size_t nodes, std::span<const Link> links, const std::vector<bool>& counts, std::size_t from,
                                     std::size_t to, std::size_t without = kNone);

/// How one walks from the roots over a tree of links: in an order in which the parent comes first.
struct Step {
  std::size_t node = 0;
  std::size_t parent = kNone;  ///< kNone: a root
  std::size_t link = kNone;
};

/// The spanning forest that takes links greedily in the order given (Kruskal), walked from the roots: for each part the first node in
/// `roots` that lies in it, else its first node.
std::vector<Step> spanningForest(std::size_t nodes, std::span<const Link> links, std::span<const std::size_t> inOrder,
                                 std::span<const std::size_t> roots);

}  // namespace ew::registration::graph
