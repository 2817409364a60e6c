// Bricks, cubic convolution and every instruction set: the same pixels, and the right ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "ew/imaging/slicing.h"
#include "imaging/support/every_target.h"
#include "imaging/support/sliced.h"
#include "imaging/support/support.h"

namespace ew::bricked_test {
namespace {

using testing::ImageToVoxel;
using testing::sliced;

constexpr Quality kQualities[] = {Quality::weave, Quality::linear, Quality::cubic};

BrickVolume inBricks(const Volume& volume, int levels = 1) {
  auto made = bricksOf(volume.view(), levels, 2, noProgress());
  EXPECT_TRUE(made);
  return std::move(*made);
}

/// Cubic convolution in double precision with clamped neighbours; -1 outside.
double cubicOrMinusOne(const Volume& volume, const glm::dvec3& p) {
  const glm::dvec3 last = glm::dvec3(volume.grid.dims - 1);
  for (int a = 0; a < 3; ++a)
    if (p[a] < -0.5 || p[a] > last[a] + 0.5) return -1.0;
  const glm::dvec3 c = glm::clamp(p, glm::dvec3(0.0), last);
  const glm::ivec3 low(glm::floor(c));
  const auto weight = [](double x) {
    const double s = std::abs(x);
    if (s < 1.0) return (1.5 * s - 2.5) * s * s + 1.0;
    return s < 2.0 ? ((-0.5 * s + 2.5) * s - 4.0) * s + 2.0 : 0.0;
  };
  double sum = 0.0;
  for (int k = -1; k <= 2; ++k)
    for (int j = -1; j <= 2; ++j)
      for (int i = -1; i <= 2; ++i) {
        const glm::ivec3 at = low + glm::ivec3(i, j, k);
        const glm::ivec3 there = glm::clamp(at, glm::ivec3(0), volume.grid.dims - 1);
        sum += weight(c.x - at.x) * weight(c.y - at.y) * weight(c.z - at.z) * volume.echo[volume.grid.indexOf(there.x, there.y, there.z)];
      }
  return std::clamp(sum, 0.0, 255.0);
}

bool nearBorder(const Grid& grid, const glm::dvec3& p) {
  for (int a = 0; a < 3; ++a)
    if (std::abs(p[a] + 0.5) < 1e-6 || std::abs(p[a] - (grid.dims[a] - 0.5)) < 1e-6) return true;
  return false;
}

TEST(BrickVolume, GivesThePixelsOfTheVolumeItWasMadeFromWithEveryQuality) {
  std::mt19937 random(21);
  for (const glm::ivec3 dims : {glm::ivec3(40, 50, 30), glm::ivec3(13, 14, 15), glm::ivec3(1, 20, 20), glm::ivec3(20, 1, 3),
                                glm::ivec3(2, 2, 2), glm::ivec3(27, 3, 1), glm::ivec3(1, 1, 1)}) {
    const Volume volume = testing::noiseVolume(dims, 22);
    const BrickVolume bricks = inBricks(volume);
    for (const Quality quality : kQualities)
      for (int trial = 0; trial < 40; ++trial) {
        const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 71, 43, trial % 3 == 0 ? 0.37 : 1.1);
        ASSERT_EQ(sliced(quality, volume.view(), plane, 71, 43), sliced(quality, bricks.source(volume.grid), plane, 71, 43))
            << "dims " << dims.x << " " << dims.y << " " << dims.z << " quality " << int(quality) << " trial " << trial;
      }
  }
}

TEST(BrickVolume, ZoomsInWithTheWeaveToTheSamePixels) {
  const Volume volume = testing::noiseVolume({40, 50, 30}, 23);
  const BrickVolume bricks = inBricks(volume);
  std::mt19937 random(24);
  for (int trial = 0; trial < 20; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 90, 70, 0.21);
    SliceScratch scratch;
    GreyImage a(90, 70), b(90, 70);
    slice(Quality::weave, volume.view(), plane, viewOf(a), scratch);
    slice(Quality::weave, bricks.source(volume.grid), plane, viewOf(b), scratch);
    ASSERT_EQ(a, b);
  }
}

TEST(Slicing, EveryInstructionSetGivesTheSamePixels) {
  const Volume volume = testing::noiseVolume({60, 50, 40}, 25);
  const BrickVolume bricks = inBricks(volume);
  std::mt19937 random(26);
  for (int trial = 0; trial < 12; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 83, 61, trial % 2 ? 1.0 : 0.43);
    for (const Quality quality : kQualities)
      for (const SliceSource& source : {SliceSource(volume.view()), bricks.source(volume.grid)}) {
        const GreyImage expected = sliced(quality, source, plane, 83, 61);
        testing::onEveryTarget(
            [&](const char* name) { EXPECT_EQ(sliced(quality, source, plane, 83, 61), expected) << name << " quality " << int(quality); });
      }
  }
}

