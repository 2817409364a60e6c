#include "ew/tracking/hand.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/constants.hpp>

#include "tracking/skins.h"

namespace ew::hand_test {
namespace {

using test::CubeSkin;
using test::CylinderSkin;
using test::PlaneSkin;
using test::SphereSkin;

glm::dvec3 axisOf(const Pose& pose, int axis) { return glm::dvec3(pose.probeToWorld.matrix[axis]); }
glm::dvec3 originOf(const Pose& pose) { return axisOf(pose, 3); }
double largestDifference(const Pose& a, const Pose& b) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      largest = std::max(largest, std::abs(a.probeToWorld.matrix[column][row] - b.probeToWorld.matrix[column][row]));
  return largest;
}

/// On the front of a patient who faces -y.
Hold onTheFront() {
  Hold hold;
  hold.contact = {{0.0, -100.0, 0.0}, {0.0, -1.0, 0.0}};
  return hold;
}

double between(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) / 1e6; }

Hold anyHold(const Skin& skin) {
  Hold hold;
  glm::dvec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
  if (glm::length(p) < 1e-3) p = {0.0, -1.0, 0.0};
  hold.contact = skin.nearest(200.0 * p);
  hold.press_mm = between(0.0, 15.0);
  return turned(hold, between(-3.1, 3.1), between(-1.2, 1.2), between(-1.2, 1.2));
}

TEST(PoseOf, OnTheFrontTheMarkerPointsToThePatientsRightAndTheFanLooksBack) {
  const Pose pose = poseOf(onTheFront());
  EXPECT_EQ(axisOf(pose, 0), glm::dvec3(-1, 0, 0)) << "lateral";
  EXPECT_EQ(axisOf(pose, 1), glm::dvec3(0, 1, 0)) << "into the body";
  EXPECT_EQ(axisOf(pose, 2), glm::dvec3(0, 0, -1)) << "elevational, towards the feet";
  EXPECT_EQ(originOf(pose), glm::dvec3(0, -100, 0));
  EXPECT_EQ(pose.status, PoseStatus::ok);
}

TEST(PoseOf, RotatingByHalfATurnMirrorsLateralAndElevationalAxes) {
  const Pose before = poseOf(onTheFront());
  const Pose after = poseOf(turned(onTheFront(), glm::pi<double>(), 0.0, 0.0));
  EXPECT_LT(glm::length(axisOf(after, 0) + axisOf(before, 0)), 1e-12);
  EXPECT_LT(glm::length(axisOf(after, 1) - axisOf(before, 1)), 1e-12);
  EXPECT_LT(glm::length(axisOf(after, 2) + axisOf(before, 2)), 1e-12);
}

TEST(PoseOf, RockKeepsTheScanPlaneAndTiltKeepsTheLateralAxis) {
  const Pose before = poseOf(onTheFront());
  const Pose rocked = poseOf(turned(onTheFront(), 0.0, 0.4, 0.0));
  EXPECT_LT(glm::length(axisOf(rocked, 2) - axisOf(before, 2)), 1e-12) << "the plane's normal";
  EXPECT_NEAR(glm::dot(axisOf(rocked, 1), axisOf(before, 1)), std::cos(0.4), 1e-12);
  const Pose tilted = poseOf(turned(onTheFront(), 0.0, 0.0, 0.4));
  EXPECT_LT(glm::length(axisOf(tilted, 0) - axisOf(before, 0)), 1e-12);
  EXPECT_NEAR(glm::dot(axisOf(tilted, 1), axisOf(before, 1)), std::cos(0.4), 1e-12);
}

RC_GTEST_PROP(PoseOf, IsRigidAndLiesThePressBelowTheContactWhateverTheHold, ()) {
  const Hold hold = anyHold(SphereSkin(120.0));
  const Pose pose = poseOf(hold);
  RC_ASSERT(checkRigid(pose.probeToWorld.matrix, 1e-9).has_value());
  RC_ASSERT(glm::distance(originOf(pose), hold.contact.point_mm - hold.press_mm * hold.contact.outward) < 1e-12);
  RC_ASSERT(glm::dot(axisOf(pose, 1), -hold.contact.outward) >= std::cos(kMaxTip_rad) - 1e-9);
}

