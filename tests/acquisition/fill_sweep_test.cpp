#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "acquisition/sweeps.h"
#include "ew/acquisition/reconstruct.h"

namespace ew::fill_sweep_test {
namespace {

using sweeps::imageOf;
using sweeps::matrixOf;
using sweeps::stack;
using sweeps::Sweep;

ReconstructResult made(const Sweep& sweep, const ReconstructOptions& options) {
  auto result = reconstruct(sweep.frames, options, noProgress());
  if (!result) {
    ADD_FAILURE() << result.error();
    return {};
  }
  return std::move(*result);
}

constexpr ReconstructOptions kPlain{.spacing_mm = 1.0, .interpolation = Interpolation::nearest};
ReconstructOptions filledBy(double reach_mm, FillMethod method = FillMethod::sweep) {
  ReconstructOptions options = kPlain;
  options.fillReach_mm = reach_mm;
  options.fillMethod = method;
  return options;
}

TEST(FillSweep, KeepsARampAlongTheSweepAndAcrossTheImage) {
  // 6 mm between frames; each voxel lies at a pixel.
  const Sweep sweep = stack(12, 9, 4, 6.0, [](int x, int y, int n) { return 10 + 2 * x + 3 * y + 6 * 5 * n; });
  const ReconstructResult result = made(sweep, filledBy(6.0));
  const Grid& grid = result.volume.grid;
  EXPECT_EQ(result.interpolatedVoxels, 12u * 9u * 3u * 5u);
  for (int k = 0; k < grid.dims.z; ++k)
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 12; ++x) {
        ASSERT_EQ(result.volume.echo[grid.indexOf(x, y, k)], 10 + 2 * x + 3 * y + 5 * k) << x << " " << y << " " << k;
        ASSERT_EQ(result.volume.coverageAt(grid.indexOf(x, y, k)), k % 6 == 0 ? Coverage::measured : Coverage::interpolated);
      }
}

TEST(FillSweep, FollowsTheProbeWhenItSlipsSideways) {
  // The second frame lies 4 mm to the right and shows the same image: a bar that follows the probe, which straight bridges would break.
  Sweep sweep;
  const auto bar = [](int x, int) { return x == 10 ? 200 : 20; };
  sweep.add(imageOf(21, 9, bar), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
  sweep.add(imageOf(21, 9, bar), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 0, 8}));
  const ReconstructResult result = made(sweep, filledBy(9.0));
  for (int k = 0; k <= 8; k += 2) EXPECT_EQ(result.volume.echo[result.volume.grid.indexOf(10 + k / 2, 4, k)], 200) << k;
  EXPECT_EQ(result.volume.echo[result.volume.grid.indexOf(10, 4, 4)], 20);
}

TEST(FillSweep, MeasuresTheReachBetweenThePointsOfTheTwoFrames) {
  Sweep sweep;
  const auto flat = [](int, int) { return 90; };
  sweep.add(imageOf(21, 9, flat), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
  sweep.add(imageOf(21, 9, flat), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 4}));  // 5 mm
  EXPECT_EQ(made(sweep, filledBy(3.9)).interpolatedVoxels, 0u);                           // nor a straight bridge of 4 mm
  // Half way the places lie between two pixels, and of 21 columns 20 are between the frames' ends.
  EXPECT_EQ(made(sweep, filledBy(5.0)).interpolatedVoxels, (21u + 20u + 21u) * 9u);
}

