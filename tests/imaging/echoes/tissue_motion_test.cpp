// Tissue that moves while a probe stands still: it is seen where it has gone, with its own speckle.
#include "ew/imaging/tissue_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <vector>

#include "ew/imaging/frame.h"
#include "imaging/support/every_target.h"
#include "imaging/support/small_convex.h"

namespace ew::tissue_motion_test {
namespace {

Probe probeOfTest() { return testing::smallConvex(0.4, 96, 90.0); }

/// A body from x, z = 0 all around and y from -20 to 130: tissue of one level with a bright layer, a reflecting surface at y = 40 and a
/// label that takes sound away below y = 55 on one side.
struct Body {
  TissueMaps maps;
  Volume labels;
};
constexpr double kSurface_mm = 40.0;

Body bodyOf(std::uint8_t level, bool hasSurface) {
  Body body;
  Grid& grid = body.maps.grid;
  grid.dims = {150, 150, 50};
  grid.origin_mm = {-75.0, -20.0, -25.0};
  body.maps.level.assign(grid.voxelCount(), level);
  body.labels.grid = grid;
  body.labels.grid.origin_mm += glm::dvec3(0.2, -0.3, 0.1);
  body.labels.echo.assign(grid.voxelCount(), 0);
  if (hasSurface) {
    body.maps.surfaceDistance.assign(grid.voxelCount(), 0);
    body.maps.surfaceKind.assign(grid.voxelCount(), 0);
    body.maps.surfaces.push_back({.name = "wall", .echoLevel = 230.0});
  }
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 mm = grid.origin_mm + glm::dvec3(i, j, k);
        const std::size_t at = grid.indexOf(i, j, k);
        if (mm.y > 55.0 && mm.y < 60.0 && mm.x > 5.0) body.labels.echo[at] = 1;
        if (!hasSurface || std::abs(mm.y - kSurface_mm) > TissueMaps::kSurfaceReach_mm) continue;
        body.maps.surfaceDistance[at] = static_cast<std::uint8_t>(std::lround(128.0 + 32.0 * (kSurface_mm - mm.y)));
        body.maps.surfaceKind[at] = 1;
      }
  return body;
}

Scene movingScene() {
  Scene scene;
  scene.liveEchoes = LiveEchoesEffect{};
  scene.sliceThickness = SliceThicknessEffect{};
  scene.focus = FocusEffect{};
  scene.attenuation = AttenuationEffect{};
  scene.tissues = {{.label = 1, .name = "stone", .attenuation_dbPerCmMhz = 4.0, .reflection_db = 10.0}};
  scene.motion = MotionEffect{};
  return scene;
}

/// A field over nodes of 3 mm.
TissueMotion motionOf(const std::function<glm::dvec3(const glm::dvec3&)>& shiftAt, TissueMotion::Kind kind = TissueMotion::Kind::breath) {
  TissueMotion motion;
  TissueMotion::Mode& mode = motion.modes.emplace_back();
  mode.kind = kind;
  mode.grid.dims = {51, 51, 18};
  mode.grid.spacing_mm = glm::dvec3(3.0);
  mode.grid.origin_mm = {-75.0, -20.0, -25.0};
  for (int k = 0; k < mode.grid.dims.z; ++k)
    for (int j = 0; j < mode.grid.dims.y; ++j)
      for (int i = 0; i < mode.grid.dims.x; ++i)
        mode.shift_mm.push_back(glm::vec3(shiftAt(mode.grid.origin_mm + 3.0 * glm::dvec3(i, j, k))));
  return motion;
}

struct Shot {
  Scene scene = movingScene();
  const TissueMotion* motion = nullptr;
  BodyState body = {};
  glm::dmat4 probeToWorld{1.0};
  glm::dmat4 ownToWorld{1.0};  ///< where the body lies
  int threads = 1;
};

constexpr int kWidth = 400, kHeight = 360;

GreyImage imageOf(const Body& body, const Shot& shot) {
  FrameMaker maker(shot.threads);
  Knobs knobs;
  knobs.greyMap = GreyMap::linear;
  maker.configure(probeOfTest(), knobs, shot.scene, body.maps.grid, kWidth, kHeight, {.labels = true, .tissue = true});
  const Transform<frame::World, frame::World> placing{shot.ownToWorld};
  FrameInput input;
  input.tissue = &body.maps;
  input.tissueGrid = placed(body.maps.grid, placing);
  input.echo = VolumeView<const std::uint8_t>{body.maps.level.data(), input.tissueGrid};
  input.labels = VolumeView<const std::uint8_t>{body.labels.echo.data(), placed(body.labels.grid, placing)};
  input.motion = shot.motion;
  input.body = shot.body;
  input.pose.probeToWorld.matrix = shot.probeToWorld;
  const DisplayImage made = maker.make(input);
  GreyImage copy(made.width(), made.height());
  for (int y = 0; y < copy.height; ++y) std::copy_n(made.grey.row(y), copy.width, viewOf(copy).row(y));
  return copy;
}

struct Difference {
  int largest = 0;
  double share = 0.0;  ///< of the pixels, that differ
};
Difference differenceOf(const GreyImage& a, const GreyImage& b) {
  Difference difference;
  for (std::size_t n = 0; n < a.pixels.size(); ++n) {
    const int off = std::abs(int{a.pixels[n]} - int{b.pixels[n]});
    difference.largest = std::max(difference.largest, off);
    difference.share += off > 0 ? 1.0 / static_cast<double>(a.pixels.size()) : 0.0;
  }
  return difference;
}

/// Depth of the brightest sample on the middle line, mm, between two depths.
double brightest_mm(const GreyImage& image, double from_mm, double to_mm) {
  const DisplayGeometry geometry = fitDisplay(probeOfTest(), {}, kWidth, kHeight, {});
  double best = -1.0, at_mm = 0.0;
  for (int y = 0; y < image.height; ++y) {
    const double depth_mm = geometry.probePoint_mm(kWidth / 2, y).y;
    if (depth_mm < from_mm || depth_mm > to_mm) continue;
    double sum = 0.0;
    for (int x = kWidth / 2 - 3; x <= kWidth / 2 + 3; ++x) sum += image.pixels[static_cast<std::size_t>(y * image.width + x)];
    if (sum > best) {
      best = sum;
      at_mm = depth_mm;
    }
  }
  return at_mm;
}

TEST(TissueMotion, OfAWholeBodyIsTheImageOfAProbeThatMovesTheOtherWay) {
  const Body body = bodyOf(140, true);
  const glm::dvec3 shift_mm(2.5, -3.25, 1.75);
  const TissueMotion motion = motionOf([&](const glm::dvec3&) { return shift_mm; });
  // The body lies turned in the world, so that every frame on the way counts.
  const glm::dmat4 turned =
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(12.0, -7.0, 3.0)), 0.4, glm::normalize(glm::dvec3(1.0, 2.0, 3.0)));
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), -0.5 * shift_mm);
  const GreyImage expected = imageOf(body, {.probeToWorld = turned * moved, .ownToWorld = turned});
  const GreyImage seen = imageOf(body, {.motion = &motion, .body = {.breath = 0.5}, .probeToWorld = turned, .ownToWorld = turned});
  const Difference difference = differenceOf(seen, expected);
  // Places are rounded in another order: a scatterer in ten thousand falls to the neighbouring row of the fine grid.
  EXPECT_LE(difference.largest, 4);
  EXPECT_LT(difference.share, 0.001);
  const Difference still = differenceOf(imageOf(body, {.probeToWorld = turned, .ownToWorld = turned}), expected);
  EXPECT_GT(still.largest, 60);
  EXPECT_GT(still.share, 0.5);
}

