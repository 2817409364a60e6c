#include "ew/acquisition/reconstruct.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <numeric>
#include <utility>

#include "acquisition/sweeps.h"

namespace ew::reconstruct_test {
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

constexpr Interpolation kInterpolations[] = {Interpolation::nearest, Interpolation::linear};
constexpr Compounding kCompoundings[] = {Compounding::mean, Compounding::maximum, Compounding::latest, Compounding::weighted};

/// A sweep with frames tilted about two axes, mirrored where asked, with pixels smaller than voxels.
Sweep tiltedSweep(int count, double tilt_rad, bool mirrored, const std::function<int(int, int, int)>& value, int width = 40,
                  int height = 33) {
  Sweep sweep;
  for (int n = 0; n < count; ++n) {
    glm::dmat4 m = glm::rotate(glm::dmat4(1.0), tilt_rad * (1.0 + 0.05 * n), glm::normalize(glm::dvec3(1.0, 0.4, 0.2)));
    m = glm::translate(m, glm::dvec3(1.3, -0.7, 0.61 * n)) * glm::scale(glm::dmat4(1.0), glm::dvec3(mirrored ? -0.31 : 0.31, 0.27, 0.29));
    sweep.add(imageOf(width, height, [&](int x, int y) { return value(x, y, n); }), m);
  }
  return sweep;
}

int speckle(int x, int y, int n) {
  return static_cast<int>((static_cast<unsigned>(x * 7919 + y * 104729 + n * 1299709) * 2654435761u) >> 24);
}

/// The definition, written as plainly as it can be: doubles, per voxel the sum of weight * value and of weight.
std::vector<std::pair<double, double>> plainSums(const Sweep& sweep, const Grid& grid, Interpolation interpolation) {
  std::vector<std::pair<double, double>> sums(grid.voxelCount());
  for (const TrackedFrame& frame : sweep.frames)
    for (int y = 0; y < frame.pixels.height; ++y)
      for (int x = 0; x < frame.pixels.width; ++x) {
        const glm::dvec3 at = ((frame.imageToWorld * Point<frame::Image>{{x, y, 0.0}}).at - grid.origin_mm) / grid.spacing_mm;
        const auto put = [&](const glm::ivec3& ijk, double weight) {
          if (!grid.contains(ijk)) return;
          auto& [total, sum] = sums[grid.indexOf(ijk.x, ijk.y, ijk.z)];
          total += weight * frame.pixels.at(x, y);
          sum += weight;
        };
        if (interpolation == Interpolation::nearest) {
          put(glm::ivec3(glm::floor(at + 0.5)), 1.0);
        } else {
          const glm::dvec3 base = glm::floor(at), f = at - base;
          for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
            put(glm::ivec3(base) + side, (side.x ? f.x : 1 - f.x) * (side.y ? f.y : 1 - f.y) * (side.z ? f.z : 1 - f.z));
          }
        }
      }
  return sums;
}

TEST(Reconstruct, PutsEveryPixelOfAnAlignedStackIntoItsOwnVoxel) {
  const auto value = [](int x, int y, int z) { return (17 * x + 31 * y + 57 * z) % 256; };
  const Sweep sweep = stack(37, 23, 11, 1.0, value);
  for (const Interpolation interpolation : kInterpolations)
    for (const Compounding compounding : kCompoundings) {
      const ReconstructResult result = made(sweep, {.spacing_mm = 1.0, .interpolation = interpolation, .compounding = compounding});
      ASSERT_EQ(result.volume.grid.dims, glm::ivec3(37, 23, 11));
      EXPECT_EQ(result.volume.grid.origin_mm, glm::dvec3(0.0));
      EXPECT_EQ(result.measuredVoxels, 37u * 23u * 11u);
      EXPECT_EQ(result.pixelsPasted, 37u * 23u * 11u);
      EXPECT_EQ(result.framesUsed, 11u);
      for (int k = 0; k < 11; ++k)
        for (int j = 0; j < 23; ++j)
          for (int i = 0; i < 37; ++i) ASSERT_EQ(result.volume.echo[result.volume.grid.indexOf(i, j, k)], value(i, j, k));
    }
}

