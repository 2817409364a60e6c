#include "ew/assessment/compass.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <numbers>

#include "../tracking/skins.h"
#include "assessment/compass_holds.h"

namespace ew {
namespace {

using test::frontHold;
using test::targetAt;

TEST(Compass, KnowsThatAPlaneOfAHoldIsReached) {
  const test::CylinderSkin skin(120.0);
  const Hold hold = turned(slid(frontHold(skin), skin, 40.0, 30.0), 0.4, 0.2, -0.3);
  const CompassTarget target = targetAt(hold, skin);
  EXPECT_TRUE(target.reachable);
  EXPECT_LT(target.left.angle_deg, 1e-6);
  const CompassAdvice advice = nextMovement(target, hold);
  EXPECT_EQ(advice.movement, HandMovement::stay);
  EXPECT_EQ(advice.text.english(), "You are there: hold the probe still.");
}

TEST(Compass, NamesThePatientsSides) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const auto from = [&](double right_mm, double feet_mm) {
    // Upright and unturned the marker, x, points to the patient's right, and z to the feet or head.
    Hold hold = frontHold(skin);
    hold.contact = skin.nearest(hold.contact.point_mm + glm::dvec3(-right_mm, 0.0, -feet_mm));
    return nextMovement(target, hold);
  };
  EXPECT_EQ(from(0.0, 60.0).text.english(), "Slide 60 mm towards the patient's head.");
  EXPECT_EQ(from(0.0, -60.0).text.english(), "Slide 60 mm towards the patient's feet.");
  EXPECT_EQ(from(40.0, 0.0).towards, PatientSide::left);
  EXPECT_EQ(from(-40.0, 0.0).towards, PatientSide::right);
  EXPECT_EQ(from(0.0, 60.0).movement, HandMovement::slide);
}

TEST(Compass, SlidesToTheRegionThenRotatesThenTips) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const Hold turnedAway = turned(frontHold(skin), 1.0, 0.4, 0.4);
  EXPECT_EQ(nextMovement(target, slid(turnedAway, skin, 80.0, 0.0)).movement, HandMovement::slide);
  EXPECT_EQ(nextMovement(target, slid(turnedAway, skin, 10.0, 0.0)).movement, HandMovement::rotate);
  EXPECT_EQ(nextMovement(target, turned(frontHold(skin), 0.0, 0.4, 0.4)).movement, HandMovement::tilt);
  EXPECT_EQ(nextMovement(target, turned(frontHold(skin), 0.0, 0.4, 0.0)).movement, HandMovement::rock);
}

TEST(Compass, NearATargetSlidesAcrossThePlaneBeforeAlongIt) {
  const test::PlaneSkin skin;
  // Lengthwise: the plane holds the way from head to feet.
  const Hold lengthwise = turned(frontHold(skin), std::numbers::pi / 2.0, 0.0, 0.0);
  const CompassTarget target = targetAt(lengthwise, skin);
  Hold now = lengthwise;
  now.contact = skin.nearest(now.contact.point_mm + glm::dvec3(7.0, 0.0, 12.0));
  const CompassAdvice advice = nextMovement(target, now);
  ASSERT_EQ(advice.movement, HandMovement::slide);
  EXPECT_EQ(advice.towards, PatientSide::right) << advice.text.english();
  EXPECT_EQ(advice.amount, 7.0);
  // What has gone the right way already is not sent along the plane either.
  now.contact = skin.nearest(lengthwise.contact.point_mm + glm::dvec3(0.0, 0.0, 9.0));
  EXPECT_EQ(nextMovement(target, now).movement, HandMovement::stay);
}

TEST(Compass, SaysWhichWayToTurnAsSeenFromAboveTheProbe) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const CompassAdvice advice = nextMovement(target, turned(frontHold(skin), 0.7, 0.0, 0.0));
  EXPECT_EQ(advice.text.english(), "Rotate anticlockwise by 40 degrees.");
  // The probe stands on the front of a patient seen from the front: right lies left, head lies up. Clockwise takes the marker from the
  // patient's right to the head.
  const glm::dvec3 marker(poseOf(turned(frontHold(skin), std::numbers::pi / 2.0, 0.0, 0.0)).probeToWorld.matrix[0]);
  EXPECT_NEAR(marker.z, 1.0, 1e-9);
}