TEST(TissueMotion, MovesWhatItMovesAndNothingBesideIt) {
  // The tissue below y = 20 mm goes down by up to 4 mm around 45 mm and is back at rest at 80 mm.
  const auto shiftAt = [](const glm::dvec3& p) {
    const double t = std::clamp((p.y - 15.0) / 60.0, 0.0, 1.0);
    return glm::dvec3(0.0, 4.0 * std::pow(std::sin(3.14159265358979 * t), 2.0), 0.0);
  };
  const TissueMotion motion = motionOf(shiftAt);
  const Body wall = bodyOf(0, true);
  Shot shot;
  shot.scene.attenuation.reset();
  shot.scene.liveEchoes->fragmentsPerCm3 = 0.0;
  shot.scene.liveEchoes->speckleReduction = 0.0;
  const double rest_mm = brightest_mm(imageOf(wall, shot), 20.0, 70.0);
  EXPECT_NEAR(rest_mm, kSurface_mm, 0.5);
  shot.motion = &motion;
  for (const double breath : {0.25, 0.5, 1.0}) {
    shot.body.breath = breath;
    const double expected_mm = breath * shiftAt({0.0, kSurface_mm, 0.0}).y;
    EXPECT_NEAR(brightest_mm(imageOf(wall, shot), 20.0, 70.0) - rest_mm, expected_mm, 0.3) << breath;
  }
  // Speckle moves with it: beyond what moves it is the same to the pixel.
  const Body tissue = bodyOf(140, false);
  shot.body.breath = 0.0;
  const GreyImage still = imageOf(tissue, shot);
  shot.body.breath = 1.0;
  const GreyImage moved = imageOf(tissue, shot);
  const DisplayGeometry geometry = fitDisplay(probeOfTest(), {}, kWidth, kHeight, {});
  double near = 0.0, far = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    const double depth_mm = geometry.probePoint_mm(kWidth / 2, y).y;
    for (int x = kWidth / 2 - 10; x < kWidth / 2 + 10; ++x) {
      const auto at = static_cast<std::size_t>(y * kWidth + x);
      const double off = std::abs(int{still.pixels[at]} - int{moved.pixels[at]});
      if (depth_mm > 3.0 && depth_mm < 12.0) near = std::max(near, off);
      if (depth_mm > 38.0 && depth_mm < 50.0) far = std::max(far, off);
    }
  }
  EXPECT_LE(near, 1.0);
  EXPECT_GT(far, 25.0);
}