TEST(Reconstruct, MovesEveryPixelByOneVoxelWhenOneFrameOfTwoMovesByOneVoxel) {
  Sweep sweep;
  const auto value = [](int x, int y) { return 5 * x + 7 * y; };
  sweep.add(imageOf(9, 8, [](int, int) { return 0; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}));
  sweep.add(imageOf(9, 8, value), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}));
  const ReconstructResult result = made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest});
  ASSERT_EQ(result.volume.grid.dims, glm::ivec3(10, 9, 2));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 9; ++x) EXPECT_EQ(result.volume.echo[result.volume.grid.indexOf(x + 1, y + 1, 1)], value(x, y));
  EXPECT_EQ(result.volume.coverageAt(result.volume.grid.indexOf(0, 0, 1)), Coverage::absent);
}

TEST(Reconstruct, ReturnsARampInAllThreeDirectionsExactlyAtHalfTheVoxelSize) {
  // The ramp is linear in x, y and z, so shares on both sides of a voxel balance and the mean is the ramp itself.
  Sweep sweep;
  for (int n = 0; n < 17; ++n)
    sweep.add(imageOf(33, 25, [&](int x, int y) { return 2 * x + 3 * y + 4 * n; }),
              matrixOf({0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {10, -20, 30 + 0.5 * n}));
  const ReconstructResult result = made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::linear});
  ASSERT_EQ(result.volume.grid.dims, glm::ivec3(17, 13, 9));
  EXPECT_EQ(result.volume.grid.origin_mm, glm::dvec3(10, -20, 30));
  for (int k = 1; k + 1 < 9; ++k)  // at the border there is no other side
    for (int j = 1; j + 1 < 13; ++j)
      for (int i = 1; i + 1 < 17; ++i) ASSERT_EQ(result.volume.echo[result.volume.grid.indexOf(i, j, k)], 4 * i + 6 * j + 8 * k);
}

TEST(Reconstruct, KeepsConstantsConstantHoweverFramesLie) {
  for (const int level : {0, 1, 127, 255})
    for (const Interpolation interpolation : kInterpolations)
      for (const Compounding compounding : kCompoundings) {
        const Sweep sweep = tiltedSweep(9, 0.7, level == 127, [&](int, int, int) { return level; });
        const ReconstructResult result = made(sweep, {.interpolation = interpolation, .compounding = compounding, .fillReach_mm = 6});
        std::size_t known = 0;
        for (std::size_t v = 0; v < result.volume.echo.size(); ++v) {
          const bool absent = result.volume.coverageAt(v) == Coverage::absent;
          ASSERT_EQ(result.volume.echo[v], absent ? 0 : level);
          known += absent ? 0 : 1;
        }
        EXPECT_EQ(known, result.measuredVoxels + result.interpolatedVoxels);
        EXPECT_GT(result.measuredVoxels, 0u);
      }
}

void expectThePlainDefinition(const Sweep& sweep, double spacing_mm) {
  for (const Interpolation interpolation : kInterpolations) {
    const ReconstructResult result = made(sweep, {.spacing_mm = spacing_mm, .interpolation = interpolation, .keepWeights = true});
    const Grid& grid = result.volume.grid;
    const auto expected = plainSums(sweep, grid, interpolation);
    std::size_t different = 0, measured = 0;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) {
          const std::size_t voxel = grid.indexOf(i, j, k);
          const auto& [total, weight] = expected[voxel];
          const bool known = weight > 1e-9;
          measured += known ? 1 : 0;
          const int echo = known ? static_cast<int>(std::floor(total / weight + 0.5)) : 0;
          if (echo != result.volume.echo[voxel] || known != (result.volume.coverageAt(voxel) == Coverage::measured)) ++different;
          ASSERT_NEAR(weight, result.weights[voxel], 1e-5 * std::max(1.0, weight));
        }
    EXPECT_EQ(different, 0u) << grid;
    EXPECT_EQ(measured, result.measuredVoxels);
  }
}

