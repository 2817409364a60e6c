#include "ew/assessment/plane_error.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace ew {
namespace {

using ProbeToWorld = Transform<frame::World, frame::Probe>;

/// A pose with no symmetry.
ProbeToWorld somePose() {
  glm::dmat4 m = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(0.3, -0.8, 0.5)));
  m[3] = glm::dvec4(12.0, -34.0, 56.0, 1.0);
  return {m};
}

/// The pose moved in its own frame.
ProbeToWorld then(const ProbeToWorld& pose, const glm::dmat4& own) { return {pose.matrix * own}; }
glm::dmat4 about(const glm::dvec3& axis, double degrees) { return glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis); }
glm::dmat4 by(const glm::dvec3& mm) { return glm::translate(glm::dmat4(1.0), mm); }

constexpr glm::dvec3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);

TEST(PlaneError, IsNothingAtTheTarget) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const PlaneError error = planeError(target, target.probeToWorld);
  EXPECT_FALSE(error.isMirrored);
  for (const double figure : {error.angle_deg, error.roll_deg, error.distance_mm, error.inImage_mm, error.face_mm, error.rotate_deg,
                              error.tilt_deg, error.rock_deg})
    EXPECT_NEAR(figure, 0.0, 1e-9);
  EXPECT_NEAR(shareOfTolerance(error, {}), 0.0, 1e-9);
}

TEST(PlaneError, OfASlideAcrossThePlaneIsItsLength) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const PlaneError error = planeError(target, then(target.probeToWorld, by({0.0, 0.0, 4.0})));
  EXPECT_NEAR(error.distance_mm, 4.0, 1e-9);
  EXPECT_NEAR(error.face_mm, 4.0, 1e-9);
  EXPECT_NEAR(error.inImage_mm, 0.0, 1e-9);
  EXPECT_NEAR(error.angle_deg, 0.0, 1e-6);
  const glm::dvec3 z(target.probeToWorld.matrix[2]);
  EXPECT_NEAR(glm::distance(error.faceOffset_mm, -4.0 * z), 0.0, 1e-9) << "to the target";
}

TEST(PlaneError, OfASlideWithinThePlaneIsInTheImageAlone) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const PlaneError error = planeError(target, then(target.probeToWorld, by({7.0, -2.0, 0.0})));
  EXPECT_NEAR(error.distance_mm, 0.0, 1e-9);
  EXPECT_NEAR(error.inImage_mm, std::hypot(7.0, 2.0), 1e-9);
  EXPECT_NEAR(shareOfTolerance(error, {5.0, 10.0}), std::hypot(7.0, 2.0) / 15.0, 1e-9);
}

TEST(PlaneError, OfATiltMovesTheDeepPointOfInterest) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const PlaneError error = planeError(target, then(target.probeToWorld, about(kX, 6.0)));
  EXPECT_NEAR(error.angle_deg, 6.0, 1e-9);
  EXPECT_NEAR(error.distance_mm, 50.0 * std::sin(glm::radians(6.0)), 1e-9);
  EXPECT_NEAR(error.tilt_deg, -6.0, 1e-9) << "what is yet to do is back";
  EXPECT_NEAR(error.rock_deg, 0.0, 1e-9);
  EXPECT_NEAR(error.rotate_deg, 0.0, 1e-9);
  EXPECT_NEAR(error.roll_deg, 0.0, 1e-9);
}

TEST(PlaneError, OfARockIsARollWithinThePlane) {
  const PlaneTarget target{somePose(), {0.0, 50.0}};
  const PlaneError error = planeError(target, then(target.probeToWorld, about(kZ, 8.0)));
  EXPECT_NEAR(error.angle_deg, 0.0, 1e-6);
  EXPECT_NEAR(error.roll_deg, -8.0, 1e-9);
  EXPECT_NEAR(error.rock_deg, -8.0, 1e-9);
  EXPECT_NEAR(error.inImage_mm, 2.0 * 50.0 * std::sin(glm::radians(4.0)), 1e-9) << "the chord";
}

TEST(PlaneError, OfARotationAboutTheBeamLeavesPointsOnTheBeam) {
  const PlaneTarget target{somePose(), {0.0, 50.0}};
  const PlaneError error = planeError(target, then(target.probeToWorld, about(kY, 25.0)));
  EXPECT_NEAR(error.angle_deg, 25.0, 1e-9);
  EXPECT_NEAR(error.rotate_deg, -25.0, 1e-9);
  EXPECT_NEAR(error.distance_mm, 0.0, 1e-9);
}

