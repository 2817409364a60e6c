#include "ew/imaging/effects/beam_gain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <sstream>

#include "ew/imaging/effects/gain.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/resolved.h"
#include "imaging/support/every_target.h"
#include "imaging/support/support.h"

namespace ew::beam_gain_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;
constexpr int kSize_px = 420;
constexpr double kDepth_mm = 160.0;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = radians(30.0);
  probe.lines = 160;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 240.0;
  probe.defaultDepth_mm = kDepth_mm;
  return probe;
}

/// A body that the whole fan lies in, and the pose that puts it there.
Volume bodyOf(const std::function<double(int, int, int)>& level) { return testing::volumeOf({80, 60, 20}, level, glm::dvec3(4.0)); }
Pose inTheBody() {
  Pose pose;
  pose.probeToWorld.matrix = glm::translate(glm::dmat4(1.0), {158.0, 30.0, 40.0});
  return pose;
}

Knobs decibels(double gain_db, std::array<double, kDgcSliders> tgc_db = {}) {
  Knobs knobs;
  knobs.gainLaw = GainLaw::decibel;
  knobs.gain_db = gain_db;
  knobs.tgc_db = tgc_db;
  return knobs;
}

struct Made {
  GreyImage image;
  DisplayGeometry geometry;
  Spans spans;

  /// The mean grey level of the fan.
  [[nodiscard]] double mean() const {
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < image.height; ++y)
      for (const RowSpan& span : spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x, ++count) sum += viewOf(image).at(x, y);
    return sum / count;
  }
};

Made made(const Volume& volume, const Knobs& knobs, const Scene& scene = {}, int threads = 1) {
  FrameMaker maker(threads);
  maker.configure(convexProbe(), knobs, scene, volume.grid, kSize_px, kSize_px);
  const ImageView<const std::uint8_t> view = maker.make(volume.view(), inTheBody()).grey;
  Made result{GreyImage(kSize_px, kSize_px), maker.geometry(), maker.spans()};
  std::copy(view.data, view.data + result.image.pixels.size(), result.image.pixels.begin());
  return result;
}

/// Along a beam, the depth around which what an image has more than `plain` lies.
double depthOfMost_mm(const Made& bright, double plain, double angle_rad) {
  double sum = 0.0, moment = 0.0;
  for (double depth_mm = 1.0; depth_mm < kDepth_mm - 1.0; depth_mm += 0.25) {
    const double radius_mm = 60.0 + depth_mm;
    const glm::dvec2 at_mm{radius_mm * std::sin(angle_rad), radius_mm * std::cos(angle_rad) - 60.0};
    const glm::dvec2 at_px =
        bright.geometry.face_px + glm::dvec2(bright.geometry.markerLeft ? -at_mm.x : at_mm.x, at_mm.y) / bright.geometry.pixel_mm;
    const double more = viewOf(bright.image).at(static_cast<int>(std::lround(at_px.x)), static_cast<int>(std::lround(at_px.y))) - plain;
    sum += more;
    moment += more * depth_mm;
  }
  return moment / sum;
}

TEST(Tgc, InDecibelsActsAtItsDepthAlongEveryBeam) {
  const Volume body = bodyOf([](int, int, int) { return 100.0; });
  const Made bright = made(body, decibels(0.0, {0, 0, 0, 0, 6, 0, 0, 0}));
  for (const double angle_deg : {0.0, 15.0, -15.0, 25.0, -25.0})
    EXPECT_NEAR(depthOfMost_mm(bright, 100.0, radians(angle_deg)), kDepth_mm * 4.5 / 8.0, 0.5) << angle_deg << " degrees";
  EXPECT_NEAR(*std::max_element(bright.image.pixels.begin(), bright.image.pixels.end()), 100.0 + 6.0 * kGreyPerDb, 0.6);
  // The paper's acts by rows of the image: at 25 degrees farther down the beam.
  Knobs paper;
  paper.dgc[4] = 1.25;
  EXPECT_GT(depthOfMost_mm(made(body, paper), 100.0, radians(25.0)), kDepth_mm * 4.5 / 8.0 + 8.0);
}

