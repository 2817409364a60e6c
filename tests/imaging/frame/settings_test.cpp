#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ew/imaging/settings_json.h"

namespace ew::settings_test {
namespace {

using nlohmann::json;

double anyNumber(double lowest, double highest) { return lowest + (highest - lowest) * (*rc::gen::inRange(0, 1 << 20)) / double(1 << 20); }

Knobs anyKnobs() {
  Knobs knobs;
  knobs.gain = anyNumber(0, 20);
  for (double& factor : knobs.dgc) factor = anyNumber(0, 4);
  knobs.gainLaw = *rc::gen::element(GainLaw::automatic, GainLaw::decibel, GainLaw::paper);
  knobs.gain_db = anyNumber(-30, 30);
  for (double& slider_db : knobs.tgc_db) slider_db = anyNumber(-20, 20);
  knobs.depth_mm = *rc::gen::element(0.0, 0.1, 160.0, 1000.0);
  knobs.focus_mm = *rc::gen::element(0.0, 80.0, 33.3);
  for (double& focus : knobs.moreFoci_mm) focus = *rc::gen::element(0.0, 0.0, 120.5);
  knobs.focusMethod = *rc::gen::element(FocusMethod::rowStretch, FocusMethod::lateralKernel);
  knobs.carrier_hz = *rc::gen::element(0.0, 1e5, 3.5e6);
  knobs.dynamicRange_db = *rc::gen::element(0.0, 20.0, 47.3);
  knobs.greyMap =
      *rc::gen::element(GreyMap::linear, GreyMap::soft, GreyMap::contrast, GreyMap::bright, GreyMap::clinical, GreyMap::automatic);
  knobs.edgeEnhancement = anyNumber(0, 1);
  knobs.persistence = anyNumber(0, 0.95);
  knobs.elevationPlanes = 2 * *rc::gen::inRange(1, 5) + 1;
  knobs.steering_rad = *rc::gen::inRange(-600, 601) * 0.1 * (std::numbers::pi / 180.0);
  knobs.trapezoid = *rc::gen::arbitrary<bool>();
  knobs.zoom = anyNumber(1, 8);
  knobs.quality = *rc::gen::element(Quality::weave, Quality::linear, Quality::cubic);
  knobs.mode = *rc::gen::element(DisplayMode::bMode, DisplayMode::mMode, DisplayMode::both);
  knobs.mLine = anyNumber(-1, 1);
  knobs.mSweep_s = anyNumber(1, 16);
  knobs.markerLeft = *rc::gen::arbitrary<bool>();
  knobs.upsideDown = *rc::gen::arbitrary<bool>();
  return knobs;
}

Scene anyScene() {
  Scene scene;
  const auto maybe = [] { return *rc::gen::arbitrary<bool>(); };
  scene.gainAndDgc = maybe();
  scene.recordedDynamicRange_db = *rc::gen::element(60.0, 72.5);
  if (maybe()) scene.focus = FocusEffect{.strength = *rc::gen::element(1.0, 0.25)};
  if (maybe()) scene.sliceThickness = SliceThicknessEffect{.scale = *rc::gen::element(1.0, 2.0)};
  if (maybe()) scene.attenuation = AttenuationEffect{.expected_dbPerCmMhz = *rc::gen::element(0.5, 0.7), .fluidLevel = anyNumber(0, 255)};
  if (maybe()) scene.reverberation = ReverberationEffect{.bounces = *rc::gen::inRange(1, 7), .mirror = maybe()};
  if (maybe()) scene.noise = NoiseEffect{.atFace_db = anyNumber(-120, 0), .largest_db = anyNumber(-60, 0)};
  if (maybe()) scene.contact = ContactEffect{.gel_mm = anyNumber(0, 20)};
  const int tissues = *rc::gen::inRange(0, 4);
  for (int n = 0; n < tissues; ++n)
    scene.tissues.push_back({.label = n * 7, .name = *rc::gen::element<std::string>("", "gall stone"), .reflection_db = anyNumber(0, 40)});
  return scene;
}

RC_GTEST_PROP(SettingsJson, KnobsComeBackAsTheyWere, ()) {
  const Knobs knobs = anyKnobs();
  const auto read = knobsFromJson(json::parse(toJson(knobs).dump()), verbatim("knobs"));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == knobs);
  RC_ASSERT(limited(knobs) == knobs);
}

RC_GTEST_PROP(SettingsJson, ScenesComeBackAsTheyWere, ()) {
  const Scene scene = anyScene();
  const auto read = sceneFromJson(json::parse(toJson(scene).dump()), verbatim("scene"));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == scene);
  RC_ASSERT(limited(scene) == scene);
}

