#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ew/registration/pose_graph.h"
#include "registration/graphs.h"

namespace ew::registration::registration_graph_test {
namespace {

using test::isotropic;
using test::KnownGraph;
using test::moved;
using test::worstError;

Result<GraphResult> solved(const KnownGraph& known) { return solveGraph(known.nodes, known.edges, {}, noProgress()); }

bool mentions(const GraphResult& result, const std::string& words) { return result.reason.english().find(words) != std::string::npos; }

TEST(GraphHardCases, AChainWithAWrongEdgeSaysThatNothingChecksIt) {
  KnownGraph known(6, 1);
  for (std::size_t i = 0; i + 1 < 6; ++i) known.join(i, i + 1, 0.2, 0.2);
  known.spoil(2, 30.0, 15.0);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->wrong.empty()) << "nothing in a chain can tell";
  EXPECT_TRUE(mentions(*found, "No loop checks the pairs")) << found->reason;
  EXPECT_TRUE(mentions(*found, "'c' with 'd'")) << found->reason;
  for (const auto& edge : found->edges) EXPECT_FALSE(edge.confirmed);
}

TEST(GraphHardCases, ADoubtfulPairThatNoLoopChecksCannotTell) {
  KnownGraph known(3, 2);
  known.join(0, 1, 0.2, 0.2);
  known.join(1, 2, 0.2, 0.2).trust = 0.3;
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell) << found->reason;
}

TEST(GraphHardCases, ASingleLoopWithAWrongEdgeKnowsThatOneIsWrongButNotWhich) {
  KnownGraph known(6, 3);
  for (std::size_t i = 0; i < 6; ++i) known.join(i, (i + 1) % 6, 0.2, 0.2);
  known.spoil(2, 30.0, 15.0);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell) << found->reason;
  EXPECT_EQ(found->wrong.size(), 1u);
  EXPECT_EQ(found->suspects.size(), 5u) << found->reason;
  EXPECT_TRUE(mentions(*found, "It could as well be")) << found->reason;
}

TEST(GraphHardCases, ALessTrustedEdgeOfASingleLoopIsTheWrongOne) {
  KnownGraph known(6, 3);
  for (std::size_t i = 0; i < 6; ++i) known.join(i, (i + 1) % 6, 0.2, 0.2);
  known.spoil(2, 30.0, 15.0);
  known.edges[2].trust = 0.4;
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->wrong, std::vector<std::size_t>{2}) << found->reason;
  EXPECT_TRUE(found->suspects.empty());
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 2.0);
}

TEST(GraphHardCases, AWrongEdgeOfALoopWithAChordIsNamed) {
  for (std::size_t wrong = 0; wrong < 8; ++wrong) {
    KnownGraph known(6, 4);
    for (std::size_t i = 0; i < 6; ++i) known.join(i, (i + 1) % 6, 0.2, 0.2);
    known.join(0, 2, 0.2, 0.2);
    known.join(3, 5, 0.2, 0.2);
    known.join(1, 4, 0.2, 0.2);
    known.spoil(wrong, 30.0, 15.0);
    const auto found = solved(known);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->verdict, Verdict::aligned) << wrong << ": " << found->reason;
    EXPECT_EQ(found->wrong, std::vector<std::size_t>{wrong}) << found->reason;
    EXPECT_LT(worstError(found->toWorld, known.truth).mm, 2.0) << wrong;
  }
}

TEST(GraphHardCases, AnAnchoredChainNamesItsWrongEdgeByTheTracker) {
  KnownGraph known(6, 5);
  for (std::size_t i = 0; i + 1 < 6; ++i) known.join(i, i + 1, 0.2, 0.2);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4}, std::size_t{5}}) {
    known.nodes[i].toWorld = known.truth[i] * moved<frame::View>(glm::dvec3(0.0), known.draw.vector(0.7), known.draw.vector(0.01));
    known.nodes[i].prior = isotropic(0.7, 0.01);
  }
  known.spoil(2, 30.0, 15.0);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->wrong, std::vector<std::size_t>{2}) << found->reason;
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 2.0);
}

TEST(GraphHardCases, TwoDisconnectedPartsAreNamedAndSolvedEach) {
  KnownGraph known(7, 6);
  for (std::size_t i = 0; i < 3; ++i) known.join(i, (i + 1) % 3, 0.2, 0.2);
  for (std::size_t i = 3; i + 1 < 7; ++i) known.join(i, i + 1, 0.2, 0.2);
  known.nodes[3].toWorld = known.truth[3];
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_EQ(found->parts, 2);
  EXPECT_EQ(found->part, (std::vector<int>{0, 0, 0, 1, 1, 1, 1}));
  EXPECT_TRUE(mentions(*found, "'a', 'b', 'c'; 'd', 'e', 'f', 'g'")) << found->reason;
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 4.0) << "each part lies right to its own gauge";
}

