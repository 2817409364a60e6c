#include "ew/imaging/echo_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "ew/imaging/cost_of_accuracy.h"
#include "ew/imaging/frame.h"
#include "imaging/support/live_echoes_support.h"

namespace ew::echo_quality_test {
namespace {

using testing::live::inputOf;

constexpr Quality kRising[] = {Quality::weave, Quality::linear, Quality::cubic};

Probe probeOf(ProbeKind kind) {
  Probe probe;
  probe.id = "probe";
  probe.kind = kind;
  probe.width_mm = 40.0;
  probe.radius_mm = kind == ProbeKind::linear ? 0.0 : 40.0;
  probe.halfAngle_rad = kind == ProbeKind::linear ? 0.0 : 0.4;
  probe.lines = 96;
  probe.carrier_hz = 5e6;
  probe.aperture_mm = 20.0;
  probe.elevationalThickness_mm = 2.0;
  probe.elevationalFocus_mm = 30.0;
  probe.elevationalAperture_mm = 6.0;
  probe.minDepth_mm = 20.0;
  probe.maxDepth_mm = 100.0;
  probe.defaultDepth_mm = 50.0;
  return probe;
}

Scene liveScene() {
  Scene scene;
  scene.liveEchoes = LiveEchoesEffect{};
  scene.sliceThickness = SliceThicknessEffect{};
  scene.focus = FocusEffect{};
  return scene;
}

TEST(EchoQuality, LeavesTheDefaultAsItIsAndKeepsWhatTheMachineShows) {
  LiveEchoesEffect asked;
  asked.looks = 2;
  asked.samplesPerPulse = 5.5;
  asked.haze_db = -33.0;
  EXPECT_EQ(qualityOf(asked, Quality::linear), asked);
  for (const Quality quality : {Quality::weave, Quality::cubic}) {
    LiveEchoesEffect changed = qualityOf(asked, quality);
    EXPECT_NE(changed, asked);
    changed.samplesPerPulse = asked.samplesPerPulse;
    changed.reach = asked.reach;
    EXPECT_EQ(changed, asked) << "nothing but the two changes";
  }
}

TEST(EchoQuality, StaysWithinTheLimitsOfTheSettings) {
  LiveEchoesEffect least, most;
  least.samplesPerPulse = 3.0;
  least.reach = 1.0;
  most.samplesPerPulse = 10.0;
  most.reach = 3.0;
  for (const LiveEchoesEffect& asked : {least, most})
    for (const Quality quality : kRising) {
      Scene scene;
      scene.liveEchoes = qualityOf(asked, quality);
      EXPECT_EQ(limited(scene), scene);
    }
}

TEST(EchoQuality, IsMoreWorkFromFastToFineWithEveryProbe) {
  for (const ProbeKind kind : {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased}) {
    const Probe probe = probeOf(kind);
    EchoWork last;
    double lastEstimate_us = 0.0;
    for (const Quality quality : kRising) {
      Knobs knobs;
      knobs.quality = quality;
      const EchoWork work = echoWorkOf(probe, knobs, liveScene(), 50.0);
      EXPECT_GT(work.scatterers, 1.1 * last.scatterers);
      EXPECT_GT(work.samples, 1.1 * last.samples);
      EXPECT_EQ(work.lines, probe.lines);
      EXPECT_EQ(work.looks, LiveEchoesEffect{}.looks);
      const Plan plan = makePlan(probe, knobs, liveScene(), fitDisplay(probe, knobs, 320, 240, {}), Grid{}, {.tissue = true});
      double estimate_us = 0.0;
      for (const Step& step : plan.steps) estimate_us += step.estimated_us;
      EXPECT_GT(estimate_us, lastEstimate_us) << "the plan's estimate follows";
      last = work;
      lastEstimate_us = estimate_us;
    }
  }
}

TEST(EchoQuality, CountsTheScatterersOfTheSlice) {
  Scene scene = liveScene();
  scene.sliceThickness.reset();  // as thick everywhere: a box
  const Probe probe = probeOf(ProbeKind::linear);
  const auto scatterers = [&](double reach) {
    scene.liveEchoes->reach = reach;
    return echoWorkOf(probe, {}, scene, 50.0).scatterers;
  };
  EXPECT_NEAR(scatterers(3.0), 1.5 * scatterers(2.0), 1e-6 * scatterers(2.0));
  // The lattice is half a millimetre times a power of the root of two.
  const double box_mm3 = 40.0 * 50.0 * 2.0 * 2.0 * 2.0 / 2.3548200450309493, pitch_mm = std::cbrt(box_mm3 / scatterers(2.0));
  const double steps = 2.0 * std::log2(pitch_mm / 0.5);
  EXPECT_NEAR(steps, std::round(steps), 0.05) << pitch_mm;
}

TissueMaps evenTissue() {
  TissueMaps maps;
  maps.grid.dims = {70, 70, 24};
  maps.grid.origin_mm = {-35.0, -8.0, -12.0};
  maps.level.assign(maps.grid.voxelCount(), 150);
  return maps;
}

/// Levels on beams as if seen by lines and depths alone: every quality has samples of its own.
std::vector<double> levelsOf(const TissueMaps& maps, const Scene& scene, Quality quality) {
  FrameMaker maker;
  Knobs knobs;
  knobs.quality = quality;
  knobs.greyMap = GreyMap::linear;
  maker.configure(probeOf(ProbeKind::linear), knobs, scene, maps.grid, 200, 200, {.tissue = true});
  const DisplayImage image = maker.make(inputOf(maps));
  std::vector<double> levels;
  for (int y = 40; y < 160; ++y)
    for (int x = 60; x < 140; ++x) levels.push_back(image.grey.at(x, y));
  return levels;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sa += a[n], sb += b[n], saa += a[n] * a[n], sbb += b[n] * b[n], sab += a[n] * b[n];
  const auto count = static_cast<double>(a.size());
  return (sab / count - sa * sb / count / count) /
         std::sqrt((saa / count - sa * sa / count / count) * (sbb / count - sb * sb / count / count));
}

TEST(EchoQuality, FormsTheSameGrainAtEveryPrice) {
  const TissueMaps maps = evenTissue();
  Scene scene = liveScene();
  const auto usual = levelsOf(maps, scene, Quality::linear);
  EXPECT_GT(correlation(usual, levelsOf(maps, scene, Quality::weave)), 0.93);
  EXPECT_GT(correlation(usual, levelsOf(maps, scene, Quality::cubic)), 0.97);
  scene.liveEchoes->scatterersPerCell = 10.0;  // other scatterers: another grain
  EXPECT_LT(correlation(usual, levelsOf(maps, scene, Quality::linear)), 0.3);
}

/// Of the brightest row, mean over its columns, in dB.
double brightestRow_db(const TissueMaps& maps, Quality quality) {
  const auto levels = levelsOf(maps, liveScene(), quality);
  constexpr std::size_t kColumns = 80;
  double brightest = 0.0;
  for (std::size_t row = 0; row < levels.size(); row += kColumns)
    brightest = std::max(brightest, std::accumulate(&levels[row], &levels[row] + kColumns, 0.0) / kColumns);
  return brightest / testing::live::kGreyPerDb;
}

TEST(EchoQuality, ShowsASurfaceThatLeansOutOfTheSliceAsBrightAtEveryPrice) {
  for (const double lean_deg : {0.0, 10.0, 20.0, 30.0}) {
    const double lean_rad = lean_deg * std::numbers::pi / 180.0;
    std::array<double, 3> mean_db{};
    // Between two samples a line is a little fainter: at several depths.
    for (const double depth_mm : {24.8, 24.93, 25.06, 25.19}) {
      TissueMaps maps = evenTissue();
      std::fill(maps.level.begin(), maps.level.end(), std::uint8_t{0});
      testing::live::addSurface(maps, {.name = "plane", .echoLevel = 200.0, .rough_db = -3.0, .roughFall_deg = 60.0},
                                [&](const glm::dvec3& p) { return (depth_mm - p.y) * std::cos(lean_rad) + p.z * std::sin(lean_rad); });
      for (std::size_t n = 0; n < mean_db.size(); ++n) mean_db[n] += 0.25 * brightestRow_db(maps, kRising[n]);
    }
    EXPECT_GT(mean_db[1], 20.0) << lean_deg << " degrees";
    EXPECT_NEAR(mean_db[0], mean_db[1], 1.0) << lean_deg << " degrees";
    EXPECT_NEAR(mean_db[2], mean_db[1], 1.0) << lean_deg << " degrees";
  }
}

TEST(EchoQuality, LosesAsMuchAtEveryPrice) {
  const TissueMaps maps = evenTissue();
  Volume labels;
  labels.grid = maps.grid;
  labels.echo.assign(maps.level.size(), 1);
  Scene scene = liveScene();
  scene.attenuation = AttenuationEffect{};
  scene.attenuation->expected_dbPerCmMhz = 0.5;
  scene.tissues = {{.label = 1, .name = "muscle", .attenuation_dbPerCmMhz = 0.9}};
  const auto levelOf_db = [&](Quality quality) {
    FrameMaker maker;
    Knobs knobs;
    knobs.quality = quality;
    knobs.greyMap = GreyMap::linear;
    maker.configure(probeOf(ProbeKind::linear), knobs, scene, maps.grid, 200, 200, {.labels = true, .tissue = true});
    FrameInput input = inputOf(maps);
    input.labels = labels.view();
    const DisplayImage image = maker.make(input);
    double sum = 0.0;
    for (int y = 100; y < 160; ++y)
      for (int x = 60; x < 140; ++x) sum += image.grey.at(x, y);
    return sum / (60.0 * 80.0) / testing::live::kGreyPerDb;
  };
  const double usual_db = levelOf_db(Quality::linear);
  EXPECT_GT(usual_db, 5.0);
  EXPECT_NEAR(levelOf_db(Quality::weave), usual_db, 0.4);
  EXPECT_NEAR(levelOf_db(Quality::cubic), usual_db, 0.4);
}

TEST(EchoQuality, ShowsTheLevelsOnBeamsThatTheImageIsMadeOf) {
  const TissueMaps maps = evenTissue();
  FrameMaker maker;
  const Probe probe = probeOf(ProbeKind::linear);
  EXPECT_TRUE(maker.beamGrid().lines.empty());
  maker.configure(probe, {}, liveScene(), maps.grid, 64, 64, {.tissue = true});
  const DisplayImage image = maker.make(inputOf(maps));
  ASSERT_EQ(maker.beamLevels().width, probe.lines);
  ASSERT_EQ(maker.beamLevels().height, maker.beamGrid().samples);
  EXPECT_GT(image.grey.width, 0);
  // Neutral slices need no beams.
  maker.configure(probe, {}, Scene{}, maps.grid, 64, 64);
  EXPECT_TRUE(maker.beamGrid().lines.empty());
  EXPECT_TRUE(maker.beamLevels().pixels.empty());
}

TEST(CostOfEchoes, FallsFromFastToFineAgainstTheSameScatterersFormedFinest) {
  const TissueMaps maps = evenTissue();
  const auto measured =
      measureCostOfEchoes(inputOf(maps), probeOf(ProbeKind::linear), {}, liveScene(), Pose{}, 160, 160, {2, 1, 1}, noProgress());
  ASSERT_TRUE(measured.has_value()) << measured.error();
  EXPECT_TRUE(measured->ofEchoes);
  EXPECT_TRUE(measured->planes.empty());
  EXPECT_GT(measured->comparedPixels, 1000u);
  ASSERT_EQ(measured->qualities.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(measured->qualities[n].knobs.quality, kRising[n]);
    EXPECT_GT(measured->qualities[n].frame_ms, 0.0);
    if (n > 0) {
      EXPECT_GT(measured->qualities[n].psnr_db, measured->qualities[n - 1].psnr_db + 1.0);
    }
  }
  EXPECT_LT(measured->qualities[2].psnr_db, CostOfAccuracy::kExact_db);
}

TEST(CostOfEchoes, SaysWhyThereIsNothingToCompareAndEndsWhenCancelled) {
  const TissueMaps maps = evenTissue();
  Pose far;
  far.probeToWorld.matrix[3] = glm::dvec4(5000.0, 0.0, 0.0, 1.0);
  const Probe probe = probeOf(ProbeKind::linear);
  const auto beside = measureCostOfEchoes(inputOf(maps), probe, {}, liveScene(), far, 64, 64, {1, 1, 1}, noProgress());
  ASSERT_FALSE(beside.has_value());
  EXPECT_EQ(beside.error().code, ErrorCode::emptyVolume);
  Pose lost;
  lost.status = PoseStatus::missing;
  EXPECT_FALSE(measureCostOfEchoes(inputOf(maps), probe, {}, liveScene(), lost, 64, 64, {1, 1, 1}, noProgress()).has_value());
  class Cancelled final : public Progress {
   public:
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } cancelled;
  const auto stopped = measureCostOfEchoes(inputOf(maps), probe, {}, liveScene(), Pose{}, 64, 64, {1, 1, 1}, cancelled);
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew::echo_quality_test