TEST(Tgc, InDecibelsActsInMModeAtTheSameDepths) {
  const Volume body = bodyOf([](int, int, int) { return 100.0; });
  Knobs knobs = decibels(3.0, {0, 0, 0, 0, 6, 0, 0, 0});
  knobs.mode = DisplayMode::mMode;
  knobs.mLine = 0.8;
  FrameMaker maker;
  maker.configure(convexProbe(), knobs, {}, body.grid, 200, 400);
  FrameInput input;
  input.echo = body.view();
  input.pose = inTheBody();
  for (int n = 0; n < 3; ++n) {
    input.time_s = 0.1 * n;
    maker.make(input);
  }
  for (int y = 0; y < 400; ++y)
    ASSERT_NEAR(maker.strip().at(4, y), 100.0 + kGreyPerDb * (3.0 + dgcAt(knobs.tgc_db, (y + 0.5) / 400.0)), 1.6) << y;
}

TEST(Gain, InDecibelsIsExactToATenth) {
  std::mt19937 random(4);
  const Volume body = bodyOf([&](int, int, int) { return 90.0 + random() % 70; });
  const double plain = made(body, {}).mean();
  for (const double gain_db : {-20.0, -7.5, -1.0, 0.5, 2.0, 6.0, 13.0, 21.0})
    EXPECT_NEAR((made(body, decibels(gain_db)).mean() - plain) / kGreyPerDb, gain_db, 0.1);
  std::array<double, kDgcSliders> all{};
  all.fill(-4.0);
  EXPECT_NEAR((made(body, decibels(9.0, all)).mean() - plain) / kGreyPerDb, 5.0, 0.1) << "gain and TGC add up";
}

TEST(Gain, InDecibelsLiftsNoiseByAsMuch) {
  const Volume empty = bodyOf([](int, int, int) { return 0.0; });
  const auto noisy = [&](double noise_db, double gain_db) {
    return made(empty, decibels(gain_db), {.noise = NoiseEffect{.atFace_db = noise_db, .growth_dbPerCmMhz = 0.0, .largest_db = 0.0}})
        .mean();
  };
  const double plain = noisy(-32.0, 0.0);
  for (const double gain_db : {-8.0, 3.0, 10.0}) EXPECT_NEAR((noisy(-32.0, gain_db) - plain) / kGreyPerDb, gain_db, 0.1);
  // Too much gain fills the vessel: noise far below black comes up as if black were nothing. Its logarithm lies 2.5 dB below its power.
  EXPECT_LT(noisy(-75.0, 0.0), 1.0);
  EXPECT_NEAR(noisy(-75.0, 30.0) / kGreyPerDb, 60.0 - 75.0 + 30.0 - 2.5, 0.8);
  EXPECT_LT(noisy(-120.0, 30.0), 0.1);
}

constexpr int kBeside_px = 3;  // a sample of a beam and its neighbours

bool isBlackAround(const GreyImage& image, int x, int y) {
  for (int v = y - kBeside_px; v <= y + kBeside_px; ++v)
    for (int u = x - kBeside_px; u <= x + kBeside_px; ++u)
      if (viewOf(image).at(u, v) > 0) return false;
  return true;
}

TEST(Gain, InDecibelsLeavesBlackWhatWasNeverRecorded) {
  // Half a body, and the lower half of the fan outside of all.
  const Volume half = testing::volumeOf(
      {80, 25, 20}, [](int i, int, int) { return i < 40 ? 120.0 : 0.0; }, glm::dvec3(4.0));
  const Made plain = made(half, {});
  for (const double range_db : {0.0, 120.0})
    for (const GainLaw law : {GainLaw::decibel, GainLaw::paper}) {
      Knobs knobs = decibels(30.0, {0, 20, 20, 20, 20, 20, 20, 0});
      knobs.gainLaw = law;
      knobs.dynamicRange_db = range_db;
      const Made lifted = made(half, knobs);
      int black = 0;
      for (int y = kBeside_px; y < kSize_px - kBeside_px; ++y)
        for (int x = kBeside_px; x < kSize_px - kBeside_px; ++x)
          if (isBlackAround(plain.image, x, y)) {
            ASSERT_EQ(viewOf(lifted.image).at(x, y), 0) << x << ", " << y;
            ++black;
          }
      EXPECT_GT(black, 60000);
    }
}

