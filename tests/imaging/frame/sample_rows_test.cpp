// Rows that lie anywhere, and cubic convolution: both against slower definitions.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <limits>

#include "ew/imaging/slicing.h"
#include "imaging/support/sliced.h"
#include "imaging/support/support.h"

namespace ew::sample_rows_test {
namespace {

using testing::ImageToVoxel;
using testing::sliced;

constexpr Quality kQualities[] = {Quality::weave, Quality::linear, Quality::cubic};

TEST(SampleRows, OfAPlaneGiveTheSliceOfThatPlane) {
  const Volume volume = testing::noiseVolume({40, 50, 30}, 2);
  std::mt19937 random(3);
  for (const Quality quality : kQualities)
    for (int trial = 0; trial < 60; ++trial) {
      const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 71, 43, trial % 2 ? 1.0 : 0.61);
      const GreyImage expected = sliced(quality, volume.view(), plane, 71, 43);
      std::vector<SampleRow> rows;
      for (int y = 0; y < 43; ++y) {
        const glm::dvec3 start = glm::dvec3(plane.matrix[3]) + static_cast<double>(y) * glm::dvec3(plane.matrix[1]);
        rows.push_back({start, glm::dvec3(plane.matrix[0]), y, {0, 71}});
      }
      GreyImage out(71, 43, 99);
      SliceScratch scratch;
      sampleRows(quality, volume.view(), rows, viewOf(out), scratch);
      int different = 0;
      for (std::size_t n = 0; n < out.pixels.size(); ++n) different += out.pixels[n] != expected.pixels[n];
      ASSERT_LE(different, 0) << "trial " << trial;
    }
}

TEST(SampleRows, FanOutFromAPointAndWriteNothingOutsideTheirSpans) {
  const Volume volume = testing::volumeOf({60, 60, 60}, [](int i, int j, int k) { return i + 2 * j + k; });
  std::vector<SampleRow> rows;
  for (int n = 0; n < 20; ++n) {
    const double angle = 0.05 * n - 0.5;
    rows.push_back({glm::dvec3(30, 2, 30), 0.7 * glm::dvec3(std::sin(angle), std::cos(angle), 0.1), 19 - n, {n % 3, 70 - n}});
  }
  SliceScratch scratch;
  for (const Quality quality : {Quality::linear, Quality::cubic}) {
    GreyImage out(75, 20, 7);
    sampleRows(quality, volume.view(), rows, viewOf(out), scratch);
    for (const SampleRow& row : rows)
      for (int x = 0; x < 75; ++x) {
        const int value = viewOf(out).at(x, row.row);
        if (x < row.span.begin || x >= row.span.end) {
          ASSERT_EQ(value, 7);
        } else {
          const glm::dvec3 p = row.start_voxel + static_cast<double>(x) * row.step_voxel;
          ASSERT_NEAR(value, p.x + 2 * p.y + p.z, quality == Quality::linear ? testing::linearBound_grey(4.0) : testing::kCubicBound_grey)
              << "row " << row.row << " sample " << x;
        }
      }
  }
}

TEST(SampleRows, ThatAreNotFiniteOrFarAwayBecomeBlackAndTheOthersStay) {
  const Volume volume = testing::volumeOf({20, 20, 20}, [](int, int, int) { return 50.0; });
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::array<SampleRow, 6> rows = {{{{5, 5, 5}, {0, 0, 0.1}, 0, {0, 12}},
                                          {{nan, 5, 5}, {0, 0, 1}, 1, {0, 12}},
                                          {{5, 5, 5}, {0, infinity, 0}, 2, {0, 12}},
                                          {{1e300, 5, 5}, {0, 0, 1}, 3, {2, 12}},
                                          {{5, 5, 5}, {-1e18, 0, 0}, 4, {0, 12}},
                                          {{5, 5, 5}, {0, 0.1, 0}, 5, {4, 4}}}};
  SliceScratch scratch;
  for (const Quality quality : kQualities) {
    GreyImage out(12, 6, 9);
    sampleRows(quality, volume.view(), rows, viewOf(out), scratch);
    for (int x = 0; x < 12; ++x) {
      EXPECT_EQ(viewOf(out).at(x, 0), 50);
      EXPECT_EQ(viewOf(out).at(x, 1), 0);
      EXPECT_EQ(viewOf(out).at(x, 2), 0);
      EXPECT_EQ(viewOf(out).at(x, 3), x < 2 ? 9 : 0);
      EXPECT_EQ(viewOf(out).at(x, 4), 0);
      EXPECT_EQ(viewOf(out).at(x, 5), 9);
    }
  }
}

}  // namespace
}  // namespace ew::sample_rows_test
