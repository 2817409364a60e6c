#include "ew/phantom/motion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "recipes.h"

namespace ew::motion_test {
namespace {

const Patient& beating() {
  static const auto patient = testing::patientOf(testing::patientRecipe(
      R"({"name": "spine", "tissue": "dark", "shape": {"capsule": {"from_mm": [0, 30, -60], "to_mm": [0, 30, 60], "from_radius_mm": 8, "to_radius_mm": 8}}},
         {"name": "vessel", "tissue": "dark", "shape": {"tube": {"points": [[4, 2, -50, 9], [0, 0, 0, 10], [3, -3, 50, 9]]}}})",
      R"("motion": {"breathing": {"displacement_mm": [0, -3, -14], "held_depth_mm": 5, "free_depth_mm": 30, "held_by": ["spine"]},
                    "pulse": {"beats_per_minute": 75, "variation": 0.1, "vessels": [{"of": "vessel", "diameter_growth_mm": 2, "reach_mm": 15}]}},)"));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return **patient;
}

glm::dvec3 placeIn(const Bounds& box) {
  glm::dvec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    const double t = static_cast<double>(*rc::gen::inRange(0, 100001)) / 1e5;
    place[axis] = box.lowest_mm[axis] + t * (box.highest_mm[axis] - box.lowest_mm[axis]);
  }
  return place;
}

BodyState anyState() {
  return {static_cast<double>(*rc::gen::inRange(0, 101)) / 100.0, static_cast<double>(*rc::gen::inRange(0, 101)) / 100.0};
}

void expectInverse(const Deformation& motion, const glm::dvec3& p) {
  RC_ASSERT(glm::distance(motion.rest(motion.moved(p)), p) < 0.01);
  RC_ASSERT(glm::distance(motion.moved(motion.rest(p)), p) < 0.01);
  RC_ASSERT(glm::distance(motion.moved(p), p) <= motion.reach_mm() + 1e-9);
}

double jacobian(const Deformation& motion, const glm::dvec3& p) {
  constexpr double kStep_mm = 0.05;
  glm::dmat3 columns;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = kStep_mm;
    columns[axis] = (motion.moved(p + step) - motion.moved(p - step)) / (2.0 * kStep_mm);
  }
  return glm::determinant(columns);
}

RC_GTEST_PROP(BodyMotion, HasAnInverseWithinAHundredthOfAMillimetre, ()) {
  expectInverse(*bodyMotion(beating(), anyState()), placeIn({glm::dvec3(-70), glm::dvec3(70)}));
}

RC_GTEST_PROP(BodyMotion, NeverFoldsTissue, ()) {
  RC_ASSERT(jacobian(*bodyMotion(beating(), anyState()), placeIn({glm::dvec3(-70), glm::dvec3(70)})) > 0.1);
}

RC_GTEST_PROP(ShippedMotion, HasAnInverseAndNeverFolds, ()) {
  const auto motion = bodyMotion(testing::shipped(), anyState());
  const glm::dvec3 p = placeIn(boxOf(testing::shipped()));
  expectInverse(*motion, p);
  RC_ASSERT(jacobian(*motion, p) > 0.1);
}

RC_GTEST_PROP(BodyMotion, MovesNeighboursAlike, ()) {
  const auto motion = bodyMotion(beating(), anyState());
  const glm::dvec3 p = placeIn({glm::dvec3(-70), glm::dvec3(70)});
  const glm::dvec3 step = 0.01 * glm::normalize(placeIn({glm::dvec3(-1), glm::dvec3(1)}) + glm::dvec3(0, 0, 1e-6));
  RC_ASSERT(glm::distance(motion->moved(p + step), motion->moved(p)) < 0.05);
}

TEST(BodyMotion, IsNoneAtRest) {
  const auto motion = bodyMotion(beating(), {});
  EXPECT_EQ(motion->reach_mm(), 0.0);
  for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(9, -20, 13)}) {
    EXPECT_EQ(motion->moved(p), p);
    EXPECT_EQ(motion->rest(p), p);
  }
}

TEST(BodyMotion, WidensAVesselByExactlyWhatTheRecipeSays) {
  for (const double pulse : {0.5, 1.0}) {
    const auto motion = bodyMotion(beating(), {0.0, pulse});
    const double left = motion->moved({10, 0, 0}).x, right = motion->moved({-10, 0, 0}).x;
    EXPECT_NEAR(left - right, 20.0 + 2.0 * pulse, 1e-9);
    EXPECT_EQ(motion->moved({0, 0, 0}), glm::dvec3(0));
    const glm::dvec3 far(25.5, 0, 0);
    EXPECT_EQ(motion->moved(far), far) << "beyond its reach nothing is pushed";
    EXPECT_GT(motion->moved({15, 0, 0}).x, 15.0);
    EXPECT_LT(motion->moved({15, 0, 0}).x - 15.0, left - 10.0) << "less with distance";
  }
}

