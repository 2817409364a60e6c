#include "comparable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "registration/ellipsoids.h"
#include "registration/shadows.h"
#include "streaks.h"

/// What images are before they are compared: what was covered, free of gain, without streaks.
namespace ew::registration::comparable_test {
namespace {

using ew::test::shadowed;
using test::centred;
using test::pose;
using test::seen;
using test::tissue;

TEST(Covered, BlackBesideTheSectorIsOutsideAndBlackInsideIsNot) {
  Volume volume;
  volume.grid = centred({40, 40, 40}, 1.0);
  volume.echo.assign(64000, 90);
  const auto set = [&](glm::ivec3 low, glm::ivec3 high, auto&& grey) {
    for (int k = low.z; k < high.z; ++k) {
      for (int j = low.y; j < high.y; ++j) {
        for (int i = low.x; i < high.x; ++i) volume.echo[volume.grid.indexOf(i, j, k)] = grey(i, j, k);
      }
    }
  };
  const auto black = [](int, int, int) { return std::uint8_t{0}; };
  set({0, 0, 0}, {12, 40, 40}, black);                     // beside the sector
  set({22, 22, 22}, {36, 36, 36}, black);                  // a cyst within
  set({20, 10, 0}, {25, 15, 40}, black);                   // a vessel to both borders, 5 mm thick
  set({28, 5, 5}, {38, 15, 35}, [](int i, int j, int k) {  // the noise floor: one voxel in six still shows
    return static_cast<std::uint8_t>((i * 7 + j * 13 + k * 29) % 6 == 0 ? 20 : 0);
  });
  const auto mask = coveredMask(volume, noProgress());
  ASSERT_TRUE(mask);
  const auto at = [&](int i, int j, int k) { return (*mask)[volume.grid.indexOf(i, j, k)]; };
  EXPECT_EQ(at(5, 20, 20), 0);
  EXPECT_EQ(at(11, 20, 20), 0);
  EXPECT_EQ(at(12, 20, 20), 255);
  EXPECT_EQ(at(29, 29, 29), 255) << "a cyst does not reach the border";
  EXPECT_EQ(at(22, 12, 0), 255) << "a vessel is too thin to be outside";
  std::size_t holes = 0;
  for (int k = 5; k < 35; ++k) {
    for (int j = 5; j < 15; ++j) {
      for (int i = 28; i < 38; ++i) holes += at(i, j, k) == 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(holes, 0u) << "voxels at the noise floor are covered";
}

TEST(Covered, FollowsTheCoverageOfTheVolumeWhenThereIsOne) {
  Volume volume;
  volume.grid = centred({20, 20, 20}, 1.0);
  volume.echo.assign(8000, 0);
  volume.coverage.assign(8000, 2);
  volume.coverage[77] = 0;
  volume.coverage[78] = 1;
  const auto mask = coveredMask(volume, noProgress());
  ASSERT_TRUE(mask);
  EXPECT_EQ((*mask)[76], 255);
  EXPECT_EQ((*mask)[77], 0);
  EXPECT_EQ((*mask)[78], 255);
}

TEST(Comparable, GainAndDepthGainHardlyShow) {
  const auto all = tissue(3, 60.0);
  const Grid grid = centred({40, 40, 40}, 1.0);
  Volume plain = seen(all, grid, {}, 1, 6.0);
  Volume gained = plain;
  for (std::size_t q = 0; q < gained.echo.size(); ++q) {
    const double depth = static_cast<double>(q / 40 % 40) / 40.0;
    gained.echo[q] = static_cast<std::uint8_t>(std::clamp(0.6 * gained.echo[q] + 20.0 + 40.0 * depth, 0.0, 255.0));
  }
  const std::vector<double> voxels{2.0, 1.0};
  const auto a = comparableImages({&plain}, voxels, {}, noProgress());
  const auto b = comparableImages({&gained}, voxels, {}, noProgress());
  ASSERT_TRUE(a && b);
  for (std::size_t level = 0; level < 2; ++level) {
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t q = 0; q < (*a)[level].value.size(); ++q) {
      const double x = (*a)[level].value[q];
      const double y = (*b)[level].value[q];
      ab += x * y;
      aa += x * x;
      bb += y * y;
    }
    EXPECT_GT(ab / std::sqrt(aa * bb), 0.94) << level;
    EXPECT_NEAR(std::sqrt(bb / aa), 1.0, 0.2) << level;
  }
}

TEST(Comparable, LevelsKeepThePlaceOfThingsOnAnyAxes) {
  // A bright plane tilted in the world must lie where it lay, whatever the voxels.
  Grid grid = centred({50, 30, 20}, 1.0);
  grid.spacing_mm = {0.8, 1.3, 2.0};
  const glm::dmat3 turn(pose({}, {20.0, 30.0, -10.0}).matrix);
  grid.directions = glm::dmat3(turn[0], turn[1], -turn[2]);  // left-handed
  grid.origin_mm = {100.0, -50.0, 7.0};
  const glm::dvec3 middle(grid.voxelToWorld().matrix * glm::dvec4(24.5, 14.5, 9.5, 1.0));
  Volume volume;
  volume.grid = grid;
  volume.echo.resize(grid.voxelCount());
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 0.4, 0.3));
  const auto height = [&](const glm::dvec3& p) { return glm::dot(p - middle, n); };
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 30; ++j) {
      for (int i = 0; i < 50; ++i) {
        const double h = height(glm::dvec3(grid.voxelToWorld().matrix * glm::dvec4(i, j, k, 1.0)));
        volume.echo[grid.indexOf(i, j, k)] = static_cast<std::uint8_t>(60.0 + 150.0 * std::exp(-0.5 * h * h / 9.0));
      }
    }
  }
  const std::vector<double> voxels{2.6, 1.3};
  const auto levels = comparableImages({&volume}, voxels, {}, noProgress());
  ASSERT_TRUE(levels);
  for (const ComparableImage& level : *levels) {
    double sum = 0.0;
    double moment = 0.0;
    for (int k = 1; k < level.grid.dims.z - 1; ++k) {
      for (int j = 1; j < level.grid.dims.y - 1; ++j) {
        for (int i = 1; i < level.grid.dims.x - 1; ++i) {
          const double v = std::max(0.0F, level.value[level.grid.indexOf(i, j, k)] - 0.5F);
          const double h = height(glm::dvec3(level.grid.voxelToWorld().matrix * glm::dvec4(i, j, k, 1.0)));
          if (std::abs(h) > 8.0) continue;
          sum += v;
          moment += v * h;
        }
      }
    }
    EXPECT_NEAR(moment / sum, 0.0, 0.15) << level.grid.spacing_mm.x;
  }
}

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::min(1.0, std::abs(glm::dot(glm::normalize(a), glm::normalize(b))))) * 57.2957795;
}

