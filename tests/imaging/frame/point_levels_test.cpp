#include "ew/imaging/point_levels.h"

#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <vector>

#include "ew/imaging/slicing.h"
#include "imaging/support/every_target.h"
#include "imaging/support/sliced.h"
#include "imaging/support/support.h"

namespace ew::point_levels_test {
namespace {

/// By the definition, in double precision; none where nothing is seen.
std::optional<double> definition(const Volume& volume, const glm::dvec3& p) {
  const glm::dvec3 last(volume.grid.dims - 1);
  for (int a = 0; a < 3; ++a)
    if (!(p[a] >= -1e-6 && p[a] <= last[a] + 1e-6)) return {};
  const glm::dvec3 inside = glm::clamp(p, glm::dvec3(0.0), last);
  const auto indexOf = [&](const glm::ivec3& ijk) { return volume.grid.indexOf(ijk.x, ijk.y, ijk.z); };
  if (volume.coverageAt(indexOf(glm::ivec3(glm::floor(inside + 0.5)))) == Coverage::absent) return {};
  double sum = 0.0, present = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 at = glm::ivec3(glm::floor(inside)) + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 near = 1.0 - glm::abs(inside - glm::dvec3(at));
    const double share = std::max(0.0, near.x) * std::max(0.0, near.y) * std::max(0.0, near.z);
    if (share == 0.0 || volume.coverageAt(indexOf(at)) == Coverage::absent) continue;
    sum += share * volume.echo[indexOf(at)];
    present += share;
  }
  return sum / present;
}

Volume withGaps(glm::ivec3 dims, unsigned seed) {
  Volume volume = testing::noiseVolume(dims, seed);
  std::mt19937 random(seed + 1);
  for (std::size_t n = 0; n < volume.echo.size(); ++n) volume.coverage.push_back(static_cast<std::uint8_t>(random() % 3));
  return volume;
}

std::vector<glm::dvec3> pointsAround(const glm::ivec3& dims, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-0.1, 1.1);
  std::vector<glm::dvec3> points;
  for (int n = 0; n < count; ++n) {
    const double a = unit(random), b = unit(random), c = unit(random);
    glm::dvec3 p = glm::dvec3(a, b, c) * glm::dvec3(dims - 1);
    if (n % 5 == 0) p = glm::round(p);               // voxel centres
    if (n % 7 == 0) p.z = n % 2 ? 0.0 : dims.z - 1;  // on the faces
    points.push_back(p);
  }
  return points;
}

std::vector<float> levelsOf(const Volume& volume, const std::vector<glm::dvec3>& points) {
  std::vector<float> levels(points.size(), 77.0F);
  levelsAt(volume, points, levels);
  return levels;
}

TEST(PointLevels, AreThoseOfTheDefinition) {
  for (const bool gaps : {false, true}) {
    for (const glm::ivec3& dims : {glm::ivec3(20, 17, 13), glm::ivec3(2, 2, 2), glm::ivec3(1, 9, 9), glm::ivec3(9, 1, 4),
                                   glm::ivec3(5, 5, 1), glm::ivec3(1, 1, 1)}) {
      const Volume volume = gaps ? withGaps(dims, 3) : testing::noiseVolume(dims, 3);
      const auto points = pointsAround(dims, 5000, 5);
      const auto levels = levelsOf(volume, points);
      int seen = 0;
      for (std::size_t n = 0; n < points.size(); ++n) {
        const auto expected = definition(volume, points[n]);
        ASSERT_EQ(levels[n] >= 0.0F, expected.has_value()) << n;
        if (!expected) continue;
        ++seen;
        ASSERT_NEAR(static_cast<double>(levels[n]), *expected, 2e-3) << n;
      }
      EXPECT_GT(seen, dims.x > 9 ? 1000 : 0);
    }
  }
}

TEST(PointLevels, OfAPlaneRoundToItsLinearSlice) {
  const Volume volume = testing::noiseVolume({60, 50, 40}, 7);
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const auto plane = testing::randomPlane(random, volume.grid, 71, 43, trial % 2 ? 1.0 : 0.4);
    const GreyImage slice = testing::sliced(Quality::linear, volume.view(), plane, 71, 43);
    std::vector<glm::dvec3> points;
    for (int y = 0; y < 43; ++y)
      for (int x = 0; x < 71; ++x) points.push_back(testing::voxelAt(plane, x, y));
    const auto levels = levelsOf(volume, points);
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (levels[n] < 0.0F) continue;
      ASSERT_NEAR(static_cast<float>(slice.pixels[n]), levels[n], testing::kLinearBoundOnNoise_grey + 1e-4) << n;
    }
  }
}

TEST(PointLevels, KeepAConstantBesideAbsentVoxels) {
  Volume volume = withGaps({16, 16, 16}, 9);
  for (std::size_t n = 0; n < volume.echo.size(); ++n) volume.echo[n] = volume.coverage[n] != 0 ? 100 : 0;
  int seen = 0;
  for (const float level : levelsOf(volume, pointsAround(volume.grid.dims, 5000, 10))) {
    if (level < 0.0F) continue;
    ++seen;
    ASSERT_NEAR(level, 100.0F, 1e-3F);
  }
  EXPECT_GT(seen, 1000);
}

TEST(PointLevels, SayNothingOfPointsThatAreNoneOrOfAVolumeWithoutVoxels) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN(), kFar = std::numeric_limits<double>::infinity();
  const std::vector<glm::dvec3> points = {{kNone, 1, 1}, {1, kFar, 1}, {1, 1, -kFar}, {1e300, 1, 1}, {1, 1, 1}, {-1e-7, 0, 0}};
  const auto levels = levelsOf(testing::volumeOf({3, 3, 3}, [](int i, int, int) { return 40 + i; }), points);
  EXPECT_EQ(levels, (std::vector<float>{kNothingSeen, kNothingSeen, kNothingSeen, kNothingSeen, 41.0F, 40.0F}));
  EXPECT_EQ(levelsOf(Volume{}, points), std::vector<float>(points.size(), kNothingSeen));
}

TEST(PointLevels, AreTheSameOnEveryInstructionSet) {
  for (const bool gaps : {false, true}) {
    const Volume volume = gaps ? withGaps({30, 20, 25}, 11) : testing::noiseVolume({30, 20, 25}, 11);
    const auto points = pointsAround(volume.grid.dims, 3001, 12);
    const auto expected = levelsOf(volume, points);
    testing::onEveryTarget([&](const char* name) { EXPECT_EQ(levelsOf(volume, points), expected) << name; });
  }
}

}  // namespace
}  // namespace ew::point_levels_test
