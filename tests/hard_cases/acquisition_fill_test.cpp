#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "acquisition/sweeps.h"
#include "ew/acquisition/confidence.h"
#include "ew/acquisition/reconstruct.h"

namespace ew::acquisition_fill_test {
namespace {

using sweeps::imageOf;
using sweeps::matrixOf;
using sweeps::stack;
using sweeps::Sweep;

int level(int x, int y, int n) { return 20 + (3 * x + 2 * y + 5 * n) % 200; }

ReconstructOptions filled(FillMethod method) {
  return {.spacing_mm = 1.0, .interpolation = Interpolation::nearest, .fillReach_mm = 6.0, .fillMethod = method};
}

TEST(HardFilling, OneFrameAndFramesInOnePlaceLeaveNothingToFill) {
  for (const int count : {1, 2, 7}) {
    Sweep sweep;
    for (int n = 0; n < count; ++n) sweep.add(imageOf(9, 9, [n](int x, int y) { return level(x, y, n); }), glm::dmat4(1.0));
    const auto made = reconstruct(sweep.frames, filled(FillMethod::sweep), noProgress());
    ASSERT_TRUE(made.has_value()) << made.error();
    EXPECT_EQ(made->interpolatedVoxels, 0u);
    EXPECT_EQ(made->measuredVoxels, 81u);
  }
}

TEST(HardFilling, FramesAtMoreThanARightAngleAreNotJoinedAlongTheSweep) {
  // The probe was turned round between two frames: no way leads from one to the other, straight bridges alone are left.
  Sweep sweep;
  sweep.add(imageOf(12, 12, [](int x, int y) { return level(x, y, 0); }), glm::dmat4(1.0));
  const glm::dmat4 turned =
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(11.0, 0.0, 4.0)), glm::radians(180.0), glm::dvec3(0.0, 1.0, 0.0));
  sweep.add(imageOf(12, 12, [](int x, int y) { return level(x, y, 9); }), turned);
  const auto along = reconstruct(sweep.frames, filled(FillMethod::sweep), noProgress());
  const auto bridged = reconstruct(sweep.frames, filled(FillMethod::bridges), noProgress());
  ASSERT_TRUE(along && bridged);
  EXPECT_GT(along->interpolatedVoxels, 0u);
  EXPECT_EQ(along->volume, bridged->volume);
}

TEST(HardProvenance, APointOutsideInAHoleOrNowhereHasNoFrame) {
  const Sweep sweep = stack(8, 8, 2, 5.0, level);
  ReconstructOptions options = filled(FillMethod::sweep);
  options.fillReach_mm = 0.0;
  options.keepSource = true;
  const auto made = reconstruct(sweep.frames, options, noProgress());
  ASSERT_TRUE(made.has_value()) << made.error();
  const auto at = [&](const glm::dvec3& p_mm) {
    return sourceFrameAt(made->volume.grid, made->source, sweep.frames, Point<frame::World>{p_mm});
  };
  ASSERT_TRUE(at({3.2, 4.0, 5.1}).has_value());
  EXPECT_EQ(at({3.2, 4.0, 5.1})->frame, 1u);
  EXPECT_NEAR(at({3.2, 4.0, 5.1})->at_px.x, 3.2, 1e-12);
  EXPECT_NEAR(at({3.2, 4.0, 5.1})->distance_mm, 0.1, 1e-12);
  EXPECT_FALSE(at({3, 4, 2}).has_value()) << "a hole";
  EXPECT_FALSE(at({3, 4, 9}).has_value()) << "outside";
  EXPECT_FALSE(at({std::numeric_limits<double>::quiet_NaN(), 4, 0}).has_value());
  EXPECT_FALSE(at({1e300, 4, 0}).has_value());
}

TEST(HardProvenance, OfMoreFramesThanSixteenBitsCountIsRefused) {
  Sweep sweep = stack(1, 1, 2, 1.0, level);
  while (sweep.frames.size() < 65535) sweep.frames.push_back(sweep.frames.back());
  ReconstructOptions options = filled(FillMethod::bridges);
  options.keepSource = true;
  const auto refused = reconstruct(sweep.frames, options, noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence().find("65534"), std::string::npos) << refused.error();
  sweep.frames.pop_back();
  EXPECT_TRUE(reconstruct(sweep.frames, options, noProgress()).has_value());
}

TEST(HardConfidence, PixelsNobodyBelievesAreNotMeasured) {
  Sweep sweep = stack(8, 8, 3, 1.0, level);
  const GreyImage none(8, 8, 0);
  for (TrackedFrame& frame : sweep.frames) frame.weights = viewOf(none);
  ReconstructOptions options = filled(FillMethod::sweep);
  options.compounding = Compounding::weighted;
  for (const auto interpolation : {Interpolation::nearest, Interpolation::linear, Interpolation::centred}) {
    options.interpolation = interpolation;
    const auto made = reconstruct(sweep.frames, options, noProgress());
    ASSERT_TRUE(made.has_value()) << made.error();
    EXPECT_EQ(made->measuredVoxels + made->interpolatedVoxels, 0u);
  }
}

TEST(HardConfidence, WeightsOfAnotherSizeAreRefusedWithTheirFrame) {
  Sweep sweep = stack(8, 8, 3, 1.0, level);
  const GreyImage small(8, 7, 9);
  sweep.frames[2].weights = viewOf(small);
  ReconstructOptions options = filled(FillMethod::sweep);
  options.compounding = Compounding::weighted;
  const auto refused = reconstruct(sweep.frames, options, noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence().find("frame 2 have 8 x 7"), std::string::npos) << refused.error();
}

TEST(HardConfidence, OfABlackFrameIsNothingAndOfAWhiteOneAll) {
  for (const auto method : {ConfidenceMethod::beamwise, ConfidenceMethod::randomWalk}) {
    Sweep sweep = stack(30, 40, 2, 1.0, [](int, int, int n) { return n == 0 ? 0 : 255; });
    const auto maps = confidenceOfFrames(sweep.frames, {}, {.method = method}, 1, noProgress());
    ASSERT_TRUE(maps.has_value()) << maps.error();
    EXPECT_EQ((*maps)[0], GreyImage(30, 40, 0)) << "the probe is off the body";
    for (const std::uint8_t confidence : (*maps)[1].pixels) ASSERT_GT(confidence, 200);
  }
}

TEST(HardConfidence, OfFramesTooSmallOrClippedAwayIsRefused) {
  const Sweep dot = stack(1, 9, 1, 1.0, level), plain = stack(9, 9, 1, 1.0, level);
  EXPECT_FALSE(confidenceOfFrames(dot.frames, {}, {}, 1, noProgress()).has_value());
  EXPECT_FALSE(confidenceOfFrames(plain.frames, {.origin_px = {50, 0}}, {}, 1, noProgress()).has_value());
}

}  // namespace
}  // namespace ew::acquisition_fill_test
