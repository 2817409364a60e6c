#include "pressed_views.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "ew/registration/rigid.h"
#include "found_views.h"
#include "places.h"

/// Twelve swept views of a virtual patient become one graph: recorded, reconstructed, matched without any tracker, solved.
namespace ew::registration::pressed_views_test {
namespace {

using namespace test;

double apart_mm(const Transform<frame::Moving, frame::Fixed>& a, const Transform<frame::Moving, frame::Fixed>& b, const glm::dvec3& at_mm) {
  return glm::length(carried(a, at_mm) - carried(b, at_mm));
}

/// Pairs with the true rigid parts in place of what was found.
FoundViews withTrueEdges(const FoundViews& found, const std::vector<PressedView>& views) {
  FoundViews ideal = found;
  for (GraphEdge& edge : ideal.edges)
    if (const auto part = trueEdge(views[edge.fixed], views[edge.moving])) edge.fixedToMoving = {part->matrix};
  return ideal;
}

/// The part with most views, by its first one.
std::size_t gaugeOf(const GraphResult& found) {
  std::vector<int> size(found.part.size() + 1, 0);
  for (const int part : found.part) ++size[static_cast<std::size_t>(part)];
  const auto largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  return static_cast<std::size_t>(std::find(found.part.begin(), found.part.end(), largest) - found.part.begin());
}

PlacedViews solvedWith(const FoundViews& views) {
  const std::vector<GraphNode> nodes(views.truth.size());
  const auto found = solveGraph(nodes, views.edges, {}, noProgress());
  if (!found) {
    ADD_FAILURE() << found.error();
    return {};
  }
  return placedWith(gaugeOf(*found), *found, views);
}

class PressedViews : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(PressedViews, TwelveAreAllPlacedWithoutATrackerAndTheWrongPairsNamed) {
  const auto views = pressedViews({.seed = GetParam()}, EW_SOURCE_DIR);
  ASSERT_EQ(views.size(), 12u);
  FoundViews found;
  for (const PressedView& view : views) {
    const RigidPart pose = truePose(view);
    found.truth.push_back({pose.matrix});
    found.middle_mm.push_back(view.middle_mm);
    std::printf("view %zu: what is not rigid in it %.2f mm\n", found.truth.size() - 1, pose.rms_mm);
  }
  int undecided = 0;
  for (const auto& [a, b] : neighbours()) {
    const auto result = matchPartial({&views[a].volume}, {&views[b].volume}, {}, noProgress());
    ASSERT_TRUE(result) << result.error();
    const RigidResult& best = result->best;
    const auto ideal = trueEdge(views[a], views[b]);
    if (best.verdict != Verdict::aligned) {
      ++undecided;
      std::printf("%zu-%zu %s: %s\n", a, b, nameOf(best.verdict), best.reason.english().c_str());
      continue;
    }
    ASSERT_TRUE(ideal && best.covariance);
    const PoseCovariance& c = *best.covariance;
    std::printf(
        "%zu-%zu: %.2f mm and %.2f degrees from the rigid part of the true motion, which leaves %.2f mm; stated %.2f mm, %.2f degrees\n", a,
        b, apart_mm(best.fixedToMoving, {ideal->matrix}, best.centre_mm),
        rotation_deg(best.fixedToMoving, Transform<frame::Moving, frame::Fixed>{ideal->matrix}), ideal->rms_mm,
        std::sqrt(c[0] + c[7] + c[14]), glm::degrees(std::sqrt(c[21] + c[28] + c[35])));
    std::fflush(stdout);
    EXPECT_LT(apart_mm(best.fixedToMoving, {ideal->matrix}, best.centre_mm), 3.0) << "called aligned, and wrong";
    found.edges.push_back(
        {.fixed = a, .moving = b, .fixedToMoving = best.fixedToMoving, .covariance = best.covariance, .centre_mm = best.centre_mm});
  }
  EXPECT_TRUE(write(found, "found_views_" + std::to_string(GetParam()) + ".txt"));
  const auto graph = spoiledGraph(found, GetParam());
  const auto solved = solveGraph(graph.nodes, graph.edges, {}, noProgress());
  ASSERT_TRUE(solved) << solved.error();
  const PlacedViews placed = placedWith(gaugeOf(*solved), *solved, found);
  const PlacedViews ideal = solvedWith(withTrueEdges(found, views));
  std::printf(
      "seed %llu: %zu of 29 pairs aligned, %d not; worst pose %.2f mm, %.2f degrees; with the true rigid parts of the pairs %.2f mm, %.2f "
      "degrees; %s\n",
      static_cast<unsigned long long>(GetParam()), found.edges.size(), undecided, placed.worst.mm, placed.worst.deg, ideal.worst.mm,
      ideal.worst.deg, solved->reason.english().c_str());
  EXPECT_EQ(solved->wrong, graph.spoiled) << solved->reason;
  EXPECT_EQ(placed.count, 12) << solved->reason;
  EXPECT_LT(placed.worst.mm, 1.0);
  EXPECT_LT(placed.worst.deg, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, PressedViews, ::testing::Values(1));

}  // namespace
}  // namespace ew::registration::pressed_views_test
