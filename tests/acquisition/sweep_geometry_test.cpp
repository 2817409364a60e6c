#include "ew/acquisition/sweep_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "acquisition/sweeps.h"

namespace ew::sweep_geometry_test {
namespace {

using sweeps::imageOf;
using sweeps::Sweep;

/// Frames of square pixels, one behind the other.
Sweep parallel(double pixel_mm, double distance_mm, int frames) {
  Sweep sweep;
  for (int n = 0; n < frames; ++n)
    sweep.add(imageOf(8, 6, [](int, int) { return 50; }),
              sweeps::matrixOf({pixel_mm, 0, 0}, {0, pixel_mm, 0}, {0, 0, pixel_mm}, {0, 0, n * distance_mm}));
  return sweep;
}

TEST(SweepGeometry, TheDistanceIsThatOfMostFrames) {
  EXPECT_EQ(frameDistance_mm({}), 0.0);
  EXPECT_EQ(frameDistance_mm(parallel(0.2, 0.7, 1).frames), 0.0);
  Sweep sweep = parallel(0.2, 0.7, 9);
  sweep.frames[8].imageToWorld.matrix[3].z += 50.0;  // lifted off and put down elsewhere
  EXPECT_NEAR(frameDistance_mm(sweep.frames), 0.7, 1e-12);
}

TEST(SweepGeometry, TheSpacingIsTwoPixelsOrMostOfTheWayToTheNextFrameWithinLimits) {
  EXPECT_EQ(carriedSpacing_mm({}), 1.0);
  EXPECT_NEAR(carriedSpacing_mm(parallel(0.3, 0.1, 5).frames), 0.6, 1e-12) << "two pixels";
  EXPECT_NEAR(carriedSpacing_mm(parallel(0.1, 1.2, 5).frames), 0.7, 1e-12) << "0.72 in steps of 0.05";
  EXPECT_NEAR(carriedSpacing_mm(parallel(0.05, 0.1, 5).frames), 0.3, 1e-12) << "no finer";
  EXPECT_NEAR(carriedSpacing_mm(parallel(0.3, 9.0, 5).frames), 1.0, 1e-12) << "no coarser";
}

TEST(SweepGeometry, HolesReachOverAMissingFrame) {
  EXPECT_NEAR(usualFillReach_mm(parallel(0.2, 2.0, 5).frames, 0.5), 5.0, 1e-12);
  EXPECT_NEAR(usualFillReach_mm(parallel(0.2, 0.1, 5).frames, 0.5), 1.5, 1e-12) << "three voxels";
}

TEST(SweepGeometry, TheBeamsAreTheColumnsOrLeaveTheWayOfTheApex) {
  const Sweep sweep = parallel(0.5, 2.0, 4);
  const auto straight = beamsOf(sweep.frames, {});
  ASSERT_TRUE(straight);
  EXPECT_LT(glm::distance(straight->direction, glm::dvec3(0, 1, 0)), 1e-12);
  EXPECT_FALSE(straight->fan);
  const auto fan = beamsOf(sweep.frames, {.fan = ClipFan{.origin_px = {4.0, -10.0}}});
  ASSERT_TRUE(fan && fan->fan);
  const double apart_mm = glm::distance(fan->fan->from_mm, fan->fan->to_mm);
  EXPECT_NEAR(apart_mm, 6.0, 1e-12) << "from the first frame to the last";
  EXPECT_NEAR(fan->fan->from_mm.y, -5.0, 1e-12);
  Sweep opposed = parallel(0.5, 2.0, 2);
  opposed.frames[1].imageToWorld.matrix[1] *= -1.0;
  EXPECT_FALSE(beamsOf(opposed.frames, {})) << "up and down";
}

}  // namespace
}  // namespace ew::sweep_geometry_test
