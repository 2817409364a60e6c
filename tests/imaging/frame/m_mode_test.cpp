#include "ew/imaging/m_mode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_motion.h"
#include "imaging/support/small_convex.h"

namespace ew::m_mode_test {
namespace {

using Beam = std::vector<std::uint8_t>;

/// A bump of brightness 10 samples wide about `centre`.
Beam beamWithTargetAt(double centre, int samples = 200) {
  Beam beam(static_cast<std::size_t>(samples));
  for (int s = 0; s < samples; ++s) {
    const double from = s - centre;
    beam[static_cast<std::size_t>(s)] = static_cast<std::uint8_t>(std::lround(20.0 + 220.0 * std::exp(-from * from / 50.0)));
  }
  return beam;
}

double targetOfColumn(const MModeStrip& strip, int x) {
  double weights = 0.0, sum = 0.0;
  for (int y = 0; y < strip.image().height; ++y) {
    const double weight = strip.image().at(x, y) - 20.0;
    weights += weight;
    sum += weight * y;
  }
  return sum / weights;
}

bool isBlack(const MModeStrip& strip, int x) {
  for (int y = 0; y < strip.image().height; ++y)
    if (strip.image().at(x, y) != 0) return false;
  return true;
}

TEST(MMode, DrawsATargetThatMovesAsASineAsASine) {
  MModeStrip strip;
  strip.configure(400, 200, 4.0);
  const auto depthAt = [](double time_s) { return 100.0 + 30.0 * std::sin(2.0 * std::numbers::pi * 0.8 * time_s); };
  for (int frame = 0; frame <= 300; ++frame) strip.add(0.01 * frame, beamWithTargetAt(depthAt(0.01 * frame)));
  for (int x = 0; x <= 300; ++x) ASSERT_NEAR(targetOfColumn(strip, x), depthAt(4.0 * x / 400), 0.05) << x;
  EXPECT_EQ(strip.cursor(), 301);
  EXPECT_TRUE(isBlack(strip, 301));
}

TEST(MMode, FillsTheColumnsBetweenUnevenFramesByInterpolationWithoutGaps) {
  MModeStrip strip;
  strip.configure(300, 40, 3.0);
  std::mt19937 random(4);
  double time_s = 7.0;
  const auto greyAt = [](double t) { return 60.0 + 50.0 * (t - 7.0); };
  const auto add = [&] { strip.add(time_s, Beam(90, static_cast<std::uint8_t>(std::lround(greyAt(time_s))))); };
  add();
  while (time_s < 9.8) {
    time_s += random() % 3 ? 0.003 : 0.021 * (1 + random() % 8);
    add();
  }
  const int drawn = static_cast<int>(std::floor((time_s - 7.0) * 100.0)) + 1;
  EXPECT_EQ(strip.cursor(), drawn % 300);
  for (int x = 0; x < std::min(drawn, 300 - 8); ++x)
    for (const int y : {0, 20, 39}) ASSERT_NEAR(strip.image().at(x, y), greyAt(7.0 + x / 100.0), 1.6) << x;
}

TEST(MMode, WrapsAtItsEndAndOverwritesTheOldest) {
  MModeStrip strip;
  strip.configure(100, 10, 1.0);
  for (int n = 0; n <= 130; ++n) strip.add(n / 100.0 + 1e-6, Beam(10, static_cast<std::uint8_t>(50 + n)));
  EXPECT_EQ(strip.cursor(), 31);
  for (int x = 0; x <= 30; ++x) EXPECT_NEAR(strip.image().at(x, 5), 150 + x, 1);
  for (int x = 31; x < 37; ++x) EXPECT_TRUE(isBlack(strip, x));
  for (int x = 37; x < 100; ++x) EXPECT_NEAR(strip.image().at(x, 5), 50 + x, 1);
}

TEST(MMode, HoldsItsPaceOverHours) {
  MModeStrip strip;
  strip.configure(1000, 4, 4.0);
  double time_s = 0.0;
  for (int n = 0; n <= 200000; ++n) strip.add(time_s = n * (1.0 / 30.0), Beam(4, 9));
  EXPECT_EQ(strip.cursor(), static_cast<int>((static_cast<std::int64_t>(time_s * 250.0 + 1e-6) + 1) % 1000));
}

TEST(MMode, DrawsNothingWhileTimeStandsStillOrRunsBackwards) {
  MModeStrip strip;
  strip.configure(100, 10, 1.0);
  for (int n = 0; n <= 50; ++n) strip.add(n / 100.0, Beam(10, 100));
  const auto pixels = [&] { return std::vector<std::uint8_t>(strip.image().data, strip.image().data + 1000); };
  const std::vector<std::uint8_t> before = pixels();
  for (const double time_s : {0.5, 0.49, 0.0, -0.4, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    strip.add(time_s, Beam(10, 200));
  strip.add(0.6, {});
  EXPECT_EQ(pixels(), before);
  EXPECT_EQ(strip.cursor(), 51);
  strip.add(0.6, Beam(10, 100));
  EXPECT_EQ(strip.cursor(), 61);
  for (int x = 0; x <= 60; ++x) EXPECT_EQ(strip.image().at(x, 3), 100) << "beams that were not drawn are not interpolated from";
}

TEST(MMode, StartsAfreshAfterAJumpOfMoreThanASweep) {
  for (const double jump_s : {1.001, 1e9, -1.5}) {
    MModeStrip strip;
    strip.configure(100, 10, 1.0);
    for (int n = 0; n <= 50; ++n) strip.add(n / 100.0, Beam(10, 100));
    strip.add(0.5 + jump_s, Beam(10, 200));
    EXPECT_EQ(strip.cursor(), 1);
    EXPECT_EQ(strip.image().at(0, 0), 200);
    for (int x = 1; x < 100; ++x) EXPECT_TRUE(isBlack(strip, x));
  }
}

TEST(MMode, FillsEveryColumnInAStepOfExactlyASweep) {
  MModeStrip strip;
  strip.configure(6, 3, 1.0);
  strip.add(0.0, Beam(3, 100));
  strip.add(1.0, Beam(3, 100));
  for (int x = 0; x < 6; ++x) EXPECT_EQ(strip.image().at(x, 1), 100);
}

TEST(MMode, IsClearedByAChangeOfItsSizeOrSweepAndByNothingElse) {
  MModeStrip strip;
  const auto draw = [&] {
    for (int n = 0; n <= 20; ++n) strip.add(n / 100.0, Beam(10, 100));
  };
  strip.configure(100, 10, 1.0);
  draw();
  strip.configure(100, 10, 1.0);
  EXPECT_EQ(strip.cursor(), 21);
  for (const auto& [width, height, sweep_s] : {std::tuple{100, 10, 2.0}, std::tuple{90, 10, 2.0}, std::tuple{90, 12, 2.0}}) {
    strip.configure(width, height, sweep_s);
    EXPECT_EQ(strip.cursor(), 0);
    for (int x = 0; x < width; ++x) EXPECT_TRUE(isBlack(strip, x));
    draw();
  }
}

TEST(MMode, OfNoSizeOrOneColumnTakesBeamsToo) {
  MModeStrip strip;
  strip.add(0.0, Beam(10, 100));
  EXPECT_EQ(strip.image().width, 0);
  strip.configure(1, 1, std::numeric_limits<double>::quiet_NaN());
  for (int n = 0; n < 100; ++n) strip.add(0.5 * n, Beam(10, 100));
  EXPECT_EQ(strip.image().at(0, 0), 100);
  EXPECT_EQ(strip.cursor(), 0);
}

TEST(MMode, StretchesTheBeamFromTheFirstRowToTheLast) {
  MModeStrip strip;
  strip.configure(4, 101, 1.0);
  Beam ramp(51);
  for (std::size_t s = 0; s < ramp.size(); ++s) ramp[s] = static_cast<std::uint8_t>(4 * s);
  strip.add(0.0, ramp);
  for (int y = 0; y < 101; ++y) EXPECT_EQ(strip.image().at(0, y), 2 * y);
}

// A vessel along z in even tissue, as live echoes see it: its two walls on the line through its middle, over one beat of the heart.

constexpr double kMiddle_mm = 45.0, kRadius_mm = 10.0, kGrowth_mm = 2.0, kReach_mm = 20.0;  ///< of the vessel; growth of its diameter
constexpr double kBeat_s = 1.0, kDepth_mm = 80.0;
constexpr int kBeams = 40, kColumns = 48, kRows = 320;  ///< a beam a column; the columns beyond hold the seam

TissueMaps vesselInTissue() {
  TissueMaps maps;
  maps.grid.dims = {80, 110, 30};
  maps.grid.origin_mm = {-40.0, -15.0, -15.0};
  maps.level.resize(maps.grid.voxelCount());
  maps.surfaceDistance.assign(maps.grid.voxelCount(), 0);
  maps.surfaceKind.assign(maps.grid.voxelCount(), 0);
  maps.surfaces.push_back({.name = "wall", .echoLevel = 235.0});
  for (int k = 0; k < maps.grid.dims.z; ++k)
    for (int j = 0; j < maps.grid.dims.y; ++j)
      for (int i = 0; i < maps.grid.dims.x; ++i) {
        const glm::dvec3 mm = maps.grid.origin_mm + glm::dvec3(i, j, k);
        const double outside_mm = std::hypot(mm.x, mm.y - kMiddle_mm) - kRadius_mm;
        const std::size_t at = maps.grid.indexOf(i, j, k);
        maps.level[at] = outside_mm > 0.0 ? 90 : 6;
        if (std::abs(outside_mm) > TissueMaps::kSurfaceReach_mm) continue;
        maps.surfaceDistance[at] = static_cast<std::uint8_t>(std::lround(128.0 + 32.0 * outside_mm));
        maps.surfaceKind[at] = 1;
      }
  return maps;
}

/// The wall goes outwards by half of the diameter's growth, the lumen alike, and what lies around it less with distance.
TissueMotion pulseOfVessel() {
  TissueMotion motion;
  motion.rhythms.pulse = BodyRhythm{kBeat_s, 0.0};
  TissueMotion::Mode& mode = motion.modes.emplace_back();
  mode.kind = TissueMotion::Kind::pulse;
  mode.grid.dims = {80, 110, 3};
  mode.grid.spacing_mm = {1.0, 1.0, 15.0};
  mode.grid.origin_mm = {-40.0, -15.0, -15.0};
  for (int k = 0; k < mode.grid.dims.z; ++k)
    for (int j = 0; j < mode.grid.dims.y; ++j)
      for (int i = 0; i < mode.grid.dims.x; ++i) {
        const glm::dvec2 offset(mode.grid.origin_mm.x + i, mode.grid.origin_mm.y + j - kMiddle_mm);
        const double rho_mm = std::max(glm::length(offset), 1e-9), fading = std::max(0.0, 1.0 - (rho_mm - kRadius_mm) / kReach_mm);
        const double push_mm = 0.5 * kGrowth_mm * (rho_mm < kRadius_mm ? rho_mm / kRadius_mm : fading);
        mode.shift_mm.emplace_back(push_mm / rho_mm * offset.x, push_mm / rho_mm * offset.y, 0.0);
      }
  return motion;
}

/// The strip of one beat.
GreyImage stripOfABeat(bool hasPulse) {
  const TissueMaps maps = vesselInTissue();
  const TissueMotion motion = pulseOfVessel();
  Scene scene;
  scene.liveEchoes = LiveEchoesEffect{.fragmentsPerCm3 = 0.0, .speckleReduction = 0.0};
  scene.sliceThickness = SliceThicknessEffect{};
  scene.focus = FocusEffect{};
  scene.motion = MotionEffect{};
  Knobs knobs;
  knobs.greyMap = GreyMap::linear;
  knobs.mode = DisplayMode::mMode;
  knobs.mSweep_s = kBeat_s * kColumns / kBeams;
  FrameMaker maker;
  maker.configure(testing::smallConvex(0.3, 48, kDepth_mm), knobs, scene, maps.grid, kColumns, kRows, {.tissue = true});
  FrameInput input;
  input.tissue = &maps;
  input.tissueGrid = maps.grid;
  input.echo = VolumeView<const std::uint8_t>{maps.level.data(), maps.grid};
  input.motion = &motion;
  BodyRhythms rhythms = motion.rhythms;
  if (!hasPulse) rhythms.pulse.reset();
  for (int n = 0; n < kBeams; ++n) {
    input.time_s = n * kBeat_s / kBeams;
    input.body = bodyAt(rhythms, input.time_s);
    maker.make(input);
  }
  const ImageView<const std::uint8_t> strip = maker.strip();
  GreyImage copy(strip.width, strip.height);
  for (int y = 0; y < strip.height; ++y) std::copy_n(strip.row(y), strip.width, viewOf(copy).row(y));
  return copy;
}

/// Depth of the brightest echo of a column between two depths, mm: the middle of what lies within 1 mm of its brightest row.
double wallOfColumn_mm(const GreyImage& strip, int x, double from_mm, double to_mm) {
  const double row_mm = kDepth_mm / kRows;
  const auto grey = [&](int y) { return static_cast<double>(viewOf(strip).row(y)[x]); };
  int brightest = static_cast<int>(from_mm / row_mm);
  for (int y = brightest; y < static_cast<int>(to_mm / row_mm); ++y)
    if (grey(y) > grey(brightest)) brightest = y;
  double weights = 0.0, sum = 0.0;
  const int around = static_cast<int>(1.0 / row_mm);
  for (int y = brightest - around; y <= brightest + around; ++y) {
    weights += grey(y) * grey(y);
    sum += grey(y) * grey(y) * y;
  }
  return sum / weights * row_mm;
}

TEST(MMode, ShowsTheWallsOfAVesselPartWithThePulse) {
  const GreyImage strip = stripOfABeat(true);
  ASSERT_EQ(strip.width, kColumns);
  ASSERT_EQ(strip.height, kRows);
  const double wavelength_mm = 1540.0 / 3.5e6 * 1e3, allowed_mm = 0.5 * kDepth_mm / kRows + 0.5 * wavelength_mm;
  const BodyRhythms rhythms = pulseOfVessel().rhythms;
  const auto nearWall_mm = [&](int x) { return wallOfColumn_mm(strip, x, kMiddle_mm - kRadius_mm - 4.0, kMiddle_mm - kRadius_mm + 4.0); };
  const auto farWall_mm = [&](int x) { return wallOfColumn_mm(strip, x, kMiddle_mm + kRadius_mm - 4.0, kMiddle_mm + kRadius_mm + 4.0); };
  ASSERT_EQ(bodyAt(rhythms, 0.0).pulse, 0.0);
  EXPECT_NEAR(farWall_mm(0) - nearWall_mm(0), 2.0 * kRadius_mm, allowed_mm);
  double widest = 0.0;
  for (int x = 0; x < kBeams; ++x) {
    const double pulse = bodyAt(rhythms, x * kBeat_s / kBeams).pulse;
    EXPECT_NEAR(nearWall_mm(x), nearWall_mm(0) - 0.5 * kGrowth_mm * pulse, allowed_mm) << x;
    EXPECT_NEAR(farWall_mm(x), farWall_mm(0) + 0.5 * kGrowth_mm * pulse, allowed_mm) << x;
    EXPECT_NEAR(farWall_mm(x) - nearWall_mm(x), farWall_mm(0) - nearWall_mm(0) + kGrowth_mm * pulse, allowed_mm) << x;
    widest = std::max(widest, pulse);
  }
  EXPECT_GT(widest, 0.95) << "a whole beat";
}

TEST(MMode, StandsStillWithoutAPulse) {
  const GreyImage strip = stripOfABeat(false);
  for (int y = 0; y < strip.height; ++y)
    for (int x = 1; x < kBeams; ++x) ASSERT_EQ(viewOf(strip).row(y)[x], viewOf(strip).row(y)[0]) << x << ' ' << y;
}

TEST(MMode, KnowsTheMomentOfEveryColumnItShowsAndTheBeamsItCameFrom) {
  MModeStrip strip;
  strip.configure(100, 10, 2.0);
  EXPECT_FALSE(strip.timeOf(0));
  EXPECT_FALSE(strip.columnOf(0.0));
  for (int n = 0; n <= 50; ++n) strip.add(10.0 + 0.05 * n, beamWithTargetAt(50.0));  // 2.5 s: it went round once
  // The newest column is 125, at 25; its seam is black until 31.
  EXPECT_EQ(strip.cursor(), 26);
  EXPECT_NEAR(*strip.timeOf(25), 12.5, 1e-12);
  EXPECT_FALSE(strip.timeOf(26));
  EXPECT_FALSE(strip.timeOf(31));
  EXPECT_NEAR(*strip.timeOf(32), 10.64, 1e-12);
  EXPECT_NEAR(*strip.columnOf(12.5), 25.0, 1e-9);
  EXPECT_NEAR(*strip.columnOf(10.64), 32.0, 1e-9);
  EXPECT_FALSE(strip.columnOf(10.6));
  EXPECT_FALSE(strip.columnOf(12.6));
  EXPECT_NEAR(strip.beamInterval_s(12.0), 0.05, 1e-6);
  strip.add(12.9, beamWithTargetAt(50.0));
  EXPECT_NEAR(strip.beamInterval_s(12.7), 0.4, 1e-6);
  EXPECT_NEAR(strip.beamInterval_s(12.0), 0.05, 1e-6);
  const MModeStrip copy = strip;  // as the cine ring keeps it
  EXPECT_EQ(copy.timeOf(32 + 20), strip.timeOf(32 + 20));
  strip.configure(100, 10, 4.0);
  EXPECT_FALSE(strip.timeOf(25));
}

}  // namespace
}  // namespace ew::m_mode_test