TEST(PoseOf, PressesAgainstTheNormalEvenWhenTheBeamIsTippedAndNeverOutOfTheBody) {
  Hold hold = turned(onTheFront(), 0.7, 0.3, -0.2);
  hold.press_mm = 6.0;
  EXPECT_EQ(originOf(poseOf(hold)), glm::dvec3(0, -94, 0));
  EXPECT_EQ(originOf(uprightPoseOf(hold)), glm::dvec3(0, -94, 0));
  hold.press_mm = -3.0;
  EXPECT_EQ(originOf(poseOf(hold)), glm::dvec3(0, -100, 0));
  hold.press_mm = 1e9;
  EXPECT_EQ(originOf(poseOf(hold)), glm::dvec3(0, -100 + kMaxPress_mm, 0));
}

TEST(Turned, StopsAtTheLargestTipAndComesBackFromThereAtOnce) {
  Hold hold = onTheFront();
  for (int i = 0; i < 200; ++i) hold = turned(hold, 0.0, 0.05, 0.03);
  const double tip_rad = std::acos(glm::dot(axisOf(poseOf(hold), 1), -hold.contact.outward));
  EXPECT_NEAR(tip_rad, kMaxTip_rad, 1e-9);
  EXPECT_EQ(turned(hold, 0.0, 0.0, 0.0), hold) << "the limit itself is not shortened again";
  const Hold back = turned(hold, 0.0, -0.1, 0.0);
  EXPECT_LT(std::acos(glm::dot(axisOf(poseOf(back), 1), -back.contact.outward)), kMaxTip_rad - 0.01);
  EXPECT_DOUBLE_EQ(turned(onTheFront(), 0.0, 9.0, 0.0).rock_rad, kMaxTip_rad);
}

TEST(Turned, KeepsTheRotationWithinHalfATurn) {
  Hold hold = onTheFront();
  for (int i = 0; i < 1000; ++i) hold = turned(hold, 0.1, 0.0, 0.0);
  EXPECT_LE(std::abs(hold.rotation_rad), glm::pi<double>());
  EXPECT_NEAR(std::cos(hold.rotation_rad), std::cos(100.0), 1e-9);
}

TEST(Slid, OnAPlaneMovesByExactlyTheAskedVector) {
  Hold hold;
  hold.contact = {{5.0, 7.0, 0.0}, {0.0, 0.0, 1.0}};
  hold.rotation_rad = 0.3;
  hold.press_mm = 4.0;
  const Pose before = poseOf(hold);
  const Hold moved = slid(hold, PlaneSkin(), 12.5, -3.25);
  const glm::dvec3 expected = originOf(before) + 12.5 * axisOf(before, 0) - 3.25 * axisOf(before, 2);
  EXPECT_LT(glm::distance(originOf(poseOf(moved)), expected), 1e-9);
  EXPECT_EQ(moved.rotation_rad, hold.rotation_rad);
  EXPECT_EQ(moved.press_mm, 4.0) << "the hand presses on while it slides";
  EXPECT_LT(glm::length(axisOf(poseOf(moved), 0) - axisOf(before, 0)), 1e-12);
}

RC_GTEST_PROP(Slid, OnASphereMovesAlongAnArcOfTheAskedLength, ()) {
  const double radius_mm = between(60.0, 300.0);
  const SphereSkin skin(radius_mm);
  const Hold hold = anyHold(skin);
  const double direction = between(-3.14, 3.14);
  const Hold moved = slid(hold, skin, 10.0 * std::cos(direction), 10.0 * std::sin(direction));
  const double arc_mm = radius_mm * std::acos(std::clamp(glm::dot(hold.contact.outward, moved.contact.outward), -1.0, 1.0));
  RC_ASSERT(std::abs(arc_mm - 10.0) < 1e-6);
  RC_ASSERT(std::abs(glm::length(moved.contact.point_mm) - radius_mm) < 1e-6);
  // It leaves along the direction asked for: the arc lies in the plane of the normal and that direction.
  const Pose upright = uprightPoseOf(hold);
  const glm::dvec3 along = std::cos(direction) * axisOf(upright, 0) + std::sin(direction) * axisOf(upright, 2);
  RC_ASSERT(std::abs(glm::dot(moved.contact.outward, glm::cross(hold.contact.outward, along))) < 1e-9);
}

