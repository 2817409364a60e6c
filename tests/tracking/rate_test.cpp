#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ew/tracking/rate_hand.h"
#include "skins.h"

namespace ew::rate_test {
namespace {

/// A tenth of what an axis can say, from -1 to 1.
std::vector<double> anyAxes() {
  std::vector<double> axes;
  for (std::size_t n = 0; n < kHandMotions; ++n) axes.push_back(0.1 * *rc::gen::inRange(-10, 11));
  return axes;
}

Hold onPlane() {
  Hold hold;
  hold.contact = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  hold.press_mm = 4.0;
  return hold;
}

Hold onCylinder() {
  Hold hold;
  hold.contact = {{0.0, -120.0, 0.0}, {0.0, -1.0, 0.0}};
  return hold;
}

/// The axes for a while, a fixed number of times a second.
Hold driven(RateHand hand, Hold hold, const Skin& skin, const std::vector<double>& axes, int ticks_hz, double time_s) {
  const int ticks = static_cast<int>(std::lround(time_s * ticks_hz));
  for (int n = 0; n < ticks; ++n) hold = hand.step(hold, skin, axes, 1.0 / ticks_hz);
  return hold;
}

double apart_mm(const Hold& a, const Hold& b) {
  return glm::distance(glm::dvec3(poseOf(a).probeToWorld.matrix[3]), glm::dvec3(poseOf(b).probeToWorld.matrix[3]));
}

}  // namespace

TEST(RateHand, FullDeflectionMovesAsFastAsTheOptionsSay) {
  RateHandOptions options = spaceMouseOptions();
  RateHand hand(options);
  const test::PlaneSkin skin;
  const Hold start = onPlane();
  const Hold slidAlong = driven(hand, start, skin, {1.0, 0, 0, 0, 0, 0}, 50, 0.5);
  EXPECT_NEAR(glm::distance(slidAlong.contact.point_mm, start.contact.point_mm), 40.0, 1e-9);
  EXPECT_NEAR(glm::dot(slidAlong.contact.point_mm - start.contact.point_mm, glm::dvec3(poseOf(start).probeToWorld.matrix[0])), -40.0, 1e-9)
      << "to the right of who stands in front: away from the marker";
  EXPECT_NEAR(driven(hand, start, skin, {0, -1.0, 0, 0, 0, 0}, 50, 0.5).press_mm, 4.0 + 7.5, 1e-9) << "pushed down it presses in";
  EXPECT_NEAR(driven(hand, start, skin, {0, 0, 0, 0, 1.0, 0}, 50, 0.5).rotation_rad, -0.6, 1e-9);
}

TEST(RateHand, RestsWithinItsDeadZoneAndOnNumbersThatAreNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const test::PlaneSkin skin;
  for (const RateMode mode : {RateMode::rate, RateMode::springBack}) {
    RateHand hand(spaceMouseOptions(mode));
    const std::vector<double> axes{0.07, -0.07, none, std::numeric_limits<double>::infinity(), 0.0};
    EXPECT_EQ(driven(hand, onPlane(), skin, axes, 60, 5.0), onPlane());
    EXPECT_TRUE(hand.isAtRest(axes));
  }
}

TEST(RateHand, SpringsBackToExactlyWhereItWasHeld) {
  RateHand hand(gameControllerOptions(RateMode::springBack));
  const test::CylinderSkin skin(120.0);
  Hold hold = onCylinder();
  const std::vector<double> pushed{1.0, -0.5, 0.3, 0.2, 1.0, 0.7}, released(6, 0.0);
  for (int n = 0; n < 60; ++n) hold = hand.step(hold, skin, pushed, 1.0 / 60);
  EXPECT_GT(apart_mm(hold, onCylinder()), 30.0);
  EXPECT_LT(glm::distance(hold.contact.point_mm, onCylinder().contact.point_mm), 60.0) << "it goes no further than it reaches";
  EXPECT_FALSE(hand.isAtRest(released));
  for (int n = 0; n < 120; ++n) hold = hand.step(hold, skin, released, 1.0 / 60);
  EXPECT_EQ(hold, onCylinder());
  EXPECT_TRUE(hand.isAtRest(released));
}

TEST(RateHand, SpringsBackToWhereTheMousePutItMeanwhile) {
  RateHand hand(spaceMouseOptions(RateMode::springBack));
  const test::PlaneSkin skin;
  Hold hold = onPlane();
  for (int n = 0; n < 30; ++n) hold = hand.step(hold, skin, std::vector<double>{1.0}, 1.0 / 60);
  Hold moved = onPlane();
  moved.contact.point_mm = {0.0, 70.0, 0.0};
  hold = moved;
  for (int n = 0; n < 120; ++n) hold = hand.step(hold, skin, std::vector<double>{0.0}, 1.0 / 60);
  EXPECT_EQ(hold, moved);
}

TEST(RateHand, DoesNotFlyAfterTheWindowHung) {
  RateHand hand(spaceMouseOptions());
  const test::PlaneSkin skin;
  const Hold after = hand.step(onPlane(), skin, std::vector<double>{1.0}, 60.0);
  EXPECT_LE(glm::distance(after.contact.point_mm, onPlane().contact.point_mm), 80.0 * 0.25 + 1e-9);
}

RC_GTEST_PROP(RateHand, GoesTheSameWayHoweverOftenItIsAsked, ()) {
  const auto axes = anyAxes();
  const auto mode = *rc::gen::element(RateMode::rate, RateMode::springBack);
  const RateHand hand(*rc::gen::arbitrary<bool>() ? spaceMouseOptions(mode) : gameControllerOptions(mode));
  const test::CylinderSkin skin(120.0);
  const Hold slow = driven(hand, onCylinder(), skin, axes, 10, 1.0);
  const Hold quick = driven(hand, onCylinder(), skin, axes, 100, 1.0);
  const Hold uneven = driven(hand, onCylinder(), skin, axes, 37, 1.0);
  RC_ASSERT(apart_mm(slow, quick) < 0.02);
  RC_ASSERT(apart_mm(uneven, quick) < 0.02);
  RC_ASSERT(std::abs(std::remainder(slow.rotation_rad - quick.rotation_rad, 2.0 * 3.14159265358979)) < 1e-6);
  RC_ASSERT(std::abs(slow.rock_rad - quick.rock_rad) < 1e-3);
  RC_ASSERT(std::abs(slow.tilt_rad - quick.tilt_rad) < 1e-3);
  RC_ASSERT(std::abs(slow.press_mm - quick.press_mm) < 1e-6);
}

RC_GTEST_PROP(RateHand, KeepsEveryHoldWithinWhatAHandCanDo, ()) {
  RateHand hand(gameControllerOptions(*rc::gen::element(RateMode::rate, RateMode::springBack)));
  const test::SphereSkin skin(90.0);
  Hold hold;
  hold.contact = {{0.0, -90.0, 0.0}, {0.0, -1.0, 0.0}};
  for (int turn = 0; turn < 12; ++turn) {
    const auto axes = anyAxes();
    const double dt_s = 0.001 * *rc::gen::inRange(0, 400);
    const glm::dvec3 before = hold.contact.point_mm;
    hold = hand.step(hold, skin, axes, dt_s);
    RC_ASSERT(hold.press_mm >= 0.0);
    RC_ASSERT(hold.press_mm <= kMaxPress_mm);
    RC_ASSERT(std::abs(hold.rock_rad) <= kMaxTip_rad + 1e-9);
    RC_ASSERT(std::abs(hold.tilt_rad) <= kMaxTip_rad + 1e-9);
    RC_ASSERT(std::abs(glm::length(hold.contact.point_mm) - 90.0) < 0.1);
    RC_ASSERT(std::isfinite(poseOf(hold).probeToWorld.matrix[3].x));
    RC_ASSERT(glm::distance(before, hold.contact.point_mm) < 120.0);
  }
}

RC_GTEST_PROP(RateHand, ShapesAnAxisSteadilyOddlyAndFullAtItsEnd, ()) {
  const double deadZone = 0.01 * *rc::gen::inRange(0, 90), curve = 0.1 * *rc::gen::inRange(10, 40);
  const double a = 0.001 * *rc::gen::inRange(-1500, 1501), b = 0.001 * *rc::gen::inRange(-1500, 1501);
  const double low = shapedAxis(std::min(a, b), deadZone, curve), high = shapedAxis(std::max(a, b), deadZone, curve);
  RC_ASSERT(low <= high);
  RC_ASSERT(shapedAxis(-a, deadZone, curve) == -shapedAxis(a, deadZone, curve));
  RC_ASSERT(shapedAxis(1.0, deadZone, curve) == 1.0);
  RC_ASSERT(std::abs(high) <= 1.0);
}

}  // namespace ew::rate_test