TEST(SettingsJson, EveryKeyOfTheManualIsWrittenAndRead) {
  const json knobs = toJson(Knobs{});
  for (const auto& [key, value] : knobs.items()) {
    EXPECT_NE(knobsManual().find("  " + key + ": "), std::string::npos) << key;
    EXPECT_TRUE(knobsFromJson({{key, value}}, verbatim("knobs"))) << key;
  }
}

TEST(SettingsJson, AnEffectIsTrueFalseOrItsParameters) {
  const auto scene =
      sceneFromJson({{"focus", true},
                     {"noise", false},
                     {"attenuation", {{"expected_db_per_cm_mhz", 0.7}}},
                     {"tissues", {{{"label", 7}, {"name", "gall stone"}, {"attenuation_db_per_cm_mhz", 8}, {"reflection_db", 25}}}},
                     {"recorded_dynamic_range_db", 66}},
                    verbatim("scene"));
  ASSERT_TRUE(scene) << scene.error();
  EXPECT_EQ(scene->focus, FocusEffect{});
  EXPECT_FALSE(scene->noise);
  EXPECT_FALSE(scene->contact);
  ASSERT_TRUE(scene->attenuation);
  EXPECT_EQ(*scene->attenuation, (AttenuationEffect{.expected_dbPerCmMhz = 0.7}));
  ASSERT_EQ(scene->tissues.size(), 1U);
  EXPECT_EQ(scene->tissues[0], (TissueAcoustics{7, "gall stone", 8.0, 25.0}));
  EXPECT_EQ(scene->recordedDynamicRange_db, 66.0);
  EXPECT_TRUE(scene->gainAndDgc);
}

TEST(SettingsJson, OldFilesAreStillRead) {
  const auto knobs = knobsFromJson({{"gain", 2}, {"focus_mm", 80}, {"quality", "weave"}}, verbatim("knobs"));
  ASSERT_TRUE(knobs);
  EXPECT_EQ(knobs->focus_mm, 80.0);
  EXPECT_EQ(knobs->moreFoci_mm, (Knobs{}).moreFoci_mm);
  const auto scene = sceneFromJson({{"gain_and_dgc", false}}, verbatim("scene"));
  ASSERT_TRUE(scene);
  EXPECT_EQ(*scene, Scene{.gainAndDgc = false});
}

TEST(SettingsJson, FilesOfBeforeThereWereDecibelsMeanThePapersFactors) {
  const auto read = [](const json& document) { return knobsFromJson(document, verbatim("knobs")).value(); };
  // As a recording of version 1.0 has them: every key of its time.
  json old = toJson(Knobs{.gain = 1.4});
  for (const char* later : {"gain_law", "gain_db", "tgc_db"}) old.erase(later);
  old["grey_map"] = "linear";
  EXPECT_EQ(read(old), (Knobs{.gain = 1.4, .gainLaw = GainLaw::paper, .greyMap = GreyMap::linear}));
  EXPECT_EQ(read({{"dgc", {1, 1, 1, 1, 1, 1, 2, 2}}}).gainLaw, GainLaw::paper);
  EXPECT_EQ(read({{"gain_db", 3}}).gainLaw, GainLaw::decibel) << "who gives decibels means them";
  EXPECT_EQ(read({{"tgc_db", {0, 0, 0, 0, 0, 0, 2, 2}}}).gainLaw, GainLaw::decibel);
  EXPECT_EQ(read({{"gain_db", 3}, {"gain", 2}}).gainLaw, GainLaw::automatic);
  EXPECT_EQ(read({{"gain_db", 3}, {"gain_law", "paper"}}).gainLaw, GainLaw::paper);
  EXPECT_EQ(read(json::object()), Knobs{});
}

