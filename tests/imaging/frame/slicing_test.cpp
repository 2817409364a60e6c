#include "ew/imaging/slicing.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "imaging/support/support.h"

namespace ew::slicing_test {
namespace {

using testing::ImageToVoxel;

int nearestOrZero(const Volume& volume, const glm::dvec3& p) {
  const glm::ivec3 ijk(glm::floor(p + 0.5));
  return volume.grid.contains(ijk) ? volume.echo[volume.grid.indexOf(ijk.x, ijk.y, ijk.z)] : 0;
}

double trilinearOrMinusOne(const Volume& volume, const glm::dvec3& p) {
  double sum = 0.0;
  const glm::dvec3 last = glm::dvec3(volume.grid.dims - 1);
  for (int a = 0; a < 3; ++a)
    if (p[a] < -0.5 || p[a] > last[a] + 0.5) return -1.0;
  const glm::dvec3 c = glm::clamp(p, glm::dvec3(0.0), last);
  const glm::ivec3 low(glm::floor(c));
  const glm::dvec3 w = c - glm::dvec3(low);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    double weight = 1.0;
    for (int a = 0; a < 3; ++a) weight *= step[a] ? w[a] : 1.0 - w[a];
    const glm::ivec3 at = glm::min(low + step, volume.grid.dims - 1);
    sum += weight * volume.echo[volume.grid.indexOf(at.x, at.y, at.z)];
  }
  return sum;
}

bool nearBorder(const Grid& grid, const glm::dvec3& p) {
  for (int a = 0; a < 3; ++a)
    if (std::abs(p[a] + 0.5) < 1e-6 || std::abs(p[a] - (grid.dims[a] - 0.5)) < 1e-6) return true;
  return false;
}

TEST(SliceWeave, ShowsTheNearestVoxelOfEveryPixelAndNothingOutsideTheVolume) {
  std::mt19937 random(1);
  const Volume volume = testing::noiseVolume({40, 50, 30}, 2);
  SliceScratch scratch;
  GreyImage out(71, 63);
  for (int trial = 0; trial < 300; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, out.width, out.height, trial % 3 == 0 ? 1.7 : 1.0);
    sliceWeave(volume.view(), plane, viewOf(out), scratch);
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        if (testing::distanceFromTie(p.x) < 1e-8 || testing::distanceFromTie(p.y) < 1e-8 || testing::distanceFromTie(p.z) < 1e-8) continue;
        ASSERT_EQ(viewOf(out).at(x, y), nearestOrZero(volume, p)) << "pixel " << x << "," << y << " of trial " << trial;
      }
  }
}

TEST(SliceWeave, ShowsOnlyVoxelsThatThePlanePierces) {
  // Each voxel carries its own number in base 251, one digit a volume, so that the image tells which voxel it shows.
  const glm::ivec3 dims(37, 41, 43);
  const auto digit = [&](int place) {
    return testing::volumeOf(dims, [&, place](int i, int j, int k) {
      int number = (k * dims.y + j) * dims.x + i;
      for (int n = 0; n < place; ++n) number /= 251;
      return number % 251 + 1;
    });
  };
  const std::array<Volume, 3> digits = {digit(0), digit(1), digit(2)};
  std::mt19937 random(3);
  SliceScratch scratch;
  std::array<GreyImage, 3> shown = {GreyImage(64, 64), GreyImage(64, 64), GreyImage(64, 64)};
  for (int trial = 0; trial < 100; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, digits[0].grid, 64, 64);
    for (std::size_t d = 0; d < 3; ++d) sliceWeave(digits[d].view(), plane, viewOf(shown[d]), scratch);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(plane.matrix[2]));
    const double reach = 0.5 * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    for (std::size_t n = 0; n < shown[0].pixels.size(); ++n) {
      if (shown[0].pixels[n] == 0) continue;
      const int number = shown[0].pixels[n] - 1 + 251 * (shown[1].pixels[n] - 1) + 251 * 251 * (shown[2].pixels[n] - 1);
      const glm::dvec3 centre(number % dims.x, number / dims.x % dims.y, number / (dims.x * dims.y));
      ASSERT_LE(std::abs(glm::dot(normal, centre - glm::dvec3(plane.matrix[3]))), reach + 1e-8);
    }
  }
}

