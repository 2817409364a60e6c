#include "ew/imaging/adaptive_quality.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>

namespace ew::adaptive_quality_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kFrame_s = 0.02;

Pose poseAt(double x_mm, double rotation_rad = 0.0) {
  Pose pose;
  pose.probeToWorld.matrix = glm::rotate(glm::translate(glm::dmat4(1.0), {x_mm, 0.0, 0.0}), rotation_rad, {0.0, 1.0, 0.0});
  return pose;
}

/// A probe that moves on frame by frame.
struct Sweep {
  AdaptiveQuality quality;
  Knobs asked = {.elevationPlanes = 9, .quality = Quality::cubic};
  double time_s = 0.0, x_mm = 0.0, rotation_rad = 0.0;
  Knobs step(double speed_mmPerS, double lastFrame_ms, double turn_radPerS = 0.0) {
    time_s += kFrame_s;
    x_mm += speed_mmPerS * kFrame_s;
    rotation_rad += turn_radPerS * kFrame_s;
    return quality.step(asked, poseAt(x_mm, rotation_rad), time_s, lastFrame_ms);
  }
};

/// How much work a setting is, in the order in which it is lowered.
int workOf(const Knobs& knobs) { return 10 * static_cast<int>(knobs.quality) + knobs.elevationPlanes; }

TEST(AdaptiveQuality, LowersLiveEchoesAtOnceWithoutPlanesToLeaveOut) {
  AdaptiveQuality quality;
  Knobs asked;
  ASSERT_EQ(asked.quality, Quality::linear);
  ASSERT_GT(asked.elevationPlanes, 3);
  Knobs used;
  for (int n = 0; n < 3; ++n) used = quality.step(asked, poseAt(2.0 * n), 0.02 * n, 15.0, false);
  EXPECT_EQ(used.quality, Quality::weave) << "the first frame beyond the budget";
  EXPECT_EQ(used.elevationPlanes, asked.elevationPlanes);
}

TEST(AdaptiveQuality, KeepsWhatIsAskedWhileTheProbeMovesSlowlyHoweverLongFramesTake) {
  Sweep sweep;
  for (int n = 0; n < 100; ++n) {
    EXPECT_EQ(sweep.step(20.0, 500.0, 0.3), sweep.asked);
    EXPECT_FALSE(sweep.quality.isLowered());
  }
}

TEST(AdaptiveQuality, KeepsWhatIsAskedWhileFramesAreInTimeHoweverFastTheProbeMoves) {
  Sweep sweep;
  for (int n = 0; n < 100; ++n) EXPECT_EQ(sweep.step(500.0, 12.0, 3.0), sweep.asked);
}

TEST(AdaptiveQuality, LowersStepByStepFromCubicToLinearThenThePlanesThenToWeave) {
  for (const bool turning : {false, true}) {
    Sweep sweep;
    EXPECT_EQ(sweep.step(0.0, 0.0), sweep.asked);
    const auto next = [&] { return sweep.step(turning ? 0.0 : 40.0, 13.0, turning ? 0.5 : 0.0); };
    for (const auto& [quality, planes] : {std::pair{Quality::linear, 9}, std::pair{Quality::linear, 7}, std::pair{Quality::linear, 5},
                                          std::pair{Quality::linear, 3}, std::pair{Quality::weave, 3}, std::pair{Quality::weave, 3}}) {
      Knobs expected = sweep.asked;
      expected.quality = quality;
      expected.elevationPlanes = planes;
      EXPECT_EQ(next(), expected);
      EXPECT_TRUE(sweep.quality.isLowered());
    }
  }
}

TEST(AdaptiveQuality, LowersTwoStepsAtOnceForAFrameOfMoreThanTwiceTheBudget) {
  Sweep sweep;
  (void)sweep.step(0.0, 0.0);
  const Knobs lowered = sweep.step(40.0, 25.0);
  EXPECT_EQ(lowered.quality, Quality::linear);
  EXPECT_EQ(lowered.elevationPlanes, 7);
}

TEST(AdaptiveQuality, ReturnsAtOnceToWhatIsAskedAfterTheProbeSettled) {
  Sweep sweep;
  (void)sweep.step(0.0, 0.0);
  for (int n = 0; n < 10; ++n) (void)sweep.step(100.0, 100.0);
  const Knobs lowest = sweep.step(100.0, 5.0);
  EXPECT_EQ(workOf(lowest), 3);
  for (int n = 1; n * kFrame_s < 0.15 - 1e-9; ++n) EXPECT_EQ(sweep.step(0.0, 5.0), lowest) << n;
  EXPECT_EQ(sweep.step(0.0, 5.0), sweep.asked);
  EXPECT_FALSE(sweep.quality.isLowered());
  EXPECT_EQ(sweep.step(0.0, 400.0), sweep.asked) << "at rest a frame may take as long as it wants";
}

TEST(AdaptiveQuality, DoesNotFlickerWhenSpeedAndTimesHoverAboutTheirThresholds) {
  Sweep sweep;
  sweep.asked.elevationPlanes = 5;
  (void)sweep.step(0.0, 0.0);
  int changes = 0;
  Knobs before = sweep.asked;
  for (int n = 0; n < 1000; ++n) {
    const Knobs now = sweep.step(25.0 + (n % 2 ? 2.0 : -2.0) + 8.0 * std::sin(0.05 * n), 12.0 + (n % 3 ? 0.5 : -0.5));
    changes += !(now == before);
    EXPECT_LE(workOf(now), workOf(before)) << "monotone while it moves";
    before = now;
  }
  EXPECT_LE(changes, 3);
}

