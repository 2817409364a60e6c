#include <gtest/gtest.h>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::coverage_test {
namespace {
using namespace test;

Volume small() {
  Volume volume;
  volume.grid.dims = {3, 2, 1};
  volume.grid.spacing_mm = {0.1, 0.2, 0.3};
  volume.grid.origin_mm = {-123.4567, 1e6, 0.1};
  volume.echo = {9, 8, 7, 6, 5, 4};
  volume.coverage = {0, 1, 2, 2, 1, 0};
  return volume;
}

TEST(Coverage, ComesBackWithItsVolume) {
  const TempFolder folder;
  const Volume volume = small();
  ASSERT_TRUE(succeeded(writeCoverage(volume, folder / "c.mha")));
  Volume again = volume;
  again.coverage.clear();
  ASSERT_TRUE(succeeded(readCoverageInto(again, folder / "c.mha")));
  EXPECT_EQ(again, volume);
}

TEST(Coverage, ThatIsNotKnownIsWrittenAsMeasured) {
  const TempFolder folder;
  Volume volume = small();
  volume.coverage.clear();
  ASSERT_TRUE(succeeded(writeCoverage(volume, folder / "c.mha")));
  ASSERT_TRUE(succeeded(readCoverageInto(volume, folder / "c.mha")));
  EXPECT_EQ(volume.coverage, std::vector<std::uint8_t>(6, 2));
}

TEST(Coverage, OfAnotherGridOrWithOtherValuesIsRefusedAndChangesNothing) {
  const TempFolder folder;
  const Volume volume = small();
  ASSERT_TRUE(succeeded(writeCoverage(volume, folder / "c.mha")));
  ASSERT_TRUE(succeeded(writeVolume(volume, folder / "echo.mha")));
  Volume moved = volume;
  moved.grid.origin_mm.x += 0.01;
  const Volume before = moved;
  EXPECT_TRUE(failedWith(readCoverageInto(moved, folder / "c.mha"), ErrorCode::badField));
  EXPECT_EQ(moved, before);
  Volume same = volume;
  EXPECT_TRUE(failedWith(readCoverageInto(same, folder / "echo.mha"), ErrorCode::badField));
  EXPECT_EQ(same, volume);
}

}  // namespace
}  // namespace ew::coverage_test
