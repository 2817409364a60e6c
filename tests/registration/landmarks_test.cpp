#include "ew/registration/landmarks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "ew/core/frames.h"
#include "registration/landmark_sets.h"

namespace ew::registration::landmarks_test {
namespace {

using test::pairsOf;
using test::rigid;
using test::scattered;
using test::worst;

TEST(Landmarks, RecoverARigidTransformExactly) {
  const auto places = scattered(6, 1);
  const auto truth = rigid(0.7, {1.0, -2.0, 0.5}, {30.0, -12.0, 70.0});
  const auto found = registerLandmarks(pairsOf(places, truth));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(worst(found->fixedToMoving, truth, places), 1e-9);
  EXPECT_LT(found->rms_mm, 1e-9);
  EXPECT_TRUE(checkRigid(found->fixedToMoving, 1e-12));
}

RC_GTEST_PROP(Landmarks, RecoverAnyRigidTransformOfAnyScatteredPlaces, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto count = *rc::gen::inRange<std::size_t>(3, 20);
  const auto angle = 0.001 * *rc::gen::inRange(-3141, 3142);
  const auto axis = scattered(1, seed + 1).front();
  const auto places = scattered(count, seed);
  const auto truth = rigid(angle, axis, scattered(1, seed + 2).front() * 10.0);
  const auto found = registerLandmarks(pairsOf(places, truth));
  RC_ASSERT(found.has_value());
  if (found->verdict == Verdict::cannotTell) RC_DISCARD("places that happen to lie on a line");
  RC_ASSERT(found->verdict == Verdict::aligned);
  RC_ASSERT(worst(found->fixedToMoving, truth, places) < 1e-8);
}

TEST(Landmarks, TheTurnDoesNotDependOnTheOrderOfThePairs) {
  auto pairs = pairsOf(scattered(7, 3), rigid(0.4, {0.0, 1.0, 1.0}, {5.0, 6.0, 7.0}));
  pairs[2].moving_mm += glm::dvec3(25.0, 0.0, 0.0);
  const auto forward = registerLandmarks(pairs);
  std::reverse(pairs.begin(), pairs.end());
  const auto backward = registerLandmarks(pairs);
  ASSERT_TRUE(forward && backward);
  EXPECT_LT(worst(forward->fixedToMoving, backward->fixedToMoving, scattered(5, 4)), 1e-7);
  EXPECT_EQ(backward->outlying, std::vector<std::size_t>{4});
}

TEST(Landmarks, WithoutRobustnessOnePairPullsTheResult) {
  const auto places = scattered(8, 5);
  const auto truth = rigid(0.3, {1.0, 0.0, 0.0}, {1.0, 2.0, 3.0});
  auto pairs = pairsOf(places, truth);
  pairs[3].moving_mm.z += 24.0;
  const auto plain = registerLandmarks(pairs, {.robust = false});
  const auto robust = registerLandmarks(pairs);
  ASSERT_TRUE(plain && robust);
  EXPECT_GT(worst(plain->fixedToMoving, truth, places), 2.0);
  EXPECT_LT(worst(robust->fixedToMoving, truth, places), 1e-6);
}

TEST(Landmarks, ExpectedErrorIsWhatPickingManyTimesGives) {
  const auto places = scattered(6, 11);
  const auto truth = rigid(0.5, {1.0, 1.0, 0.0}, {10.0, 0.0, -4.0});
  glm::dvec3 centre(0.0);
  for (const auto& p : places) centre += p / 6.0;
  double reach = 0.0;
  for (const auto& p : places) reach = std::max(reach, glm::length(p - centre));
  const double pick_mm = 0.5;
  std::mt19937_64 draw(12);
  std::normal_distribution<double> error(0.0, pick_mm);
  const auto picked = [&](const glm::dvec3& p) {
    const double x = error(draw);
    const double y = error(draw);
    return p + glm::dvec3(x, y, error(draw));
  };
  // The worst of many directions at that reach, as the figure promises.
  std::vector<glm::dvec3> targets;
  for (const auto& direction : scattered(100, 13)) targets.push_back(centre + reach * glm::normalize(direction));
  std::vector<double> squares(targets.size(), 0.0);
  constexpr int kRuns = 600;
  double expected = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<LandmarkPair> pairs;
    for (const auto& p : places) pairs.push_back({"", picked(p), picked(carried(truth, p))});
    const auto found = registerLandmarks(pairs, {.pickError_mm = pick_mm});
    ASSERT_TRUE(found);
    expected += found->expectedError_mm / kRuns;
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const double off = glm::length(carried(found->fixedToMoving, targets[t]) - carried(truth, targets[t]));
      squares[t] += off * off / kRuns;
    }
  }
  const double simulated = std::sqrt(*std::max_element(squares.begin(), squares.end()));
  EXPECT_NEAR(expected / simulated, 1.0, 0.15) << expected << " expected, " << simulated << " simulated";
}

TEST(Landmarks, ACoarseHandIsBelievedButRaisesTheExpectedError) {
  const auto places = scattered(10, 21);
  const auto truth = rigid(0.2, {0.0, 0.0, 1.0}, {0.0, 8.0, 0.0});
  std::mt19937_64 draw(22);
  std::normal_distribution<double> error(0.0, 3.0);
  auto pairs = pairsOf(places, truth);
  for (auto& pair : pairs)
    for (int axis = 0; axis < 3; ++axis) pair.moving_mm[axis] += error(draw);
  const auto found = registerLandmarks(pairs);
  const auto sure = registerLandmarks(pairsOf(places, truth));
  ASSERT_TRUE(found && sure);
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LE(found->outlying.size(), 1u) << found->reason;
  EXPECT_GT(found->expectedError_mm, 1.5 * sure->expectedError_mm);
}

TEST(Landmarks, RefuseACoordinateThatIsNoNumber) {
  auto pairs = pairsOf(scattered(4, 1), {});
  pairs[1].name = "portal vein";
  pairs[1].moving_mm.y = std::numeric_limits<double>::quiet_NaN();
  const auto found = registerLandmarks(pairs);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::badField);
  EXPECT_NE(found.error().sentence().find("'portal vein'"), std::string::npos) << found.error();
  for (const double pick : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(registerLandmarks(pairsOf(scattered(4, 1), {}), {.pickError_mm = pick})) << pick;
}

}  // namespace
}  // namespace ew::registration::landmarks_test