TEST(SettingsJson, SeveralFociAreAList) {
  const auto knobs = knobsFromJson({{"focus_mm", {40, 80, 0, 120}}}, verbatim("knobs"));
  ASSERT_TRUE(knobs);
  EXPECT_EQ(knobs->focus_mm, 40.0);
  EXPECT_EQ(knobs->moreFoci_mm, (std::array<double, 3>{80, 0, 120}));
  EXPECT_FALSE(knobsFromJson({{"focus_mm", json::array()}}, verbatim("knobs")));
  EXPECT_FALSE(knobsFromJson({{"focus_mm", {1, 2, 3, 4, 5}}}, verbatim("knobs")));
}

TEST(SettingsJson, WhatCannotBeUsedIsNamedWithWhatWasFoundAndExpected) {
  struct Wrong {
    const char* text;
    const char* field;
    const char* found;
    const char* expected;
  };
  for (const Wrong& wrong : {Wrong{R"({"gain": "loud"})", "gain", "\"loud\"", "number from 0"},
                             {R"({"gain": -1})", "gain", "-1", "0 to 1"},
                             {R"({"dgc": [1, 2, 3]})", "dgc", "[1,2,3]", "8 factors"},
                             {R"({"gain_db": 31})", "gain_db", "31", "-30 to 30"},
                             {R"({"tgc_db": [1, 2, 3]})", "tgc_db", "[1,2,3]", "8 numbers of decibels"},
                             {R"({"tgc_db": [0, 0, 0, 0, 0, 0, 0, 21]})", "tgc_db", "21", "-20 to 20"},
                             {R"({"gain_law": "loud"})", "gain_law", "\"loud\"", "\"automatic\", \"decibel\" or \"paper\""},
                             {R"({"zoom": 0.5})", "zoom", "0.5", "1 to 8"},
                             {R"({"quality": "best"})", "quality", "\"best\"", "\"weave\", \"linear\" or \"cubic\""},
                             {R"({"elevation_planes": 4})", "elevation_planes", "4", "odd number from 3 to 9"},
                             {R"({"elevation_planes": 5.5})", "elevation_planes", "5.5", "odd"},
                             {R"({"carrier_hz": 10})", "carrier_hz", "10", "or 0 for the probe's own"},
                             {R"({"steering_deg": 90})", "steering_deg", "90", "-60 to 60"},
                             {R"({"persistence": 1})", "persistence", "1", "0.95"},
                             {R"({"trapezoid": 1})", "trapezoid", "1", "true or false"},
                             {R"({"gian": 2})", "gian", "", "gain"}}) {
    const auto read = knobsFromJson(json::parse(wrong.text), verbatim("'knobs.json'"));
    ASSERT_FALSE(read) << wrong.text;
    EXPECT_EQ(read.error().code, ErrorCode::badField);
    EXPECT_EQ(read.error().context.front().second, wrong.field);
    for (const char* part : {wrong.field, wrong.found, wrong.expected, "'knobs.json'"})
      EXPECT_NE(read.error().sentence().find(part), std::string::npos) << read.error().sentence() << " without " << part;
    EXPECT_TRUE(read.error().sentence().ends_with('.'));
  }
  for (const Wrong& wrong : {Wrong{R"({"focus": 1})", "focus", "1", "true, false or an object"},
                             {R"({"focus": {"strength": 4}})", "focus.strength", "4", "0 to 3"},
                             {R"({"focus": {"strong": 1}})", "focus.strong", "", "strength"},
                             {R"({"reverberation": {"bounces": 0}})", "reverberation.bounces", "0", "1 to 6"},
                             {R"({"tissues": {}})", "tissues", "{}", "a list"},
                             {R"({"tissues": [{"name": "stone"}]})", "tissues[0]", "stone", "label"},
                             {R"({"tissues": [{"label": 7}, {"label": 7}]})", "tissues[1].label", "7", "no other tissue"},
                             {R"({"tissues": [{"label": 7}, {"label": 300}]})", "tissues[1].label", "300", "0 to 255"}}) {
    const auto read = sceneFromJson(json::parse(wrong.text), verbatim("scene"));
    ASSERT_FALSE(read) << wrong.text;
    EXPECT_EQ(read.error().context.front().second, wrong.field);
    for (const char* part : {wrong.field, wrong.found, wrong.expected})
      EXPECT_NE(read.error().sentence().find(part), std::string::npos) << read.error().sentence() << " without " << part;
  }
  EXPECT_EQ(sceneFromJson(json::array(), verbatim("scene")).error().code, ErrorCode::badHeader);
}

