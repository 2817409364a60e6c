// Hard cases of slicing, stretching and the gain table; each test's name is the documented outcome.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <thread>

#include "ew/imaging/effects/gain.h"
#include "ew/imaging/effects/stretch.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/slicing.h"
#include "imaging/support/support.h"

namespace ew::imaging_test {
namespace {

using testing::ImageToVoxel;

int valueAt(const Volume& volume, int i, int j, int k) {
  return volume.grid.contains({i, j, k}) ? volume.echo[volume.grid.indexOf(i, j, k)] : 0;
}

ImageToVoxel axisPlane(int along, int across, const glm::dvec3& corner_voxel) {
  ImageToVoxel plane;
  plane.matrix = glm::dmat4(0.0);
  plane.matrix[0][along] = 1.0;
  plane.matrix[1][across] = 1.0;
  plane.matrix[2][3 - along - across] = 1.0;
  plane.matrix[3] = glm::dvec4(corner_voxel, 1.0);
  return plane;
}

GreyImage sliced(Quality quality, const VolumeView<const std::uint8_t>& volume, const ImageToVoxel& plane, int width, int height) {
  SliceScratch scratch;
  GreyImage out(width, height, 99);
  slice(quality, volume, plane, viewOf(out), scratch);
  // Every case holds for both layouts.
  const auto bricks = bricksOf(volume, 1, 1, noProgress());
  EXPECT_TRUE(bricks);
  GreyImage fromBricks(width, height, 99);
  slice(quality, bricks->source(volume.grid), plane, viewOf(fromBricks), scratch);
  EXPECT_EQ(out, fromBricks);
  return out;
}

constexpr Quality kQualities[] = {Quality::weave, Quality::linear, Quality::cubic};

TEST(HardGeometry, APlaneThroughVoxelCentresCopiesThemWithEveryQualityAlongEveryPairOfAxes) {
  const Volume volume = testing::noiseVolume({9, 11, 13}, 1);
  for (const Quality quality : kQualities)
    for (int along = 0; along < 3; ++along)
      for (int across = 0; across < 3; ++across) {
        if (along == across) continue;
        glm::dvec3 corner(4.0);
        corner[along] = -2.0;
        corner[across] = -1.0;
        const GreyImage out = sliced(quality, volume.view(), axisPlane(along, across, corner), 18, 16);
        for (int y = 0; y < 16; ++y)
          for (int x = 0; x < 18; ++x) {
            glm::ivec3 at(corner);
            at[along] += x;
            at[across] += y;
            ASSERT_EQ(viewOf(out).at(x, y), valueAt(volume, at.x, at.y, at.z));
          }
      }
}

TEST(HardGeometry, APlaneInTheOutermostFaceOfTheVolumeShowsTheOutermostVoxels) {
  const Volume volume = testing::noiseVolume({9, 11, 13}, 2);
  for (const Quality quality : kQualities)
    for (const double k : {-0.4999, 0.0, 12.0, 12.4999}) {
      const GreyImage out = sliced(quality, volume.view(), axisPlane(0, 1, {0, 0, k}), 9, 11);
      for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 9; ++x) ASSERT_EQ(viewOf(out).at(x, y), valueAt(volume, x, y, k < 6 ? 0 : 12)) << "k " << k;
    }
}

TEST(HardGeometry, APlaneJustOutsideOrFarOutsideIsBlack) {
  const Volume volume = testing::noiseVolume({9, 11, 13}, 3);
  for (const Quality quality : kQualities)
    for (const double k : {-0.5001, -3.0, 12.5001, 1e4, -1e8}) {
      const GreyImage out = sliced(quality, volume.view(), axisPlane(0, 1, {0, 0, k}), 9, 11);
      for (const std::uint8_t pixel : out.pixels) ASSERT_EQ(pixel, 0) << "k " << k;
    }
}

TEST(HardGeometry, APlaneAlongAnEdgeOrThroughACornerShowsThatEdgeOrCorner) {
  const Volume volume = testing::noiseVolume({10, 10, 10}, 4);
  // Contains the volume's edge i = j = 0 and leans outwards: only the edge itself is inside.
  ImageToVoxel edge;
  edge.matrix[0] = glm::dvec4(0, 0, 1, 0);
  edge.matrix[1] = glm::dvec4(std::sqrt(0.5), -std::sqrt(0.5), 0, 0);
  edge.matrix[3] = glm::dvec4(0, 0, 0, 1);
  for (const Quality quality : kQualities) {
    const GreyImage out = sliced(quality, volume.view(), edge, 10, 3);
    for (int x = 0; x < 10; ++x) {
      EXPECT_EQ(viewOf(out).at(x, 0), valueAt(volume, 0, 0, x));
      EXPECT_EQ(viewOf(out).at(x, 1), 0);
    }
  }
  ImageToVoxel corner;
  corner.matrix[0] = glm::dvec4(glm::normalize(glm::dvec3(1, -1, 0)), 0);
  corner.matrix[1] = glm::dvec4(glm::normalize(glm::dvec3(1, 1, -2)), 0);
  corner.matrix[3] = glm::dvec4(9, 9, 9, 1);
  for (const Quality quality : kQualities) {
    const GreyImage out = sliced(quality, volume.view(), corner, 4, 4);
    EXPECT_EQ(viewOf(out).at(0, 0), valueAt(volume, 9, 9, 9));
    EXPECT_EQ(viewOf(out).at(3, 0), 0);
  }
}

TEST(HardGeometry, AGrazingPlaneShowsItsRunOfVoxelsWithoutReadingBeyond) {
  const Volume volume = testing::volumeOf({400, 400, 3}, [](int, int, int) { return 180.0; });
  for (const Quality quality : kQualities)
    for (const double slope : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      ImageToVoxel plane = axisPlane(0, 1, {0, 0, 2.5 - 200 * slope});
      plane.matrix[0][2] = slope;
      const GreyImage out = sliced(quality, volume.view(), plane, 400, 400);
      for (const std::uint8_t pixel : out.pixels) ASSERT_TRUE(pixel == 0 || pixel == 180);
      if (slope < 1e-10) continue;  // nearer to the face than positions are resolved: either side is right
      EXPECT_EQ(viewOf(out).at(0, 5), 180);
      EXPECT_EQ(viewOf(out).at(198, 5), 180);
      EXPECT_EQ(viewOf(out).at(202, 5), 0);
    }
}

TEST(HardGeometry, AVolumeOfOneVoxelThicknessIsShownAlongEveryAxis) {
  std::mt19937 random(5);
  for (const glm::ivec3 dims :
       {glm::ivec3(1, 20, 20), glm::ivec3(20, 1, 20), glm::ivec3(20, 20, 1), glm::ivec3(1, 1, 20), glm::ivec3(1, 1, 1)}) {
    const Volume volume = testing::volumeOf(dims, [](int, int, int) { return 77.0; });
    const glm::dvec3 middle = 0.5 * glm::dvec3(dims - 1);
    for (const Quality quality : kQualities)
      for (int trial = 0; trial < 50; ++trial) {
        const GreyImage out =
            sliced(quality, volume.view(), testing::planeThrough(middle, testing::randomRotation(random), 1.0, 31, 31), 31, 31);
        EXPECT_EQ(viewOf(out).at(15, 15), 77);
        for (const std::uint8_t pixel : out.pixels) ASSERT_TRUE(pixel == 0 || pixel == 77) << int(pixel);
      }
  }
}

TEST(HardGeometry, AVolumeWithoutVoxelsIsBlack) {
  for (const Quality quality : kQualities) {
    const GreyImage out = sliced(quality, VolumeView<const std::uint8_t>{}, ImageToVoxel{}, 5, 4);
    EXPECT_EQ(out, GreyImage(5, 4, 0));
  }
}

TEST(HardGeometry, TwentyToOneAnisotropyKeepsARampExactInMillimetres) {
  // Grey level is the position along z in quarter millimetres, on slices 5 mm apart and pixels of 0.25 mm.
  Volume volume = testing::volumeOf({80, 80, 12}, [](int, int, int k) { return 4.0 * 5.0 * k; }, {0.25, 0.25, 5.0});
  const Transform<frame::World, frame::Image> imageToWorld{
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(4, 4, 8)), 0.9, glm::dvec3(1, 0.4, 0.2)) *
      glm::scale(glm::dmat4(1.0), glm::dvec3(0.25))};
  const ImageToVoxel plane = volume.grid.worldToVoxel() * imageToWorld;
  const GreyImage out = sliced(Quality::linear, volume.view(), plane, 40, 120);
  int inside = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 40; ++x) {
      const glm::dvec3 p = testing::voxelAt(plane, x, y);
      if (glm::any(glm::lessThan(p, glm::dvec3(0.0))) || glm::any(glm::greaterThan(p, glm::dvec3(79, 79, 11)))) continue;
      ASSERT_NEAR(viewOf(out).at(x, y), 20.0 * p.z, testing::linearBound_grey(20.0));
      ++inside;
    }
  EXPECT_GT(inside, 1000);
}