TEST(Streaks, AreFoundAlongTheBeamAndNotInTissue) {
  const Grid grid = centred({52, 48, 56}, 1.5);
  Grid turned = grid;
  turned.directions = glm::dmat3(pose({}, {25.0, -10.0, 40.0}).matrix);
  turned.origin_mm = turned.directions * grid.origin_mm;
  const std::vector<double> voxels{3.0};
  for (const Grid& g : {grid, turned}) {
    const Volume plain = seen(tissue(5, 130.0), g, {}, 3);
    for (const glm::dvec3 beam : {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.3, -2.0, 0.4)}) {
      const Volume dark = shadowed(plain, beam, 0.4);
      const auto images = comparableImages({&dark}, voxels, {}, noProgress());
      ASSERT_TRUE(images);
      const auto found = findStreaks((*images)[0], 1, noProgress());
      ASSERT_FALSE(found.empty());
      EXPECT_LT(angle_deg(found[0], beam), 4.0);
    }
    const auto images = comparableImages({&plain}, voxels, {}, noProgress());
    ASSERT_TRUE(images);
    EXPECT_TRUE(findStreaks((*images)[0], 1, noProgress()).empty());
  }
}

TEST(Streaks, AreTakenOutAndWhatIsCompactStays) {
  const Grid grid = centred({40, 36, 44}, 1.5);
  const glm::dvec3 beam(0.2, 0.9, 0.3);
  Volume streaks;
  streaks.grid = grid;
  streaks.echo.assign(grid.voxelCount(), 120);
  streaks = shadowed(std::move(streaks), beam, 0.5);
  const auto spread = [&](const Volume& volume) {
    std::vector<float> sum(volume.echo.begin(), volume.echo.end());
    double mean = 0.0;
    for (const float v : sum) mean += static_cast<double>(v) / static_cast<double>(sum.size());
    double before = 0.0;
    for (const float v : sum) before += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
    EXPECT_TRUE(takeOutAlong(grid, {static_cast<std::size_t>(grid.dims.x)}, {beam}, kAlongBeam_mm, std::vector<float>(sum.size(), 1.0F),
                             sum, 1, noProgress()));
    double after = 0.0;
    for (const float v : sum) after += static_cast<double>(v) * static_cast<double>(v);
    return std::sqrt(after / before);
  };
  EXPECT_LT(spread(streaks), 0.2);
  EXPECT_GT(spread(seen(tissue(6, 80.0), grid, {}, 1, 0.0)), 0.4);
}

TEST(Streaks, OfAFanAreTakenOutAlongEachBeam) {
  const Grid grid = centred({60, 56, 20}, 1.5);
  const Beams fan{{0.0, 1.0, 0.0}, Beams::Fan{{0.0, -70.0, -20.0}, {0.0, -70.0, 20.0}}};
  std::vector<float> sum(grid.voxelCount());
  const auto shadowsOfTheFan = [&] {
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) {
          const glm::dvec3 beam = fan.at(glm::dvec3(grid.voxelToWorld().matrix * glm::dvec4(i, j, k, 1.0)));
          sum[grid.indexOf(i, j, k)] = static_cast<float>(60.0 * std::sin(40.0 * std::atan2(beam.x, beam.y)));
        }
  };
  const auto left = [&](const Beams& beams) {
    shadowsOfTheFan();
    double before = 0.0, after = 0.0;
    for (const float v : sum) before += static_cast<double>(v) * static_cast<double>(v);
    EXPECT_TRUE(takeOutAlong(grid, {static_cast<std::size_t>(grid.dims.x)}, beams, kAlongBeam_mm, std::vector<float>(sum.size(), 1.0F), sum,
                             2, noProgress()));
    for (const float v : sum) after += static_cast<double>(v) * static_cast<double>(v);
    return std::sqrt(after / before);
  };
  EXPECT_LT(left(fan), 0.2);
  EXPECT_GT(left({fan.direction}), 0.4);  // one direction for all leaves those of the sides
}

}  // namespace
}  // namespace ew::registration::comparable_test
