#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "colour_support.h"
#include "ew/imaging/display.h"

namespace ew::colour_test {
namespace {

using namespace ew::testing::colour;

constexpr double kDepth_mm = TrialVessel{}.depth_mm;
constexpr double kPerDegree = std::numbers::pi / 180.0;

TrialEstimates measured(const Shot& shot, int frames = 1500) { return estimatesOfColour(shot.vessel, shot.knobs, shot.scene, frames); }

double share(const Image<Rgba>& image) {
  return static_cast<double>(std::count_if(image.pixels.begin(), image.pixels.end(), [](const Rgba& c) { return c.a > 0; })) /
         static_cast<double>(image.pixels.size());
}
double coloured(const DisplayImage& image) { return share(copyOf(image.colour)); }

TEST(ColourDoppler, FindsTheTruthBeyondTwoEdgesOfTheWallFilter) {
  for (const double angle_deg : {0.0, 30.0, 45.0, 60.0, 120.0, 180.0}) {
    Shot shot;
    shot.vessel.angle_rad = angle_deg * kPerDegree;
    shot.vessel.axis_mmPerS = 250.0;
    const ColourBox box = colourBoxOf(shot.probe, shot.knobs);
    const double truth = shot.vessel.towards_mmPerS();
    ASSERT_GT(std::abs(truth), 2.0 * box.wallEdge_mmPerS);
    const double allowed = std::abs(angle_deg - 90.0) < 31.0 ? 0.10 : 0.05;
    EXPECT_NEAR(measured(shot).mean * box.nyquist_mmPerS, truth, allowed * std::abs(truth)) << angle_deg << " degrees";
  }
}

TEST(ColourDoppler, ScattersAsMovingScatterersDo) {
  for (const double angle_deg : {0.0, 45.0, 60.0})
    for (const double snr_db : {10.0, 20.0}) {
      Shot shot;
      shot.vessel.angle_rad = angle_deg * kPerDegree;
      shot.scene = trialScene(snr_db);
      const TrialEstimates ours = measured(shot, 3000);
      const TrialEstimates theirs =
          estimatesOfScatterers(shot.vessel, shot.knobs, shot.scene, {.signalToNoise = std::pow(10.0, 0.1 * snr_db)}, 1500);
      EXPECT_NEAR(ours.mean, theirs.mean, 0.02) << angle_deg << " degrees, " << snr_db << " dB";
      EXPECT_NEAR(ours.deviation / theirs.deviation, 1.0, 0.15)
          << angle_deg << " degrees, " << snr_db << " dB: " << ours.deviation << " for " << theirs.deviation;
    }
}

TEST(ColourDoppler, TurnsAroundExactlyAtTheScale) {
  Shot shot;
  shot.vessel.angle_rad = 0.0 * kPerDegree;
  shot.vessel.bluntness = 60.0;  // a plug
  const double nyquist = colourBoxOf(shot.probe, shot.knobs).nyquist_mmPerS;
  for (const double share : {0.95, 0.99, 1.01, 1.05, 1.5, 2.0}) {
    shot.vessel.axis_mmPerS = share * nyquist;
    const double shown = share > 1.0 ? share - 2.0 : share;
    EXPECT_NEAR(std::remainder(measured(shot, 400).mean, 2.0), shown, 0.01) << share;
  }
}

TEST(ColourDoppler, SaysWhatItsLevelsAre) {
  // Signal to noise of trialScene(), from powers with and without blood.
  Shot shot;
  shot.vessel.axis_mmPerS = 250.0;
  shot.vessel.angle_rad = 0.0 * kPerDegree;
  shot.scene = trialScene(10.0);
  const double about = 250.0 / colourBoxOf(shot.probe, shot.knobs).nyquist_mmPerS;
  const double both = measured(shot).power;
  // Of what is just shown: noise that passes the filter lies 5 dB below it.
  const double noise = std::pow(10.0, -0.5);
  const WallFilter filter(10, 0);
  const double signal = (both - noise) / filter.response(about) * filter.noiseShare();
  EXPECT_NEAR(10.0 * std::log10(signal / noise), 10.0, 0.4);
}

TEST(ColourDoppler, ShowsNothingWithoutFlowAndWithoutNoise) {
  Shot shot;
  shot.vessel.axis_mmPerS = 0.0;
  ColourScan still(shot);
  EXPECT_EQ(coloured(still.next()), 0.0);
  EXPECT_EQ(coloured(still.next()), 0.0);
}

TEST(ColourDoppler, FindsNoDirectionSquareToTheFlow) {
  Shot shot;
  shot.vessel.angle_rad = 90.0 * kPerDegree;
  shot.vessel.axis_mmPerS = 600.0;
  const TrialEstimates found = measured(shot);
  EXPECT_NEAR(found.mean, 0.0, 0.02);
  EXPECT_GT(found.deviation, 0.05);  // blood that crosses the beam widens the spectrum past the wall filter
}

TEST(ColourDoppler, WorksWithTwoPulsesAndInHalfAWall) {
  Shot shot;
  shot.vessel.angle_rad = 0.0 * kPerDegree;
  shot.vessel.axis_mmPerS = 150.0;
  shot.knobs.colour->packet = 2;
  // With the mean taken out of two samples, one is the other's opposite, whatever moves.
  EXPECT_EQ(colourBoxOf(shot.probe, shot.knobs).filterOrder, -1);
  const double about = 150.0 / colourBoxOf(shot.probe, shot.knobs).nyquist_mmPerS;
  const TrialEstimates found = measured(shot);
  EXPECT_NEAR(found.mean, about, 0.05 * about);
  EXPECT_TRUE(std::isfinite(found.deviation));

  shot = {};
  ColourScan scan(shot);
  scan.next();
  const double edge_mm = shot.vessel.radius_mm / std::sin(std::numbers::pi / 4.0);
  const PacketSums sums = scan.sumsAt({0.0, kDepth_mm + edge_mm});
  EXPECT_TRUE(std::isfinite(sums.r0) && std::isfinite(std::abs(sums.r1)));
  EXPECT_LE(std::abs(meanVelocity(sums)), 1.0);
}

TEST(ColourDoppler, FlashesWhenTheProbeMoves) {
  Shot shot;
  shot.vessel.axis_mmPerS = 0.0;
  shot.knobs.colour->boxWidth = 0.6;
  ColourScan scan(shot);
  scan.next();
  scan.input().pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), {0.0, 8.0, 0.0});  // 160 mm/s, towards what it sees
  const DisplayImage flash = scan.next();
  EXPECT_GT(coloured(flash), 0.02);
  // What comes nearer is red.
  const Rgba* found = nullptr;
  for (int y = 0; y < flash.height(); ++y)
    for (int x = 0; x < flash.width(); ++x)
      if (flash.colour.at(x, y).a == 255) found = &flash.colour.at(x, y);
  ASSERT_NE(found, nullptr);
  EXPECT_GT(found->r, found->b);
  EXPECT_EQ(coloured(scan.next()), 0.0);  // and once it stands still, nothing
}

