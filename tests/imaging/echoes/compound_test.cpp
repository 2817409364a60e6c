#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_level.h"
#include "imaging/support/every_target.h"
#include "imaging/support/live_echoes_support.h"

// What a console adds to live echoes: the mean of several directions, and harmonics.
namespace ew::compound_test {
namespace {

using namespace testing::live;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

Shot compounded(int angles, Shot shot = {}) {
  shot.knobs.compoundAngles = angles;
  return shot;
}

Probe linear() {
  Probe probe = testing::live::convex();
  probe.id = "linear";
  probe.kind = ProbeKind::linear;
  probe.radius_mm = probe.halfAngle_rad = 0.0;
  probe.width_mm = 40.0;
  probe.maxSteering_rad = 20.0 * kDegree_rad;
  probe.trapezoidHalfAngle_rad = 12.0 * kDegree_rad;
  return probe;
}

double deviationOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

struct Spot {
  glm::dvec2 at_mm{0.0};
  double level = 0.0;
};
/// The brightest pixel of an image.
Spot brightestOf(const GreyImage& image, const Shot& shot) {
  const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
  const auto brightest = std::max_element(image.pixels.begin(), image.pixels.end()) - image.pixels.begin();
  const int x = static_cast<int>(brightest % image.width), y = static_cast<int>(brightest / image.width);
  return {geometry.probePoint_mm(x, y), static_cast<double>(image.pixels[static_cast<std::size_t>(brightest)])};
}

bool has(const Plan& plan, StepKind kind) {
  return std::any_of(plan.steps.begin(), plan.steps.end(), [kind](const Step& step) { return step.kind == kind; });
}

TEST(Compounding, KeepsTheLevelAndTakesGrainAsSoManyIndependentImagesDo) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  for (Probe probe : {testing::live::convex(), linear()}) {
    Shot shot;
    shot.probe = std::move(probe);
    const std::vector<double> once = levelsBetween(imageOf(maps, shot), shot, 30.0, 70.0, 8.0);
    const std::vector<double> three = levelsBetween(imageOf(maps, compounded(3, shot)), shot, 30.0, 70.0, 8.0);
    EXPECT_NEAR((meanOf(three) - meanOf(once)) / kGreyPerDb, 0.0, 0.6) << shot.probe.id;
    EXPECT_NEAR(deviationOf(three) / deviationOf(once), 1.0 / std::sqrt(3.0), 0.05) << shot.probe.id;
    const std::vector<double> five = levelsBetween(imageOf(maps, compounded(5, shot)), shot, 30.0, 70.0, 8.0);
    EXPECT_NEAR(deviationOf(five) / deviationOf(once), 1.0 / std::sqrt(5.0), 0.06) << shot.probe.id;
  }
}

TEST(Compounding, SeesEverythingWhereItLies) {
  for (Probe probe : {testing::live::convex(), linear()})
    for (const glm::dvec2 at_mm : {glm::dvec2(0.0, 60.0), glm::dvec2(-11.0, 35.0), glm::dvec2(12.0, 90.0)}) {
      const TissueMaps ball =
          tissueOf([&](const glm::dvec3& p) { return glm::distance(p, glm::dvec3(at_mm, 0.0)) < 0.9 ? 200.0 : 0.0; }, 0.5);
      Shot shot;
      shot.probe = probe;
      shot.scene.liveEchoes->gain_db = -3.0;
      const Spot once = brightestOf(imageOf(ball, shot), shot), three = brightestOf(imageOf(ball, compounded(3, shot)), shot);
      EXPECT_LT(glm::distance(three.at_mm, once.at_mm), 1.0) << probe.id << " " << at_mm.x << " " << at_mm.y;
      // Speckle of the ball differs from direction to direction; beside one another they would all be 20 dB darker.
      EXPECT_GT(three.level, once.level - 9.0 * kGreyPerDb) << probe.id << " " << at_mm.x << " " << at_mm.y;
    }
}

TEST(Compounding, BrightensWhatLeansAwayFromTheFace) {
  const auto peakOf = [](int angles, double lean_rad) {
    TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
    addPlane(maps, {.name = "plane", .echoLevel = 220.0, .rough_db = -60.0}, 60.0, lean_rad);
    Shot shot = compounded(angles);
    shot.probe = linear();
    shot.scene.sliceThickness.reset();
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, 50.0, 70.0, 4.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  for (const double side : {-1.0, 1.0})
    EXPECT_GT(peakOf(3, side * 20.0 * kDegree_rad), peakOf(1, side * 20.0 * kDegree_rad) + 4.0 * kGreyPerDb) << side;
  EXPECT_NEAR((peakOf(3, 0.0) - peakOf(1, 0.0)) / kGreyPerDb, -2.3, 1.0)
      << "two of three see it a little from the side, and the mean is held";
}

TEST(Compounding, EndsAShadowWhereAllDirectionsPassWhatThrowsIt) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 170.0; });
  Volume labels;
  labels.grid = maps.grid;
  labels.echo.assign(maps.level.size(), 1);
  for (std::size_t n = 0; n < labels.echo.size(); ++n) {
    const auto i = static_cast<int>(n) % maps.grid.dims.x, j = static_cast<int>(n) / maps.grid.dims.x % maps.grid.dims.y;
    const glm::dvec2 mm = glm::dvec2(maps.grid.origin_mm) + glm::dvec2(i, j);
    if (std::abs(mm.x) < 6.0 && mm.y > 20.0 && mm.y < 26.0) labels.echo[n] = 2;
  }
  const auto levelAt = [&](int angles, double depth_mm) {
    Shot shot;
    shot.probe = linear();
    shot.probe.aperture_mm = 6.0;  // a narrow aperture throws a shadow with hard sides
    shot.labels = &labels;
    shot.scene.attenuation = AttenuationEffect{.expected_dbPerCmMhz = 0.0};
    shot.scene.tissues = {{.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 0.0},
                          {.label = 2, .name = "stone", .attenuation_dbPerCmMhz = 10.0}};
    shot = compounded(angles, shot);
    return meanOf(levelsBetween(imageOf(maps, shot), shot, depth_mm - 3.0, depth_mm + 3.0, 1.5));
  };
  const double free = 170.0;
  // 6 mm beside the middle, 10 degrees: the sides meet 34 mm below the stone.
  EXPECT_LT(levelAt(3, 35.0), free - 25.0 * kGreyPerDb) << "no direction passes";
  EXPECT_LT(levelAt(1, 90.0), free - 25.0 * kGreyPerDb);
  EXPECT_GT(levelAt(3, 90.0), levelAt(1, 90.0) + 10.0 * kGreyPerDb) << "two of three pass";
}