TEST(Reconstruct, EqualsThePlainDefinitionOnTiltedAndMirroredFrames) {
  for (const bool mirrored : {false, true})
    for (const double tilt_rad : {0.0, 0.3, 1.1, 2.9}) expectThePlainDefinition(tiltedSweep(7, tilt_rad, mirrored, speckle), 0.43);
}

TEST(Reconstruct, EqualsThePlainDefinitionWhereManyBricksShareFrames) {
  expectThePlainDefinition(tiltedSweep(3, 0.7, true, speckle, 150, 110), 0.27);
}

RC_GTEST_PROP(Reconstruct, GivesTheSameVoxelsWithOneTwoAndEightThreads, ()) {
  const double tilt_rad = *rc::gen::inRange(-300, 300) / 100.0;
  const int count = *rc::gen::inRange(1, 12);
  const unsigned seed = *rc::gen::inRange(0u, 1000u);
  ReconstructOptions options;
  options.spacing_mm = *rc::gen::inRange(15, 60) / 100.0;
  options.interpolation = *rc::gen::elementOf(std::vector(std::begin(kInterpolations), std::end(kInterpolations)));
  options.compounding = *rc::gen::elementOf(std::vector(std::begin(kCompoundings), std::end(kCompoundings)));
  options.fillReach_mm = *rc::gen::inRange(0, 9);
  const Sweep sweep =
      tiltedSweep(count, tilt_rad, seed % 2 == 0, [&](int x, int y, int n) { return speckle(x, y, n + static_cast<int>(seed)); });
  options.threads = 1;
  const auto one = reconstruct(sweep.frames, options, noProgress());
  RC_ASSERT(one.has_value());
  for (const int threads : {2, 8}) {
    options.threads = threads;
    const auto many = reconstruct(sweep.frames, options, noProgress());
    RC_ASSERT(many.has_value());
    RC_ASSERT(many->volume == one->volume);
    RC_ASSERT(many->measuredVoxels == one->measuredVoxels);
    RC_ASSERT(many->interpolatedVoxels == one->interpolatedVoxels);
  }
}

RC_GTEST_PROP(Reconstruct, LosesNoPixelHoweverTheRowsAreCutIntoBricks, ()) {
  // The weights of all voxels add up to the number of pixels: nothing is dropped or pasted twice at the borders of bricks.
  const double tilt_rad = *rc::gen::inRange(-300, 300) / 100.0;
  const int width = *rc::gen::inRange(1, 500);
  const double spacing_mm = *rc::gen::inRange(25, 80) / 100.0;
  const Sweep sweep = tiltedSweep(3, tilt_rad, false, speckle, width, 40);
  const auto result = reconstruct(
      sweep.frames, {.spacing_mm = spacing_mm, .interpolation = Interpolation::nearest, .threads = 2, .keepWeights = true}, noProgress());
  RC_ASSERT(result.has_value());
  const double pasted = std::accumulate(result->weights.begin(), result->weights.end(), 0.0);
  RC_ASSERT(pasted == 3.0 * width * 40.0);
}

TEST(Reconstruct, RoundsTheMeanOnceAndTiesUpwards) {
  Sweep sweep;
  const glm::dmat4 here = matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0});
  for (const int level : {10, 11, 11, 10, 255}) sweep.add(imageOf(2, 2, [&](int, int) { return level; }), here);
  EXPECT_EQ(made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest}).volume.echo[0], 59);  // 297 / 5 = 59.4
  sweep.frames.pop_back();
  EXPECT_EQ(made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest}).volume.echo[0], 11);  // 42 / 4 = 10.5
  EXPECT_EQ(made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::linear}).volume.echo[0], 11);
}