TEST(GraphHardCases, ANodeLeftAloneByItsOnlyWrongEdgesIsNotPlacedByThem) {
  KnownGraph known(5, 7);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) known.join(i, j, 0.2, 0.2);
  known.join(0, 4, 0.2, 0.2);
  known.join(1, 4, 0.2, 0.2);
  known.spoil(6, 40.0, 10.0);
  known.spoil(7, 25.0, 25.0);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell) << found->reason;
  EXPECT_EQ(found->wrong.size(), 1u) << "one of the two places it, the other contradicts: " << found->reason;
  EXPECT_EQ(found->suspects.size(), 1u);
}

TEST(GraphHardCases, ASingleNodeStaysWhereItIs) {
  KnownGraph known(1, 8);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned);
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 1e-12);
  EXPECT_EQ(found->parts, 1);
}

TEST(GraphHardCases, EdgesWithoutInformationAreNamedAndLeftOut) {
  KnownGraph known(4, 9);
  for (std::size_t i = 0; i < 3; ++i) known.join(i, (i + 1) % 3, 0.2, 0.2);
  known.join(2, 3, 0.2, 0.2).covariance.reset();
  known.join(1, 3, 0.2, 0.2).trust = 0.0;
  PoseCovariance nothing{};
  for (std::size_t k = 0; k < 6; ++k) nothing[7 * k] = std::numeric_limits<double>::infinity();
  known.join(0, 3, 0.2, 0.2).covariance = nothing;
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->withoutInformation, (std::vector<std::size_t>{3, 4, 5}));
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_EQ(found->parts, 2);
  EXPECT_TRUE(mentions(*found, "Without information, and left out: 'c' with 'd', 'b' with 'd' and 'a' with 'd'")) << found->reason;
}

TEST(GraphHardCases, AnEdgeThatSlidesAlongAnAxisLeavesItsNodeFreeToSlide) {
  KnownGraph known(3, 10);
  known.join(0, 1, 0.2, 0.2);
  (*known.join(1, 2, 0.2, 0.2).covariance)[0] = std::numeric_limits<double>::infinity();
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::cannotTell);
  EXPECT_TRUE(mentions(*found, "leave 'c' free to slide")) << found->reason;
  EXPECT_TRUE(found->covariance.empty());
}

TEST(GraphHardCases, ThreeSlidingEdgesTogetherHoldANode) {
  KnownGraph known(4, 11);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j) known.join(i, j, 0.1, 0.1);
  for (std::size_t i = 0; i < 3; ++i) (*known.join(i, 3, 0.1, 0.1).covariance)[7 * i] = std::numeric_limits<double>::infinity();
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 3.0);
}

TEST(GraphHardCases, HalfATurnOffIsNoTrapForAWrongEdge) {
  KnownGraph known(6, 12);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i + 1; j < std::min<std::size_t>(6, i + 3); ++j) known.join(i, j, 0.2, 0.2);
  known.spoil(4, 80.0, 180.0);
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->wrong, std::vector<std::size_t>{4}) << found->reason;
  EXPECT_LT(worstError(found->toWorld, known.truth).mm, 2.0);
}

TEST(GraphHardCases, TwoHundredNodesWithWrongPairsAreSolved) {
  KnownGraph known(200, 13);
  for (std::size_t i = 0; i < 200; ++i)
    for (const std::size_t step : {std::size_t{1}, std::size_t{2}, std::size_t{5}})
      if (i + step < 200) known.join(i, i + step, 0.2, 0.1);
  std::vector<std::size_t> wrong;
  for (std::size_t e = 7; e < known.edges.size(); e += 41) {
    known.spoil(e, 45.0, 20.0);
    wrong.push_back(e);
  }
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->wrong, wrong) << found->reason;
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_EQ(found->covariance.size(), 200u);
  for (std::size_t e = 0; e < known.edges.size(); ++e)
    EXPECT_LT(found->edges[e].residual_mm, 3.0 + (found->edges[e].wrong ? 1e3 : 0.0)) << e;
}

TEST(GraphHardCases, OriginsFarAwayDoNotSpoilThePoses) {
  KnownGraph known(4, 14);
  const Transform<frame::View, frame::View> far{glm::translate(glm::dmat4(1.0), {1e6, -1e6, 1e6})};
  for (auto& truth : known.truth) truth = truth * inverse(far);  // every subvolume's own origin is 1700 m from its tissue
  known.nodes[0].toWorld = known.truth[0];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      auto& edge = known.join(i, j);
      edge.centre_mm += glm::dvec3(1e6, -1e6, 1e6);
    }
  const auto found = solved(known);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(worstError(found->toWorld, known.truth, {1e6, -1e6, 1e6}).mm, 1e-3);
}

}  // namespace
}  // namespace ew::registration::registration_graph_test