TEST(BeamGain, OpensBlackByWhatBringsItBackToBlackAndKeepsOrderAndAllLevelsAboveFaint) {
  EXPECT_TRUE(rc::check("black", [] {
    BeamGrid grid;
    grid.samples = *rc::gen::inRange(2, 40);
    grid.sampleSpacing_mm = 1.0;
    BeamGainSetting setting;
    setting.gain_db = *rc::gen::inRange(-300, 301) / 10.0;
    for (double& slider : setting.tgc_db) slider = *rc::gen::inRange(-200, 201) / 10.0;
    setting.recordedDynamicRange_db = *rc::gen::inRange(20, 121);
    setting.dynamicRange_db = *rc::gen::inRange(20, 121);
    setting.middleLevel = *rc::gen::inRange(0, 256);
    const BeamGain gain = makeBeamGain(setting, grid);
    BeamImage echoes(256, grid.samples);
    for (int s = 0; s < grid.samples; ++s)
      for (int v = 0; v < 256; ++v) viewOf(echoes).row(s)[v] = static_cast<float>(v);
    openBlack(gain, 0, viewOf(echoes));
    BeamImage shown = echoes;
    amplify(gain, 0, viewOf(shown));
    for (int s = 0; s < grid.samples; ++s) {
      const double position = s / (grid.samples - 1.0);
      const double tgc_db = dgcAt(setting.tgc_db, position);
      const double middle_db = (255.0 - setting.middleLevel) / 255.0 * setting.recordedDynamicRange_db;  // below white
      const double lift_db =
          setting.gain_db + tgc_db + setting.middleLevel / 255.0 * (setting.dynamicRange_db - setting.recordedDynamicRange_db);
      RC_ASSERT(lift_db <= setting.largestLift_db() + 1e-9);
      RC_ASSERT(viewOf(shown).at(0, s) < 1e-3F);
      for (int v = 0; v < 256; ++v) {
        if (v > 0) RC_ASSERT(viewOf(shown).at(v, s) > viewOf(shown).at(v - 1, s));
        if (v >= 16 || lift_db <= 0.0) RC_ASSERT(viewOf(echoes).at(v, s) == static_cast<float>(v));
        if (v < 16) continue;
        const double below_db = (255.0 - v) / 255.0 * setting.recordedDynamicRange_db - setting.gain_db - tgc_db;
        const double expected = setting.middleLevel + 255.0 * (middle_db - below_db) / setting.dynamicRange_db;
        RC_ASSERT(std::abs(static_cast<double>(viewOf(shown).at(v, s)) - expected) < 0.01);
      }
    }
  }));
}

TEST(BeamGain, OfBandsIsThatOfTheWholeAndTheSameOnEveryTargetAndAnyThreads) {
  std::mt19937 random(4);
  const Volume body = bodyOf([&](int, int, int) { return random() % 200; });
  Knobs knobs = decibels(4.3, {-3.3, 1.1, 0, 2.7, 6.1, -9, 12.3, 0.1});
  knobs.dynamicRange_db = 71.0;
  knobs.greyMap = GreyMap::clinical;
  Scene scene;
  scene.noise.emplace();
  scene.focus.emplace();
  const Made expected = made(body, knobs, scene);
  for (const int threads : {2, 8}) EXPECT_EQ(made(body, knobs, scene, threads).image, expected.image) << threads;
  testing::onEveryTarget([&](const char* name) { EXPECT_EQ(made(body, knobs, scene).image, expected.image) << name; });
}

std::string planOf(const Knobs& knobs, const Scene& scene = {}) {
  std::ostringstream text;
  text << makePlan(convexProbe(), knobs, scene, fitDisplay(convexProbe(), knobs, 400, 400), Grid{{100, 100, 100}, glm::dvec3(0.2)});
  return text.str();
}

TEST(PlanInDecibels, AtNeutralIsThatOfThePaperAndHasNoStep) {
  EXPECT_EQ(planOf(decibels(0.0)), "display: linear");
  Scene noise;
  noise.noise.emplace();
  EXPECT_EQ(planOf(decibels(0.0), noise), planOf({}, noise));
  Scene without{.gainAndDgc = false};
  EXPECT_EQ(planOf(decibels(6.0), without), "display: linear");
  EXPECT_EQ(planOf(decibels(6.0, {1, 2}), without), "display: linear");
  std::mt19937 random(4);
  const Volume body = bodyOf([&](int, int, int) { return random() % 200; });
  EXPECT_EQ(made(body, decibels(0.0), noise).image, made(body, {}, noise).image);
}