TEST(Compounding, IsTheSamePixelsOnEveryTargetAndWithAnyNumberOfThreads) {
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y > 60.0 ? 160.0 : p.x > 10.0 ? 90.0 : 0.0; });
  addPlane(maps, {.name = "plane"}, 60.3);
  for (Probe probe : {testing::live::convex(), linear()}) {
    Shot shot = compounded(3);
    shot.probe = std::move(probe);
    shot.scene.liveEchoes = LiveEchoesEffect{};
    shot.scene.noise = NoiseEffect{};
    const GreyImage one = imageOf(maps, shot);
    shot.threads = 3;
    EXPECT_EQ(imageOf(maps, shot), one) << shot.probe.id;
    testing::onEveryTarget([&](const char* target) { EXPECT_EQ(imageOf(maps, shot), one) << shot.probe.id << " " << target; });
  }
}

TEST(Compounding, IsInThePlanWhereItActsAndNowhereElse) {
  const auto planOf = [](const Probe& probe, const Knobs& knobs, bool hasTissue = true, bool isRecorded = false) {
    const DisplayGeometry geometry = fitDisplay(probe, knobs, 640, 480, {});
    return makePlan(probe, knobs, plainScene(), geometry, Grid{}, {.tissue = hasTissue, .recorded = isRecorded});
  };
  Knobs three;
  three.compoundAngles = 3;
  EXPECT_TRUE(has(planOf(testing::live::convex(), three), StepKind::compound));
  EXPECT_TRUE(has(planOf(linear(), three), StepKind::compound));
  EXPECT_FALSE(has(planOf(testing::live::convex(), {}), StepKind::compound));
  EXPECT_FALSE(has(planOf(testing::live::convex(), three, false), StepKind::compound)) << "nothing is formed anew";
  EXPECT_FALSE(has(planOf(testing::live::convex(), three, true, true), StepKind::compound)) << "a recorded volume has one grain";
  Probe phased = testing::live::convex();
  phased.kind = ProbeKind::phased;
  EXPECT_FALSE(has(planOf(phased, three), StepKind::compound));
  Knobs fast = three;
  fast.quality = Quality::weave;
  EXPECT_FALSE(has(planOf(testing::live::convex(), fast), StepKind::compound)) << "the fast quality follows the hand";
  Knobs fanned = three;
  fanned.trapezoid = true;
  EXPECT_FALSE(has(planOf(linear(), fanned), StepKind::compound));
  EXPECT_TRUE(has(planOf(testing::live::convex(), fanned), StepKind::compound)) << "a convex probe has no trapezoid";
}