RC_GTEST_PROP(FillSweep, FillsNothingFurtherThanTheReachFromWhatWasMeasuredAndKeepsConstants, ()) {
  Sweep sweep;
  const int count = *rc::gen::inRange(1, 6);
  double z_mm = 0.0;
  for (int n = 0; n < count; ++n) {
    const double rotation_rad = *rc::gen::inRange(-40, 41) / 100.0;
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(*rc::gen::inRange(-30, 31) / 10.0, 0.0, z_mm));
    m = glm::rotate(m, rotation_rad, glm::normalize(glm::dvec3(1.0, 0.3, 0.1))) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.7, 0.4, 1.0));
    sweep.add(imageOf(14, 17, [](int, int) { return 133; }), m);
    z_mm += *rc::gen::inRange(-20, 60) / 10.0;  // frames cross, come twice and go back
  }
  ReconstructOptions options = filledBy(*rc::gen::inRange(1, 8), *rc::gen::elementOf(std::vector{FillMethod::sweep, FillMethod::bridges}));
  options.spacing_mm = *rc::gen::elementOf(std::vector{0.5, 0.8, 1.3});
  options.interpolation = *rc::gen::elementOf(std::vector{Interpolation::nearest, Interpolation::linear, Interpolation::centred});
  options.keepSource = true;
  options.threads = 1;
  const auto result = reconstruct(sweep.frames, options, noProgress());
  RC_ASSERT(result.has_value());
  const Grid& grid = result->volume.grid;
  std::size_t interpolated = 0, measured = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const std::size_t index = grid.indexOf(i, j, k);
        const Coverage coverage = result->volume.coverageAt(index);
        RC_ASSERT(result->volume.echo[index] == (coverage == Coverage::absent ? 0 : 133));
        RC_ASSERT((result->source[index] == 0) == (coverage == Coverage::absent));
        measured += coverage == Coverage::measured ? 1 : 0;
        if (coverage != Coverage::interpolated) continue;
        ++interpolated;
        // Within half the reach of a pixel, or of the centre of a voxel that has one.
        const auto source =
            sourceFrameAt(grid, result->source, sweep.frames, grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)});
        RC_ASSERT(source.has_value());
        RC_ASSERT(source->distance_mm <= 0.5 * options.fillReach_mm + 2.0 * options.spacing_mm);
      }
  RC_ASSERT(interpolated == result->interpolatedVoxels);
  RC_ASSERT(measured == result->measuredVoxels);
  for (const int threads : {2, 8}) {
    options.threads = threads;
    const auto many = reconstruct(sweep.frames, options, noProgress());
    RC_ASSERT(many.has_value());
    RC_ASSERT(many->volume == result->volume);
    RC_ASSERT(many->source == result->source);
  }
}

TEST(FillSweep, ReadsAnAreaAsLargeAsAVoxelFromFinePixels) {
  // A checkerboard of pixels an eighth of a voxel: every voxel between the frames must see its mean, not one of its fields.
  Sweep sweep;
  for (int n = 0; n < 2; ++n)
    sweep.add(imageOf(160, 160, [](int x, int y) { return (x + y) % 2 == 0 ? 0 : 200; }),
              matrixOf({0.125, 0, 0}, {0, 0.125, 0}, {0, 0, 1}, {0, 0, 4.0 * n}));
  const ReconstructResult result = made(sweep, filledBy(4.0));
  for (int j = 2; j < 18; ++j)
    for (int i = 2; i < 18; ++i) EXPECT_EQ(result.volume.echo[result.volume.grid.indexOf(i, j, 2)], 100);
}

TEST(FillSweep, TakesNothingFromOutsideTheClip) {
  // Bright outside the fan, dark inside.
  Sweep sweep = stack(41, 41, 2, 4.0, [](int x, int y, int) { return std::hypot(x - 20.0, y) > 30.0 ? 255 : 40; });
  ReconstructOptions options = filledBy(4.0);
  options.clip.fan = ClipFan{.origin_px = {20, 0}, .leftAngle_rad = -0.5, .rightAngle_rad = 0.5, .startRadius_px = 5, .stopRadius_px = 30};
  const ReconstructResult result = made(sweep, options);
  EXPECT_EQ(result.interpolatedVoxels, 3 * result.measuredVoxels / 2);
  EXPECT_EQ(*std::max_element(result.volume.echo.begin(), result.volume.echo.end()), 40);
}

TEST(FillSweep, DoesNotReadPixelsNobodyTrusts) {
  Sweep sweep = stack(10, 10, 2, 4.0, [](int, int, int) { return 60; });
  const GreyImage weights = imageOf(10, 10, [](int x, int) { return x < 5 ? 255 : 0; });
  sweep.frames[1].weights = viewOf(weights);
  ReconstructOptions options = filledBy(4.0);
  options.compounding = Compounding::weighted;
  EXPECT_EQ(made(sweep, options).interpolatedVoxels, 5u * 10u * 3u);
}

TEST(Centred, ReadsARampAtTheCentresOfTheVoxels) {
  // Pixels of 0.7 mm in voxels of 1 mm: the mean of the pixels in a voxel is off by up to a third of a pixel, reading at the centre is not.
  Sweep sweep;
  sweep.add(imageOf(60, 30, [](int x, int) { return 4 * x; }), matrixOf({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, 1}, {0, 0, 0}));
  ReconstructOptions options = kPlain;
  options.interpolation = Interpolation::centred;
  const ReconstructResult centred = made(sweep, options);
  for (int i = 1; i < 40; ++i)
    EXPECT_EQ(centred.volume.echo[centred.volume.grid.indexOf(i, 10, 0)], static_cast<int>(std::floor(4.0 * i / 0.7 + 0.5))) << i;
  EXPECT_EQ(centred.measuredVoxels, made(sweep, kPlain).measuredVoxels);
}

