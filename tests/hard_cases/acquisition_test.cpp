#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "acquisition/sweeps.h"
#include "ew/acquisition/reconstruct.h"

namespace ew::acquisition_test {
namespace {

using sweeps::imageOf;
using sweeps::matrixOf;
using sweeps::stack;
using sweeps::Sweep;

ErrorCode codeOf(const Sweep& sweep, const ReconstructOptions& options, const std::string& expectedWords) {
  const auto result = reconstruct(sweep.frames, options, noProgress());
  if (result) {
    ADD_FAILURE() << "was reconstructed, expected: " << expectedWords;
    return ErrorCode::internal;
  }
  EXPECT_NE(result.error().sentence().find(expectedWords), std::string::npos) << result.error();
  EXPECT_EQ(result.error().sentence().back(), '.');
  return result.error().code;
}

int level(int x, int y, int n) { return (x + 2 * y + 5 * n) % 251; }

TEST(HardSequences, ASweepWithoutAValidPoseIsRefused) { EXPECT_EQ(codeOf({}, {}, "no frame with a usable pose"), ErrorCode::noValidPose); }

TEST(HardSequences, OneValidFrameBecomesAVolumeOneVoxelThick) {
  const Sweep sweep = stack(12, 9, 1, 1.0, level);
  for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::linear}) {
    const auto result = reconstruct(sweep.frames, {.spacing_mm = 1.0, .interpolation = interpolation, .fillReach_mm = 5}, noProgress());
    ASSERT_TRUE(result.has_value()) << result.error();
    EXPECT_EQ(result->volume.grid.dims, glm::ivec3(12, 9, 1));
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 12; ++x) EXPECT_EQ(result->volume.echo[result->volume.grid.indexOf(x, y, 0)], level(x, y, 0));
  }
}

TEST(HardSequences, AOneColumnImageAndASinglePixelArePasted) {
  for (const glm::ivec2 size : {glm::ivec2(1, 30), glm::ivec2(30, 1), glm::ivec2(1, 1)}) {
    const Sweep sweep = stack(size.x, size.y, 4, 1.0, level);
    const auto result = reconstruct(sweep.frames, {.spacing_mm = 1.0}, noProgress());
    ASSERT_TRUE(result.has_value()) << result.error();
    EXPECT_EQ(result->volume.grid.dims, glm::ivec3(size, 4));
    EXPECT_EQ(result->measuredVoxels, result->volume.grid.voxelCount());
    EXPECT_EQ(result->volume.echo.back(), level(size.x - 1, size.y - 1, 3));
  }
}

TEST(HardSequences, TheScaleInTheCalibrationMatrixIsTheOnlyScale) {
  Sweep sweep;
  for (int n = 0; n < 3; ++n)
    sweep.add(imageOf(101, 51, [&](int x, int y) { return level(x, y, n); }), matrixOf({0.1, 0, 0}, {0, 0.2, 0}, {0, 0, 0.15}, {0, 0, n}));
  const auto result = reconstruct(sweep.frames, {.spacing_mm = 0.5}, noProgress());
  ASSERT_TRUE(result.has_value()) << result.error();
  EXPECT_EQ(result->volume.grid.dims, glm::ivec3(21, 21, 5));
}

TEST(HardGeometry, AnOriginAMillionMillimetresAwayMovesNoVoxel) {
  Sweep near, far;
  const glm::dvec3 away(1e6, -1e6, 1e6);
  for (int n = 0; n < 6; ++n) {
    const GreyImage image = imageOf(40, 30, [&](int x, int y) { return level(x, y, n); });
    const glm::dvec3 x(0.28131, 0.03177, 0.10291), y(-0.04173, 0.30113, 0.02319), z(0, 0, 0.3), origin(0.0, 0.10331 * n, 0.49719 * n);
    near.add(image, matrixOf(x, y, z, origin));
    far.add(image, matrixOf(x, y, z, origin + away));
  }
  for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::linear}) {
    const auto here = reconstruct(near.frames, {.interpolation = interpolation}, noProgress());
    const auto there = reconstruct(far.frames, {.interpolation = interpolation}, noProgress());
    ASSERT_TRUE(here.has_value() && there.has_value());
    ASSERT_EQ(here->volume.grid.dims, there->volume.grid.dims);
    std::size_t different = 0;
    for (std::size_t v = 0; v < here->volume.echo.size(); ++v) different += here->volume.echo[v] != there->volume.echo[v] ? 1 : 0;
    EXPECT_LE(different, here->volume.echo.size() / 1000);  // 1e-10 mm of rounding may tip a pixel that lies on a border
  }
}