TEST(HardGeometry, LeftHandedAndObliqueDirectionsShowTheSameBodyAtTheSamePlace) {
  const auto body = [](const glm::dvec3& p_mm) { return 120.0 + p_mm.x + 0.5 * p_mm.y - 0.7 * p_mm.z; };
  const Transform<frame::World, frame::Image> imageToWorld{glm::translate(glm::dmat4(1.0), glm::dvec3(-15, -12, 2))};
  const glm::dmat3 oblique(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3)));
  glm::dmat3 mirrored = oblique;
  mirrored[0] = -mirrored[0];
  for (const glm::dmat3& directions : {glm::dmat3(1.0), oblique, mirrored}) {
    Volume volume;
    volume.grid = {{90, 80, 85}, {0.9, 1.1, 1.0}, {0, 0, 0}, directions};
    volume.grid.origin_mm = -(directions * (0.5 * volume.grid.spacing_mm * glm::dvec3(volume.grid.dims - 1)));
    volume.echo.resize(volume.grid.voxelCount());
    const auto voxelToWorld = volume.grid.voxelToWorld();
    for (int k = 0; k < 85; ++k)
      for (int j = 0; j < 80; ++j)
        for (int i = 0; i < 90; ++i)
          volume.echo[volume.grid.indexOf(i, j, k)] =
              static_cast<std::uint8_t>(std::clamp(std::lround(body((voxelToWorld * Point<frame::Voxel>{{i, j, k}}).at)), 0L, 255L));
    const GreyImage out = sliced(Quality::linear, volume.view(), volume.grid.worldToVoxel() * imageToWorld, 30, 24);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 30; ++x) ASSERT_NEAR(viewOf(out).at(x, y), body({x - 15, y - 12, 2}), 1.01);
  }
}

