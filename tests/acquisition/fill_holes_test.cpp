#include "ew/acquisition/fill_holes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ew::fill_holes_test {
namespace {

Volume emptyVolume(const glm::ivec3& dims) {
  Volume volume;
  volume.grid.dims = dims;
  volume.echo.assign(volume.grid.voxelCount(), 0);
  volume.coverage.assign(volume.grid.voxelCount(), 0);
  return volume;
}

void measure(Volume& volume, const glm::ivec3& at, int echo) {
  const std::size_t index = volume.grid.indexOf(at.x, at.y, at.z);
  volume.echo[index] = static_cast<std::uint8_t>(echo);
  volume.coverage[index] = static_cast<std::uint8_t>(Coverage::measured);
}

Volume randomVolume(const glm::ivec3& dims, double share, unsigned seed) {
  Volume volume = emptyVolume(dims);
  std::mt19937 random(seed);
  for (std::size_t v = 0; v < volume.echo.size(); ++v)
    if (random() < share * 4294967296.0) {
      volume.coverage[v] = 2;
      volume.echo[v] = static_cast<std::uint8_t>(random() >> 24);
    }
  return volume;
}

HoleFillResult filled(const Volume& volume, double reach_mm, int threads = 1) {
  auto result = fillHoles(volume, {reach_mm, threads}, noProgress());
  if (!result) {
    ADD_FAILURE() << result.error();
    return {};
  }
  return std::move(*result);
}

/// The definition, voxel by voxel: the nearest measured ones along both ways of 13 directions.
Volume plainlyFilled(const Volume& volume, double reach_mm) {
  Volume result = volume;
  const int reach_voxels =
      static_cast<int>(std::ceil(reach_mm / std::min({volume.grid.spacing_mm.x, volume.grid.spacing_mm.y, volume.grid.spacing_mm.z})));
  const Grid& grid = volume.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        if (volume.coverageAt(grid.indexOf(i, j, k)) != Coverage::absent) continue;
        double total = 0.0, weight = 0.0;
        for (int direction = 14; direction < 27; ++direction) {
          const glm::ivec3 step(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
          int steps[2] = {0, 0}, echo[2] = {0, 0};
          for (int side = 0; side < 2; ++side)
            for (int n = 1; n <= reach_voxels && steps[side] == 0; ++n) {
              const glm::ivec3 at = glm::ivec3(i, j, k) + step * (side == 0 ? -n : n);
              if (!grid.contains(at)) break;
              if (volume.coverageAt(grid.indexOf(at.x, at.y, at.z)) != Coverage::measured) continue;
              steps[side] = n;
              echo[side] = volume.echo[grid.indexOf(at.x, at.y, at.z)];
            }
          if (steps[0] == 0 || steps[1] == 0) continue;
          const int span = steps[0] + steps[1];
          const glm::dvec3 step_mm = glm::dvec3(step) * grid.spacing_mm;
          const double squared = static_cast<double>(span) * span * glm::dot(step_mm, step_mm);
          if (squared > reach_mm * reach_mm + 1e-6) continue;
          const double share = std::pow(squared, -6.0);
          total += (static_cast<double>(echo[0]) * steps[1] + static_cast<double>(echo[1]) * steps[0]) / span * share;
          weight += share;
        }
        if (weight == 0.0) continue;
        result.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(std::floor(total / weight + 0.5));
        result.coverage[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(Coverage::interpolated);
      }
  return result;
}

TEST(FillHoles, InterpolatesLinearlyBetweenTwoSheets) {
  Volume volume = emptyVolume({5, 70, 6});
  for (int j = 0; j < 70; ++j)
    for (int i = 0; i < 5; ++i) {
      measure(volume, {i, j, 0}, 50);
      measure(volume, {i, j, 5}, 100);
    }
  const HoleFillResult result = filled(volume, 5);
  EXPECT_EQ(result.filledVoxels, 5u * 70u * 4u);
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 70; ++j) EXPECT_EQ(result.volume.echo[volume.grid.indexOf(2, j, k)], 50 + 10 * k);
}

TEST(FillHoles, LeavesAGapWiderThanTheReachOpen) {
  Volume volume = emptyVolume({3, 3, 20});
  measure(volume, {1, 1, 2}, 10);
  measure(volume, {1, 1, 12}, 20);
  EXPECT_EQ(filled(volume, 9).filledVoxels, 0u);
  EXPECT_EQ(filled(volume, 10).filledVoxels, 9u);
}

TEST(FillHoles, MeasuresTheReachAsADistanceAlongDiagonalsToo) {
  Volume volume = emptyVolume({8, 8, 8});
  measure(volume, {1, 1, 1}, 10);
  measure(volume, {5, 5, 5}, 10);  // 4 * sqrt(3) = 6.93 away
  EXPECT_EQ(filled(volume, 6).filledVoxels, 0u);
  EXPECT_EQ(filled(volume, 7).filledVoxels, 3u);
}

TEST(FillHoles, MeasuresTheReachInMmWhateverTheSpacing) {
  for (const double spacing_mm : {0.25, 0.5, 2.0}) {
    Volume volume = emptyVolume({3, 3, 20});
    volume.grid.spacing_mm = {1.0, 7.0, spacing_mm};
    measure(volume, {1, 1, 2}, 10);
    measure(volume, {1, 1, 12}, 20);
    EXPECT_EQ(filled(volume, 10 * spacing_mm - 0.01).filledVoxels, 0u) << spacing_mm;
    EXPECT_EQ(filled(volume, 10 * spacing_mm).filledVoxels, 9u) << spacing_mm;
  }
}

TEST(FillHoles, DoesNotInflateTheOutsideOfASheet) {
  Volume volume = emptyVolume({40, 40, 9});
  for (int j = 5; j < 35; ++j)
    for (int i = 5; i < 35; ++i) measure(volume, {i, j, 4}, 77);
  EXPECT_EQ(filled(volume, 8).filledVoxels, 0u);
}

TEST(FillHoles, TreatsAMeasuredZeroAsAnEnd) {
  Volume volume = emptyVolume({5, 1, 1});
  measure(volume, {0, 0, 0}, 200);
  measure(volume, {2, 0, 0}, 0);
  measure(volume, {4, 0, 0}, 100);
  const HoleFillResult result = filled(volume, 4);
  EXPECT_EQ(result.volume.echo[1], 100);
  EXPECT_EQ(result.volume.echo[3], 50);
}

TEST(FillHoles, BridgesWordsOfSixtyFourVoxels) {
  Volume volume = emptyVolume({200, 3, 3});
  measure(volume, {60, 1, 1}, 100);
  measure(volume, {132, 1, 1}, 172);
  const HoleFillResult result = filled(volume, 100);
  EXPECT_EQ(result.filledVoxels, 71u);
  for (int i = 61; i < 132; ++i) EXPECT_EQ(result.volume.echo[volume.grid.indexOf(i, 1, 1)], 40 + i);
}

RC_GTEST_PROP(FillHoles, EqualsThePlainDefinition, ()) {
  const glm::ivec3 dims(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
  const double reach_mm = *rc::gen::inRange(0, 12);
  const double share = *rc::gen::elementOf(std::vector{0.02, 0.1, 0.5, 0.95});
  Volume volume = randomVolume(dims, share, *rc::gen::inRange(0u, 100000u));
  volume.grid.spacing_mm = *rc::gen::elementOf(std::vector<glm::dvec3>{{1, 1, 1}, {1, 1.5, 3}, {2, 0.75, 1}});
  const auto result = fillHoles(volume, {reach_mm, 2}, noProgress());
  RC_ASSERT(result.has_value());
  const Volume expected = plainlyFilled(volume, reach_mm);
  RC_ASSERT(result->volume.coverage == expected.coverage);
  for (std::size_t v = 0; v < expected.echo.size(); ++v)
    RC_ASSERT(std::abs(int{result->volume.echo[v]} - int{expected.echo[v]}) <= 1);  // ties of the doubles may fall either way
}

TEST(FillHoles, EqualsThePlainDefinitionWhereBridgesCrossTiles) {
  const Volume volume = randomVolume({70, 110, 120}, 0.01, 5);
  const HoleFillResult result = filled(volume, 9);
  const Volume expected = plainlyFilled(volume, 9);
  EXPECT_TRUE(result.volume.coverage == expected.coverage);
  std::size_t different = 0;
  for (std::size_t v = 0; v < expected.echo.size(); ++v)
    different += std::abs(int{result.volume.echo[v]} - int{expected.echo[v]}) > 1 ? 1 : 0;
  EXPECT_EQ(different, 0u);
}

RC_GTEST_PROP(FillHoles, NeverChangesAMeasuredVoxelAndIsTheSameWithAnyNumberOfThreads, ()) {
  const Volume volume =
      randomVolume({*rc::gen::inRange(1, 90), *rc::gen::inRange(1, 90), *rc::gen::inRange(1, 90)}, 0.05, *rc::gen::inRange(0u, 100000u));
  const double reach_mm = *rc::gen::inRange(2, 9);
  const auto one = fillHoles(volume, {reach_mm, 1}, noProgress());
  RC_ASSERT(one.has_value());
  std::size_t interpolated = 0;
  for (std::size_t v = 0; v < volume.echo.size(); ++v) {
    if (volume.coverage[v] == 2) RC_ASSERT(one->volume.echo[v] == volume.echo[v] && one->volume.coverage[v] == 2);
    interpolated += one->volume.coverage[v] == 1 ? 1 : 0;
  }
  RC_ASSERT(interpolated == one->filledVoxels);
  for (const int threads : {2, 8}) {
    const auto many = fillHoles(volume, {reach_mm, threads}, noProgress());
    RC_ASSERT(many.has_value());
    RC_ASSERT(many->volume == one->volume);
  }
}

TEST(FillHoles, RefusesAReachItCannotUseAndVoxelsThatDoNotFitTheGrid) {
  const auto far = fillHoles(emptyVolume({4, 4, 4}), {100000, 1}, noProgress());
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().code, ErrorCode::badField);
  for (const double reach_mm : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(fillHoles(emptyVolume({4, 4, 4}), {reach_mm, 1}, noProgress()).has_value()) << reach_mm;
  Volume broken = emptyVolume({4, 4, 4});
  broken.coverage.pop_back();
  EXPECT_FALSE(fillHoles(broken, {4, 1}, noProgress()).has_value());
}

}  // namespace
}  // namespace ew::fill_holes_test