TEST(Compounding, HasNoStepWhereADirectionEnds) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  Shot shot;
  shot.probe = linear();
  shot.knobs.depth_mm = 60.0;
  shot.knobs.compoundAngles = 3;
  const GreyImage image = imageOf(maps, shot);
  const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
  const int middle = static_cast<int>(std::lround(geometry.face_px.x)), aside = static_cast<int>(15.0 / geometry.pixel_mm);
  // From row to row the image changes as its grain does. Two of the three end at 60 mm cos 8.5 degrees.
  std::vector<double> before, there;
  for (int y = 0; y + 1 < image.height; ++y) {
    const double depth_mm = geometry.probePoint_mm(middle, y).y;
    double squares = 0.0;
    for (int x = middle - aside; x < middle + aside; ++x)
      squares += std::pow(static_cast<double>(viewOf(image).at(x, y + 1)) - viewOf(image).at(x, y), 2.0);
    if (depth_mm > 58.8 && depth_mm < 59.15) before.push_back(std::sqrt(squares));
    if (depth_mm > 59.15 && depth_mm < 59.5) there.push_back(std::sqrt(squares));
  }
  EXPECT_LT(meanOf(there), 2.0 * meanOf(before)) << "and not at once by as much as one direction's grain does";
}

TEST(Compounding, ForgetsTheOtherDirectionsWhenItIsSwitchedOff) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  const Shot once;
  FrameMaker maker(1);
  const FrameInput input = inputOf(maps);
  const auto made = [&](int angles) {
    Knobs knobs;
    knobs.compoundAngles = angles;
    maker.configure(once.probe, knobs, once.scene, maps.grid, 320, 256, {.tissue = true});
    const DisplayImage image = maker.make(input);
    return std::vector<std::uint8_t>(image.grey.data, image.grey.data + 320 * 256);
  };
  const auto one = made(1), three = made(3), five = made(5);
  EXPECT_NE(one, three);
  EXPECT_NE(three, five);
  EXPECT_EQ(made(3), three);
  EXPECT_EQ(made(1), one);
}

TEST(Steering, OfALinearProbeSeesOtherSpeckleAsAnotherApertureDoes) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  const auto seenWith = [&](double steering_deg) {
    Shot shot;
    shot.probe = linear();
    shot.knobs.depth_mm = 60.0;
    shot.knobs.steering_rad = steering_deg * kDegree_rad;
    FrameMaker maker(1);
    Knobs knobs = shot.knobs;
    knobs.greyMap = GreyMap::linear;
    maker.configure(shot.probe, knobs, shot.scene, maps.grid, 640, 512, {.tissue = true});
    const FrameInput input = inputOf(maps);
    (void)maker.make(input);
    // At the same places of the tissue.
    std::vector<double> levels;
    for (double y_mm = 15.0; y_mm < 35.0; y_mm += 0.25)
      for (double x_mm = -4.0; x_mm < 4.0; x_mm += 0.5) {
        const glm::dvec2 at = lineAndSampleAt(shot.probe, knobs, maker.beamGrid(), {x_mm, y_mm});
        levels.push_back(
            static_cast<double>(viewOf(maker.beamLevels()).at(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)))));
      }
    return levels;
  };
  const std::vector<double> straight = seenWith(0.0);
  EXPECT_GT(correlation(straight, seenWith(1.0)), 0.6);
  EXPECT_LT(correlation(straight, seenWith(10.0)), 0.25);
}