TEST(HardGeometry, ARowOfAHundredThousandPixelsDriftsByLessThanHalfAVoxel) {
  constexpr int kPixels = 100000;
  const glm::dvec3 perPixel = glm::dvec3(0.01510203, 0.00016809, 0.00007107);
  Sweep sweep;
  sweep.add(imageOf(kPixels, 1, [](int x, int) { return x / 400; }), matrixOf(perPixel, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}));
  const auto result =
      reconstruct(sweep.frames, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest, .keepWeights = true}, noProgress());
  ASSERT_TRUE(result.has_value()) << result.error();
  const Grid& grid = result->volume.grid;
  std::vector<float> expected(grid.voxelCount());
  for (int x = 0; x < kPixels; ++x) {
    const glm::ivec3 at(glm::floor(perPixel * static_cast<double>(x) + 0.5));
    ASSERT_TRUE(grid.contains(at));
    expected[grid.indexOf(at.x, at.y, at.z)] += 1.0F;
  }
  EXPECT_TRUE(result->weights == expected);
}

TEST(HardGeometry, MirroredAndObliqueMatricesPasteEveryPixel) {
  for (const double sign : {1.0, -1.0}) {
    Sweep sweep;
    for (int n = 0; n < 4; ++n)
      sweep.add(imageOf(30, 20, [&](int x, int y) { return level(x, y, n); }),
                matrixOf({0.3 * sign, 0.1, 0.2}, {0.15, 0.35, -0.1}, {0.1, 0.0, 0.3}, {0, 0, 0.4 * n}));
    const auto result = reconstruct(sweep.frames, {.interpolation = Interpolation::nearest, .keepWeights = true}, noProgress());
    ASSERT_TRUE(result.has_value()) << result.error();
    double pixels = 0.0;
    for (const float weight : result->weights) pixels += static_cast<double>(weight);
    EXPECT_EQ(pixels, 30.0 * 20.0 * 4.0);
  }
}

TEST(HardGeometry, MatricesThatAreNotFiniteNotAffineOrFlatAreRefusedWithTheirFrame) {
  const auto withMatrix = [](const glm::dmat4& matrix) {
    Sweep sweep = stack(5, 5, 3, 1.0, level);
    sweep.frames[1].imageToWorld.matrix = matrix;
    return sweep;
  };
  glm::dmat4 m(1.0);
  m[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf(withMatrix(m), {}, "frame 1 from image to world contains a value that is not a finite number"), ErrorCode::badField);
  m[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(codeOf(withMatrix(m), {}, "not a finite number"), ErrorCode::badField);
  m = glm::dmat4(1.0);
  m[0][3] = 0.5;
  EXPECT_EQ(codeOf(withMatrix(m), {}, "0 0 0 1"), ErrorCode::badField);
  EXPECT_EQ(codeOf(withMatrix(matrixOf({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {})), {}, "a line or a point"), ErrorCode::badField);
  EXPECT_EQ(codeOf(withMatrix(matrixOf({1, 2, 3}, {2, 4, 6}, {0, 0, 1}, {})), {}, "a line or a point"), ErrorCode::badField);
  EXPECT_EQ(codeOf(withMatrix(matrixOf({1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 1}, {})), {}, "a line or a point"), ErrorCode::badField);
  EXPECT_EQ(codeOf(withMatrix(matrixOf({1e9, 0, 0}, {0, 1e9, 0}, {0, 0, 1}, {})), {}, "wrong scale"), ErrorCode::tooLarge);
}

TEST(HardGeometry, OptionsThatCannotBeUsedAreRefused) {
  const Sweep sweep = stack(20, 10, 3, 1.0, level);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double spacing_mm : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(codeOf(sweep, {.spacing_mm = spacing_mm}, "spacing"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.fillReach_mm = -1}, "reach"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.fillReach_mm = nan}, "reach"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.fillReach_mm = 1000.0}, "more than the 256"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.threads = -2}, "threads"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.clip = {.origin_px = {25, 0}}}, "outside the 20 x 10 px frame"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.clip = {.size_px = glm::dvec2(-5, 5)}}, "negative size"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.clip = {.origin_px = {nan, 0}}}, "not a number"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.clip = {.fan = ClipFan{{500, 500}, -0.1, 0.1, 1, 2}}}, "no pixel"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.clip = {.fan = ClipFan{{5, 5}, -0.1, 0.1, 9, 2}}}, "before it begins"), ErrorCode::badField);
  EXPECT_EQ(codeOf(sweep, {.compounding = Compounding::latest, .keepWeights = true}, "mean"), ErrorCode::badField);
}

TEST(HardSequences, FramesOfDifferentSizesAreRefused) {
  Sweep sweep = stack(5, 5, 2, 1.0, level);
  sweep.add(imageOf(6, 5, [](int, int) { return 0; }), glm::dmat4(1.0));
  EXPECT_EQ(codeOf(sweep, {}, "Frame 2 has 6 x 5 pixels"), ErrorCode::badField);
}

}  // namespace
}  // namespace ew::acquisition_test