TEST(HardGeometry, AnOriginAMillionMillimetresAwayChangesNoPixel) {
  Volume volume = testing::noiseVolume({40, 40, 40}, 6, {0.5, 0.5, 0.5});
  const glm::dvec3 far_mm(1e6, -1e6, 1e6);
  const auto plane_world = [](const glm::dvec3& offset_mm) {
    return Transform<frame::World, frame::Image>{glm::translate(glm::dmat4(1.0), offset_mm + glm::dvec3(2.1, 3.3, 4.7)) *
                                                 glm::scale(glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(1, 2, 0.5)), glm::dvec3(0.45))};
  };
  for (const Quality quality : kQualities) {
    volume.grid.origin_mm = glm::dvec3(0.0);
    const GreyImage near = sliced(quality, volume.view(), volume.grid.worldToVoxel() * plane_world(glm::dvec3(0.0)), 40, 40);
    volume.grid.origin_mm = far_mm;
    const GreyImage far = sliced(quality, volume.view(), volume.grid.worldToVoxel() * plane_world(far_mm), 40, 40);
    int different = 0;
    for (std::size_t n = 0; n < near.pixels.size(); ++n) {
      if (quality == Quality::linear) {
        ASSERT_NEAR(near.pixels[n], far.pixels[n], 1);
      }
      different += near.pixels[n] != far.pixels[n];
    }
    EXPECT_LE(different, 2);
  }
}