TEST(Slid, GoesAllTheWayAroundASphereAndComesHome) {
  const SphereSkin skin(100.0);
  const Hold start = onTheFront();
  Hold hold = start;
  const int steps = 100;
  for (int i = 0; i < steps; ++i) hold = slid(hold, skin, glm::two_pi<double>() * 100.0 / steps, 0.0);
  EXPECT_LT(glm::distance(hold.contact.point_mm, start.contact.point_mm), 1e-5);
  EXPECT_LT(largestDifference(poseOf(hold), poseOf(start)), 1e-5) << "around the flanks, where the first hint meets the normal";
}

TEST(Slid, AroundATrunkTheMarkerKeepsPointingAroundIt) {
  const CylinderSkin skin(150.0);
  Hold hold = onTheFront();
  hold.contact = skin.nearest({0.0, -150.0, 40.0});
  hold = slid(hold, skin, glm::half_pi<double>() * 150.0, 0.0);
  EXPECT_LT(glm::distance(hold.contact.point_mm, glm::dvec3(-150.0, 0.0, 40.0)), 1e-6) << "the patient's right flank";
  EXPECT_LT(glm::length(axisOf(poseOf(hold), 0) - glm::dvec3(0.0, 1.0, 0.0)), 1e-6) << "now posterior";
  hold = slid(hold, skin, glm::half_pi<double>() * 150.0, 25.0);
  EXPECT_NEAR(hold.contact.point_mm.z, 40.0 - 25.0, 1e-3) << "a helix of 237 mm";
}

RC_GTEST_PROP(Slid, ThereAndBackIsWhereItBegan, ()) {
  const SphereSkin skin(130.0);
  const Hold hold = anyHold(skin);
  const double lateral_mm = between(-30.0, 30.0);
  const double elevational_mm = between(-30.0, 30.0);
  const Hold back = slid(slid(hold, skin, lateral_mm, elevational_mm), skin, -lateral_mm, -elevational_mm);
  RC_ASSERT(largestDifference(poseOf(back), poseOf(hold)) < 1e-5);
}

TEST(Slid, CrossesTheSharpEdgesOfACube) {
  const CubeSkin skin(50.0);
  Hold hold;
  hold.contact = skin.nearest({0.0, -60.0, 3.0});
  double farthest_mm = 0.0;
  int faces = 0;
  glm::dvec3 last = hold.contact.outward;
  for (int i = 0; i < 500; ++i) {
    const Hold next = slid(hold, skin, 1.0, 0.0);
    farthest_mm = std::max(farthest_mm, glm::distance(next.contact.point_mm, hold.contact.point_mm));
    EXPECT_LT(skin.distance_mm(next.contact.point_mm), 1e-6) << "step " << i;
    EXPECT_NE(next.contact.point_mm, hold.contact.point_mm) << "stuck at step " << i;
    faces += next.contact.outward != last ? 1 : 0;
    last = next.contact.outward;
    hold = next;
  }
  EXPECT_GE(faces, 4) << "once around";
  EXPECT_LT(farthest_mm, 3.0);
}

TEST(Slid, ClimbsOutOfAConcaveCorner) {
  const test::CornerSkin skin;
  Hold hold;
  hold.contact = skin.nearest({5.0, 0.0, 0.0});
  hold = slid(hold, skin, 10.0, 0.0);  // the marker points to -x: into the wall
  EXPECT_NEAR(hold.contact.point_mm.x, 0.0, 1e-9);
  EXPECT_GT(hold.contact.point_mm.z, 3.0) << "about five millimetres up the wall";
}

TEST(Slid, ZeroIsTheSameHold) { EXPECT_EQ(slid(onTheFront(), SphereSkin(100.0), 0.0, 0.0), onTheFront()); }