TEST(Compass, SaysWhereTheBeamIsToTip) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const Hold fanned = turned(frontHold(skin), 0.0, 0.0, 0.5);
  const glm::dvec3 beam(poseOf(fanned).probeToWorld.matrix[1]);
  const CompassAdvice tilt = nextMovement(target, fanned);
  ASSERT_EQ(tilt.movement, HandMovement::tilt);
  EXPECT_EQ(tilt.towards, beam.z > 0.0 ? PatientSide::feet : PatientSide::head);
  const Hold rocked = turned(frontHold(skin), 0.0, 0.5, 0.0);
  const glm::dvec3 rockedBeam(poseOf(rocked).probeToWorld.matrix[1]);
  const CompassAdvice rock = nextMovement(target, rocked);
  ASSERT_EQ(rock.movement, HandMovement::rock);
  EXPECT_EQ(rock.towards, rockedBeam.x > 0.0 ? PatientSide::right : PatientSide::left);
}

TEST(Compass, SaysThatTheMarkerPointsTheWrongWay) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const CompassAdvice advice = nextMovement(target, turned(frontHold(skin), std::numbers::pi, 0.0, 0.0));
  EXPECT_EQ(advice.movement, HandMovement::turnRound);
}

TEST(Compass, GoesOnTurningTheWayItBegan) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const CompassAdvice first = nextMovement(target, turned(frontHold(skin), std::numbers::pi - 0.02, 0.0, 0.0));
  const CompassAdvice second = nextMovement(target, turned(frontHold(skin), std::numbers::pi + 0.02, 0.0, 0.0), first);
  EXPECT_GT(first.amount * second.amount, 0.0);
}

TEST(Compass, GoesOnAroundTheBodyTheWayItBegan) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const auto behind = [&](double left_mm, const std::optional<CompassAdvice>& before) {
    Hold hold = frontHold(skin);
    hold.contact = skin.nearest({left_mm, 500.0, 0.0});
    return nextMovement(target, hold, before);
  };
  const CompassAdvice first = behind(5.0, {});
  ASSERT_EQ(first.movement, HandMovement::slide);
  EXPECT_EQ(first.towards, PatientSide::left) << "the nearer way";
  EXPECT_EQ(behind(-5.0, {}).towards, PatientSide::right);
  EXPECT_EQ(behind(-5.0, first).towards, PatientSide::left) << "a tremor across the spine changes nothing";
  EXPECT_NEAR(first.amount, 120.0 * std::numbers::pi, 8.0) << "half around the body";
}

TEST(Compass, TakesATiltForMoreWhereThePointLiesDeep) {
  const test::PlaneSkin skin;
  const auto advised = [&](double depth_mm) {
    const Hold hold = frontHold(skin);
    const CompassTarget target = compassTargetOf({poseOf(hold).probeToWorld, {0.0, depth_mm}}, {5.0, 10.0}, skin);
    // Of both signs of the slide one adds to what the tilt does to the point, so that the plane is not found.
    const Hold off = turned(hold, 0.0, 0.0, glm::radians(4.0));
    Hold now = slid(off, skin, 0.0, 4.5);
    if (planeError(target.plane, poseOf(now).probeToWorld).distance_mm < 4.5) now = slid(off, skin, 0.0, -4.5);
    return nextMovement(target, now).movement;
  };
  EXPECT_EQ(advised(100.0), HandMovement::tilt);
  EXPECT_EQ(advised(15.0), HandMovement::slide);
}

TEST(Compass, KeepsSayingThereUntilThePlaneIsLeft) {
  const test::CylinderSkin skin(120.0);
  const CompassTarget target = targetAt(frontHold(skin), skin);
  const Hold near = slid(frontHold(skin), skin, 0.0, 4.5);  // between found and left
  EXPECT_NE(nextMovement(target, near).movement, HandMovement::stay);
  CompassAdvice there;
  EXPECT_EQ(nextMovement(target, near, there).movement, HandMovement::stay);
  EXPECT_NE(nextMovement(target, slid(frontHold(skin), skin, 0.0, 5.5), there).movement, HandMovement::stay);
}

TEST(Compass, SaysWhenAPlaneCannotBeReachedFromTheSkin) {
  const test::CylinderSkin skin(120.0);
  PlaneTarget inside{poseOf(frontHold(skin)).probeToWorld, {0.0, 60.0}};
  inside.probeToWorld.matrix[3].y += 60.0;  // its face lies in the middle of the body
  const CompassTarget target = compassTargetOf(inside, {}, skin);
  EXPECT_FALSE(target.reachable);
  EXPECT_EQ(nextMovement(target, frontHold(skin)).movement, HandMovement::none);
}

}  // namespace
}  // namespace ew
