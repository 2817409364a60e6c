#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "ew/imaging/settings_json.h"
#include "ew/library/case.h"
#include "ew/library/schema.h"
#include "library/temporary_folder.h"
#include "places.h"

namespace ew::case_scene_test {
namespace {

using nlohmann::json;

json caseWith(const json& scene) {
  return {{"format", 1}, {"id", "one"}, {"title", "One"}, {"volume", {{"file", "volumes/a.mha"}}}, {"scene", scene}};
}

json schemaOfScenes() {
  std::ifstream file(std::string(EW_SOURCE_DIR) + "/resources/schemas/case.schema.json");
  return json::parse(file)["properties"]["scene"]["properties"];
}

TEST(CaseScene, HoldsEffectsTissuesAndTheRecordedRange) {
  const json scene = {{"gain_and_dgc", true},
                      {"focus", true},
                      {"attenuation", {{"expected_db_per_cm_mhz", 0.7}}},
                      {"tissues", {{{"label", 7}, {"name", "gall stone"}, {"attenuation_db_per_cm_mhz", 8.0}, {"reflection_db", 25.0}}}},
                      {"recorded_dynamic_range_db", 66.0}};
  const auto made = caseFromManifest(caseWith(scene), {});
  ASSERT_TRUE(made) << made.error();
  EXPECT_TRUE(made->scene.focus);
  EXPECT_FALSE(made->scene.noise);
  ASSERT_TRUE(made->scene.attenuation);
  EXPECT_EQ(made->scene.attenuation->expected_dbPerCmMhz, 0.7);
  ASSERT_EQ(made->scene.tissues.size(), 1U);
  EXPECT_EQ(made->scene.tissues[0].reflection_db, 25.0);
  EXPECT_EQ(made->scene.recordedDynamicRange_db, 66.0);
  EXPECT_EQ(manifestOf(*made)["scene"], scene);
  EXPECT_EQ(made->otherFields, json::object());
}

TEST(CaseScene, KeepsWhatNewerProgramsWroteIntoAnEffect) {
  const json scene = {{"gain_and_dgc", true}, {"doppler", {{"prf_hz", 4000}}}, {"focus", {{"apodization", "hann"}}}};
  auto made = caseFromManifest(caseWith(scene), {});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(manifestOf(*made)["scene"], scene);
  made->scene.focus.reset();
  EXPECT_EQ(manifestOf(*made)["scene"], (json{{"gain_and_dgc", true}, {"doppler", {{"prf_hz", 4000}}}}));
}

TEST(CaseScene, NamesWhatCannotBeUsed) {
  struct Wrong {
    json scene;
    const char* field;
  };
  for (const Wrong& wrong : {Wrong{{{"focus", 1}}, "scene.focus"}, Wrong{{{"noise", {{"at_face_db", 3}}}}, "scene.noise.at_face_db"},
                             Wrong{{{"reverberation", {{"bounces", 2.5}}}}, "scene.reverberation.bounces"},
                             Wrong{{{"tissues", {{{"name", "stone"}}}}}, "scene.tissues[0]"},
                             Wrong{{{"tissues", {{{"label", 7}}, {{"label", 7}}}}}, "scene.tissues[1].label"}}) {
    const auto problems = checkManifest(caseWith(wrong.scene), {});
    ASSERT_EQ(problems.size(), 1U) << wrong.field;
    EXPECT_EQ(problems[0].code, ErrorCode::badField);
    EXPECT_EQ(problems[0].context.front().second, wrong.field) << problems[0];
  }
}

TEST(CaseScene, TheSchemaAndTheReaderAllowTheSame) {
  const auto agreed = [](const std::string& effect, const std::string& key, const json& value, bool isGood) {
    json scene;
    if (effect.empty())
      scene[key] = value;
    else if (effect == "tissues")
      scene["tissues"] = {key == "label" ? json{{"label", value}} : json{{"label", 1}, {key, value}}};
    else
      scene[effect][key] = value;
    EXPECT_EQ(sceneFromJson(scene, verbatim("scene")).has_value(), isGood) << scene;
    EXPECT_EQ(schemaProblems(caseWith(scene), SchemaName::caseManifest, verbatim("case.json")).empty(), isGood) << scene;
  };
  int checked = 0;
  const auto check = [&](const std::string& effect, const json& properties) {
    for (const auto& [key, rule] : properties.items()) {
      EXPECT_NE(sceneManual().find(" " + key + ": "), std::string::npos) << key << " is in the schema alone";
      if (!rule.contains("minimum")) continue;
      const bool whole = rule["type"] == "integer";
      const double lowest = rule["minimum"], highest = rule["maximum"], step = whole ? 1.0 : 1e-6;
      const auto as = [&](double value) { return whole ? json(static_cast<int>(value)) : json(value); };
      agreed(effect, key, as(lowest), true);
      agreed(effect, key, as(highest), true);
      agreed(effect, key, as(lowest - step), false);
      agreed(effect, key, as(highest + step), false);
      agreed(effect, key, "1", false);
      ++checked;
    }
  };
  const json scene = schemaOfScenes();
  check("", scene);
  for (const auto& [key, rule] : scene.items())
    if (rule.contains("properties")) check(key, rule["properties"]);
  check("tissues", scene["tissues"]["items"]["properties"]);
  EXPECT_EQ(checked, 42);
  const json everything = toJson(sceneWithEverything());
  for (const auto& [key, value] : everything.items()) EXPECT_TRUE(scene.contains(key)) << key << " is missing in the schema";
}

TEST(CaseSchema, WhatAFieldHasToBeIsATextForTranslators) {
  const auto problems = schemaProblems(caseWith({{"reverberation", {{"bounces", 9}}}}), SchemaName::caseManifest, verbatim("case.json"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence(), "'scene.reverberation.bounces' in case.json is 9; it must be a whole number from 1 to 6.");
  const char* expected = problems[0].message.arguments().back().text();
  EXPECT_STREQ(expected, "a whole number from 1 to 6");
  bool isListed = false;
  for (const MessageText* each = firstMessageText(); each != nullptr; each = each->next) isListed = isListed || each->text == expected;
  EXPECT_TRUE(isListed);
}

}  // namespace
}  // namespace ew::case_scene_test