TEST(Reconstruct, IsExactHoweverManyPixelsFallIntoAVoxel) {
  // 100 pixels of a frame in each voxel: with 33 frames sums of 32 bits are enough, with 34 they might not be, and 45 frames overflow them.
  for (const int frames : {33, 34, 45}) {
    Sweep sweep;
    const auto value = [](int x, int y, int n) { return (x * 7 + y * 13 + n * 29) % 5 == 0 ? 0 : 255 - (x + y + n) % 3; };
    for (int n = 0; n < frames; ++n)
      sweep.add(imageOf(40, 20, [&](int x, int y) { return value(x, y, n); }), matrixOf({0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 1}, {0, 0, 0}));
    const ReconstructResult result =
        made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest, .threads = 1, .keepWeights = true});
    const Grid& grid = result.volume.grid;
    std::vector<std::int64_t> sums(grid.voxelCount()), counts(grid.voxelCount());
    for (int n = 0; n < frames; ++n)
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) {
          const std::size_t index = grid.indexOf((x + 5) / 10, (y + 5) / 10, 0);
          sums[index] += value(x, y, n);
          ++counts[index];
        }
    for (std::size_t index = 0; index < grid.voxelCount(); ++index) {
      ASSERT_EQ(result.volume.echo[index], (2 * sums[index] + counts[index]) / (2 * counts[index])) << frames << " frames, " << index;
      ASSERT_EQ(result.weights[index], static_cast<float>(counts[index]));
    }
  }
}

TEST(Reconstruct, MaximumKeepsTheLargestLatestTheLastAndAMeasuredZeroIsMeasured) {
  Sweep sweep;
  const glm::dmat4 here = matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0});
  for (const int level : {40, 200, 0}) sweep.add(imageOf(3, 3, [&](int, int) { return level; }), here);
  for (const Interpolation interpolation : kInterpolations) {
    const auto maximum = made(sweep, {.spacing_mm = 1.0, .interpolation = interpolation, .compounding = Compounding::maximum});
    const auto latest = made(sweep, {.spacing_mm = 1.0, .interpolation = interpolation, .compounding = Compounding::latest});
    for (std::size_t v = 0; v < maximum.volume.echo.size(); ++v) {
      EXPECT_EQ(maximum.volume.echo[v], 200);
      EXPECT_EQ(latest.volume.echo[v], 0);
      EXPECT_EQ(latest.volume.coverageAt(v), Coverage::measured);
    }
  }
}

TEST(Reconstruct, LinearMaximumAndLatestReachVoxelsOfAtLeastOneEighth) {
  // The first two frames span the grid, the third is a pixel in the middle of 8 voxels, the fourth one close to a voxel.
  Sweep sweep;
  for (const auto& [level, at_mm] : {std::pair(1, 0.0), std::pair(1, 5.0), std::pair(90, 1.5), std::pair(80, 4.25)})
    sweep.add(imageOf(1, 1, [&, value = level](int, int) { return value; }), matrixOf({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, glm::dvec3(at_mm)));
  for (const Compounding compounding : {Compounding::maximum, Compounding::latest}) {
    const auto result = made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::linear, .compounding = compounding});
    const Volume& volume = result.volume;
    for (int corner = 0; corner < 8; ++corner)
      EXPECT_EQ(volume.echo[volume.grid.indexOf(1 + (corner & 1), 1 + (corner >> 1 & 1), 1 + (corner >> 2))], 90);
    EXPECT_EQ(volume.echo[volume.grid.indexOf(4, 4, 4)], 80);              // weight 27/64
    EXPECT_EQ(std::count(volume.echo.begin(), volume.echo.end(), 80), 4);  // and three at 9/64, those at 3/64 stay absent
  }
}