TEST(HardGeometry, ARowOfAHundredThousandSamplesDriftsByLessThanAThousandthOfAVoxel) {
  // Along i the grey level counts voxels modulo 250, so a drift of half a voxel would show as a wrong level.
  constexpr int kSamples = 100000;
  const Volume volume = testing::volumeOf({70000, 2, 2}, [](int i, int, int) { return i % 250; });
  ImageToVoxel plane;
  const double step = 0.7 - 1.0 / 3.0e6;
  plane.matrix[0] = glm::dvec4(step, 1e-6, 0, 0);
  plane.matrix[3] = glm::dvec4(0.123, 0.2, 0.3, 1);
  SliceScratch scratch;
  GreyImage out(kSamples, 1);
  sliceWeave(volume.view(), plane, viewOf(out), scratch);
  for (int x = 0; x < kSamples; ++x) {
    const double p = 0.123 + x * step;
    if (testing::distanceFromTie(p) < 1e-6) continue;
    ASSERT_EQ(out.pixels[static_cast<std::size_t>(x)], static_cast<int>(std::floor(p + 0.5)) % 250) << "sample " << x;
  }
  sliceLinear(volume.view(), plane, viewOf(out), scratch);
  for (int x = 0; x < kSamples; ++x) {
    const double p = 0.123 + x * step;
    if (static_cast<int>(p) % 250 == 249) continue;  // between 249 and 0
    ASSERT_NEAR(out.pixels[static_cast<std::size_t>(x)], std::fmod(p, 250.0), testing::linearBound_grey(1.0)) << "sample " << x;
  }
}

TEST(HardGeometry, AMatrixThatIsNotFiniteOrAbsurdlyLargeIsBlack) {
  const Volume volume = testing::noiseVolume({20, 20, 20}, 7);
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(), 1e300, -1e300};
  for (const Quality quality : kQualities)
    for (const double value : bad)
      for (const int column : {0, 1, 3})
        for (int row = 0; row < 3; ++row) {
          ImageToVoxel plane;
          plane.matrix[column][row] = value;
          ASSERT_EQ(sliced(quality, volume.view(), plane, 12, 10), GreyImage(12, 10, 0));
        }
}

TEST(HardGeometry, AStepOfZeroRepeatsOneSample) {
  const Volume volume = testing::volumeOf({20, 20, 20}, [](int, int, int) { return 50.0; });
  for (const Quality quality : kQualities) {
    ImageToVoxel plane;
    plane.matrix = glm::dmat4(0.0);
    plane.matrix[3] = glm::dvec4(10, 10, 10, 1);
    EXPECT_EQ(sliced(quality, volume.view(), plane, 12, 10), GreyImage(12, 10, 50));
  }
}

TEST(HardGeometry, PosesThatAreMirroredScaledOrNotFiniteGiveABlackFrameAndAreNamedInvalid) {
  const Volume volume = testing::volumeOf(
      {60, 60, 60}, [](int, int, int) { return 90.0; }, glm::dvec3(3.0));
  Probe probe;
  FrameMaker maker;
  maker.configure(probe, {}, {}, volume.grid, 50, 50);
  glm::dmat4 mirrored(1.0), zero(0.0), nan(1.0), sheared(1.0);
  mirrored[0][0] = -1.0;
  zero[3][3] = 1.0;
  nan[1][2] = std::numeric_limits<double>::quiet_NaN();
  sheared[1][0] = 0.1;
  for (const glm::dmat4& matrix : {mirrored, zero, nan, sheared}) {
    Pose pose;
    pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(80.0));
    const auto good = maker.make(volume.view(), pose).grey;
    EXPECT_EQ(good.at(25, 25), 90);
    pose.probeToWorld.matrix = matrix;
    const auto image = maker.make(volume.view(), pose).grey;
    EXPECT_TRUE(std::all_of(image.data, image.data + 2500, [](std::uint8_t v) { return v == 0; }));
    EXPECT_EQ(maker.lastStatus(), PoseStatus::invalid);
  }
}

