// One list of effects for all: what the case's schema allows, what a scene's JSON holds and what a Scene has must be that list.
#include "ew/imaging/effect_info.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <type_traits>

#include "ew/imaging/settings_json.h"
#include "places.h"

namespace ew::effect_info_test {
namespace {

using nlohmann::json;

template <class T>
struct IsEffect : std::is_same<T, bool> {};
template <class T>
struct IsEffect<std::optional<T>> : std::true_type {};

/// Members of a Scene that can be there or not. A new member does not compile here until it is named, and counts when it is an effect.
int effectsOfScene() {
  const Scene scene;
  const auto& [gainAndDgc, liveEchoes, recordedRange, focus, sliceThickness, attenuation, reverberation, noise, contact, motion, tissues] =
      scene;
  return []<class... Members>(const Members&...) { return (0 + ... + (IsEffect<Members>::value ? 1 : 0)); }(
             gainAndDgc, liveEchoes, recordedRange, focus, sliceThickness, attenuation, reverberation, noise, contact, motion, tissues);
}

json schemaOfScene() {
  const json document = json::parse(std::ifstream(std::string(EW_SOURCE_DIR) + "/resources/schemas/case.schema.json"));
  return document["properties"]["scene"]["properties"];
}

bool allowsBoolean(const json& rule) {
  const json type = rule.value("type", json());
  return type == "boolean" || (type.is_array() && std::find(type.begin(), type.end(), "boolean") != type.end());
}

/// The scene with nothing on.
Scene bareScene() {
  Scene scene;
  for (const EffectInfo& effect : sceneEffects()) effect.switchTo(scene, false);
  return scene;
}

std::set<std::string> keysOfEffects() {
  std::set<std::string> keys;
  for (const EffectInfo& effect : sceneEffects()) keys.insert(effect.key);
  return keys;
}

TEST(EffectInfo, ListsEveryEffectThatASceneHas) {
  EXPECT_EQ(static_cast<int>(sceneEffects().size()), effectsOfScene());
  EXPECT_EQ(keysOfEffects().size(), sceneEffects().size());
}

TEST(EffectInfo, ListsWhatTheSchemaOfCasesLists) {
  const json schema = schemaOfScene();
  std::set<std::string> keys;
  for (const auto& [key, rule] : schema.items())
    if (allowsBoolean(rule)) keys.insert(key);
  EXPECT_EQ(keys, keysOfEffects());
  for (const EffectInfo& effect : sceneEffects()) {
    std::set<std::string> parts, named;
    const json rule = schema[effect.key].value("properties", json::object());
    for (const auto& [key, part] : rule.items())
      if (allowsBoolean(part)) parts.insert(key);
    if (effect.option) named.insert(effect.option->key);
    EXPECT_EQ(parts, named) << effect.key;
  }
}

TEST(EffectInfo, SwitchesWhatTheKeyOfASceneFileSwitches) {
  for (const EffectInfo& effect : sceneEffects()) {
    json all = json::object();
    for (const std::string& key : keysOfEffects()) all[key] = key == effect.key;
    const auto read = sceneFromJson(all, verbatim("scene"));
    ASSERT_TRUE(read) << read.error();
    Scene alone = bareScene();
    effect.switchTo(alone, true);
    EXPECT_EQ(*read, alone) << effect.key;
    for (const EffectInfo& other : sceneEffects()) EXPECT_EQ(other.isOn(alone), &other == &effect) << effect.key << ", " << other.key;
    EXPECT_EQ(toJson(alone)[effect.key], json(true));
    EXPECT_NE(sceneManual().find("  " + std::string(effect.key) + ": true"), std::string::npos) << effect.key;
    effect.switchTo(alone, false);
    EXPECT_EQ(alone, bareScene()) << effect.key;
  }
}

TEST(EffectInfo, SwitchingOnKeepsTheParametersOfWhatIsOnAndCopyingBringsThem) {
  for (const EffectInfo& effect : sceneEffects()) {
    if (!effect.strength) continue;
    Scene strong = sceneWithEverything();
    effect.strength->set(strong, effect.strength->highest);
    const Scene before = strong;
    effect.switchTo(strong, true);
    EXPECT_EQ(strong, before) << effect.key;
    Scene other = bareScene();
    effect.copy(strong, other);
    EXPECT_EQ(effect.strength->of(other), effect.strength->highest) << effect.key;
    effect.copy(bareScene(), other);
    EXPECT_EQ(other, bareScene()) << effect.key;
  }
}

TEST(EffectInfo, OffersNoStrengthThatAFileMayNotHold) {
  for (const EffectInfo& effect : sceneEffects()) {
    if (!effect.strength) continue;
    const EffectStrength& strength = *effect.strength;
    EXPECT_LT(strength.lowest, strength.highest);
    for (const double value : {strength.lowest, strength.highest}) {
      Scene scene = sceneWithEverything();
      strength.set(scene, value);
      EXPECT_EQ(strength.of(scene), value) << effect.key;
      EXPECT_EQ(limited(scene), scene) << effect.key << " at " << value;
    }
    const double usual = strength.of(sceneWithEverything());
    EXPECT_TRUE(strength.lowest <= usual && usual <= strength.highest) << effect.key;
    Scene without = bareScene();
    strength.set(without, usual);
    EXPECT_EQ(without, bareScene()) << effect.key;
  }
}

TEST(EffectInfo, SwitchesAPartOfAnEffectOnlyWhileTheEffectIsOn) {
  int parts = 0;
  for (const EffectInfo& effect : sceneEffects()) {
    if (!effect.option) continue;
    ++parts;
    Scene scene = sceneWithEverything();
    for (const bool on : {false, true, false}) {
      effect.option->switchTo(scene, on);
      EXPECT_EQ(effect.option->isOn(scene), on);
      EXPECT_TRUE(effect.isOn(scene));
    }
    scene = bareScene();
    effect.option->switchTo(scene, true);
    EXPECT_FALSE(effect.option->isOn(scene));
    EXPECT_EQ(scene, bareScene());
  }
  EXPECT_EQ(parts, 1);  // the mirror images of reverberation
}

TEST(EffectInfo, GivesNoKeyStrokeTwiceAndLeavesNoTextEmpty) {
  std::set<std::string> strokes;
  const auto check = [&](const auto& texts) {
    const bool isNew = *texts.keyStroke == '\0' || strokes.insert(texts.keyStroke).second;
    EXPECT_TRUE(isNew) << texts.keyStroke;
    for (const std::string text : {texts.key, texts.name, texts.shortName, texts.tip}) {
      EXPECT_FALSE(text.empty()) << texts.key;
      EXPECT_FALSE(text.ends_with('.')) << text;
    }
  };
  for (const EffectInfo& effect : sceneEffects()) {
    check(effect);
    if (effect.option) check(*effect.option);
    const std::string pattern = effect.strength ? effect.strength->pattern : "%1";
    EXPECT_NE(pattern.find("%1"), std::string::npos) << effect.key;
  }
}

}  // namespace
}  // namespace ew::effect_info_test
