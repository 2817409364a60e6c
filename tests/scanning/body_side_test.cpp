#include "ew/scanning/body_side.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ew {
namespace {

/// From the front, at this place, the beams leaning by the angle to the patient's left.
Pose poseAt(double x_mm, double lean_rad = 0.0) {
  const double c = std::cos(lean_rad), s = std::sin(lean_rad);
  Pose pose;
  pose.probeToWorld.matrix =
      glm::dmat4(glm::dvec4(c, -s, 0, 0), glm::dvec4(s, c, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(x_mm, -100, 0, 1));
  pose.status = PoseStatus::ok;
  return pose;
}

TEST(BodySide, ThePatientsLeftIsWhereXOfTheWorldGrows) {
  EXPECT_EQ(bodySideOf(poseAt(34.0), 40.0), BodySide::left);
  EXPECT_EQ(bodySideOf(poseAt(-34.0), 40.0), BodySide::right);
}

TEST(BodySide, AnImageOfTheMidlineHasNone) {
  EXPECT_FALSE(bodySideOf(poseAt(0.0), 40.0));
  EXPECT_FALSE(bodySideOf(poseAt(8.0), 40.0));
  EXPECT_TRUE(bodySideOf(poseAt(8.01), 40.0));
  EXPECT_FALSE(bodySideOf(poseAt(30.0), 40.0, 30.0));
}

TEST(BodySide, TheMiddleOfTheFanCountsNotTheProbe) {
  // 20 mm down along beams that lean by a right angle to the left.
  EXPECT_EQ(bodySideOf(poseAt(-5.0, 1.5707963267948966), 40.0), BodySide::left);
  EXPECT_FALSE(bodySideOf(poseAt(-12.1, 1.5707963267948966), 40.0));
}

TEST(BodySide, NoPlaceHasNoSide) {
  Pose lost = poseAt(34.0);
  lost.status = PoseStatus::missing;
  EXPECT_FALSE(bodySideOf(lost, 40.0));
  EXPECT_FALSE(bodySideOf(poseAt(std::numeric_limits<double>::quiet_NaN()), 40.0));
}

}  // namespace
}  // namespace ew
