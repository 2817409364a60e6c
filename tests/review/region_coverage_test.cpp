#include "logic/region_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ew/scanning/contact.h"
#include "made_log.h"

namespace ew::review {
namespace {

using test::allOf;
using test::at;
using test::logOf;

/// A box of 80 x 40 x 40 mm whose first corner is the origin of the world.
Volume box() {
  Volume volume;
  volume.grid.dims = {40, 20, 20};
  volume.grid.spacing_mm = glm::dvec3(2.0);
  volume.grid.origin_mm = glm::dvec3(1.0);
  volume.echo.assign(volume.grid.voxelCount(), 100);
  return volume;
}

TEST(VolumeRegions, FillAVolumeWithCubes) {
  const VolumeRegions regions(box(), box().grid);
  EXPECT_EQ(regions.count(), 20U * 10U * 10U);
  glm::vec3 low(1e9F), high(-1e9F);
  for (const glm::vec3& middle : regions.middles_mm()) {
    low = glm::min(low, middle);
    high = glm::max(high, middle);
  }
  EXPECT_EQ(low, glm::vec3(2.0F));
  EXPECT_EQ(high, glm::vec3(78.0F, 38.0F, 38.0F));
}

TEST(VolumeRegions, LeaveOutWhereThereIsNoEcho) {
  Volume half = box();
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) half.echo[half.grid.indexOf(i, j, k)] = 0;
  EXPECT_EQ(VolumeRegions(half, half.grid).count(), 1000U);
}

TEST(RegionCoverage, CountsTheFramesAndSecondsOfEachRegion) {
  const Volume volume = box();
  const VolumeRegions regions(volume, volume.grid);
  // A face of 40 mm about x = 40, on the surface, looking 60 mm along +y; its plane at z = 22 for 3 frames, then off the box for 2.
  const ScanLog log = logOf(6, 0.2, [](int n, ScanState& state) { state.pose = at({40.0, 0.0, n < 3 ? 22.0 : 300.0}); });
  const auto seen = regionCoverageOf(regions, log, allOf(log));
  ASSERT_TRUE(seen);
  // The slab is as thick as a region's diagonal, 6.93 mm: middles at z = 18.5..25.5, which are 22 alone (18 is too far, so is 26).
  // In x those of 20..60: 22, 26, ... 58.
  EXPECT_EQ(regions.count() - static_cast<std::size_t>(std::count(seen->frames.begin(), seen->frames.end(), 0U)), 10U * 10U);
  for (std::size_t n = 0; n < regions.count(); ++n) {
    const glm::vec3& middle = regions.middles_mm()[n];
    const bool isSeen = middle.z == 22.0F && middle.x > 20.0F && middle.x < 60.0F;
    EXPECT_EQ(seen->frames[n], isSeen ? 3U : 0U);
    EXPECT_FLOAT_EQ(seen->seconds[n], isSeen ? 0.6F : 0.0F);
  }
}

TEST(RegionCoverage, SeesNothingWhereTheFaceDoesNotTouchOrNobodyKnowsThePose) {
  const Volume volume = box();
  const VolumeRegions regions(volume, volume.grid);
  const ScanLog log = logOf(4, 0.2, [](int n, ScanState& state) {
    state.pose = at({40.0, 0.0, 22.0});
    if (n < 2)
      state.gaps_mm.assign(kPointsOfFace, 30.0F);
    else
      state.pose.status = PoseStatus::invalid;
  });
  const auto seen = regionCoverageOf(regions, log, allOf(log));
  ASSERT_TRUE(seen);
  EXPECT_TRUE(std::all_of(seen->frames.begin(), seen->frames.end(), [](std::uint32_t n) { return n == 0; }));
}

TEST(RegionCoverage, CountsNoTimeWhileItIsFrozen) {
  const Volume volume = box();
  const VolumeRegions regions(volume, volume.grid);
  ScanLog log = logOf(2, 0.1, [](int, ScanState& state) { state.pose = at({40.0, 0.0, 22.0}); });
  log.setFrozen(0.1, true);
  log.addNote(60.0, "mark", nullptr);
  const auto seen = regionCoverageOf(regions, log, allOf(log));
  ASSERT_TRUE(seen);
  EXPECT_FLOAT_EQ(seen->longest_s(), 0.1F);
}

TEST(RegionCoverage, AFrameThatStaysLongCountsForAWhileOnly) {
  const Volume volume = box();
  const VolumeRegions regions(volume, volume.grid);
  const ScanLog log = logOf(2, 60.0, [](int, ScanState& state) { state.pose = at({40.0, 0.0, 22.0}); });
  const auto seen = regionCoverageOf(regions, log, allOf(log));
  ASSERT_TRUE(seen);
  EXPECT_FLOAT_EQ(seen->longest_s(), static_cast<float>(kLongestFrame_s));
}

}  // namespace
}  // namespace ew::review