TEST(SettingsJson, KeepsWhatIsNotKnownAtItsPlaceWhenAsked) {
  const json document = {
      {"gain_and_dgc", true},
      {"doppler", {{"prf_hz", 4000}}},
      {"focus", {{"strength", 2.0}, {"apodization", "hann"}}},
      {"noise", {{"colour", "pink"}}},
      {"tissues", {{{"label", 3}, {"speed_m_per_s", 1580}}, {{"label", 7}, {"name", "stone"}, {"speed_m_per_s", 3000}}}}};
  json unknown;
  auto scene = sceneFromJson(document, verbatim("scene"), &unknown);
  ASSERT_TRUE(scene) << scene.error();
  EXPECT_EQ(toJson(*scene, &unknown), document);
  scene->noise.reset();
  scene->tissues.erase(scene->tissues.begin());
  const json edited = toJson(*scene, &unknown);
  EXPECT_FALSE(edited.contains("noise")) << "an effect taken away must not come back through what was not known of it";
  EXPECT_EQ(edited["tissues"], json({{{"label", 7}, {"name", "stone"}, {"speed_m_per_s", 3000}}}));
  EXPECT_EQ(edited["doppler"], document["doppler"]);
}

TEST(Limited, BringsEveryNumberIntoItsRangeAndTakesTheDefaultForWhatIsNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  Knobs knobs;
  knobs.gain = kNan;
  knobs.dgc = {kNan, kInf, -1, 1, 1, 1, 1, 1};
  knobs.gain_db = 77.0;
  knobs.tgc_db = {kNan, kInf, -kInf};
  knobs.carrier_hz = 5.0;
  knobs.persistence = 2.0;
  knobs.elevationPlanes = 6;
  knobs.steering_rad = -kInf;
  knobs.zoom = kNan;
  knobs.quality = static_cast<Quality>(77);
  const Knobs usable = limited(knobs);
  EXPECT_EQ(usable.gain, 1.0);
  EXPECT_EQ(usable.dgc[0], 1.0);
  EXPECT_EQ(usable.dgc[1], 1e6);
  EXPECT_EQ(usable.dgc[2], 0.0);
  EXPECT_EQ(usable.gain_db, 30.0);
  EXPECT_EQ(usable.tgc_db, (std::array<double, kDgcSliders>{0.0, 20.0, -20.0}));
  EXPECT_EQ(usable.carrier_hz, 1e5);
  EXPECT_EQ(usable.persistence, 0.95);
  EXPECT_EQ(usable.elevationPlanes, 7);
  EXPECT_NEAR(usable.steering_rad, -std::numbers::pi / 3.0, 1e-12);
  EXPECT_EQ(usable.zoom, 1.0);
  EXPECT_EQ(usable.quality, Quality::linear);
  Scene scene = sceneWithEverything();
  scene.recordedDynamicRange_db = 0.0;
  scene.reverberation->bounces = 1000000;
  scene.attenuation->interface_dbPerMm = kNan;
  scene.contact->ringDown_mm = -kInf;
  scene.tissues.push_back({.label = 999, .name = "", .attenuation_dbPerCmMhz = kInf});
  const Scene usableScene = limited(scene);
  EXPECT_EQ(usableScene.recordedDynamicRange_db, 20.0);
  EXPECT_EQ(usableScene.reverberation->bounces, 6);
  EXPECT_EQ(usableScene.attenuation->interface_dbPerMm, AttenuationEffect{}.interface_dbPerMm);
  EXPECT_EQ(usableScene.contact->ringDown_mm, 0.5);
  EXPECT_EQ(usableScene.tissues[0].label, 255);
  EXPECT_EQ(usableScene.tissues[0].attenuation_dbPerCmMhz, 100.0);
}

TEST(Limited, ChangesNothingOfTheDefaults) {
  EXPECT_EQ(limited(Knobs{}), Knobs{});
  EXPECT_EQ(limited(sceneWithEverything()), sceneWithEverything());
}

}  // namespace
}  // namespace ew::settings_test