TEST(Harmonics, GrowWithDepthAndAreAsBrightAsTheCarrierAtHalfOfIt) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  for (const double carrier_hz : {2.5e6, 5e6}) {
    Shot once, harmonic;
    once.knobs.carrier_hz = harmonic.knobs.carrier_hz = carrier_hz;
    harmonic.knobs.harmonic = true;
    const GreyImage usual = imageOf(maps, once), second = imageOf(maps, harmonic);
    const auto grown = [carrier_hz](double depth_mm) { return depth_mm / (depth_mm + 57.0 * 1.54e6 / carrier_hz); };
    for (const double depth_mm : {12.0, 20.0, 60.0, 105.0}) {
      const double found_db = (meanOf(levelsBetween(second, harmonic, depth_mm - 3.0, depth_mm + 3.0, 25.0)) -
                               meanOf(levelsBetween(usual, once, depth_mm - 3.0, depth_mm + 3.0, 25.0))) /
                              kGreyPerDb;
      EXPECT_NEAR(found_db, 20.0 * std::log10(grown(depth_mm) / grown(60.0)), 0.9) << depth_mm << " " << carrier_hz;
    }
  }
}

TEST(Harmonics, AreSentByABeamOfHalfTheFrequencyWhichTheirSquareNarrows) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  // Width of the grain, mm: of Gaussians, intensities correlate by exp(-x^2 / 2 sigma^2) of the two-way beam.
  const auto widthOf = [&](bool isHarmonic) {
    Shot shot;
    shot.probe.lines = 400;
    shot.knobs.harmonic = isHarmonic;
    const GreyImage image = imageOf(maps, shot);
    const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
    const auto shift = 4;
    std::vector<double> here, there;
    for (int y = 0; y < image.height; ++y)
      for (int x = shift; x < image.width; ++x) {
        const glm::dvec2 p = geometry.probePoint_mm(x, y);
        if (p.y < 55.0 || p.y > 65.0 || std::abs(p.x) > 14.0) continue;
        const auto intensityAt = [&](int column) {
          return std::pow(10.0, image.pixels[static_cast<std::size_t>(y * image.width + column)] / kGreyPerDb / 10.0);
        };
        here.push_back(intensityAt(x));
        there.push_back(intensityAt(x - shift));
      }
    const double away_mm = shift * geometry.pixel_mm;
    return away_mm / std::sqrt(-2.0 * std::log(correlation(here, there)));
  };
  // At the focus both beams are s N wide on reception; on transmission s N, or sqrt(2) s N.
  const double ratio = std::sqrt((2.0 / 3.0) / (1.0 / 2.0));
  EXPECT_NEAR(widthOf(true) / widthOf(false), ratio, 0.08);
}

TEST(Harmonics, LeaveFluidDarkerBesideBrightTissueAndAreNearerToTheNoise) {
  const TissueMaps maps = tissueOf([](const glm::dvec3& p) { return std::abs(p.x) > 6.0 ? 220.0 : 0.0; });
  const auto fluidOf = [&](bool isHarmonic) {
    Shot shot;
    shot.scene.liveEchoes->haze_db = -20.0;
    shot.knobs.harmonic = isHarmonic;
    return meanOf(levelsBetween(imageOf(maps, shot), shot, 55.0, 65.0, 1.0));
  };
  EXPECT_NEAR((fluidOf(true) - fluidOf(false)) / kGreyPerDb, -10.0, 1.5);

  const TissueMaps nothing = tissueOf([](const glm::dvec3&) { return 0.0; });
  const auto noiseOf = [&](bool isHarmonic) {
    Shot shot;
    shot.scene.noise = NoiseEffect{.atFace_db = -35.0, .growth_dbPerCmMhz = 0.0};
    shot.knobs.harmonic = isHarmonic;
    return meanOf(levelsBetween(imageOf(nothing, shot), shot, 20.0, 100.0));
  };
  EXPECT_NEAR((noiseOf(true) - noiseOf(false)) / kGreyPerDb, 10.0, 0.5);
}

TEST(Harmonics, DoNotActOnARecordedVolume) {
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  maps.isRecorded = true;
  FrameMaker maker(1);
  const FrameInput input = inputOf(maps);
  const auto made = [&](bool isHarmonic) {
    Knobs knobs;
    knobs.harmonic = isHarmonic;
    maker.configure(testing::live::convex(), knobs, plainScene(), maps.grid, 320, 256, {.tissue = true, .recorded = true});
    const DisplayImage image = maker.make(input);
    return std::vector<std::uint8_t>(image.grey.data, image.grey.data + 320 * 256);
  };
  EXPECT_EQ(made(true), made(false));
}

}  // namespace
}  // namespace ew::compound_test