TEST(ColourDoppler, LosesBloodBehindAStone) {
  Shot shot;
  shot.knobs.colour->boxWidth = 0.4;
  shot.vessel.angle_rad = 60.0 * kPerDegree;
  ColourScan scan(shot);
  scan.next();
  const double open = coloured(scan.next());
  ASSERT_GT(open, 0.01);
  Scene scene = shot.scene;
  scene.attenuation = AttenuationEffect{};
  scene.tissues = {{.label = 0, .name = "soft", .attenuation_dbPerCmMhz = 0.5},
                   {.label = 1, .name = "stone", .attenuation_dbPerCmMhz = 10.0, .reflection_db = 60.0}};
  Volume labels;
  labels.grid = scan.maps().grid;
  labels.echo.assign(labels.grid.voxelCount(), 0);
  for (int k = 0; k < labels.grid.dims.z; ++k)
    for (int j = 16; j < 22; ++j)
      for (int i = 0; i < labels.grid.dims.x; ++i) labels.echo[labels.grid.indexOf(i, j, k)] = 1;  // 6 to 9 mm deep, all across
  scan.maker().configure(shot.probe, shot.knobs, scene, labels.grid, 320, 320, {.labels = true, .tissue = true, .flow = true});
  scan.input().labels = labels.view();
  EXPECT_EQ(coloured(scan.next()), 0.0);
}