TEST(Centred, BlendsFramesThatAreNearAndKeepsThoseThatAreNot) {
  // The second frame lies 0.3 mm behind the centre of its voxel: near the first one, that voxel is on the straight line between them.
  for (const double z_mm : {2.3, 3.3}) {
    Sweep sweep;
    sweep.add(imageOf(6, 5, [](int, int) { return 20; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
    sweep.add(imageOf(6, 5, [](int, int) { return 250; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, z_mm}));
    ReconstructOptions options = kPlain;
    options.interpolation = Interpolation::centred;
    const ReconstructResult result = made(sweep, options);
    const Grid& grid = result.volume.grid;
    EXPECT_EQ(result.volume.echo[grid.indexOf(3, 2, 0)], 20);
    EXPECT_EQ(result.volume.echo[grid.indexOf(3, 2, grid.dims.z - 1)], z_mm < 2.5 ? 220 : 250);
    EXPECT_EQ(result.measuredVoxels, 2u * 6u * 5u);
    // The second frame is trusted a quarter as much.
    const GreyImage full(6, 5, 200), quarter(6, 5, 50);
    sweep.frames[0].weights = viewOf(full);
    sweep.frames[1].weights = viewOf(quarter);
    options.compounding = Compounding::weighted;
    const ReconstructResult weighted = made(sweep, options);
    const double ofSecond = 2.0 / (2.0 + 4.0 * 0.3);
    EXPECT_EQ(weighted.volume.echo[grid.indexOf(3, 2, grid.dims.z - 1)], z_mm < 2.5 ? std::floor(20.0 + 230.0 * ofSecond + 0.5) : 250);
  }
}

TEST(KeepSource, NamesTheNearestFrameOfEveryVoxel) {
  const Sweep sweep = stack(6, 5, 3, 4.0, [](int, int, int n) { return 10 * n; });
  for (const FillMethod method : {FillMethod::sweep, FillMethod::bridges})
    for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::linear, Interpolation::centred}) {
      ReconstructOptions options = filledBy(4.0, method);
      options.interpolation = interpolation;
      options.keepSource = true;
      const ReconstructResult result = made(sweep, options);
      const Grid& grid = result.volume.grid;
      // Half way the earlier frame is taken.
      const int expected[] = {1, 1, 1, 2, 2, 2, 2, 3, 3};
      for (int k = 0; k < 9; ++k) EXPECT_EQ(result.source[grid.indexOf(3, 2, k)], expected[k]) << k;
      const auto at = sourceFrameAt(grid, result.source, sweep.frames, {{3.2, 1.9, 3.1}});
      ASSERT_TRUE(at.has_value());
      EXPECT_EQ(at->frame, 1u);
      EXPECT_NEAR(at->at_px.x, 3.2, 1e-9);
      EXPECT_NEAR(at->at_px.y, 1.9, 1e-9);
      EXPECT_NEAR(at->distance_mm, 0.9, 1e-9);
      EXPECT_FALSE(sourceFrameAt(grid, result.source, sweep.frames, {{3.2, 1.9, 9.1}}).has_value());
      EXPECT_FALSE(sourceFrameAt(grid, result.source, sweep.frames, {{std::nan(""), 1.9, 3.1}}).has_value());
    }
}

TEST(KeepSource, TakesTheFrameOfThePixelNearestToTheCentre) {
  // Three frames in one layer of voxels, at -0.4, 0.1 and 0.3 mm from its centre.
  Sweep sweep;
  for (const double z_mm : {0.0, 0.5, 0.7})
    sweep.add(imageOf(6, 5, [](int, int) { return 50; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, z_mm}));
  sweep.add(imageOf(6, 5, [](int, int) { return 50; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 3.0}));
  ReconstructOptions options = kPlain;
  options.keepSource = true;
  const ReconstructResult result = made(sweep, options);
  EXPECT_EQ(result.source[result.volume.grid.indexOf(2, 2, 0)], 1);
  EXPECT_EQ(result.source[result.volume.grid.indexOf(2, 2, 1)], 3);
  EXPECT_EQ(result.source[result.volume.grid.indexOf(2, 2, 2)], 0);
  EXPECT_EQ(result.source[result.volume.grid.indexOf(2, 2, 3)], 4);
}

}  // namespace
}  // namespace ew::fill_sweep_test
