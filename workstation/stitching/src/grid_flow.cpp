#include "grid_flow.h"

#include <algorithm>
#include <limits>

#include "ew/core/contract.h"

namespace ew::stitching {
namespace {

constexpr std::uint8_t kQueued = 0x80;
constexpr std::uint8_t kParent = 0x7f;
constexpr std::int32_t kNoWay = std::numeric_limits<std::int32_t>::max();
/// Between two looks at the clock of who might cancel.
constexpr int kStepsBetweenLooks = 4096;

}  // namespace

GridFlow::GridFlow(const glm::ivec3& size)
    : padded_(size + 2), stride_{-1,
                                 1,
                                 -padded_.x,
                                 padded_.x,
                                 -static_cast<std::ptrdiff_t>(padded_.x) * padded_.y,
                                 static_cast<std::ptrdiff_t>(padded_.x) * padded_.y} {
  const auto nodes = samplesIn(padded_);
  capacity_.assign(nodes * 6, 0);
  terminal_.assign(nodes, 0);
  distance_.assign(nodes, 0);
  stamp_.assign(nodes, 0);
  tree_.assign(nodes, kFree);
  parent_.assign(nodes, kNoParent);
}

void GridFlow::addCosts(std::size_t node, std::int64_t onSinkSide, std::int64_t onSourceSide) {
  // What both sides cost is paid anyway; only the difference is left to decide.
  const std::int64_t net = terminal_[node] + onSinkSide - onSourceSide;
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / 2;
  terminal_[node] = static_cast<std::int32_t>(std::clamp(net, -most, most));
}

void GridFlow::addLink(std::size_t node, Towards towards, std::int32_t forth, std::int32_t back) {
  EW_EXPECTS(forth >= 0 && back >= 0);
  capacity(node, towards) += forth;
  capacity(neighbour(node, towards), towards ^ 1) += back;
}

void GridFlow::activate(std::size_t node) {
  if ((parent_[node] & kQueued) != 0) return;
  parent_[node] |= kQueued;
  active_.push_back(node);
}

bool GridFlow::solve(const std::function<bool()>& stopped) {
  for (std::size_t node = 0; node < terminal_.size(); ++node) {
    if (terminal_[node] == 0) continue;
    tree_[node] = terminal_[node] > 0 ? kSourceTree : kSinkTree;
    parent_[node] = kTerminal;
    distance_[node] = 1;
    activate(node);
  }
  int steps = 0;
  while (!active_.empty()) {
    if (++steps >= kStepsBetweenLooks) {
      steps = 0;
      if (stopped()) return false;
    }
    const std::size_t node = active_.front();
    bool met = false;
    if (tree_[node] != kFree)
      for (int towards = 0; towards < 6 && !met; ++towards) {
        if (outward(node, towards) <= 0) continue;
        const std::size_t other = neighbour(node, towards);
        if (tree_[other] == kFree) {
          tree_[other] = tree_[node];
          parent_[other] = static_cast<std::uint8_t>((parent_[other] & kQueued) | (towards ^ 1));
          stamp_[other] = stamp_[node];
          distance_[other] = distance_[node] + 1;
          activate(other);
        } else if (tree_[other] != tree_[node]) {
          // The trees meet: send what the path holds, mend, and look at the same node again.
          met = true;
          ++time_;
          if (tree_[node] == kSourceTree)
            augment(node, towards);
          else
            augment(other, towards ^ 1);
          while (!orphans_.empty()) {
            const std::size_t orphan = orphans_.front();
            orphans_.pop_front();
            adopt(orphan);
            if (++steps >= kStepsBetweenLooks) {
              steps = 0;
              if (stopped()) return false;
            }
          }
        } else if (stamp_[other] <= stamp_[node] && distance_[other] > distance_[node] + 1) {
          // A shorter way to the root keeps later paths short.
          parent_[other] = static_cast<std::uint8_t>((parent_[other] & kQueued) | (towards ^ 1));
          stamp_[other] = stamp_[node];
          distance_[other] = distance_[node] + 1;
        }
      }
    if (met) continue;
    active_.pop_front();
    parent_[node] &= kParent;
  }
  return true;
}

void GridFlow::augment(std::size_t fromSource, int towards) {
  const std::size_t toSink = neighbour(fromSource, towards);
  std::int32_t most = capacity(fromSource, towards);
  std::size_t node = fromSource;
  for (int up = parent_[node] & kParent; up != kTerminal; up = parent_[node] & kParent) {
    node = neighbour(node, up);
    most = std::min(most, capacity(node, up ^ 1));
  }
  most = std::min(most, terminal_[node]);
  node = toSink;
  for (int up = parent_[node] & kParent; up != kTerminal; up = parent_[node] & kParent) {
    most = std::min(most, capacity(node, up));
    node = neighbour(node, up);
  }
  most = std::min(most, -terminal_[node]);

  const auto orphaned = [&](std::size_t child) {
    parent_[child] = static_cast<std::uint8_t>((parent_[child] & kQueued) | kNoParent);
    orphans_.push_back(child);
  };
  capacity(fromSource, towards) -= most;
  capacity(toSink, towards ^ 1) += most;
  node = fromSource;
  for (int up = parent_[node] & kParent; up != kTerminal; up = parent_[node] & kParent) {
    const std::size_t above = neighbour(node, up);
    capacity(node, up) += most;
    if ((capacity(above, up ^ 1) -= most) == 0) orphaned(node);
    node = above;
  }
  if ((terminal_[node] -= most) == 0) orphaned(node);
  node = toSink;
  for (int up = parent_[node] & kParent; up != kTerminal; up = parent_[node] & kParent) {
    const std::size_t above = neighbour(node, up);
    capacity(above, up ^ 1) += most;
    if ((capacity(node, up) -= most) == 0) orphaned(node);
    node = above;
  }
  if ((terminal_[node] += most) == 0) orphaned(node);
  flow_ += most;
}

/// Steps to the terminal, or kNoWay when the way ends at an orphan. Marks the way, so that it is walked once per augmentation.
std::int32_t GridFlow::distanceToRoot(std::size_t node) {
  std::int32_t steps = 0;
  for (std::size_t at = node;;) {
    if (stamp_[at] == time_) {
      steps += distance_[at];
      break;
    }
    const int up = parent_[at] & kParent;
    ++steps;
    if (up == kTerminal) {
      stamp_[at] = time_;
      distance_[at] = 1;
      break;
    }
    if (up == kNoParent) return kNoWay;
    at = neighbour(at, up);
  }
  std::int32_t left = steps;
  for (std::size_t at = node; stamp_[at] != time_; at = neighbour(at, parent_[at] & kParent)) {
    stamp_[at] = time_;
    distance_[at] = left--;
  }
  return steps;
}

void GridFlow::adopt(std::size_t orphan) {
  const std::uint8_t tree = tree_[orphan];
  // What may still flow from a neighbour of the tree to the orphan, seen along the tree's direction.
  const auto inward = [&](int towards) {
    return tree == kSourceTree ? capacity(neighbour(orphan, towards), towards ^ 1) : capacity(orphan, towards);
  };
  std::int32_t nearest = kNoWay;
  int parent = kNoParent;
  for (int towards = 0; towards < 6; ++towards) {
    const std::size_t other = neighbour(orphan, towards);
    if (tree_[other] != tree || inward(towards) <= 0) continue;
    const std::int32_t steps = distanceToRoot(other);
    if (steps >= nearest) continue;
    nearest = steps;
    parent = towards;
  }
  if (parent != kNoParent) {
    parent_[orphan] = static_cast<std::uint8_t>((parent_[orphan] & kQueued) | parent);
    stamp_[orphan] = time_;
    distance_[orphan] = nearest + 1;
    return;
  }
  for (int towards = 0; towards < 6; ++towards) {
    const std::size_t other = neighbour(orphan, towards);
    if (tree_[other] != tree) continue;
    if (inward(towards) > 0) activate(other);
    if ((parent_[other] & kParent) == (towards ^ 1)) {
      parent_[other] = static_cast<std::uint8_t>((parent_[other] & kQueued) | kNoParent);
      orphans_.push_back(other);
    }
  }
  tree_[orphan] = kFree;
}

}  // namespace ew::stitching
