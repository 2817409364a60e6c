#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ew/imaging/frame.h"
#include "imaging/support/every_target.h"
#include "imaging/support/live_echoes_support.h"

// What a machine shows beside the echoes of tissue: sound that goes to and fro, and its filter of speckle.
namespace ew::live_machine_test {
namespace {

using namespace testing::live;

/// Tissue in front of gas or lung from 60 mm on; the front itself is the tissue's last echo, or a surface that the test adds.
struct Layers {
  TissueMaps maps;
  Volume labels;
  Shot shot;

  template <class Level>
  Layers(const Level& level, double impedance_mrayl) : maps(tissueOf([&](const glm::dvec3& p) { return p.y > 60.0 ? 0.0 : level(p); })) {
    labels = layersOf(maps, 60.0);
    shot.labels = &labels;
    shot.scene.attenuation = AttenuationEffect{};
    shot.scene.reverberation = ReverberationEffect{};
    shot.scene.reverberation->clutter_db = shot.scene.reverberation->shadowHaze_db = -60.0;
    shot.scene.tissues = {
        {.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 0.5},
        {.label = 2, .name = "air", .attenuation_dbPerCmMhz = 12.0, .reflection_db = 40.0, .impedance_mrayl = impedance_mrayl}};
  }
  [[nodiscard]] double meanBetween(double from_mm, double to_mm, double half_mm = 6.0) const {
    return meanOf(levelsBetween(imageOf(maps, shot), shot, from_mm, to_mm, half_mm));
  }
};

constexpr double kGas_mrayl = 0.0004;
constexpr double kLung_mrayl = 0.18;
constexpr auto kEven = [](const glm::dvec3&) { return 170.0; };

TEST(LiveReverberation, FillsWhatSendsNothingBackWithAHazeOfWhatLiesInFront) {
  Layers layers(kEven, 1.5);
  EXPECT_LT(layers.meanBetween(80.0, 100.0), 5.0);
  const double tissue = layers.meanBetween(35.0, 55.0);
  for (const double haze_db : {-10.0, -14.0}) {
    layers.shot.scene.reverberation->shadowHaze_db = haze_db;
    // The mean of what lies in front: 60 mm of tissue.
    const double expected_db = -haze_db + 10.0 * std::log10(90.0 / 60.0);
    EXPECT_NEAR((tissue - layers.meanBetween(80.0, 100.0)) / kGreyPerDb, expected_db, 2.0) << haze_db;
    EXPECT_NEAR(layers.meanBetween(35.0, 55.0), tissue, 0.5 * kGreyPerDb) << "what sends back is hardly brighter";
  }
}

TEST(LiveReverberation, MakesHardlyMoreHazeBehindAMirror) {
  // A skull over brain, and fat square to the beam in a kidney: what lies behind keeps its contrast.
  Layers layers([](const glm::dvec3&) { return 130.0; }, 1.5);
  layers.shot.scene.reverberation->shadowHaze_db = -10.0;
  const double without = layers.meanBetween(80.0, 100.0, 3.0);
  addPlane(layers.maps, {.name = "mirror", .echoLevel = 255.0}, 40.0);
  EXPECT_GT(without, 60.0);
  EXPECT_LT(layers.meanBetween(80.0, 100.0, 3.0) - without, 2.0 * kGreyPerDb);
}

TEST(LiveReverberation, RingsDownBehindGasAsFastAsItIsTold) {
  Layers layers(kEven, kGas_mrayl);
  addPlane(layers.maps, {.name = "front", .echoLevel = 250.0, .frontOnly = true}, 60.0);
  layers.shot.scene.reverberation->loss_dbPerBounce = 60.0;
  // Patches fall as they are told; the stray sound under them is 5 dB fainter and falls 0.35 times as fast.
  const auto expected_db = [&](double away_mm) {
    const double fall = layers.shot.scene.reverberation->ringDownFall_dbPerMm * away_mm;
    return 10.0 * std::log10(std::pow(10.0, -0.1 * fall) + std::pow(10.0, -0.1 * (5.0 + 0.35 * fall)));
  };
  for (const double fall_dbPerMm : {0.65, 1.3}) {
    layers.shot.scene.reverberation->ringDownFall_dbPerMm = fall_dbPerMm;
    const double near = layers.meanBetween(64.0, 70.0, 12.0), far = layers.meanBetween(79.0, 85.0, 12.0);
    EXPECT_GT(near, 120.0);
    EXPECT_NEAR((near - far) / kGreyPerDb, expected_db(7.0) - expected_db(22.0), 2.0) << fall_dbPerMm;
  }
  layers.shot.scene.reverberation->ringDown_db = -60.0;
  EXPECT_LT(layers.meanBetween(64.0, 70.0, 12.0), 20.0);
}

TEST(LiveReverberation, IsDirtyInStripesThatStayWithTheGas) {
  Layers layers(kEven, kGas_mrayl);
  addPlane(layers.maps, {.name = "front", .echoLevel = 250.0, .frontOnly = true}, 60.0);
  const std::vector<double> here = levelsBetween(imageOf(layers.maps, layers.shot), layers.shot, 63.0, 80.0, 8.0);
  double mean = meanOf(here), square = 0.0;
  for (const double level : here) square += (level - mean) * (level - mean);
  EXPECT_GT(std::sqrt(square / static_cast<double>(here.size())), 3.0 * kGreyPerDb);
  // Patches lie in the tissue: a probe that slides by 8 mm sees the same ones 8 mm farther.
  layers.shot.probeToWorld[3].x = 0.05;
  const std::vector<double> moved = levelsBetween(imageOf(layers.maps, layers.shot), layers.shot, 63.0, 80.0, 8.0);
  EXPECT_GT(correlation(here, moved), 0.9);
}

TEST(LiveReverberation, MirrorsWhatLiesInFrontOfTheLung) {
  Layers layers([](const glm::dvec3& p) { return std::abs(p.y - 44.0) < 4.0 ? 230.0 : 120.0; }, kLung_mrayl);
  addPlane(layers.maps, {.name = "pleura", .echoLevel = 250.0, .frontOnly = true}, 60.0);
  layers.shot.scene.reverberation->loss_dbPerBounce = 60.0;
  layers.shot.scene.reverberation->ringDown_db = -60.0;
  EXPECT_NEAR(layers.meanBetween(74.5, 77.5, 4.0), 230.0 - 12.0 * kGreyPerDb, 14.0);
  layers.shot.scene.reverberation->mirror = false;
  EXPECT_LT(layers.meanBetween(74.5, 77.5, 4.0), 20.0);
}

TEST(LiveReverberation, RepeatsThePleuraAtTwiceItsDepth) {
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
  addPlane(maps, {.name = "pleura", .echoLevel = 250.0, .rough_db = -60.0, .frontOnly = true}, 40.0);
  const Volume labels = layersOf(maps, 40.0);
  Shot shot;
  shot.labels = &labels;
  shot.scene.reverberation = ReverberationEffect{.shadowHaze_db = -60.0};
  shot.scene.tissues = {{.label = 2, .name = "lung", .reflection_db = 40.0, .impedance_mrayl = kLung_mrayl}};
  const auto peak = [&](double from_mm, double to_mm) {
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, from_mm, to_mm, 2.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  const double once = peak(76.0, 84.0);
  EXPECT_NEAR(once, 250.0 - (14.0 + 5.0 / kGreyPerDb) * kGreyPerDb, 25.0);
  shot.scene.reverberation->loss_dbPerBounce = 24.0;
  EXPECT_NEAR((once - peak(76.0, 84.0)) / kGreyPerDb, 10.0, 0.5);
}

TEST(LiveReverberation, LaysClutterIntoFluidBehindABrightWall) {
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y < 30.0 ? 200.0 : 0.0; });
  const Volume labels = layersOf(maps, 30.0);
  Shot shot;
  shot.labels = &labels;
  shot.scene.tissues = {{.label = 1, .name = "wall"}, {.label = 2, .name = "bile", .attenuation_dbPerCmMhz = 0.0}};
  const double clean = meanOf(levelsBetween(imageOf(maps, shot), shot, 33.0, 36.0));
  shot.scene.reverberation = ReverberationEffect{.shadowHaze_db = -60.0};
  const GreyImage cluttered = imageOf(maps, shot);
  const double near = meanOf(levelsBetween(cluttered, shot, 33.0, 36.0)), far = meanOf(levelsBetween(cluttered, shot, 39.5, 42.5));
  EXPECT_LT(clean, 5.0);
  EXPECT_GT(near, 60.0);
  EXPECT_LT(near, 200.0 - 20.0 * kGreyPerDb);
  EXPECT_LT(far, near - 2.0 * kGreyPerDb);
}

TEST(LiveReverberation, LaysNoLadderBelowABrightLine) {
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
  addPlane(maps, {.name = "skull", .echoLevel = 250.0}, 30.0);
  const Volume labels = layersOf(maps, 30.0);
  Shot shot;
  shot.labels = &labels;
  shot.scene.tissues = {{.label = 1, .name = "before"}, {.label = 2, .name = "behind", .attenuation_dbPerCmMhz = 0.0}};
  shot.scene.reverberation = ReverberationEffect{.shadowHaze_db = -60.0};
  const GreyImage image = imageOf(maps, shot);
  const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
  // A rung lies at one depth all along: the mean over the lines is as bright there as each of them.
  const int middle = static_cast<int>(std::lround(geometry.face_px.x)), aside = static_cast<int>(12.0 / geometry.pixel_mm);
  std::vector<double> brightest(static_cast<std::size_t>(2 * aside + 1), 0.0);
  double rung = 0.0;
  for (int y = 0; y < image.height; ++y) {
    if (const double depth_mm = geometry.probePoint_mm(middle, y).y; depth_mm < 33.9 || depth_mm > 45.0) continue;
    double sum = 0.0;
    for (int n = 0; n <= 2 * aside; ++n) {
      const double level = viewOf(image).at(middle - aside + n, y);
      brightest[static_cast<std::size_t>(n)] = std::max(brightest[static_cast<std::size_t>(n)], level);
      sum += level;
    }
    rung = std::max(rung, sum / (2 * aside + 1));
  }
  EXPECT_GT(meanOf(brightest), 60.0) << "clutter is there";
  EXPECT_LT(rung, 0.75 * meanOf(brightest));
}

TEST(LiveReverberation, IsTheSameOnEveryTargetAndWithAnyNumberOfThreads) {
  Layers layers(kEven, kLung_mrayl);
  addPlane(layers.maps, {.name = "pleura", .echoLevel = 250.0, .frontOnly = true}, 60.0);
  layers.shot.scene.liveEchoes = LiveEchoesEffect{};
  layers.shot.scene.reverberation = ReverberationEffect{};
  for (const double impedance_mrayl : {kLung_mrayl, kGas_mrayl}) {
    layers.shot.scene.tissues.back().impedance_mrayl = impedance_mrayl;
    layers.shot.threads = 1;
    const GreyImage one = imageOf(layers.maps, layers.shot);
    for (const int threads : {2, 8}) {
      layers.shot.threads = threads;
      EXPECT_EQ(imageOf(layers.maps, layers.shot), one) << threads;
    }
    layers.shot.threads = 1;
    testing::onEveryTarget([&](const char* target) { EXPECT_EQ(imageOf(layers.maps, layers.shot), one) << target; });
  }
}

TEST(SpeckleReduction, FlattensGrainAndKeepsItsMean) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  Shot shot;
  shot.scene.liveEchoes->looks = 3;
  const auto spread = [](const std::vector<double>& levels) {
    const double mean = meanOf(levels);
    double square = 0.0;
    for (const double level : levels) square += (level - mean) * (level - mean);
    return std::sqrt(square / static_cast<double>(levels.size()));
  };
  const std::vector<double> plain = levelsBetween(imageOf(maps, shot), shot, 40.0, 100.0);
  shot.scene.liveEchoes->speckleReduction = 0.4;
  const std::vector<double> flat = levelsBetween(imageOf(maps, shot), shot, 40.0, 100.0);
  EXPECT_NEAR(meanOf(flat), meanOf(plain), 1.0);
  EXPECT_NEAR(spread(flat) / spread(plain), 0.6, 0.08);
  EXPECT_GT(correlation(flat, plain), 0.95);
}

TEST(SpeckleReduction, LeavesEdgesAndWhatStandsOut) {
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y < 60.0 ? 120.0 : 0.0; });
  addPlane(maps, {.name = "wall", .echoLevel = 230.0, .rough_db = -60.0}, 40.0);
  Shot shot;
  const auto peak = [&] {
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, 37.0, 43.0, 3.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  const double plain = peak();
  shot.scene.liveEchoes->speckleReduction = 0.8;
  EXPECT_NEAR(peak(), plain, 1.0);
  EXPECT_LT(meanOf(levelsBetween(imageOf(maps, shot), shot, 64.0, 70.0)), 2.0);
}

}  // namespace
}  // namespace ew::live_machine_test
