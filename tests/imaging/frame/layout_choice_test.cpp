// Which of the two layouts a slice is read from: rows and bricks hold different greys here, so that an image tells.
#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include "ew/imaging/layout_times.h"
#include "ew/imaging/slicing.h"
#include "imaging/support/sliced.h"
#include "imaging/support/support.h"

namespace ew::layout_choice_test {
namespace {

using testing::ImageToVoxel;
using testing::sliced;

constexpr int kSide = 48, kPixels = 9;
constexpr std::uint8_t kOfRows = 40, kOfBricks = 200;

Volume filledWith(std::uint8_t grey) {
  Volume volume;
  volume.grid.dims = glm::ivec3(kSide);
  volume.echo.assign(volume.grid.voxelCount(), grey);
  return volume;
}

struct BothLayouts {
  Volume rows = filledWith(kOfRows);
  BrickVolume bricks = *bricksOf(filledWith(kOfBricks).view(), 1, 1, noProgress());
  [[nodiscard]] SliceSource source(const LayoutChoice& choice) const { return inBothLayouts(rows.view(), bricks, choice); }
};

/// A plane through the middle that belongs to a class.
ImageToVoxel planeOf(const SliceClass& wanted) {
  for (int n = 0; n < 10000; ++n) {
    const double t = n;
    const glm::dmat3 axes =
        glm::mat3_cast(glm::angleAxis(0.7 + 0.9 * t, glm::normalize(glm::dvec3(std::sin(2.4 * t), std::cos(1.7 * t), std::sin(3.1 * t)))));
    if (sliceClassOf(wanted.quality, axes[0], axes[1]) != wanted) continue;
    ImageToVoxel plane;
    for (int a = 0; a < 3; ++a) plane.matrix[a] = glm::dvec4(axes[a], 0.0);
    plane.matrix[3] = glm::dvec4(glm::dvec3(0.5 * kSide) - 0.5 * (kPixels - 1) * (axes[0] + axes[1]), 1.0);
    return plane;
  }
  ADD_FAILURE() << "no plane of class " << wanted.index();
  return {};
}

std::uint8_t greyOf(const SliceClass& slice, const SliceSource& source) {
  return sliced(slice.quality, source, planeOf(slice), kPixels, kPixels).pixels[kPixels * kPixels / 2];
}

}  // namespace

TEST(SliceClass, IsHowManyOfTheVolumesRowsASampleMeetsAndWhetherSamplesFollowThem) {
  using Meets = SliceClass::Meets;
  const glm::dvec3 i(1.0, 0.0, 0.0), j(0.0, 1.0, 0.0), k(0.0, 0.0, 1.0);
  const auto classOf = [](const glm::dvec3& step, const glm::dvec3& nextRow) { return sliceClassOf(Quality::linear, step, nextRow); };
  EXPECT_EQ(classOf(i, j), (SliceClass{Quality::linear, Meets::few, true}));
  EXPECT_EQ(classOf(j, i), (SliceClass{Quality::linear, Meets::few, false}));
  EXPECT_EQ(classOf(j, k), (SliceClass{Quality::linear, Meets::many, false}));
  EXPECT_EQ(classOf(-k, j), (SliceClass{Quality::linear, Meets::many, false})) << "to either side";
  EXPECT_EQ(classOf(0.5 * j, 0.5 * k), (SliceClass{Quality::linear, Meets::some, false})) << "four pixels a voxel meet a row together";
  EXPECT_EQ(classOf(0.2 * j, 0.2 * k), (SliceClass{Quality::linear, Meets::few, false}));
  EXPECT_EQ(classOf(glm::dvec3(0.96, 0.28, 0.0), k), (SliceClass{Quality::linear, Meets::some, true}));
  EXPECT_EQ(classOf(glm::dvec3(-0.96, 0.0, 0.28), j), (SliceClass{Quality::linear, Meets::some, true}));
  for (std::size_t n = 0; n < SliceClass::kCount; ++n) EXPECT_EQ(SliceClass::at(n).index(), n);
}

TEST(LayoutChoice, ASliceIsReadFromBricksWhereItsClassIsChosenAndFromRowsElsewhere) {
  const BothLayouts both;
  for (std::size_t chosen = 0; chosen < SliceClass::kCount; ++chosen) {
    const SliceSource source = both.source(LayoutChoice().set(chosen));
    for (std::size_t asked = 0; asked < SliceClass::kCount; ++asked)
      EXPECT_EQ(greyOf(SliceClass::at(asked), source), asked == chosen ? kOfBricks : kOfRows) << chosen << ' ' << asked;
  }
}

TEST(LayoutChoice, PiecesOfAnImageAndScanLinesChooseAsTheirPlaneDoes) {
  const BothLayouts both;
  SliceScratch scratch;
  for (std::size_t n = 0; n < SliceClass::kCount; ++n) {
    const SliceClass slice = SliceClass::at(n);
    const ImageToVoxel plane = planeOf(slice);
    const SliceSource source = both.source(LayoutChoice().set(n));
    GreyImage band(kPixels, kPixels), lines(kPixels, kPixels);
    sliceBand(slice.quality, source, plane, Spans(kPixels, {{0, kPixels}}), 3, 1, viewOf(band), scratch);
    std::vector<SampleRow> rows;
    for (int y = 0; y < kPixels; ++y)
      rows.push_back(
          {glm::dvec3(plane.matrix[3] + static_cast<double>(y) * plane.matrix[1]), glm::dvec3(plane.matrix[0]), y, {0, kPixels}});
    sampleRows(slice.quality, source, rows, viewOf(lines), scratch);
    for (int x = 0; x < kPixels; ++x) {
      EXPECT_EQ(viewOf(band).at(x, 3), kOfBricks) << n;
      EXPECT_EQ(viewOf(lines).at(x, 5), kOfBricks) << n;
    }
  }
}

TEST(LayoutChoice, AWeaveThatZoomsInIsOfTheClassOfItsVoxelSizedSamples) {
  const BothLayouts both;
  const SliceClass many{Quality::weave, SliceClass::Meets::many, false};
  ImageToVoxel plane = planeOf(many);
  const glm::dvec4 middle = plane.matrix * glm::dvec4(0.5 * (kPixels - 1), 0.5 * (kPixels - 1), 0.0, 1.0);
  plane.matrix[0] *= 0.25;
  plane.matrix[1] *= 0.25;
  plane.matrix[3] = middle - 0.5 * (kPixels - 1) * (plane.matrix[0] + plane.matrix[1]);
  GreyImage image(kPixels, kPixels);
  SliceScratch scratch;
  slice(Quality::weave, both.source(LayoutChoice().set(many.index())), plane, viewOf(image), scratch);
  EXPECT_EQ(viewOf(image).at(kPixels / 2, kPixels / 2), kOfBricks);
}

TEST(LayoutTimes, ChooseTheFasterLayoutOfEachClass) {
  LayoutTimes times;
  for (std::size_t n = 0; n < SliceClass::kCount; ++n) times.ofClass[n] = {100.0, n % 3 == 0 ? 50.0 : n % 3 == 1 ? 99.0 : 200.0};
  for (std::size_t n = 0; n < SliceClass::kCount; ++n) EXPECT_EQ(times.choice().test(n), n % 3 != 2) << n;
  EXPECT_NEAR(times.mean().rows_us, 100.0, 1e-9);
  EXPECT_NEAR(times.mean().bricks_us, 100.0 * std::cbrt(0.99), 1e-9);
  EXPECT_NEAR(times.chosen_us(), 100.0 * std::cbrt(0.99 / 2.0), 1e-9) << "a third of the slices takes half";
}

TEST(LayoutTimes, AreMeasuredForEveryClass) {
  const BothLayouts both;
  const LayoutTimes times = timeLayouts(both.rows.view(), both.bricks);
  for (const LayoutPair& pair : times.ofClass) {
    EXPECT_GT(pair.rows_us, 0.0);
    EXPECT_GT(pair.bricks_us, 0.0);
    EXPECT_LT(pair.rows_us + pair.bricks_us, 1e9);
  }
}

}  // namespace ew::layout_choice_test
