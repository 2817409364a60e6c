#include "ew/tracking/pose_source.h"

#include <gtest/gtest.h>

namespace ew::pose_source_test {
namespace {

Pose at(double x_mm) {
  Pose pose;
  pose.probeToWorld.matrix[3].x = x_mm;
  return pose;
}

}  // namespace

TEST(PoseSource, AHandIsWhereItWasHeldLast) {
  HandOnSkin hand;
  EXPECT_EQ(hand.poseAt(0.0), poseOf(hand.hold()));
  Hold held = hand.hold();
  held.contact.point_mm = {10.0, -90.0, 5.0};
  held.rock_rad = 0.2;
  hand.setHold(held);
  EXPECT_EQ(hand.poseAt(1e9), poseOf(held));
  EXPECT_FALSE(hand.movesAfter(0.0));
}

TEST(PoseSource, APathHoldsEachPoseUntilTheNextAndStaysFree) {
  Pose leaning = at(2.0);
  leaning.probeToWorld.matrix[1] = {0.0, 0.0, -1.0, 0.0};
  leaning.probeToWorld.matrix[2] = {0.0, 1.0, 0.0, 0.0};
  const PosePath path({{1.0, at(1.0)}, {2.0, leaning}, {2.0, at(3.0)}, {4.0, at(4.0)}});
  EXPECT_EQ(path.poseAt(0.0), at(1.0));
  EXPECT_EQ(path.poseAt(1.5), at(1.0));
  EXPECT_EQ(path.poseAt(2.0), at(3.0));
  EXPECT_EQ(path.poseAt(3.999), at(3.0));
  EXPECT_EQ(path.poseAt(99.0), at(4.0));
  EXPECT_TRUE(path.movesAfter(3.9));
  EXPECT_FALSE(path.movesAfter(4.0));
  EXPECT_EQ(PosePath({{0.0, leaning}}).poseAt(7.0), leaning) << "no skin bends it";
}

}  // namespace ew::pose_source_test
