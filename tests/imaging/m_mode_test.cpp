#include "ew/imaging/m_mode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

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
  for (int y = 0; y < strip.picture().height; ++y) {
    const double weight = strip.picture().at(x, y) - 20.0;
    weights += weight;
    sum += weight * y;
  }
  return sum / weights;
}

bool isBlack(const MModeStrip& strip, int x) {
  for (int y = 0; y < strip.picture().height; ++y)
    if (strip.picture().at(x, y) != 0) return false;
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
    for (const int y : {0, 20, 39}) ASSERT_NEAR(strip.picture().at(x, y), greyAt(7.0 + x / 100.0), 1.6) << x;
}

TEST(MMode, WrapsAtItsEndAndOverwritesTheOldest) {
  MModeStrip strip;
  strip.configure(100, 10, 1.0);
  for (int n = 0; n <= 130; ++n) strip.add(n / 100.0 + 1e-6, Beam(10, static_cast<std::uint8_t>(50 + n)));
  EXPECT_EQ(strip.cursor(), 31);
  for (int x = 0; x <= 30; ++x) EXPECT_NEAR(strip.picture().at(x, 5), 150 + x, 1);
  for (int x = 31; x < 37; ++x) EXPECT_TRUE(isBlack(strip, x));
  for (int x = 37; x < 100; ++x) EXPECT_NEAR(strip.picture().at(x, 5), 50 + x, 1);
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
  const auto pixels = [&] { return std::vector<std::uint8_t>(strip.picture().data, strip.picture().data + 1000); };
  const std::vector<std::uint8_t> before = pixels();
  for (const double time_s : {0.5, 0.49, 0.0, -0.4, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    strip.add(time_s, Beam(10, 200));
  strip.add(0.6, {});
  EXPECT_EQ(pixels(), before);
  EXPECT_EQ(strip.cursor(), 51);
  strip.add(0.6, Beam(10, 100));
  EXPECT_EQ(strip.cursor(), 61);
  for (int x = 0; x <= 60; ++x) EXPECT_EQ(strip.picture().at(x, 3), 100) << "beams that were not drawn are not interpolated from";
}

TEST(MMode, StartsAfreshAfterAJumpOfMoreThanASweep) {
  for (const double jump_s : {1.001, 1e9, -1.5}) {
    MModeStrip strip;
    strip.configure(100, 10, 1.0);
    for (int n = 0; n <= 50; ++n) strip.add(n / 100.0, Beam(10, 100));
    strip.add(0.5 + jump_s, Beam(10, 200));
    EXPECT_EQ(strip.cursor(), 1);
    EXPECT_EQ(strip.picture().at(0, 0), 200);
    for (int x = 1; x < 100; ++x) EXPECT_TRUE(isBlack(strip, x));
  }
}

TEST(MMode, FillsEveryColumnInAStepOfExactlyASweep) {
  MModeStrip strip;
  strip.configure(6, 3, 1.0);
  strip.add(0.0, Beam(3, 100));
  strip.add(1.0, Beam(3, 100));
  for (int x = 0; x < 6; ++x) EXPECT_EQ(strip.picture().at(x, 1), 100);
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
  EXPECT_EQ(strip.picture().width, 0);
  strip.configure(1, 1, std::numeric_limits<double>::quiet_NaN());
  for (int n = 0; n < 100; ++n) strip.add(0.5 * n, Beam(10, 100));
  EXPECT_EQ(strip.picture().at(0, 0), 100);
  EXPECT_EQ(strip.cursor(), 0);
}

TEST(MMode, StretchesTheBeamFromTheFirstRowToTheLast) {
  MModeStrip strip;
  strip.configure(4, 101, 1.0);
  Beam ramp(51);
  for (std::size_t s = 0; s < ramp.size(); ++s) ramp[s] = static_cast<std::uint8_t>(4 * s);
  strip.add(0.0, ramp);
  for (int y = 0; y < 101; ++y) EXPECT_EQ(strip.picture().at(0, y), 2 * y);
}

}  // namespace
}  // namespace ew::m_mode_test