TEST(HardResampling, OneValueIsRepeatedAndOnePlaceTakesTheFirst) {
  const std::vector<std::uint8_t> one = {42}, many = {7, 200, 100};
  std::vector<std::uint8_t> wide(1000), single(1), two(2);
  stretch(one, wide);
  EXPECT_TRUE(std::all_of(wide.begin(), wide.end(), [](std::uint8_t v) { return v == 42; }));
  stretch(one, single);
  EXPECT_EQ(single[0], 42);
  stretch(many, single);
  EXPECT_EQ(single[0], 7);
  stretch(many, two);
  EXPECT_EQ(two, (std::vector<std::uint8_t>{7, 100}));
  stretch(many, std::span<std::uint8_t>());
}

TEST(HardResampling, AMillionPlacesKeepConstantsAndRampsExact) {
  std::vector<std::uint8_t> ramp(256), constant(313, 201), out(1000000);
  for (std::size_t v = 0; v < 256; ++v) ramp[v] = static_cast<std::uint8_t>(v);
  stretch(ramp, out);
  for (std::size_t x = 0; x < out.size(); ++x) ASSERT_NEAR(out[x], 255.0 * static_cast<double>(x) / 999999.0, 0.501);
  EXPECT_TRUE(std::is_sorted(out.begin(), out.end()));
  stretch(constant, out);
  EXPECT_TRUE(std::all_of(out.begin(), out.end(), [](std::uint8_t v) { return v == 201; }));
  const std::vector<std::uint8_t> edge = {0, 255};
  stretch(edge, out);
  for (std::size_t x = 0; x < out.size(); ++x) ASSERT_NEAR(out[x], 255.0 * static_cast<double>(x) / 999999.0, 0.57);
  EXPECT_EQ(out.back(), 255);
}

TEST(HardResampling, FewerPlacesThanValuesUndersampleARampExactly) {
  std::vector<std::uint8_t> ramp(256);
  for (std::size_t v = 0; v < 256; ++v) ramp[v] = static_cast<std::uint8_t>(v);
  for (const std::size_t n : {2U, 3U, 17U, 100U, 255U}) {
    std::vector<std::uint8_t> out(n);
    stretch(ramp, out);
    for (std::size_t x = 0; x < n; ++x) ASSERT_NEAR(out[x], 255.0 * static_cast<double>(x) / static_cast<double>(n - 1), 0.501);
  }
}

TEST(HardResampling, EveryQualityAgreesOnConstantsFromOneSixtyFourthToSixtyFourfold) {
  const Volume volume = testing::volumeOf({300, 300, 8}, [](int, int, int) { return 163.0; });
  for (const Quality quality : kQualities)
    for (double zoom = 1.0 / 64.0; zoom <= 64.0; zoom *= 2.0) {
      const int side = std::clamp(static_cast<int>(250 * zoom), 4, 130);
      const GreyImage out =
          sliced(quality, volume.view(), testing::planeThrough({149.5, 149.5, 3.5}, glm::dmat3(1.0), 1.0 / zoom, side, side), side, side);
      for (const std::uint8_t pixel : out.pixels) ASSERT_EQ(pixel, 163) << "zoom " << zoom;
    }
}

TEST(HardResampling, ZoomingIntoARampStaysWithinOneRoundingWhenSamplesMeetVoxelCentres) {
  const Volume volume = testing::volumeOf({60, 60, 3}, [](int i, int j, int) { return 2 * i + 2 * j; });
  for (const int zoom : {2, 4, 16, 64}) {
    // 40 voxels and a bit: the first and last pixel lie on voxel centres, so voxel-sized samples are exact.
    const int side = 10 * zoom + 1;
    ImageToVoxel plane;
    plane.matrix[0] = glm::dvec4(1.0 / zoom, 0, 0, 0);
    plane.matrix[1] = glm::dvec4(0, 1.0 / zoom, 0, 0);
    plane.matrix[3] = glm::dvec4(20, 20, 1, 1);
    const GreyImage out = sliced(Quality::weave, volume.view(), plane, side, side);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) ASSERT_NEAR(viewOf(out).at(x, y), 80 + 2.0 * (x + y) / zoom, 1.01) << "zoom " << zoom;
  }
}

