#include <gtest/gtest.h>

#include <cmath>

#include "../tracking/skins.h"
#include "assessment/compass_holds.h"
#include "ew/assessment/compass.h"
#include "ew/library/body_skin.h"
#include "ew/library/case_truth.h"
#include "ew/simulated_people/simulated_hand.h"

// What the compass says is enough for a hand that follows nothing else.
namespace ew::compass_hands_test {
namespace {

TEST(CompassHands, GiveUpWhereThereIsNothingToFollow) {
  const test::CylinderSkin skin(120.0);
  PlaneTarget inside{poseOf(test::frontHold(skin)).probeToWorld, {0.0, 60.0}};
  inside.probeToWorld.matrix[3].y += 60.0;  // its face lies in the middle of the body
  EXPECT_FALSE(followCompass(compassTargetOf(inside, {}, skin), test::frontHold(skin), skin, 1).reached);
}

/// Starts all over `skin` at most so far from the target, turned anyhow.
template <class AnySkin>
void expectHandsArrive(const AnySkin& skin, double farthest_mm, int hands) {
  const Hold hold = turned(slid(test::frontHold(skin), skin, 20.0, 10.0), 0.6, -0.2, 0.3);
  const CompassTarget target = test::targetAt(hold, skin);
  ASSERT_TRUE(target.reachable);
  for (int n = 0; n < hands; ++n) {
    const double way = farthest_mm * (n + 1.0) / hands;
    const Hold start =
        turned(slid(hold, skin, way * std::cos(2.4 * n), way * std::sin(2.4 * n)), 2.4 * n, 0.3 * std::sin(n), 0.3 * std::cos(n));
    const HandRun run = followCompass(target, start, skin, static_cast<std::uint64_t>(n));
    EXPECT_TRUE(run.reached) << "from " << way << " mm, angle " << run.error.angle_deg << ", distance " << run.error.distance_mm;
    EXPECT_TRUE(isFound(planeError(target.plane, poseOf(run.end).probeToWorld), target.tolerance));
    EXPECT_LT(run.changesOfAdvice, 40) << "it chatters";
  }
}

TEST(CompassHands, ArriveOnFlatSkin) { expectHandsArrive(test::PlaneSkin(), 150.0, 20); }
TEST(CompassHands, ArriveAroundATrunk) { expectHandsArrive(test::CylinderSkin(120.0), 377.0, 30); }
TEST(CompassHands, ArriveFromTheOtherSideOfTheBody) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = test::targetAt(test::frontHold(skin), skin);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Hold start = test::frontHold(skin);
    start.contact = skin.nearest({0.5 * static_cast<double>(seed) - 2.5, 500.0, 10.0 * static_cast<double>(seed) - 50.0});
    const HandRun run = followCompass(target, start, skin, seed);
    EXPECT_TRUE(run.reached) << run.changesOfAdvice << " changes of advice";
  }
}
TEST(CompassHands, ArriveAroundABall) { expectHandsArrive(test::SphereSkin(90.0), 282.0, 20); }

TEST(CompassHands, ArriveAtThePlanesOfTheNeck) {
  const auto cases = shippedCasesFolder();
  const auto resources = resourceFolder();
  ASSERT_TRUE(cases && resources);
  const auto opened = loadCase(*cases / "neck-carotid-thyroid");
  ASSERT_TRUE(opened) << opened.error();
  const auto truth = loadCaseTruth(*opened, noProgress());
  ASSERT_TRUE(truth) << truth.error();
  const auto skin = readBodySkin(*resources / "mannequin" / opened->mannequin);
  ASSERT_TRUE(skin) << skin.error();
  ASSERT_GE(truth->planes.size(), 5U);
  for (const ReferencePlane& plane : truth->planes) {
    const CompassTarget target = compassTargetOf(targetOf(plane, *truth, 40.0), toleranceOf(plane), **skin);
    ASSERT_TRUE(target.reachable) << plane.name << ": " << target.left.angle_deg << " deg, " << target.left.distance_mm << " mm";
    const Hold start = turned(slid(target.hold, **skin, 25.0, 15.0), 2.0, 0.2, -0.2);
    EXPECT_TRUE(followCompass(target, start, **skin, 3).reached) << plane.name;
  }
}

}  // namespace
}  // namespace ew::compass_hands_test
