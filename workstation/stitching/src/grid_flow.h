#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "ew/core/volume.h"

namespace ew::stitching {

/// Minimum cut of a box of cells, each joined to its six neighbours, between a source and a sink.
/// Source: Boykov and Kolmogorov, IEEE Trans. Pattern Anal. Mach. Intell. 26(9), 2004: augmenting paths from two search trees that are kept
/// and mended between augmentations. Written from the paper, for a box: neighbours are strides, and a rim of dead cells saves all bounds.
/// Memory: kBytesPerCell for every cell of the box and its rim.
class GridFlow {
 public:
  enum Towards { down_i, up_i, down_j, up_j, down_k, up_k };
  static constexpr std::uint64_t kBytesPerCell = 6 * 4 + 4 + 4 + 4 + 1 + 1;

  explicit GridFlow(const glm::ivec3& size);

  [[nodiscard]] std::size_t nodeOf(int i, int j, int k) const { return sampleIndex(padded_, i + 1, j + 1, k + 1); }
  /// What it costs to put the node on the sink's side, and on the source's: may be called repeatedly, costs add up; either may be negative.
  void addCosts(std::size_t node, std::int64_t onSinkSide, std::int64_t onSourceSide);
  /// Costs `forth` when the node is on the source's side and its neighbour on the sink's, `back` the other way round; both >= 0.
  void addLink(std::size_t node, Towards neighbour, std::int32_t forth, std::int32_t back);

  /// @return false when stopped
  bool solve(const std::function<bool()>& stopped);
  /// True for the fewest nodes that a cheapest cut puts there: of equal cuts, the one nearest to the sink.
  [[nodiscard]] bool onSinkSide(std::size_t node) const { return tree_[node] == kSinkTree; }
  [[nodiscard]] std::int64_t flow() const { return flow_; }

 private:
  static constexpr std::uint8_t kFree = 0, kSourceTree = 1, kSinkTree = 2;
  static constexpr std::uint8_t kTerminal = 6, kNoParent = 7;

  [[nodiscard]] std::size_t neighbour(std::size_t node, int towards) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + stride_[towards]);
  }
  std::int32_t& capacity(std::size_t node, int towards) { return capacity_[node * 6 + static_cast<std::size_t>(towards)]; }
  /// What may still flow between a node and its neighbour in the direction of the node's tree: away from the source, towards the sink.
  [[nodiscard]] std::int32_t outward(std::size_t node, int towards) {
    return tree_[node] == kSourceTree ? capacity(node, towards) : capacity(neighbour(node, towards), towards ^ 1);
  }
  void activate(std::size_t node);
  void augment(std::size_t fromSource, int towards);
  void adopt(std::size_t orphan);
  [[nodiscard]] std::int32_t distanceToRoot(std::size_t node);

  glm::ivec3 padded_;
  std::ptrdiff_t stride_[6];
  std::vector<std::int32_t> capacity_;
  std::vector<std::int32_t> terminal_;  ///< > 0: what may still come from the source; < 0: what may still go to the sink
  std::vector<std::int32_t> distance_;
  std::vector<std::int32_t> stamp_;
  std::vector<std::uint8_t> tree_;
  std::vector<std::uint8_t> parent_;  ///< direction of the parent, or one of the two above; with kQueued in the high bit
  std::deque<std::size_t> active_;
  std::deque<std::size_t> orphans_;
  std::int32_t time_ = 0;
  std::int64_t flow_ = 0;
};

}  // namespace ew::stitching
