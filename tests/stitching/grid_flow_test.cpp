#include "grid_flow.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace ew::stitching::grid_flow_test {
namespace {

const auto kNeverStopped = [] { return false; };

/// A random box and what every labelling of it costs.
struct Problem {
  glm::ivec3 size{1};
  std::vector<std::array<int, 2>> own;    ///< cost on the sink's side, on the source's
  std::vector<std::array<int, 4>> links;  ///< lower cell, direction, forth, back
  [[nodiscard]] int indexOf(int i, int j, int k) const { return (k * size.y + j) * size.x + i; }

  static Problem random(const glm::ivec3& size, int strongest) {
    Problem problem;
    problem.size = size;
    const auto draw = [&] { return *rc::gen::inRange(0, strongest); };
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
          problem.own.push_back({draw(), draw()});
          const int cell = problem.indexOf(i, j, k);
          if (i + 1 < size.x) problem.links.push_back({cell, GridFlow::up_i, draw(), draw()});
          if (j + 1 < size.y) problem.links.push_back({cell, GridFlow::up_j, draw(), draw()});
          if (k + 1 < size.z) problem.links.push_back({cell, GridFlow::up_k, draw(), draw()});
        }
    return problem;
  }
  [[nodiscard]] long costOf(const std::vector<bool>& sink) const {
    long cost = 0;
    for (std::size_t c = 0; c < own.size(); ++c) cost += own[c][sink[c] ? 0 : 1];
    for (const auto& [cell, towards, forth, back] : links) {
      const int step = towards == GridFlow::up_i ? 1 : towards == GridFlow::up_j ? size.x : size.x * size.y;
      const bool a = sink[static_cast<std::size_t>(cell)];
      const bool b = sink[static_cast<std::size_t>(cell + step)];
      if (!a && b) cost += forth;
      if (a && !b) cost += back;
    }
    return cost;
  }
  [[nodiscard]] std::vector<bool> cut() const {
    GridFlow flow(size);
    const auto nodeOf = [&](int cell) { return flow.nodeOf(cell % size.x, cell / size.x % size.y, cell / size.x / size.y); };
    for (std::size_t c = 0; c < own.size(); ++c) flow.addCosts(nodeOf(static_cast<int>(c)), own[c][0], own[c][1]);
    for (const auto& [cell, towards, forth, back] : links) flow.addLink(nodeOf(cell), static_cast<GridFlow::Towards>(towards), forth, back);
    RC_ASSERT(flow.solve(kNeverStopped));
    std::vector<bool> sink(own.size());
    for (std::size_t c = 0; c < own.size(); ++c) sink[c] = flow.onSinkSide(nodeOf(static_cast<int>(c)));
    return sink;
  }
};

RC_GTEST_PROP(GridFlow, FindsTheCheapestOfAllLabellingsOfASmallBox, ()) {
  const auto problem = Problem::random({*rc::gen::inRange(1, 4), *rc::gen::inRange(1, 4), *rc::gen::inRange(1, 3)}, 20);
  const std::size_t cells = problem.own.size();
  RC_PRE(cells <= 12u);
  long least = std::numeric_limits<long>::max();
  std::size_t fewest = 0;
  for (unsigned labelling = 0; labelling < (1u << cells); ++labelling) {
    std::vector<bool> sink(cells);
    for (std::size_t c = 0; c < cells; ++c) sink[c] = ((labelling >> c) & 1u) != 0;
    const long cost = problem.costOf(sink);
    const auto count = static_cast<std::size_t>(std::count(sink.begin(), sink.end(), true));
    if (cost < least || (cost == least && count < fewest)) {
      least = cost;
      fewest = count;
    }
  }
  const auto found = problem.cut();
  RC_ASSERT(problem.costOf(found) == least);
  RC_ASSERT(static_cast<std::size_t>(std::count(found.begin(), found.end(), true)) == fewest);
}

RC_GTEST_PROP(GridFlow, CannotBeBetteredByMovingAnyBlockOfALargeBox, ()) {
  // No proof of a minimum, but what a broken tree or a lost orphan leaves behind shows here.
  const auto problem = Problem::random({9, 8, 7}, *rc::gen::inRange(2, 200));
  auto found = problem.cut();
  const long cost = problem.costOf(found);
  for (int attempt = 0; attempt < 60; ++attempt) {
    const glm::ivec3 low(*rc::gen::inRange(0, 9), *rc::gen::inRange(0, 8), *rc::gen::inRange(0, 7));
    const glm::ivec3 high = glm::min(low + *rc::gen::inRange(1, 4), problem.size);
    const bool to = *rc::gen::arbitrary<bool>();
    auto changed = found;
    for (int k = low.z; k < high.z; ++k)
      for (int j = low.y; j < high.y; ++j)
        for (int i = low.x; i < high.x; ++i) changed[static_cast<std::size_t>(problem.indexOf(i, j, k))] = to;
    RC_ASSERT(problem.costOf(changed) >= cost);
  }
}

TEST(GridFlow, StopsWhenAskedTo) {
  GridFlow flow({60, 60, 60});
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        flow.addCosts(flow.nodeOf(i, j, k), (i * 7 + j * 5 + k) % 13, (i + j * 3 + k * 11) % 13);
        if (i < 59) flow.addLink(flow.nodeOf(i, j, k), GridFlow::up_i, 3, 3);
      }
  int asked = 0;
  EXPECT_FALSE(flow.solve([&] { return ++asked > 2; }));
}

}  // namespace
}  // namespace ew::stitching::grid_flow_test