TEST(SliceCubic, EqualsCubicConvolutionInDoublePrecisionWithinOneRoundingAndItsWeights) {
  std::mt19937 random(27);
  const Volume volume = testing::noiseVolume({30, 40, 25}, 28);
  const BrickVolume bricks = inBricks(volume);
  int atTheBorder = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 61, 53, trial % 3 == 0 ? 0.3 : 1.0);
    const GreyImage out = sliced(Quality::cubic, bricks.source(volume.grid), plane, 61, 53);
    for (int y = 0; y < 53; ++y)
      for (int x = 0; x < 61; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        if (nearBorder(volume.grid, p)) continue;
        const double expected = cubicOrMinusOne(volume, p);
        const int found = out.pixels[static_cast<std::size_t>(y * 61 + x)];
        if (expected < 0.0) {
          ASSERT_EQ(found, 0);
        } else {
          ASSERT_NEAR(found, expected, testing::kCubicBound_grey) << "pixel " << x << "," << y << " of trial " << trial;
          for (int a = 0; a < 3; ++a) atTheBorder += p[a] < 1.0 || p[a] > volume.grid.dims[a] - 2;
        }
      }
  }
  EXPECT_GT(atTheBorder, 1000);
}

TEST(SliceCubic, ReproducesConstantsAndAwayFromTheFacesRamps) {
  const Volume constant = testing::volumeOf({40, 40, 40}, [](int, int, int) { return 201.0; });
  const Volume ramp = testing::volumeOf({60, 60, 60}, [](int i, int j, int k) { return 10 + i + 2 * j + k; });
  std::mt19937 random(29);
  for (int trial = 0; trial < 50; ++trial) {
    const glm::dmat3 turn = testing::randomRotation(random);
    const GreyImage flat = sliced(Quality::cubic, constant.view(), testing::planeThrough(glm::dvec3(19.5), turn, 0.8, 31, 31), 31, 31);
    for (const std::uint8_t pixel : flat.pixels) ASSERT_EQ(pixel, 201);
    const ImageToVoxel plane = testing::planeThrough(glm::dvec3(29.5), turn, 0.9, 41, 41);
    const GreyImage out = sliced(Quality::cubic, ramp.view(), plane, 41, 41);
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 41; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        ASSERT_NEAR(out.pixels[static_cast<std::size_t>(y * 41 + x)], 10 + p.x + 2 * p.y + p.z, testing::kCubicBound_grey);
      }
  }
}

TEST(SliceBand, BandsGiveTheWholeImageWithEveryQualityAndZoom) {
  const Volume volume = testing::noiseVolume({50, 40, 45}, 30);
  std::mt19937 random(31);
  const Spans spans(64, {{0, 80}});
  for (const Quality quality : kQualities)
    for (const double step : {0.3, 1.0}) {
      const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 80, 64, step);
      SliceScratch scratch;
      GreyImage whole(80, 64), bands(80, 64);
      slice(quality, volume.view(), plane, viewOf(whole), scratch);
      for (const auto& [first, count] : {std::pair(40, 24), std::pair(0, 1), std::pair(1, 20), std::pair(21, 19), std::pair(5, 0)}) {
        SliceScratch own;
        sliceBand(quality, volume.view(), plane, spans, first, count, viewOf(bands), own);
      }
      ASSERT_EQ(whole, bands) << "quality " << int(quality) << " step " << step;
    }
}

TEST(SampleRows, ALineOfAHundredThousandSamplesDriftsByLessThanAMillionthOfAVoxel) {
  constexpr int kSamples = 100000;
  const Volume volume = testing::volumeOf({70000, 2, 2}, [](int i, int, int) { return i % 250; });
  const BrickVolume bricks = inBricks(volume);
  const double step = 0.7 - 1.0 / 3.0e6;
  const SampleRow row{{0.123, 0.2, 0.3}, {step, 1e-6, 0.0}, 0, {0, kSamples}};
  SliceScratch scratch;
  for (const SliceSource& source : {SliceSource(volume.view()), bricks.source(volume.grid)}) {
    GreyImage out(kSamples, 1);
    sampleRows(Quality::weave, source, {&row, 1}, viewOf(out), scratch);
    for (int x = 0; x < kSamples; ++x) {
      const double p = 0.123 + x * step;
      if (testing::distanceFromTie(p) < 1e-6) continue;
      ASSERT_EQ(out.pixels[static_cast<std::size_t>(x)], static_cast<int>(std::floor(p + 0.5)) % 250) << "sample " << x;
    }
  }
}

TEST(BrickVolume, HoldsAsManyBytesAsForecast) {
  const Volume volume = testing::noiseVolume({45, 33, 21}, 32);
  const BrickVolume bricks = inBricks(volume, 3);
  EXPECT_EQ(bricks.levels(), 3);
  EXPECT_EQ(bricks.bytes(), bricksForecast_bytes(volume.grid.dims, 3));
  EXPECT_LT(static_cast<double>(bricksForecast_bytes({512, 512, 512}, 1)), 1.36 * 512 * 512 * 512);
}

TEST(BrickVolume, OfAnEmptyVolumeIsEmptyAndBlack) {
  const auto made = bricksOf(VolumeView<const std::uint8_t>{}, 2, 1, noProgress());
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->source({}).empty());
}