TEST(TissueMotion, AtRestIsNoMotionToThePixel) {
  const Body body = bodyOf(140, true);
  const TissueMotion motion = motionOf([](const glm::dvec3& p) { return glm::dvec3(0.1 * p.y, 2.0, 1.0); });
  Shot plain;
  plain.scene.motion.reset();
  const GreyImage expected = imageOf(body, plain);
  EXPECT_EQ(imageOf(body, {}).pixels, expected.pixels);
  EXPECT_EQ(imageOf(body, {.motion = &motion}).pixels, expected.pixels);
  // Moves another way than this field.
  EXPECT_EQ(imageOf(body, {.motion = &motion, .body = {.pulse = 1.0, .bowel = 0.3}}).pixels, expected.pixels);
  Shot off{.motion = &motion, .body = {.breath = 1.0}};
  EXPECT_NE(imageOf(body, off).pixels, expected.pixels);
  off.scene.motion->strength = 0.0;
  EXPECT_EQ(imageOf(body, off).pixels, expected.pixels);
  off.scene.motion.reset();
  EXPECT_EQ(imageOf(body, off).pixels, expected.pixels);
}

TEST(TissueMotion, IsTheSameForAnyNumberOfThreadsAndOnEveryInstructionSet) {
  const Body body = bodyOf(140, true);
  TissueMotion motion = motionOf([](const glm::dvec3& p) {
    return glm::dvec3(1.5 * std::sin(0.08 * p.y), 4.0 * std::sin(0.05 * p.x + 0.04 * p.y), 3.0 * std::cos(0.06 * p.x));
  });
  motion.modes.push_back(
      motionOf([](const glm::dvec3& p) { return glm::dvec3(0.0, 0.8 * std::sin(0.2 * p.y), 0.0); }, TissueMotion::Kind::pulse)
          .modes.front());
  const Shot shot{.motion = &motion, .body = {.breath = 0.9, .pulse = 0.7}};
  const GreyImage expected = imageOf(body, shot);
  for (const int threads : {2, 8}) {
    Shot shared = shot;
    shared.threads = threads;
    EXPECT_EQ(imageOf(body, shared).pixels, expected.pixels) << threads;
  }
  testing::onEveryTarget([&](const char* target) { EXPECT_EQ(imageOf(body, shot).pixels, expected.pixels) << target; });
}

TEST(TissueMotion, KnowsWhereABodyStandsAtATime) {
  BodyRhythms rhythms;
  EXPECT_EQ(bodyAt(rhythms, 3.7), BodyState{});
  rhythms.breathing = BodyRhythms::Breathing{{4.0, 0.0}, 0.5, 0.4};
  rhythms.pulse = BodyRhythm{1.0, 0.0};
  rhythms.bowel = BodyRhythm{10.0, 0.0};
  EXPECT_EQ(bodyAt(rhythms, 20.0), BodyState{});
  EXPECT_NEAR(bodyAt(rhythms, 9.0).breath, 0.4, 1e-12);  // a quiet breath, halfway of what moves
  EXPECT_EQ(bodyAt(rhythms, 11.0).breath, 0.0);          // the pause
  EXPECT_NEAR(bodyAt(rhythms, 8.26).pulse, 1.0, 1e-12);  // a sixth of a second after the wave came
  EXPECT_NEAR(bodyAt(rhythms, 12.5).bowel, 0.25, 1e-12);
  EXPECT_EQ(amplitudeOf(TissueMotion::Kind::bowelCosine, {}), 0.0);
  EXPECT_EQ(amplitudeOf(TissueMotion::Kind::bowelSine, {}), 0.0);
  EXPECT_NEAR(amplitudeOf(TissueMotion::Kind::bowelCosine, {.bowel = 0.5}), -2.0, 1e-12);
}

}  // namespace
}  // namespace ew::tissue_motion_test