TEST(SliceWeave, LeavesNoHolesInAFullVolume) {
  const Volume volume = testing::volumeOf({64, 64, 64}, [](int, int, int) { return 200.0; });
  std::mt19937 random(4);
  SliceScratch scratch;
  for (int trial = 0; trial < 200; ++trial) {
    GreyImage out(33, 33);
    const ImageToVoxel plane = testing::planeThrough(glm::dvec3(31.5), testing::randomRotation(random), 1.0, 33, 33);
    sliceWeave(volume.view(), plane, viewOf(out), scratch);
    for (const std::uint8_t pixel : out.pixels) ASSERT_EQ(pixel, 200);
  }
}

TEST(SliceLinear, EqualsTheTrilinearFormulaWithinOneRounding) {
  std::mt19937 random(5);
  const Volume volume = testing::noiseVolume({40, 50, 30}, 6);
  SliceScratch scratch;
  GreyImage out(71, 63);
  int atTheBorder = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, out.width, out.height, trial % 3 == 0 ? 0.3 : 1.0);
    sliceLinear(volume.view(), plane, viewOf(out), scratch);
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        if (nearBorder(volume.grid, p)) continue;
        const double expected = trilinearOrMinusOne(volume, p);
        if (expected < 0.0) {
          ASSERT_EQ(viewOf(out).at(x, y), 0);
        } else {
          ASSERT_NEAR(viewOf(out).at(x, y), expected, testing::kLinearBoundOnNoise_grey)
              << "pixel " << x << "," << y << " of trial " << trial;
          for (int a = 0; a < 3; ++a) atTheBorder += p[a] < 0.0 || p[a] > volume.grid.dims[a] - 1;
        }
      }
  }
  EXPECT_GT(atTheBorder, 1000);
}

TEST(SliceLinear, ReproducesARampWithinOneRounding) {
  const Volume volume = testing::volumeOf({60, 60, 60}, [](int i, int j, int k) { return 10 + i + 2 * j + k; });
  std::mt19937 random(7);
  SliceScratch scratch;
  GreyImage out(41, 41);
  for (int trial = 0; trial < 100; ++trial) {
    const ImageToVoxel plane = testing::planeThrough(glm::dvec3(29.5), testing::randomRotation(random), 0.9, 41, 41);
    sliceLinear(volume.view(), plane, viewOf(out), scratch);
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        ASSERT_NEAR(viewOf(out).at(x, y), 10 + p.x + 2 * p.y + p.z, testing::linearBound_grey(4.0));
      }
  }
}

TEST(Slice, EveryQualityAndZoomReproducesAConstant) {
  const Volume volume = testing::volumeOf({50, 50, 50}, [](int, int, int) { return 137.0; });
  std::mt19937 random(8);
  SliceScratch scratch;
  for (const Quality quality : {Quality::weave, Quality::linear})
    for (const double step : {1.0 / 64.0, 0.125, 0.37, 0.999, 1.0, 1.4}) {
      GreyImage out(23, 19);
      slice(quality, volume.view(), testing::planeThrough(glm::dvec3(24.5), testing::randomRotation(random), step, 23, 19), viewOf(out),
            scratch);
      for (const std::uint8_t pixel : out.pixels) ASSERT_EQ(pixel, 137) << "step " << step;
    }
}

TEST(Slice, WithoutZoomTheWeaveIsTheSameAsSliceWeave) {
  const Volume volume = testing::noiseVolume({50, 50, 50}, 9);
  std::mt19937 random(10);
  SliceScratch scratch;
  for (int trial = 0; trial < 50; ++trial) {
    GreyImage a(40, 40), b(40, 40);
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 40, 40);
    slice(Quality::weave, volume.view(), plane, viewOf(a), scratch);
    sliceWeave(volume.view(), plane, viewOf(b), scratch);
    ASSERT_EQ(a, b);
  }
}

TEST(Slice, ZoomingInWithTheWeaveBlendsVoxelSizedSamplesOfARampWithinAVoxel) {
  const Volume volume = testing::volumeOf({60, 60, 60}, [](int i, int j, int) { return 4 * i + j / 2.0; });
  SliceScratch scratch;
  for (const double zoom : {2.0, 3.7, 8.0, 64.0}) {
    GreyImage out(200, 160);
    const ImageToVoxel plane = testing::planeThrough(glm::dvec3(29.5), glm::dmat3(1.0), 1.0 / zoom, out.width, out.height);
    if (zoom < 4.0 && (out.width - 1) / zoom > 58.0) continue;
    slice(Quality::weave, volume.view(), plane, viewOf(out), scratch);
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        // Half a voxel along i and j at most, and one rounding.
        ASSERT_NEAR(viewOf(out).at(x, y), 4 * p.x + p.y / 2.0, 4 * 0.5 + 0.25 + 1.0) << "zoom " << zoom << " at " << x << "," << y;
      }
  }
}