TEST(Reconstruct, CutsTheClipRectangleToTheLastPixelAndPastesOnlyInsideIt) {
  const Sweep sweep = stack(20, 16, 1, 1.0, [](int x, int y, int) { return 1 + x + 10 * y; });
  const auto result = made(
      sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest, .clip = {.origin_px = {3, 2}, .size_px = glm::dvec2(100, 5)}});
  EXPECT_EQ(result.volume.grid.origin_mm, glm::dvec3(3, 2, 0));
  EXPECT_EQ(result.volume.grid.dims, glm::ivec3(17, 6, 1));
  EXPECT_EQ(result.pixelsPasted, 17u * 6u);
  EXPECT_EQ(result.volume.echo[0], 1 + 3 + 20);
}

TEST(Reconstruct, PastesExactlyThePixelsOfTheFanWhereTheNearArcSplitsRows) {
  const double half_rad = 70.0 * std::numbers::pi / 180.0;
  const ClipFan fan{{30.0, 4.0}, half_rad, -half_rad, 12.0, 25.0};
  const Sweep sweep = stack(61, 40, 1, 1.0, [](int, int, int) { return 200; });
  const auto result = made(sweep, {.spacing_mm = 1.0, .interpolation = Interpolation::nearest, .clip = {.fan = fan}});
  std::size_t inside = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 61; ++x) {
      const double radius = std::hypot(x - 30.0, y - 4.0), angle_rad = std::atan2(x - 30.0, y - 4.0);
      const bool expected = radius >= 12.0 && radius <= 25.0 && std::abs(angle_rad) <= half_rad;
      inside += expected ? 1 : 0;
      ASSERT_EQ(result.volume.echo[result.volume.grid.indexOf(x, y, 0)], expected ? 200 : 0) << x << ", " << y;
    }
  EXPECT_EQ(result.pixelsPasted, inside);
  EXPECT_EQ(result.measuredVoxels, inside);
}

TEST(Reconstruct, WeighsEachPixelAsItsFrameSays) {
  Sweep sweep = stack(6, 5, 2, 0.0, [](int, int, int n) { return n == 0 ? 10 : 110; });
  const GreyImage weights[2] = {imageOf(6, 5, [](int x, int) { return x < 4 ? 60 : 0; }),
                                imageOf(6, 5, [](int x, int) { return x < 2 ? 180 : 0; })};
  for (std::size_t n = 0; n < 2; ++n) sweep.frames[n].weights = viewOf(weights[n]);
  for (const Interpolation interpolation : kInterpolations) {
    const auto result =
        made(sweep, {.spacing_mm = 1.0, .interpolation = interpolation, .compounding = Compounding::weighted, .keepWeights = true});
    for (int x = 0; x < 6; ++x) {
      const std::size_t index = result.volume.grid.indexOf(x, 2, 0);
      EXPECT_EQ(result.volume.echo[index], x < 2 ? 85 : x < 4 ? 10 : 0);
      EXPECT_EQ(result.volume.coverageAt(index), x < 4 ? Coverage::measured : Coverage::absent);
      EXPECT_FLOAT_EQ(result.weights[index], x < 2 ? 240.0F / 255.0F : x < 4 ? 60.0F / 255.0F : 0.0F);
    }
  }
}

