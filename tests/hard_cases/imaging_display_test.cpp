// What is done to the image and with it: tone, edges, persistence, M-mode, quality of a moving probe.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

#include "ew/imaging/adaptive_quality.h"
#include "ew/imaging/effects/edge_enhancement.h"
#include "ew/imaging/effects/gain.h"
#include "ew/imaging/effects/persistence.h"
#include "ew/imaging/latency.h"
#include "ew/imaging/m_mode.h"

namespace ew::imaging_display_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(HardTables, AnyToneBehindSlidersAlternatingBetweenExtremesKeepsEveryRowMonotone) {
  std::vector<double> rows;
  for (int n = 0; n <= 60; ++n) rows.push_back(n / 60.0);
  std::vector<std::uint8_t> table;
  for (const double far : {1e-17, 1.0, 1e4})
    for (const double range_db : {20.0, 59.0, 120.0})
      for (const GreyMap map : {GreyMap::linear, GreyMap::soft, GreyMap::contrast, GreyMap::bright, GreyMap::clinical})
        for (const double gain : {0.0, 1.0, 1e4}) {
          buildGainTable(gain, {0, far, 0, far, 0, far, 0, far}, {.dynamicRange_db = range_db, .map = map}, rows, table);
          for (std::size_t row = 0; row < rows.size(); ++row)
            for (std::size_t v = 1; v < 256; ++v) ASSERT_GE(table[256 * row + v], table[256 * row + v - 1]);
        }
}

TEST(HardTables, DynamicRangesThatAreNoNumbersChangeNothingAndExtremeOnesAreKeptWithinTwentyAndAHundredAndTwenty) {
  for (const double none : {kNan, 0.0, -1.0})
    for (int level = 0; level < 256; ++level) ASSERT_EQ(shownLevel({.dynamicRange_db = none}, level), level);
  EXPECT_EQ(shownLevel({.dynamicRange_db = kInfinity}, 0.0), shownLevel({.dynamicRange_db = 120.0}, 0.0));
  EXPECT_EQ(shownLevel({.dynamicRange_db = 1e-300}, 200.0), shownLevel({.dynamicRange_db = 20.0}, 200.0));
}

TEST(HardImages, FansOfOnePixelOneRowOrOneColumnAreShownAsTheyAreByEdgeEnhancement) {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{300, 1}, std::pair{1, 300}, std::pair{300, 4}, std::pair{4, 300}}) {
    GreyImage in(width, height), out(width, height);
    for (std::uint8_t& pixel : in.pixels) pixel = static_cast<std::uint8_t>(random());
    enhanceEdges(1.0, Spans(static_cast<std::size_t>(height), {{0, width}}), viewOf(in), 0, height, viewOf(out));
    EXPECT_EQ(in, out);
  }
}

TEST(HardImages, AStillImageIsReachedByPersistenceExactlyForEveryShareAndStep) {
  const Spans spans(1, {{0, 256}});
  for (const double share : {1e-9, 0.5, 0.949, 0.95, 1.0, kInfinity})
    for (const int before : {0, 1, 128, 254, 255}) {
      PersistenceMemory memory;
      GreyImage image(256, 1, static_cast<std::uint8_t>(before));
      for (int frame = 0; frame <= 200; ++frame) {
        beginPersistence(256, 1, memory);
        persist(share, spans, 0, 1, viewOf(image), memory);
        for (std::size_t v = 0; v < 256; ++v)
          if (frame < 200) image.pixels[v] = static_cast<std::uint8_t>(v);
      }
      for (std::size_t v = 0; v < 256; ++v) ASSERT_EQ(memory.levels[v], 128 * v) << "share " << share << " from " << before;
    }
}

TEST(HardTimes, MModeDrawsNothingForTimesThatRepeatRunBackwardsOrAreNoneAndStartsAfreshAfterAJump) {
  const std::vector<std::uint8_t> grey(50, 100), white(50, 255);
  MModeStrip strip;
  strip.configure(64, 20, 2.0);
  strip.add(1e6, grey);
  strip.add(1e6 + 1.0, grey);
  EXPECT_EQ(strip.cursor(), 33);
  for (const double time_s : {1e6 + 1.0, 1e6 + 0.5, 1e6 - 0.9, kNan, kInfinity, -kInfinity}) strip.add(time_s, white);
  strip.add(1e6 + 1.5, {});
  EXPECT_EQ(strip.cursor(), 33);
  strip.add(1e6 + 1.5, grey);
  for (int x = 0; x < 49; ++x) EXPECT_EQ(strip.image().at(x, 10), 100);
  strip.add(-1e300, grey);
  EXPECT_EQ(strip.cursor(), 1);
  strip.add(1e300, white);
  EXPECT_EQ(strip.cursor(), 1);
  EXPECT_EQ(strip.image().at(0, 0), 255);
  EXPECT_EQ(strip.image().at(40, 0), 0);
}

TEST(HardTimes, QualityIsNotLoweredByPosesOrTimesThatAreNoneNorByTheSignOfAQuaternion) {
  const Knobs asked{.elevationPlanes = 9, .quality = Quality::cubic};
  const glm::dquat turn = glm::angleAxis(3.1, glm::normalize(glm::dvec3(1, 2, 3)));
  const auto poseOf = [](const glm::dquat& q) {
    Pose pose;
    pose.probeToWorld.matrix = glm::mat4_cast(q);
    return pose;
  };
  Pose none = poseOf(turn);
  none.probeToWorld.matrix[3][0] = kNan;
  AdaptiveQuality quality;
  for (int n = 0; n < 50; ++n) {
    EXPECT_EQ(quality.step(asked, poseOf(n % 2 ? turn : -turn), 0.02 * n, 500.0), asked);
    EXPECT_EQ(quality.step(asked, none, 0.02 * n + 0.01, 500.0), asked);
    EXPECT_EQ(quality.step(asked, poseOf(glm::dquat(1, 0, 0, 0)), n % 2 ? kNan : -kInfinity, 500.0), asked);
  }
}

TEST(HardTimes, LatenciesThatAreNegativeOrNotFiniteDoNotSpoilTheHistogram) {
  LatencyHistogram times;
  for (const double us : {kNan, kInfinity, -kInfinity, -3.0, 100.0, 1e300}) times.add(us);
  EXPECT_EQ(times.count(), 3U);
  EXPECT_EQ(times.quantile_us(0.3), 16.0);
  EXPECT_NEAR(times.quantile_us(0.6), 107.6, 0.1);
  EXPECT_EQ(times.quantile_us(1.0), 1e300);
}

}  // namespace
}  // namespace ew::imaging_display_test