TEST(Slice, ZoomingInWithTheWeaveIsSmoothWhereReplicationWouldBeBlocky) {
  const Volume volume = testing::volumeOf({60, 60, 60}, [](int i, int, int) { return 4 * i; });
  SliceScratch scratch;
  GreyImage out(200, 10);
  slice(Quality::weave, volume.view(), testing::planeThrough(glm::dvec3(30.0), glm::dmat3(1.0), 0.125, 200, 10), viewOf(out), scratch);
  for (int x = 1; x < out.width; ++x) ASSERT_LE(out.pixels[static_cast<std::size_t>(x)] - out.pixels[static_cast<std::size_t>(x - 1)], 1);
}

TEST(Slice, WithSpansWritesThePixelsOfTheSpansAndNoOthers) {
  const Volume volume = testing::noiseVolume({50, 40, 45}, 11);
  std::mt19937 random(12);
  SliceScratch scratch;
  for (const Quality quality : {Quality::weave, Quality::linear})
    for (const double step : {0.4, 1.0}) {
      const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 48, 30, step);
      GreyImage whole(48, 30), part(48, 30, 77);
      Spans spans(30);
      for (int y = 3; y < 29; ++y) {
        spans[static_cast<std::size_t>(y)] = {{y / 2, 20}};
        if (y > 10) spans[static_cast<std::size_t>(y)].push_back({25, 48 - y});
      }
      for (auto& row : spans) std::erase_if(row, [](const RowSpan& span) { return span.begin >= span.end; });
      slice(quality, volume.view(), plane, viewOf(whole), scratch);
      slice(quality, volume.view(), plane, spans, viewOf(part), scratch);
      for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 48; ++x) {
          bool inside = false;
          for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) inside = inside || (x >= span.begin && x < span.end);
          ASSERT_EQ(viewOf(part).at(x, y), inside ? viewOf(whole).at(x, y) : 77);
        }
    }
}

TEST(Slice, RowsWithAStrideLeaveThePaddingAlone) {
  const Volume volume = testing::noiseVolume({20, 20, 20}, 13);
  SliceScratch scratch;
  std::vector<std::uint8_t> memory(30 * 20, 9);
  const ImageView<std::uint8_t> out{memory.data(), 20, 20, 30};
  slice(Quality::linear, volume.view(), ImageToVoxel{}, out, scratch);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) EXPECT_EQ(out.at(x, y), volume.echo[volume.grid.indexOf(x, y, 0)]);
    for (std::size_t x = 20; x < 30; ++x) EXPECT_EQ(memory[static_cast<std::size_t>(y) * 30 + x], 9);
  }
}

TEST(SliceGeometry, PutsTheMiddleOfTheFirstRowAtTheFace) {
  const auto imageToProbe = sliceGeometry(401, 0.25);
  EXPECT_EQ((imageToProbe * Point<frame::Image>{{200.0, 0.0, 0.0}}).at, glm::dvec3(0.0));
  EXPECT_EQ((imageToProbe * Point<frame::Image>{{0.0, 8.0, 0.0}}).at, glm::dvec3(-50.0, 2.0, 0.0));
}

TEST(SliceProperty, WeaveEqualsNearestForAnyPlane) {
  EXPECT_TRUE(rc::check("weave equals nearest", [] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const glm::ivec3 dims(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40));
    std::mt19937 random(seed);
    const Volume volume = testing::noiseVolume(dims, seed + 1);
    const double step = *rc::gen::inRange(1, 300) / 100.0;
    const ImageToVoxel plane = testing::randomPlane(random, volume.grid, 30, 20, step);
    SliceScratch scratch;
    GreyImage weave(30, 20), linear(30, 20);
    sliceWeave(volume.view(), plane, viewOf(weave), scratch);
    sliceLinear(volume.view(), plane, viewOf(linear), scratch);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 30; ++x) {
        const glm::dvec3 p = testing::voxelAt(plane, x, y);
        if (nearBorder(volume.grid, p)) continue;
        const double expected = trilinearOrMinusOne(volume, p);
        RC_ASSERT(std::abs(viewOf(linear).at(x, y) - std::max(expected, 0.0)) < testing::kLinearBoundOnNoise_grey);
        if (testing::distanceFromTie(p.x) < 1e-8 || testing::distanceFromTie(p.y) < 1e-8 || testing::distanceFromTie(p.z) < 1e-8) continue;
        RC_ASSERT(viewOf(weave).at(x, y) == nearestOrZero(volume, p));
      }
  }));
}

}  // namespace
}  // namespace ew::slicing_test