TEST(PlanInDecibels, AmplifiesBehindTheNoiseAndOpensBlackOnlyForWhatIsLifted) {
  Scene noise;
  noise.noise.emplace();
  EXPECT_EQ(planOf(decibels(6.0)), "beams: linear + black + gain + scan conversion");
  EXPECT_EQ(planOf(decibels(-6.0)), "beams: linear + gain + scan conversion");
  EXPECT_EQ(planOf(decibels(6.0), noise), "beams: linear + black + noise + gain + scan conversion");
  EXPECT_EQ(planOf(decibels(-6.0, {0, 0, 0, 7}), noise), "beams: linear + black + noise + gain + scan conversion");
  Knobs wide = decibels(0.0), mMode = decibels(-1.0);
  wide.dynamicRange_db = 80.0;
  EXPECT_EQ(planOf(wide), "beams: linear + black + gain + scan conversion");
  wide.dynamicRange_db = 40.0;
  wide.greyMap = GreyMap::clinical;
  EXPECT_EQ(planOf(wide), "beams: linear + gain + scan conversion + grey table");
  mMode.mode = DisplayMode::both;
  EXPECT_EQ(planOf(mMode), "beams: linear + gain + M-mode + scan conversion");
}

TEST(PlanInDecibels, AddsNoiseThatOnlyTheGainMakesSeen) {
  Scene faint;
  faint.noise = NoiseEffect{.atFace_db = -100.0, .growth_dbPerCmMhz = 0.0};
  EXPECT_EQ(planOf(decibels(0.0), faint), "display: linear");
  EXPECT_EQ(planOf(decibels(20.0), faint), "beams: linear + black + noise + gain + scan conversion");
}

TEST(GainLaws, KeepTheValuesOfTheOtherAndDoNothingWithThem) {
  Knobs both = decibels(6.0, {3});
  both.gain = 2.0;
  both.dgc[2] = 0.5;
  Knobs onlyDecibels = decibels(6.0, {3}), onlyFactors;
  onlyFactors.gain = 2.0;
  onlyFactors.dgc[2] = 0.5;
  std::mt19937 random(4);
  const Volume body = bodyOf([&](int, int, int) { return random() % 200; });
  EXPECT_EQ(made(body, both).image, made(body, onlyDecibels).image);
  both.gainLaw = GainLaw::automatic;
  EXPECT_EQ(made(body, both).image, made(body, onlyFactors).image);
  both.gainLaw = GainLaw::paper;
  EXPECT_EQ(made(body, both).image, made(body, onlyFactors).image);
}

TEST(DynamicRange, TurnsAboutTheGreyOfParenchymaByBothLawsAndForBothKindsOfScene) {
  EXPECT_EQ(middleLevel(false), kMiddleGrey);
  EXPECT_NEAR(shownLevel({.map = usualGreyMap(true)}, middleLevel(true)), kMiddleGrey, 1e-3);
  std::mt19937 random(4);
  const Volume body = bodyOf([&](int, int, int) { return 25.0 + random() % 41; });  // about 45
  const auto spread = [](const Made& image) {
    const double mean = image.mean();
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < image.image.height; ++y)
      for (const RowSpan& span : image.spans[static_cast<std::size_t>(y)])
        for (int x = span.begin; x < span.end; ++x, ++count) sum += std::pow(viewOf(image.image).at(x, y) - mean, 2.0);
    return std::sqrt(sum / count);
  };
  const Made plain = made(body, {});
  for (const GainLaw law : {GainLaw::decibel, GainLaw::paper})
    for (const double range_db : {40.0, 80.0}) {
      Knobs knobs;
      knobs.gainLaw = law;
      knobs.dynamicRange_db = range_db;
      const Made turned = made(body, knobs);
      EXPECT_NEAR(turned.mean(), plain.mean(), 0.6) << range_db;
      EXPECT_NEAR(spread(turned) / spread(plain), 60.0 / range_db, 0.04) << range_db;
    }
}

TEST(Resolved, IsThePapersAndLinearForARecordedVolumeAndAMachinesForEchoesFormedAnew) {
  EXPECT_EQ(usualGainLaw(false), GainLaw::paper);
  EXPECT_EQ(usualGreyMap(false), GreyMap::linear);
  EXPECT_EQ(usualGainLaw(true), GainLaw::decibel);
  EXPECT_EQ(usualGreyMap(true), GreyMap::clinical);
  EXPECT_FALSE(formsEchoes({}));
  EXPECT_TRUE(formsEchoes(sceneWithEverything()));
  EXPECT_EQ(resolvedGainLaw({}, {}), GainLaw::paper);
  EXPECT_EQ(resolvedGreyMap({}, {}), GreyMap::linear);
  EXPECT_EQ(resolvedGainLaw({.gainLaw = GainLaw::decibel}, {}), GainLaw::decibel);
  EXPECT_EQ(resolvedGreyMap({.greyMap = GreyMap::bright}, {}), GreyMap::bright);
}

}  // namespace
}  // namespace ew::beam_gain_test