TEST(ColourDoppler, BloomsWithGainAndStaysGreyWhereEchoesAreBright) {
  Shot shot;
  shot.knobs.colour->boxWidth = 0.4;
  shot.scene = trialScene(20.0);
  const auto at = [&](double gain_db, double priority) {
    shot.knobs.colour->gain_db = gain_db;
    shot.knobs.colour->priority = priority;
    return coloured(ColourScan(shot).next());
  };
  EXPECT_GT(at(-8.0, 1.0), at(-25.0, 1.0));
  EXPECT_GT(at(3.0, 1.0), 1.05 * at(-8.0, 1.0));
  EXPECT_GT(at(20.0, 1.0), 1.5 * at(0.0, 1.0));  // noise all over the box
  EXPECT_LT(at(3.0, 0.1), at(3.0, 1.0));         // tissue beside the vessel is brighter than a tenth
}

TEST(ColourDoppler, IsTheSameWithAnyNumberOfThreads) {
  Shot shot;
  shot.knobs.colour = ColourDoppler{.boxWidth = 0.7, .carrier_hz = 5e6};
  shot.scene = trialScene(15.0);
  ColourScan one(shot, 1), three(shot, 3);
  for (int n = 0; n < 3; ++n) {
    one.input().pose.probeToWorld.matrix = three.input().pose.probeToWorld.matrix =
        glm::translate(glm::dmat4(1.0), {0.2 * n, 0.3 * n, 0.0});
    EXPECT_EQ(copyOf(one.next().colour), copyOf(three.next().colour));
  }
}

TEST(ColourDoppler, LeavesTheImageBelowAsItIs) {
  Shot shot;
  ColourScan with(shot);
  const GreyImage grey = copyOf(with.next().grey);
  shot.knobs.colour.reset();
  ColourScan without(shot);
  const DisplayImage plain = without.next();
  EXPECT_EQ(grey, copyOf(plain.grey));
  EXPECT_FALSE(plain.hasColour());
}

TEST(ColourDoppler, IsInThePlanWhereBloodIsKnown) {
  Shot shot;
  const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, 320, 320);
  const auto has = [&](const FrameParts& parts) {
    const Plan plan = makePlan(shot.probe, shot.knobs, {}, geometry, Grid{{100, 100, 100}, glm::dvec3(0.5)}, parts);
    return std::any_of(plan.steps.begin(), plan.steps.end(), [](const Step& step) { return step.kind == StepKind::colour; });
  };
  EXPECT_TRUE(has({.tissue = true, .flow = true}));
  EXPECT_FALSE(has({.tissue = true}));
  EXPECT_FALSE(has({.flow = true}));
  shot.knobs.colour.reset();
  EXPECT_FALSE(has({.tissue = true, .flow = true}));
}

TEST(ColourDoppler, GoesOnFromWhatItRemembers) {
  Shot shot;
  shot.knobs.colour->persistence = 0.8;
  ColourScan scan(shot), other(shot);
  scan.next();
  const FrameMemory memory = scan.maker().memory();
  const Image<Rgba> second = copyOf(scan.next().colour);
  other.next();
  other.maker().forget();
  other.maker().recall(memory);
  EXPECT_EQ(copyOf(other.next().colour), second);
  // Without it, the second frame stands alone.
  other.maker().forget();
  other.input() = scan.input();
  --other.input().number;
  other.input().time_s -= 0.05;
  EXPECT_NE(copyOf(other.next().colour), second);
}

TEST(ColourDoppler, TakesSettingsThatAreNone) {
  const double nan = std::nan(""), inf = INFINITY;
  for (const double value : {nan, inf, -inf, 1e300, -1e300, 1e-300, 0.0, -1.0})
    for (const int whole : {-100, 0, 1, 3, 1000}) {
      Shot shot;
      ColourDoppler& colour = *shot.knobs.colour;
      colour.boxMiddle = colour.boxWidth = colour.boxMiddle_mm = colour.boxHeight_mm = colour.steering_rad = value;
      colour.carrier_hz = colour.prf_hz = colour.baseline = colour.gain_db = colour.priority = colour.reject = colour.persistence = value;
      colour.packet = colour.everyLine = colour.smoothing = whole;
      shot.knobs.mode = DisplayMode::spectrum;
      SpectralDoppler& spectral = shot.knobs.spectral.emplace();
      spectral.line = spectral.depth_mm = spectral.gate_mm = spectral.steering_rad = spectral.angle_rad = spectral.carrier_hz = value;
      spectral.prf_hz = spectral.baseline = spectral.wallFilter_hz = spectral.gain_db = spectral.dynamicRange_db = value;
      spectral.highPrf = whole > 0;
      ColourScan scan(shot);
      for (int n = 0; n < 2; ++n) scan.next();
      const FrameMemory memory = scan.maker().memory();
      EXPECT_TRUE(std::all_of(memory.colour.sums.begin(), memory.colour.sums.end(), [](float sum) { return std::isfinite(sum); }))
          << value << " " << whole;
      for (const std::complex<float>& sample : scan.maker().dopplerSamples()) ASSERT_TRUE(std::isfinite(std::abs(sample))) << value;
    }
}

