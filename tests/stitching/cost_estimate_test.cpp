#include "ew/stitching/cost_estimate.h"

#include <gtest/gtest.h>

namespace ew::stitching::cost_estimate_test {
namespace {

using registration::ElasticEffort;

Grid cube(int side, double spacing_mm) {
  Grid grid;
  grid.dims = glm::ivec3(side);
  grid.spacing_mm = glm::dvec3(spacing_mm);
  return grid;
}

TEST(CostEstimate, IsWhatTheBenchmarkMeasuredOnItsOwnPair) {
  const auto costs = expectedWarps(cube(96, 0.6), cube(96, 0.6));
  EXPECT_NEAR(costs[0].seconds, 0.15, 1e-9);
  EXPECT_NEAR(costs[1].seconds, 0.45, 1e-9);
  EXPECT_NEAR(costs[2].seconds, 0.68, 1e-9);
  EXPECT_EQ(costs[0].error_mm, 0.21);
  EXPECT_EQ(costs[1].error_mm, 0.13);
  EXPECT_EQ(costs[2].error_mm, 0.11);
  EXPECT_NEAR(expectedSearch_s(cube(96, 0.9), cube(96, 0.9), 30.0), 1.8, 1e-9);
}

TEST(CostEstimate, GoesWithTheVoxelsThatAreLookedAt) {
  const auto once = expectedWarps(cube(96, 0.6), cube(96, 0.6));
  const auto larger = expectedWarps(cube(192, 0.6), cube(192, 0.6));
  const auto unlike = expectedWarps(cube(96, 0.6), cube(192, 0.6));
  const auto coarse = expectedWarps(cube(96, 2.0), cube(96, 2.0));
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(larger[n].seconds, 8.0 * once[n].seconds, 1e-9);
    EXPECT_NEAR(unlike[n].seconds, 4.5 * once[n].seconds, 1e-9) << "the mean of both";
    EXPECT_EQ(larger[n].error_mm, once[n].error_mm) << "a larger view is no worse";
    EXPECT_GT(coarse[n].error_mm, once[n].error_mm);
    EXPECT_GT(coarse[n].error95_mm, coarse[n].error_mm);
  }
  // Where the voxels are coarser than the fast setting goes, it saves no level.
  const double volumes = std::pow(2.0 / 0.6, 3.0);
  EXPECT_NEAR(coarse[0].seconds / once[0].seconds, 0.45 * volumes + 0.55 * volumes / 8.0, 1e-9);
}

TEST(CostEstimate, CostsMoreTheMoreItBrings) {
  for (const double spacing : {0.3, 0.6, 1.0, 2.5}) {
    const auto costs = expectedWarps(cube(80, spacing), cube(80, spacing));
    for (std::size_t n = 0; n + 1 < 3; ++n) {
      EXPECT_EQ(costs[n].effort, kEfforts[n]);
      EXPECT_GE(costs[n].error_mm, costs[n + 1].error_mm) << spacing;
    }
    EXPECT_LT(costs[0].seconds, costs[1].seconds);
    EXPECT_LT(costs[1].seconds, costs[2].seconds);
  }
  double before = 0.0;
  for (const double turn : {5.0, 15.0, 30.0, 60.0, 120.0, 180.0}) {
    const double seconds = expectedSearch_s(cube(96, 0.9), cube(96, 0.9), turn);
    EXPECT_GT(seconds, before) << turn;
    before = seconds;
  }
}

TEST(CostEstimate, LearnsThePaceOfThisMachineFromWhatWasBent) {
  const std::vector<std::optional<Grid>> grids = {cube(96, 0.6), cube(96, 0.6), std::nullopt};
  EXPECT_EQ(paceOf(std::vector<PairDeformation>{}, grids).pairs, 0u);
  EXPECT_EQ(paceOf(std::vector<PairDeformation>{}, grids).factor, 1.0);
  std::vector<PairDeformation> warped(4);
  warped[0] = {.fixed = 0, .moving = 1, .effort = ElasticEffort::balanced, .seconds = 50.0, .processor_s = 0.9};
  warped[1] = {.fixed = 0, .moving = 1, .effort = ElasticEffort::fast, .seconds = 0.45, .processor_s = 0.45};
  warped[2] = {.fixed = 1, .moving = 0, .effort = ElasticEffort::balanced, .seconds = 70.0, .processor_s = 1.8};
  warped[3] = {.fixed = 1, .moving = 2, .effort = ElasticEffort::fast, .processor_s = 99.0};  // a volume that is no longer there
  const MachinePace pace = paceOf(warped, grids);
  EXPECT_EQ(pace.pairs, 3u);
  EXPECT_NEAR(pace.factor, 3.0, 1e-9) << "the middle of 2, 3 and 4; that the machine was busy says nothing about it";
  EXPECT_NEAR(expectedWarps(*grids[0], *grids[1], pace)[1].seconds, 1.35, 1e-9);
  EXPECT_NEAR(pace.clock, 70.0 / 1.8, 1e-9) << "but how long one waits for it is known as well";
}

}  // namespace
}  // namespace ew::stitching::cost_estimate_test