TEST(HardTables, GainZeroIsBlackAndGainTenThousandIsWhiteAboveZero) {
  const std::array<double, kDgcSliders> ones{1, 1, 1, 1, 1, 1, 1, 1};
  const std::vector<double> rows = {0.0, 0.5, 1.0};
  std::vector<std::uint8_t> table;
  buildGainTable(0.0, ones, rows, table);
  EXPECT_TRUE(std::all_of(table.begin(), table.end(), [](std::uint8_t v) { return v == 0; }));
  buildGainTable(1e4, ones, rows, table);
  for (std::size_t n = 0; n < table.size(); ++n) ASSERT_EQ(table[n], n % 256 == 0 ? 0 : 255);
}

TEST(HardTables, SlidersThatAlternateBetweenExtremesNeverOvershootAndEveryRowStaysMonotone) {
  const std::array<double, kDgcSliders> extremes{0, 1e4, 0, 1e4, 0, 1e4, 0, 1e4};
  std::vector<double> rows(1001);
  for (std::size_t n = 0; n < rows.size(); ++n) {
    rows[n] = static_cast<double>(n) / 1000.0;
    const double factor = dgcAt(extremes, rows[n]);
    ASSERT_GE(factor, 0.0);
    ASSERT_LE(factor, 1e4);
  }
  std::vector<std::uint8_t> table;
  for (const double gain : {0.0, 1e-4, 1.0, 1e4}) {
    buildGainTable(gain, extremes, rows, table);
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t v = 1; v < 256; ++v) ASSERT_GE(table[256 * row + v], table[256 * row + v - 1]);
  }
}

TEST(HardTables, FactorsThatAreNotNumbersCountAsZero) {
  std::array<double, kDgcSliders> sliders{1, 1, 1, 1, 1, 1, 1, 1};
  sliders[0] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> rows = {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()};
  std::vector<std::uint8_t> table;
  buildGainTable(1.0, sliders, rows, table);
  EXPECT_EQ(table[255], 0);
  EXPECT_EQ(table[256 + 255], 255);
  buildGainTable(std::numeric_limits<double>::infinity(), sliders, rows, table);
  EXPECT_EQ(table[255], 0);
  EXPECT_EQ(table[256], 0);
  EXPECT_EQ(table[256 + 255], 255);
}

TEST(HardTables, KnobsThatChangeEveryFrameGiveEachFrameItsOwnTable) {
  const Volume volume = testing::volumeOf(
      {60, 60, 60}, [](int, int, int) { return 100.0; }, glm::dvec3(3.0));
  Pose pose;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(80.0));
  FrameMaker maker;
  for (int n = 0; n < 200; ++n) {
    Knobs knobs;
    knobs.gain = (n % 40) / 10.0;
    maker.configure(Probe{}, knobs, {}, volume.grid, 60, 60);
    ASSERT_EQ(maker.make(volume.view(), pose).grey.at(30, 30), std::min(255L, std::lround(knobs.gain * 100.0)));
  }
}

TEST(HardSameAnswer, SlicesMadeByEightThreadsEqualTheOnesMadeByOne) {
  const Volume volume = testing::noiseVolume({70, 60, 50}, 8);
  std::mt19937 random(9);
  std::vector<ImageToVoxel> planes;
  for (int n = 0; n < 32; ++n) planes.push_back(testing::randomPlane(random, volume.grid, 64, 64, n % 2 ? 1.0 : 0.4));
  for (const Quality quality : kQualities) {
    std::vector<GreyImage> alone, together(planes.size());
    for (const ImageToVoxel& plane : planes) alone.push_back(sliced(quality, volume.view(), plane, 64, 64));
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 8; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t n = t; n < planes.size(); n += 8) together[n] = sliced(quality, volume.view(), planes[n], 64, 64);
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(alone, together);
  }
}

}  // namespace
}  // namespace ew::imaging_test