TEST(PlaneError, TellsTheMarkerTheWrongWayRoundFromBeingWrong) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const auto turned = then(target.probeToWorld, about(kY, 180.0));
  const PlaneError error = planeError(target, turned);
  EXPECT_TRUE(error.isMirrored);
  EXPECT_NEAR(error.angle_deg, 0.0, 1e-6);
  EXPECT_NEAR(error.distance_mm, 0.0, 1e-9);
  EXPECT_NEAR(error.inImage_mm, 0.0, 1e-9) << "mirrored in the image as the image is";
  EXPECT_TRUE(isFound(error, {}));
  EXPECT_FALSE(planeError(target, then(target.probeToWorld, about(kY, 89.0))).isMirrored);
  EXPECT_TRUE(planeError(target, then(target.probeToWorld, about(kY, 91.0))).isMirrored);
}

TEST(PlaneError, PartsRebuildTheTargetFromThePose) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-80.0, 80.0);
  for (int n = 0; n < 200; ++n) {
    const PlaneTarget target{somePose(), {3.0, 50.0}};
    const auto pose = then(then(then(target.probeToWorld, about(kX, angle(random))), about(kY, angle(random))), about(kZ, angle(random)));
    const PlaneError error = planeError(target, pose);
    auto rebuilt = pose.matrix * about(kY, error.rotate_deg) * about(kX, error.tilt_deg) * about(kZ, error.rock_deg);
    if (error.isMirrored) rebuilt = rebuilt * about(kY, 180.0);
    for (int column = 0; column < 3; ++column)
      EXPECT_LT(glm::distance(glm::dvec3(rebuilt[column]), glm::dvec3(target.probeToWorld.matrix[column])), 1e-9);
  }
}

TEST(PlaneError, DoesNotDependOnWhereTheWorldIs) {
  const PlaneTarget target{somePose(), {3.0, 50.0}};
  const auto pose = then(target.probeToWorld, by({3.0, 1.0, -2.0}) * about(kX, 11.0) * about(kY, 17.0));
  const glm::dmat4 elsewhere = by({100.0, 20.0, -70.0}) * about(glm::normalize(glm::dvec3(1.0, 2.0, 3.0)), 77.0);
  const PlaneError here = planeError(target, pose);
  const PlaneError there = planeError({{elsewhere * target.probeToWorld.matrix}, target.interest_mm}, {elsewhere * pose.matrix});
  EXPECT_NEAR(here.angle_deg, there.angle_deg, 1e-9);
  EXPECT_NEAR(here.roll_deg, there.roll_deg, 1e-9);
  EXPECT_NEAR(here.distance_mm, there.distance_mm, 1e-9);
  EXPECT_NEAR(here.inImage_mm, there.inImage_mm, 1e-9);
}

TEST(PlaneError, IsFoundUpToEachToleranceAndNoFurther) {
  const PlaneTarget target{somePose(), {0.0, 0.001}};
  const PlaneTolerance tolerance{5.0, 10.0};
  const auto found = [&](const glm::dmat4& own) { return isFound(planeError(target, then(target.probeToWorld, own)), tolerance); };
  EXPECT_TRUE(found(by({0.0, 0.0, 4.999})));
  EXPECT_FALSE(found(by({0.0, 0.0, 5.001})));
  EXPECT_TRUE(found(about(kX, 9.999)));
  EXPECT_FALSE(found(about(kX, 10.001)));
  EXPECT_TRUE(found(by({14.999, 0.0, 0.0})));
  EXPECT_FALSE(found(by({15.001, 0.0, 0.0})));
}

TEST(PlaneTarget, TakesThePointThatIsMeasuredInThePlane) {
  ReferencePlane plane;
  plane.name = "transthalamic";
  plane.probeToWorld = somePose();
  CaseTruth truth;
  EXPECT_EQ(targetOf(plane, truth, 90.0).interest_mm, glm::dvec2(0.0, 45.0));
  ReferenceMeasurement measured;
  measured.plane = plane.name;
  measured.points_mm = {carried(plane.probeToWorld, glm::dvec3(-20.0, 30.0, 0.0)),
                        carried(plane.probeToWorld, glm::dvec3(30.0, 50.0, 0.0))};
  truth.measurements = {measured};
  const PlaneTarget target = targetOf(plane, truth, 90.0);
  EXPECT_NEAR(target.interest_mm.x, 5.0, 1e-9);
  EXPECT_NEAR(target.interest_mm.y, 40.0, 1e-9);
}

}  // namespace
}  // namespace ew