TEST(BodyMotion, HoldsSkinAndSpineWhileOrgansGoDown) {
  const auto motion = bodyMotion(beating(), {1.0, 0.0});
  for (const glm::dvec3& p : {glm::dvec3(0, -58, 0), glm::dvec3(57, 0, 0), glm::dvec3(0, 30, 10)})
    EXPECT_LT(glm::distance(motion->moved(p), p), 0.05) << p.x << " " << p.y;
  EXPECT_NEAR(motion->moved({0, -10, 0}).z, -14.0, 0.5);
}

TEST(ShippedMotion, MovesTheLiverDownAndLeavesRibsAndSpineAlone) {
  const auto motion = bodyMotion(testing::shipped(), {1.0, 1.0});
  EXPECT_TRUE(moves(testing::shipped()));
  EXPECT_NEAR(motion->moved({-60, 0, 0}).z, -15.0, 0.2);
  const glm::dvec3 kidney(-66, 40, -76), body(0, 55, -34);
  EXPECT_LT(motion->moved(kidney).z - kidney.z, -8.0);
  EXPECT_LT(glm::distance(motion->moved(body), body), 0.6) << "the aorta in front of it pushes a little";
}

TEST(Rhythms, RestAtTheBeginningAndGiveTheSameStateAtTheSameTime) {
  EXPECT_EQ(stateAt(beating(), 3.3), stateAt(beating(), 3.3));
  for (double t = -9.0; t < 9.0; t += 0.01) {
    const BodyState state = stateAt(beating(), t), next = stateAt(beating(), t + 0.001);
    EXPECT_TRUE(state.breath >= 0.0 && state.breath <= 1.0 && state.pulse >= 0.0 && state.pulse <= 1.0);
    EXPECT_LT(std::abs(next.breath - state.breath), 0.003) << t;
    EXPECT_LT(std::abs(next.pulse - state.pulse), 0.03) << t;
  }
}

TEST(Rhythms, BreatheEveryFourSecondsWithAPauseOfThreeTenths) {
  int resting = 0, full = 0;
  for (int n = 0; n < 4000; ++n) {
    const double breath = stateAt(testing::shipped(), 0.004 * n).breath;
    resting += breath < 1e-3;
    full += breath > 0.999;
    EXPECT_NEAR(breath, stateAt(testing::shipped(), 0.004 * n + 4.0).breath, 1e-9);
  }
  EXPECT_NEAR(resting / 4000.0, 0.3 + 0.7 * 0.02, 0.01);
  EXPECT_GT(full, 0);
}

TEST(Electrocardiogram, HasAnRPeakOfOneMillivoltAtEachBeat) {
  int peaks = 0;
  double before = ecgAt_mv(beating(), -0.002), now = ecgAt_mv(beating(), -0.001), last_s = -1.0;
  for (int n = 0; n < 16000; ++n) {
    const double after = ecgAt_mv(beating(), 0.001 * n);
    if (now > 0.5 && now > before && now >= after) {
      ++peaks;
      EXPECT_NEAR(now, 1.0, 0.01);
      const double at_s = 0.001 * (n - 1);
      if (last_s >= 0.0) {
        EXPECT_NEAR(at_s - last_s, 0.8, 0.8 * 0.1 + 0.002);
      }
      last_s = at_s;
      EXPECT_EQ(stateAt(beating(), at_s).pulse < 0.02, true) << "the vessel widens after the R peak";
    }
    before = now;
    now = after;
  }
  EXPECT_NEAR(peaks, 20, 1);
}

TEST(Electrocardiogram, IsFlatWithoutAPulse) {
  const auto patient = testing::patientOf(testing::patientRecipe(R"({"name": "all", "tissue": "dark", "shape": {"of": "skin surface"}})"));
  ASSERT_TRUE(patient);
  EXPECT_FALSE(moves(**patient));
  for (double t = 0.0; t < 2.0; t += 0.05) EXPECT_EQ(ecgAt_mv(**patient, t), 0.0);
}

}  // namespace
}  // namespace ew::motion_test