RC_GTEST_PROP(Reconstruct, GivesTheVoxelsOfTheMeanWhenAllWeightsAreEqual, ()) {
  Sweep sweep = tiltedSweep(*rc::gen::inRange(1, 8), *rc::gen::inRange(-300, 300) / 100.0, false, speckle);
  ReconstructOptions options;
  options.spacing_mm = *rc::gen::inRange(15, 60) / 100.0;
  options.interpolation = *rc::gen::elementOf(std::vector(std::begin(kInterpolations), std::end(kInterpolations)));
  const auto mean = reconstruct(sweep.frames, options, noProgress());
  RC_ASSERT(mean.has_value());
  // 0: no weights at all.
  const int level = *rc::gen::elementOf(std::vector{0, 1, 77, 255});
  const GreyImage weights(40, 33, static_cast<std::uint8_t>(level));
  for (TrackedFrame& frame : sweep.frames)
    if (level > 0) frame.weights = viewOf(weights);
  options.compounding = Compounding::weighted;
  const auto weighted = reconstruct(sweep.frames, options, noProgress());
  RC_ASSERT(weighted.has_value());
  std::size_t different = 0;
  for (std::size_t v = 0; v < mean->volume.echo.size(); ++v) {
    // Doubles that are a hair apart may round apart, and the least weights of a splat may fall below what counts as measured.
    const int apart = std::abs(int{mean->volume.echo[v]} - int{weighted->volume.echo[v]});
    const bool same = apart <= 1 && mean->volume.coverage[v] == weighted->volume.coverage[v];
    different += same && (apart == 0 || options.interpolation == Interpolation::linear) ? 0 : 1;
  }
  // One voxel in ten thousand lies at that border, and one may in a small volume (seed 446353666127751187).
  RC_ASSERT(different <= (options.interpolation == Interpolation::linear ? 1 + mean->volume.echo.size() / 10000 : 0));
}

TEST(Reconstruct, NeedsAtMostEightBytesAVoxelAndSaysSoBefore) {
  Grid grid;
  grid.dims = {546, 484, 325};
  for (const Interpolation interpolation : kInterpolations)
    EXPECT_LT(static_cast<double>(forecastBytes(grid, {.interpolation = interpolation, .fillReach_mm = 8, .threads = 2})),
              2.6 * static_cast<double>(grid.voxelCount()));
}

TEST(Reconstruct, RefusesAVolumeOverTheLimitBeforeTakingMemory) {
  const Sweep sweep = stack(20, 16, 5, 1.0, [](int, int, int) { return 9; });
  const auto result = reconstruct(sweep.frames, {.spacing_mm = 0.001, .maxBytes = 1ull << 30}, noProgress());
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::tooLarge);
  EXPECT_NE(result.error().sentence().find("19001 x 15001 x 4001"), std::string::npos) << result.error();
  EXPECT_NE(result.error().sentence().find("GiB"), std::string::npos) << result.error();
}

class StopsAtOnce final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

TEST(Reconstruct, StopsWhenAskedTo) {
  const Sweep sweep = stack(20, 16, 5, 1.0, [](int, int, int) { return 9; });
  StopsAtOnce stop;
  const auto result = reconstruct(sweep.frames, {.fillReach_mm = 4}, stop);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

TEST(ReconstructOnto, FramesOfOnePartLieWhereTheyLieInTheGridOfAll) {
  const Sweep all = stack(9, 7, 6, 1.0, [](int x, int y, int n) { return 1 + x + 9 * y + 30 * n; });
  const ReconstructOptions options{.spacing_mm = 1.0};
  const auto grid = gridFor(all.frames, options);
  ASSERT_TRUE(grid.has_value());
  const auto part = reconstructOnto(*grid, std::span(all.frames).subspan(2, 2), options, noProgress());
  ASSERT_TRUE(part.has_value()) << part.error();
  EXPECT_EQ(part->volume.grid, *grid);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(part->volume.echo[grid->indexOf(3, 4, k)], k == 2 || k == 3 ? 1 + 3 + 9 * 4 + 30 * k : 0) << k;
}

TEST(ReconstructOnto, RefusesAGridThatDoesNotHoldEveryFrame) {
  const Sweep all = stack(9, 7, 6, 1.0, [](int, int, int) { return 7; });
  const ReconstructOptions options{.spacing_mm = 1.0};
  const auto small = gridFor(std::span(all.frames).subspan(0, 3), options);
  ASSERT_TRUE(small.has_value());
  const auto made = reconstructOnto(*small, all.frames, options, noProgress());
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().code, ErrorCode::badField);
  Grid coarse = *gridFor(all.frames, options);
  coarse.spacing_mm = glm::dvec3(2.0);
  EXPECT_FALSE(reconstructOnto(coarse, all.frames, options, noProgress()).has_value());
}

}  // namespace
}  // namespace ew::reconstruct_test
