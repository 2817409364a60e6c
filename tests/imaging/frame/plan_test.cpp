#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <sstream>

#include "ew/imaging/frame.h"

namespace ew::plan_test {
namespace {

Probe convexProbe() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 55.0;
  probe.halfAngle_rad = 32.0 * std::numbers::pi / 180.0;
  probe.lines = 192;
  probe.minDepth_mm = 40.0;
  probe.maxDepth_mm = 240.0;
  probe.defaultDepth_mm = 150.0;
  return probe;
}

struct Setting {
  Knobs knobs = {};
  Scene scene = {.gainAndDgc = true};
  Probe probe = convexProbe();
  double voxel_mm = 0.2;
  bool hasLabels = false;
  bool hasGaps = false;
};

Plan planOf(const Setting& s) {
  const Grid grid{{100, 100, 100}, glm::dvec3(s.voxel_mm)};
  return makePlan(s.probe, s.knobs, s.scene, fitDisplay(s.probe, s.knobs, 400, 400), grid, {.labels = s.hasLabels}, s.hasGaps);
}

std::string printed(const Setting& setting) {
  std::ostringstream text;
  text << planOf(setting);
  return text.str();
}

TEST(Plan, OfNeutralKnobsIsSamplingAlone) {
  Setting s;
  EXPECT_EQ(printed(s), "display: linear");
  s.knobs.quality = Quality::weave;
  EXPECT_EQ(printed(s), "display: weave");
  s.knobs.quality = Quality::cubic;
  EXPECT_EQ(printed(s), "display: cubic");
}

TEST(Plan, StretchesAWeaveThatZoomsInOnTheDisplayAlone) {
  Setting s{.knobs = {.quality = Quality::weave}, .voxel_mm = 1.0};
  EXPECT_EQ(printed(s), "display: weave + zoom stretch");
  s.scene.noise.emplace();
  EXPECT_EQ(printed(s), "beams: weave + noise + scan conversion");
}

TEST(Plan, FusesGainDgcDynamicRangeAndGreyMapIntoOneTable) {
  Setting s;
  s.knobs.dgc[3] = 1.5;
  EXPECT_EQ(printed(s), "display: linear + grey table");
  s.knobs.gain = 2.0;
  s.knobs.dynamicRange_db = 50.0;
  s.knobs.greyMap = GreyMap::soft;
  EXPECT_EQ(printed(s), "display: linear + grey table");
}

TEST(Plan, HasNoTableThatChangesNothing) {
  Setting s;
  s.knobs.dynamicRange_db = 60.0;  // what the volume was recorded with
  EXPECT_EQ(printed(s), "display: linear");
  s.scene.recordedDynamicRange_db = 70.0;
  EXPECT_EQ(printed(s), "display: linear + grey table");
  s.knobs.dynamicRange_db = 0.0;
  s.knobs.gain = 2.0;
  s.scene.gainAndDgc = false;
  EXPECT_EQ(printed(s), "display: linear") << "the scene has no gain";
  s.knobs.greyMap = GreyMap::bright;
  EXPECT_EQ(printed(s), "display: linear + grey table") << "grey maps belong to the screen, not to the scene";
}

TEST(Plan, SharpensAndPersistsOnlyWhenTheKnobsAreTurned) {
  Setting s;
  s.knobs.edgeEnhancement = 0.5;
  s.knobs.persistence = 0.5;
  s.knobs.gain = 1.5;
  EXPECT_EQ(printed(s), "display: linear + edges + persistence + grey table");
}

TEST(Plan, SamplesBeamsAsSoonAsOneEffectNeedsThem) {
  const auto with = [](auto change) {
    Setting s;
    change(s);
    return printed(s);
  };
  EXPECT_EQ(with([](Setting& s) { s.scene.focus.emplace(); }), "beams: linear + focus + scan conversion");
  EXPECT_EQ(with([](Setting& s) {
              s.scene.focus.emplace();
              s.knobs.focusMethod = FocusMethod::rowStretch;
            }),
            "beams: linear + focus (stretch) + scan conversion");
  EXPECT_EQ(with([](Setting& s) { s.scene.focus = FocusEffect{.strength = 0.0}; }), "display: linear");
  EXPECT_EQ(with([](Setting& s) { s.scene.sliceThickness.emplace(); }), "beams: linear + slice thickness + scan conversion");
  EXPECT_EQ(with([](Setting& s) { s.scene.attenuation.emplace(); }), "beams: linear + shadow + scan conversion");
  EXPECT_EQ(with([](Setting& s) { s.scene.reverberation.emplace(); }), "beams: linear + reverberation + scan conversion");
  EXPECT_EQ(with([](Setting& s) { s.scene.noise.emplace(); }), "beams: linear + noise + scan conversion");
}

TEST(Plan, LeavesOutNoiseThatNobodyCanSee) {
  Setting s;
  s.scene.noise = NoiseEffect{.atFace_db = -150.0, .growth_dbPerCmMhz = 0.0};
  EXPECT_EQ(printed(s), "display: linear");
  s.scene.noise->growth_dbPerCmMhz = 0.5;  // 75 dB and more at the bottom
  EXPECT_EQ(printed(s), "beams: linear + noise + scan conversion");
}

TEST(Plan, LosesContactOnlyWhileAPartOfTheFaceIsOffTheSkin) {
  Setting s;
  s.scene.contact.emplace();
  EXPECT_EQ(printed(s), "display: linear");
  s.hasGaps = true;
  EXPECT_EQ(printed(s), "beams: linear + contact + scan conversion");
  s.scene.contact.reset();
  EXPECT_EQ(printed(s), "display: linear");
}

TEST(Plan, AsksForTissuesOnlyWhenSomethingIsKnownOfThem) {
  Setting s{.hasLabels = true};
  s.scene.tissues.push_back({.label = 7, .name = "stone", .reflection_db = 25.0});
  EXPECT_EQ(printed(s), "display: linear") << "nothing asks what the tissues are";
  s.scene.attenuation.emplace();
  EXPECT_EQ(printed(s), "beams: linear + tissues + shadow + scan conversion");
  s.hasLabels = false;
  EXPECT_EQ(printed(s), "beams: linear + shadow + scan conversion");
  s.hasLabels = true;
  s.scene.tissues.clear();
  EXPECT_EQ(printed(s), "beams: linear + shadow + scan conversion");
}

TEST(Plan, NeedsNoBeamsToSteerToFanOutOrForMMode) {
  Probe linear;
  linear.maxSteering_rad = 0.4;
  linear.trapezoidHalfAngle_rad = 0.2;
  EXPECT_EQ(printed({.knobs = {.steering_rad = 0.3}, .probe = linear}), "display: linear");
  EXPECT_EQ(printed({.knobs = {.trapezoid = true}, .probe = linear}), "display: linear");
  EXPECT_EQ(printed({.knobs = {.mode = DisplayMode::mMode}}), "display: linear + M-mode");
  EXPECT_EQ(printed({.knobs = {.mode = DisplayMode::both}, .scene = {.gainAndDgc = true, .noise = NoiseEffect{}}}),
            "beams: linear + noise + M-mode + scan conversion");
}

TEST(Plan, WithEverythingRunsInTheOrderSoundAndMachineWork) {
  Setting s{.scene = sceneWithEverything(), .hasLabels = true, .hasGaps = true};
  s.scene.tissues.push_back({.label = 7, .name = "stone"});
  s.knobs.gain = 1.2;
  s.knobs.edgeEnhancement = 0.4;
  s.knobs.persistence = 0.3;
  s.knobs.mode = DisplayMode::both;
  EXPECT_EQ(
      printed(s),
      "beams: linear + slice thickness + tissues + contact + shadow + reverberation + focus + noise + M-mode + scan conversion + edges + "
      "persistence + grey table");
}

TEST(Plan, ComparesByItsStepsAndWhereTheyWork) {
  Setting s;
  const Plan plain = planOf(s);
  s.voxel_mm = 0.4;
  EXPECT_EQ(planOf(s), plain);
  s.knobs.gain = 2.0;
  EXPECT_NE(planOf(s), plain);
}

/// An effect switched on adds its step and moves nothing else about, whatever else is on.
RC_GTEST_PROP(Plan, GrowsByExactlyTheStepOfAnEffectSwitchedOn, ()) {
  Setting s;
  const auto maybe = [] { return *rc::gen::arbitrary<bool>(); };
  s.scene.noise.emplace();  // on beams already
  if (maybe()) s.scene.focus.emplace();
  if (maybe()) s.scene.reverberation.emplace();
  if (maybe()) s.scene.sliceThickness.emplace();
  if (maybe()) s.knobs.edgeEnhancement = 0.5;
  if (maybe()) s.knobs.gain = 1.5;
  const Plan before = planOf(s);
  s.scene.attenuation.emplace();
  Plan after = planOf(s);
  const auto added =
      std::find_if(after.steps.begin(), after.steps.end(), [](const Step& step) { return step.kind == StepKind::attenuation; });
  RC_ASSERT(added != after.steps.end());
  after.steps.erase(added);
  RC_ASSERT(after == before);
}

TEST(Plan, EstimatesEveryStepAndMoreForMore) {
  Setting s{.scene = sceneWithEverything(), .hasLabels = true, .hasGaps = true};
  s.scene.tissues.push_back({.label = 7, .name = "stone"});
  s.knobs.gain = 1.2;
  s.knobs.edgeEnhancement = 0.4;
  s.knobs.persistence = 0.3;
  s.knobs.mode = DisplayMode::both;
  for (const Step& step : planOf(s).steps) EXPECT_GT(step.estimated_us, 0.0) << nameOf(step.kind);
  const auto thickness = [&] { return planOf(s).steps[1].estimated_us; };
  const double five = thickness();
  s.knobs.elevationPlanes = 9;
  EXPECT_NEAR(thickness(), 2.0 * five, 1e-9);
}

}  // namespace
}  // namespace ew::plan_test