TEST(AdaptiveQuality, TakesFramesWithoutANewPoseForNoRest) {
  Sweep sweep;
  (void)sweep.step(0.0, 0.0);
  for (int n = 0; n < 10; ++n) (void)sweep.step(100.0, 100.0);
  // Two frames for each pose of the tracker.
  for (int n = 0; n < 50; ++n) EXPECT_EQ(workOf(sweep.step(n % 2 ? 100.0 : 0.0, 5.0)), 3);
}

TEST(AdaptiveQuality, SeesHalfATurnAndNotTheSignOfAQuaternion) {
  AdaptiveQuality quality;
  Knobs asked;
  const auto poseOf = [](const glm::dquat& turn) {
    Pose pose;
    pose.probeToWorld.matrix = glm::mat4_cast(turn);
    return pose;
  };
  const glm::dquat turn = glm::angleAxis(1.0, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)));
  (void)quality.step(asked, poseOf(turn), 0.0, 100.0);
  EXPECT_EQ(quality.step(asked, poseOf(-turn), 0.02, 100.0), asked) << "the same rotation";
  EXPECT_NE(quality.step(asked, poseOf(turn * glm::angleAxis(std::numbers::pi, glm::dvec3(0, 0, 1))), 0.04, 100.0), asked);
  quality.reset();
  EXPECT_FALSE(quality.isLowered());
  EXPECT_EQ(quality.step(asked, poseOf(turn), 0.06, 100.0), asked) << "nothing is remembered";
}

TEST(AdaptiveQuality, TakesAPoseThatCannotBeUsedForRestAndNotForAJump) {
  for (const bool lost : {true, false}) {
    Sweep sweep;
    (void)sweep.step(0.0, 0.0);
    Pose none = poseAt(kNan);
    if (lost) {
      none = poseAt(900.0);
      none.status = PoseStatus::missing;
    }
    EXPECT_EQ(sweep.quality.step(sweep.asked, none, sweep.time_s + 0.01, 100.0), sweep.asked);
    EXPECT_EQ(sweep.step(0.0, 100.0), sweep.asked) << "the pose before is remembered";
    for (int n = 0; n < 10; ++n) (void)sweep.step(100.0, 100.0);
    EXPECT_TRUE(sweep.quality.isLowered());
    for (int n = 1; n <= 8; ++n) (void)sweep.quality.step(sweep.asked, none, sweep.time_s + 0.02 * n, 100.0);
    EXPECT_FALSE(sweep.quality.isLowered());
  }
}

TEST(AdaptiveQuality, TakesTimesThatStandStillRunBackwardsOrAreNoneForRestThatLastsNoTime) {
  for (const double time_s : {1.0, 0.5, -1e9, kNan, std::numeric_limits<double>::infinity()}) {
    AdaptiveQuality quality;
    const Knobs asked;
    (void)quality.step(asked, poseAt(0.0), 1.0, 0.0);
    EXPECT_EQ(quality.step(asked, poseAt(500.0), time_s, 100.0), asked);
  }
  Sweep sweep;
  (void)sweep.step(0.0, 0.0);
  for (int n = 0; n < 10; ++n) (void)sweep.step(100.0, 100.0);
  for (int n = 0; n < 100; ++n) {
    sweep.time_s -= kFrame_s;
    (void)sweep.step(0.0, 100.0);
    EXPECT_TRUE(sweep.quality.isLowered());
  }
  for (int n = 0; n < 8; ++n) (void)sweep.step(0.0, 100.0);
  EXPECT_FALSE(sweep.quality.isLowered());
}

TEST(AdaptiveQuality, HasNothingToLowerBelowTheLeastWork) {
  Sweep sweep;
  sweep.asked = {.elevationPlanes = 3, .quality = Quality::weave};
  for (int n = 0; n < 10; ++n) {
    EXPECT_EQ(sweep.step(100.0, 1000.0), sweep.asked);
    EXPECT_FALSE(sweep.quality.isLowered());
  }
}

RC_GTEST_PROP(AdaptiveQuality, ChangesNothingButQualityAndPlanesAndNeverRaisesThem, ()) {
  Sweep sweep;
  sweep.asked.gain = 1.7;
  sweep.asked.quality = *rc::gen::element(Quality::weave, Quality::linear, Quality::cubic);
  sweep.asked.elevationPlanes = *rc::gen::inRange(-1, 12);
  for (int n = 0; n < 60; ++n) {
    const Knobs got = sweep.step(*rc::gen::inRange(0, 90), *rc::gen::element(0.0, 5.0, 13.0, 30.0, 1e300, kNan));
    RC_ASSERT(static_cast<int>(got.quality) <= static_cast<int>(sweep.asked.quality));
    RC_ASSERT(got.elevationPlanes <= sweep.asked.elevationPlanes);
    RC_ASSERT((got == sweep.asked) == !sweep.quality.isLowered());
    Knobs restored = got;
    restored.quality = sweep.asked.quality;
    restored.elevationPlanes = sweep.asked.elevationPlanes;
    RC_ASSERT(restored == sweep.asked);
  }
}

}  // namespace
}  // namespace ew::adaptive_quality_test