TEST(ColourBox, StaysInTheFanAndSlowsThePulses) {
  const Probe probe = trialProbe();
  Knobs knobs;
  knobs.colour = ColourDoppler{.boxMiddle = 0.9, .boxMiddle_mm = 39.0, .boxHeight_mm = 20.0, .prf_hz = 20000.0};
  const ColourBox box = colourBoxOf(probe, knobs);
  EXPECT_DOUBLE_EQ(box.left, 0.0);
  EXPECT_DOUBLE_EQ(box.right, 1.0);
  EXPECT_DOUBLE_EQ(box.top_mm, 20.0);
  EXPECT_DOUBLE_EQ(box.bottom_mm, 40.0);
  EXPECT_DOUBLE_EQ(box.prf_hz, 1.54e6 / 80.0);
  EXPECT_NEAR(box.carrier_hz, 5e6, 1.0);
  EXPECT_NEAR(box.nyquist_mmPerS, nyquist_mmPerS(19250.0, 5e6), 1e-9);
  EXPECT_NEAR(box.frame_s, box.lines * 10 / 19250.0, 1e-12);
  const Knobs moved = withColourBoxAt(probe, knobs, {0.0, 5.0});
  EXPECT_DOUBLE_EQ(colourBoxOf(probe, moved).top_mm, 0.0);
  EXPECT_DOUBLE_EQ(colourBoxOf(probe, moved).bottom_mm, 20.0);
  EXPECT_DOUBLE_EQ(colourBoxOf(probe, moved).left, -0.5);
}

TEST(ColourBox, IsAParallelogramWhereLinesAreSteered) {
  const Probe probe = trialProbe();
  Knobs knobs;
  knobs.colour = ColourDoppler{.boxMiddle_mm = 20.0, .boxHeight_mm = 10.0, .steering_rad = 0.3};
  const std::vector<glm::dvec2> outline = colourBoxOutline_mm(probe, knobs);
  EXPECT_EQ(outline.front(), outline.back());
  // From one of the upper corners straight down its line.
  const glm::dvec2 down = outline[1] - outline[0];
  EXPECT_NEAR(down.x / down.y, std::tan(0.3), 1e-9);
  EXPECT_NEAR(glm::length(down), 10.0, 1e-9);
  knobs.colour->steering_rad = 0.0;
  EXPECT_NEAR((colourBoxOutline_mm(probe, knobs)[1] - colourBoxOutline_mm(probe, knobs)[0]).x, 0.0, 1e-12);
}

TEST(ColourMap, MovesWithTheBaselineAndTurnsWhenInverted) {
  ColourDoppler colour;
  const Rgb fast = colourOf(colour, 0.8), back = colourOf(colour, -0.8);
  EXPECT_GT(fast.r, fast.b);
  EXPECT_GT(back.b, back.r);
  colour.invert = true;
  EXPECT_EQ(colourOf(colour, 0.8), back);
  const RgbImage bar = colourBar({}, 3, 101);
  EXPECT_GT(viewOf(bar).at(1, 0).r, viewOf(bar).at(1, 0).b);
  EXPECT_GT(viewOf(bar).at(1, 100).b, viewOf(bar).at(1, 100).r);
  const RgbImage lowered = colourBar({.baseline = 0.5}, 1, 101);
  EXPECT_GT(viewOf(lowered).at(0, 60).r, viewOf(lowered).at(0, 60).b);  // a fifth below the middle is still towards
}

}  // namespace
}  // namespace ew::colour_test