TEST(BrickVolume, MakingOneStopsWhenAsked) {
  class Stopped final : public Progress {
   public:
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } stopped;
  const auto made = bricksOf(testing::noiseVolume({40, 40, 40}, 33).view(), 2, 2, stopped);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::cancelled);
}

TEST(BrickVolume, CoarserLevelsShowTheSameBodyAtTheSamePlace) {
  // A ramp in millimetres: its means over 2 x 2 x 2 voxels lie on it again, at the middles of those voxels.
  Volume volume = testing::volumeOf({96, 80, 64}, [](int i, int j, int k) { return i + 0.5 * j + k; }, {0.5, 0.5, 0.5});
  volume.grid.origin_mm = {10.0, -20.0, 5.0};
  const BrickVolume bricks = inBricks(volume, 4);
  for (const auto& [pixel_mm, spacing_mm] :
       {std::pair(0.4, 0.5), std::pair(0.99, 0.5), std::pair(1.0, 1.0), std::pair(2.5, 2.0), std::pair(50.0, 4.0)}) {
    const SliceSource source = bricks.sourceFor(volume.grid, pixel_mm);
    EXPECT_DOUBLE_EQ(source.grid.spacing_mm.x, spacing_mm);
    const Transform<frame::World, frame::Image> imageToWorld{glm::translate(glm::dmat4(1.0), glm::dvec3(18.0, -12.0, 14.0))};
    const GreyImage out = sliced(Quality::linear, source, source.grid.worldToVoxel() * imageToWorld, 20, 20);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        const glm::dvec3 p_voxel = (volume.grid.worldToVoxel() * (imageToWorld * Point<frame::Image>{{x, y, 0.0}})).at;
        ASSERT_NEAR(out.pixels[static_cast<std::size_t>(y * 20 + x)], p_voxel.x + 0.5 * p_voxel.y + p_voxel.z, 2.01)
            << "pixel " << pixel_mm;
      }
  }
}

TEST(BrickVolume, ZoomingOutOverACoarserLevelAliasesLessThanUndersampling) {
  // Noise has nothing in common from pixel to pixel: its area average over a pixel of 4 voxels is near the mean, single voxels are not.
  const Volume volume = testing::noiseVolume({128, 128, 128}, 34);
  const BrickVolume bricks = inBricks(volume, 3);
  const Transform<frame::World, frame::Image> imageToWorld{glm::scale(glm::dmat4(1.0), glm::dvec3(4.0)) *
                                                           glm::translate(glm::dmat4(1.0), glm::dvec3(1.4, 1.4, 15.4))};
  const auto rmsError = [&](const SliceSource& source) {
    const GreyImage out = sliced(Quality::linear, source, source.grid.worldToVoxel() * imageToWorld, 28, 28);
    double squares = 0.0;
    for (int y = 0; y < 28; ++y)
      for (int x = 0; x < 28; ++x) {
        const glm::ivec3 from(glm::floor((imageToWorld * Point<frame::Image>{{x, y, 0.0}}).at - 1.5));
        double mean = 0.0;
        for (int k = 0; k < 4; ++k)
          for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) mean += volume.echo[volume.grid.indexOf(from.x + i, from.y + j, from.z + k)] / 64.0;
        squares += std::pow(out.pixels[static_cast<std::size_t>(y * 28 + x)] - mean, 2);
      }
    return std::sqrt(squares / (28.0 * 28.0));
  };
  const double undersampled = rmsError(bricks.source(volume.grid)), coarser = rmsError(bricks.sourceFor(volume.grid, 4.0));
  EXPECT_LT(coarser, 0.4 * undersampled) << coarser << " against " << undersampled;
}

RC_GTEST_PROP(SliceProperty, CubicAndBothLayoutsAgreeForAnyGridAndPlane, ()) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const glm::ivec3 dims(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40));
  std::mt19937 random(seed);
  const Volume volume = testing::noiseVolume(dims, seed + 1);
  ImageToVoxel plane = testing::randomPlane(random, volume.grid, 30, 20, *rc::gen::inRange(1, 300) / 100.0);
  plane.matrix[*rc::gen::inRange(0, 2)] *= *rc::gen::element(1.0, -1.0, 0.05, 20.0, 0.0);  // mirrored, anisotropic, degenerate
  const BrickVolume bricks = inBricks(volume);
  for (const Quality quality : kQualities)
    RC_ASSERT(sliced(quality, volume.view(), plane, 30, 20) == sliced(quality, bricks.source(volume.grid), plane, 30, 20));
  const GreyImage cubic = sliced(Quality::cubic, bricks.source(volume.grid), plane, 30, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 30; ++x) {
      const glm::dvec3 p = testing::voxelAt(plane, x, y);
      if (!nearBorder(volume.grid, p))
        RC_ASSERT(std::abs(cubic.pixels[static_cast<std::size_t>(y * 30 + x)] - std::max(0.0, cubicOrMinusOne(volume, p))) <
                  testing::kCubicBound_grey);
    }
}

}  // namespace
}  // namespace ew::bricked_test