TEST(MovedTo, KeepsTheAngles) {
  const SphereSkin skin(100.0);
  const Hold hold = turned(onTheFront(), 0.5, 0.2, -0.3);
  const Hold moved = movedTo(hold, skin.nearest({30.0, -80.0, 40.0}));
  EXPECT_EQ(moved.rotation_rad, hold.rotation_rad);
  EXPECT_EQ(moved.rock_rad, hold.rock_rad);
  EXPECT_EQ(moved.tilt_rad, hold.tilt_rad);
  EXPECT_EQ(moved.contact, skin.nearest({30.0, -80.0, 40.0}));
}

TEST(MovedTo, FromTheFrontToTheBackTurnsAboutTheBodysLongAxis) {
  const Hold back = movedTo(onTheFront(), {{0.0, 100.0, 0.0}, {0.0, 1.0, 0.0}});
  EXPECT_LT(glm::length(axisOf(poseOf(back), 0) - glm::dvec3(1.0, 0.0, 0.0)), 1e-12);
  EXPECT_LT(glm::length(axisOf(poseOf(back), 2) - glm::dvec3(0.0, 0.0, -1.0)), 1e-12);
}

RC_GTEST_PROP(HoldFor, ReproducesThePoseOfAnyHold, ()) {
  const SphereSkin skin(140.0);
  const Hold hold = anyHold(skin);
  const Hold found = holdFor(poseOf(hold), skin);
  RC_ASSERT(largestDifference(poseOf(found), poseOf(hold)) < 1e-7);
}

TEST(HoldFor, FindsTheVeryAnglesWhereTheHintIsTheUsualOne) {
  const SphereSkin skin(140.0);
  Hold hold;
  hold.contact = skin.nearest({30.0, -100.0, 20.0});
  hold = turned(hold, 1.1, -0.3, 0.6);
  const Hold found = holdFor(poseOf(hold), skin);
  EXPECT_NEAR(found.rotation_rad, 1.1, 1e-9);
  EXPECT_NEAR(found.rock_rad, -0.3, 1e-9);
  EXPECT_NEAR(found.tilt_rad, 0.6, 1e-9);
}

TEST(HoldFor, RecoversThePressWhereSmoothedNormalsLeanAwayFromTheSurface) {
  const test::LeaningSkin skin;
  for (const double press_mm : {0.0, 0.5, 5.0, 12.0, kMaxPress_mm}) {
    for (double x_mm = -40.0; x_mm <= 40.0; x_mm += 5.0) {
      Hold hold;
      hold.contact = skin.nearest({x_mm, 3.0, 1.0});
      hold.press_mm = press_mm;
      const Hold found = holdFor(poseOf(hold), skin);
      EXPECT_NEAR(found.press_mm, press_mm, 1e-6) << "at " << x_mm;
      EXPECT_LT(largestDifference(poseOf(found), poseOf(hold)), 1e-6) << "at " << x_mm << " pressed " << press_mm;
    }
  }
}

TEST(HoldFor, TakesNoMorePressFromADeepPoseThanAHandCanGive) {
  Pose pose = poseOf(onTheFront());
  pose.probeToWorld.matrix[3] = glm::dvec4(0.0, -50.0, 0.0, 1.0);
  const Hold found = holdFor(pose, SphereSkin(100.0));
  EXPECT_EQ(found.press_mm, kMaxPress_mm);
  EXPECT_LT(glm::distance(found.contact.point_mm, glm::dvec3(0.0, -100.0, 0.0)), 1e-9);
}

TEST(HoldFor, PutsAProbeHeldInTheAirOnTheSkinBelowIt) {
  const SphereSkin skin(100.0);
  Pose pose = poseOf(onTheFront());
  pose.probeToWorld.matrix[3] = glm::dvec4(0.0, -180.0, 0.0, 1.0);
  const Hold found = holdFor(pose, skin);
  EXPECT_LT(glm::distance(found.contact.point_mm, glm::dvec3(0.0, -100.0, 0.0)), 1e-9);
  EXPECT_EQ(found.press_mm, 0.0);
}

}  // namespace
}  // namespace ew::hand_test
