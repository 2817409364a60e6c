#include "ew/controls/keys_file.h"
#include "places.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace ew::controls {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

KeysAndControls some() {
  return {{{"freeze", {"F13", "Ctrl+Space"}}, {"flip", {}}},
          {{{"nanoKONTROL2", ControlKind::midiControl, 1, 16}, Encoding::absolute, {Target::Kind::setting, "gain"}, false},
           {{"Shuttle", ControlKind::hidByte, 0, 1}, Encoding::counter, {Target::Kind::setting, "probe.tilt"}, true},
           {{"Shuttle", ControlKind::hidBit, 0, 36}, Encoding::button, {Target::Kind::action, "freeze"}, false}}};
}

Result<KeysAndControls> read(const json& document) { return keysFromJson(document, verbatim("k.json")); }

TEST(KeysFile, ComesBackAsItWasWritten) {
  const auto back = read(toJson(some()));
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(*back, some());
  const fs::path file = fs::path(::testing::TempDir()) / "ew_keys.json";
  ASSERT_TRUE(writeKeys(some(), file));
  const auto again = readKeys(file);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, some());
  EXPECT_EQ(read({{"format", 1}}).value(), KeysAndControls{});
}

TEST(KeysFile, SaysWhichFieldCannotBeUsed) {
  const auto refused = [](const std::function<void(json&)>& spoil) {
    json document = toJson(some());
    spoil(document);
    const auto result = read(document);
    return result ? std::string() : result.error().sentence();
  };
  EXPECT_EQ(refused([](json&) {}), "");
  EXPECT_NE(refused([](json& d) { d["controls"][0]["kind"] = "wheel"; }).find("controls[0].kind"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["controls"][0]["number"] = 128; }).find("controls[0].number"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["controls"][0]["encoding"] = "counter"; }).find("controls[0].encoding"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["controls"][2]["encoding"] = "absolute"; }).find("controls[2].encoding"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["controls"][0]["action"] = "freeze"; }).find("controls[0].setting"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["keys"]["freeze"] = "F13"; }).find("freeze"), std::string::npos);
  EXPECT_NE(refused([](json& d) { d["mouse"] = 1; }).find("mouse"), std::string::npos);
  json newer = toJson(some());
  newer["format"] = 2;
  EXPECT_EQ(read(newer).error().code, ErrorCode::newerFormat);
}

TEST(KeysFile, ItsSchemaNamesTheSameFields) {
  const json schema = json::parse(std::ifstream(fs::path(EW_SOURCE_DIR) / "resources" / "schemas" / "keys.schema.json"));
  const json document = toJson(some());
  for (const auto& [key, unused] : document.items()) EXPECT_TRUE(schema["properties"].contains(key)) << key;
  EXPECT_EQ(schema["properties"].size(), document.size() + 1);  // and "note"
  const json& control = schema["properties"]["controls"]["items"]["properties"];
  for (const json& each : document["controls"])
    for (const auto& [key, unused] : each.items()) EXPECT_TRUE(control.contains(key)) << key;
  for (const auto& [field, good] : {std::pair{"kind", ControlKind::hidBit}, std::pair{"kind", ControlKind::midiBend}}) {
    KeysAndControls one = some();
    one.controls = {{{"d", good, 1, 0}, Encoding::button, {Target::Kind::action, "freeze"}, false}};
    const json word = toJson(one)["controls"][0][field];
    EXPECT_NE(std::find(control[field]["enum"].begin(), control[field]["enum"].end(), word), control[field]["enum"].end()) << word;
  }
}

TEST(KeysFile, SaysWhatIsWrongWithAFileThatIsNone) {
  const fs::path file = fs::path(::testing::TempDir()) / "ew_broken_keys.json";
  std::ofstream(file) << "{ \"format\": 1, \"keys\": ";
  EXPECT_EQ(readKeys(file).error().code, ErrorCode::badHeader);
  EXPECT_EQ(readKeys(file.string() + ".none").error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::controls
