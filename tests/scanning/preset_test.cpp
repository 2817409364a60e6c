#include "ew/scanning/preset.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/io/safe_file.h"
#include "places.h"

namespace ew::preset_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kResources = fs::path(EW_SOURCE_DIR) / "resources";

std::vector<Probe> probes() { return readProbes(kResources / "probes").value(); }

std::vector<Preset> shipped() {
  auto presets = readPresets(kResources / "presets");
  EXPECT_TRUE(presets) << presets.error();
  return presets ? std::move(*presets) : std::vector<Preset>{};
}

class OwnFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string made = (fs::temp_directory_path() / "ew-presets-XXXXXX").string();
    ASSERT_NE(mkdtemp(made.data()), nullptr);
    folder_ = made;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

Preset deepAbdomen() {
  Knobs knobs;
  knobs.depth_mm = 200.0;
  knobs.focus_mm = 60.0;
  knobs.moreFoci_mm = {110.0, 0.0, 0.0};
  knobs.gain_db = 4.0;
  knobs.tgc_db = {0, 0, 1, 2, 3, 4, 5, 6};
  knobs.carrier_hz = 2.5e6;
  knobs.persistence = 0.3;
  knobs.steering_rad = 0.0;
  Preset preset = presetOf("Abdomen, deep", probes().front(), knobs);
  preset.id = "abdomen-deep";
  preset.source = "for large patients";
  return preset;
}

TEST(Presets, OfTheProgramFitTheirProbesAndNameWhatThereIs) {
  const auto presets = shipped();
  std::set<std::string> covered, titles;
  for (const Preset& preset : presets) {
    const auto fits = checkPreset(preset, probes());
    EXPECT_TRUE(fits) << fits.error();
    covered.insert(preset.probe);
    EXPECT_TRUE(titles.insert(preset.probe + preset.title.english).second) << preset.id;
    EXPECT_TRUE(preset.id.ends_with("-" + preset.probe)) << preset.id;
    EXPECT_FALSE(preset.source.empty()) << preset.id;
    EXPECT_NE(preset.knobs.greyMap, GreyMap::clinical) << preset.id << ": a recording went through that curve already";
    for (const auto& [folder, id] : {std::pair{"annotations", preset.annotations}, std::pair{"body_marks", preset.bodyMark},
                                     std::pair{"measurements", preset.measurements}})
      EXPECT_TRUE(id.empty() || fs::exists(kResources / folder / (id + ".json"))) << preset.id << ": " << folder << "/" << id;
  }
  for (const Probe& probe : probes()) EXPECT_TRUE(covered.contains(probe.id)) << probe.id;
}

TEST(Presets, PutTheTargetIntoTheImageAndTheFocusIntoItsLowerHalf) {
  for (const Preset& preset : shipped()) {
    EXPECT_GT(preset.knobs.depth_mm, 0.0) << preset.id;
    EXPECT_GE(preset.knobs.focus_mm, 0.45 * preset.knobs.depth_mm) << preset.id;
    EXPECT_LE(preset.knobs.focus_mm, 0.75 * preset.knobs.depth_mm) << preset.id;
  }
}

TEST(Presets, LeaveTheQualityOfTheMachineAsItIs) {
  Knobs present;
  present.quality = Quality::cubic;
  present.gain_db = -7.0;
  const Knobs set = applied(deepAbdomen(), present);
  EXPECT_EQ(set.quality, Quality::cubic);
  EXPECT_EQ(set.gain_db, 4.0);
  EXPECT_EQ(set.depth_mm, 200.0);
}

TEST(Presets, OfTheConsoleKeepOutOfItWhatBelongsToTheMoment) {
  Knobs knobs;
  knobs.quality = Quality::weave;
  knobs.zoom = 3.0;
  knobs.mode = DisplayMode::both;
  knobs.mLine = 0.4;
  knobs.mSweep_s = 9.0;
  knobs.depth_mm = 75.0;
  knobs.markerLeft = false;
  const Preset preset = presetOf("Mine", probes().front(), knobs);
  Knobs expected;
  expected.depth_mm = 75.0;
  expected.markerLeft = false;
  EXPECT_EQ(preset.knobs, expected);
  EXPECT_EQ(preset.title, (Words{"Mine", "Mine"}));
}

TEST(PresetJson, ComesBackAsItWas) {
  for (Preset preset : shipped()) {
    const auto back = presetFromJson(toJson(preset), preset.id, verbatim("p.json"));
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back, preset) << preset.id;
  }
  for (const GainLaw law : {GainLaw::automatic, GainLaw::decibel, GainLaw::paper}) {
    Preset preset = deepAbdomen();
    preset.knobs.gainLaw = law;
    const auto back = presetFromJson(toJson(preset), preset.id, verbatim("p.json"));
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back, preset);
  }
  EXPECT_FALSE(toJson(deepAbdomen())["knobs"].contains("edge_enhancement")) << "what is neutral is left out";
}

TEST(PresetJson, SaysWhatIsWrong) {
  const json whole = toJson(deepAbdomen());
  const auto sentence = [&](const json::json_pointer& at, const json& value) {
    json changed = whole;
    changed[at] = value;
    const auto read = presetFromJson(changed, "p", verbatim("p.json"));
    return read ? std::string("taken") : read.error().sentence();
  };
  EXPECT_EQ(sentence("/format"_json_pointer, 2), "p.json has format 2, this program reads up to 1; update EchoWeave.");
  EXPECT_NE(sentence("/knobs/depth_mm"_json_pointer, -1).find("'depth_mm' in the knobs of p.json is -1"), std::string::npos)
      << sentence("/knobs/depth_mm"_json_pointer, -1);
  EXPECT_EQ(sentence("/knobs/quality"_json_pointer, "cubic"),
            "'knobs.quality' in p.json is \"cubic\"; it must be left out: how fast the machine is belongs to no examination.");
  EXPECT_EQ(sentence("/body_mark"_json_pointer, "../womb"),
            "'body_mark' in p.json is \"../womb\"; it must be small letters, digits, ., - and _.");
  EXPECT_NE(sentence("/surprise"_json_pointer, 1).find("surprise"), std::string::npos);
  EXPECT_NE(sentence("/knobs"_json_pointer, 7).find("'knobs' in p.json is 7"), std::string::npos);
}

TEST(PresetCheck, NamesWhatTheProbeCannotDo) {
  const auto sentence = [](const std::function<void(Preset&)>& change) {
    Preset preset;
    preset.id = "mine";
    preset.probe = "convex-3.5";
    change(preset);
    const auto fits = checkPreset(preset, probes());
    return fits ? std::string("fits") : fits.error().sentence();
  };
  EXPECT_EQ(sentence([](Preset&) {}), "fits");
  EXPECT_NE(sentence([](Preset& p) { p.probe = "convex-9"; }).find("the probe 'convex-9', which there is not; those there are: "),
            std::string::npos);
  EXPECT_EQ(sentence([](Preset& p) { p.knobs.depth_mm = 300.0; }),
            "'knobs.depth_mm' in the preset mine is 300; it must be a number from 60 to 240.");
  EXPECT_EQ(sentence([](Preset& p) { p.knobs.carrier_hz = 4e6; }),
            "'knobs.carrier_hz' in the preset mine is 4e+06; it must be 0 or one of the probe's frequencies, 2500000, 3500000, 5e+06.");
  EXPECT_EQ(sentence([](Preset& p) { p.knobs.moreFoci_mm[1] = 170.0; }),
            "'knobs.focus_mm' in the preset mine is 170; it must be at most the depth, 160 mm.");
  EXPECT_EQ(sentence([](Preset& p) { p.knobs.steering_rad = 0.1 * std::numbers::pi; }),
            "'knobs.steering_deg' in the preset mine is 18; it must be 0: the probe cannot steer.");
  EXPECT_EQ(sentence([](Preset& p) {
              p.probe = "linear-12";
              p.knobs.steering_rad = 20.0 / 180.0 * std::numbers::pi;
            }),
            "fits");
  EXPECT_EQ(sentence([](Preset& p) { p.knobs.trapezoid = true; }),
            "'knobs.trapezoid' in the preset mine is true; it must be false: the probe cannot fan out.");
}

TEST_F(OwnFolder, KeepsPresetsAsFilesThatCanBeHandedOn) {
  const fs::path mine = folder_ / "mine", colleagues = folder_ / "colleague's";
  EXPECT_TRUE(readOwnPresets(mine).presets.empty());
  EXPECT_TRUE(readOwnPresets(mine).problems.empty()) << "a folder that is not there holds nothing";
  const auto file = saveOwnPreset(deepAbdomen(), mine);
  ASSERT_TRUE(file) << file.error();
  EXPECT_EQ(file->filename(), "abdomen-deep-convex-3-5.json");
  fs::create_directories(colleagues);
  fs::copy(*file, colleagues);
  const OwnPresets handedOn = readOwnPresets(colleagues);
  ASSERT_EQ(handedOn.presets.size(), 1u);
  EXPECT_EQ(handedOn.presets[0].knobs, deepAbdomen().knobs);
  EXPECT_EQ(handedOn.presets[0].source, "for large patients");
}

TEST_F(OwnFolder, ReplacesThePresetOfThatNameAndNoOther) {
  Preset preset = deepAbdomen();
  const auto first = saveOwnPreset(preset, folder_);
  preset.knobs.depth_mm = 150.0;
  const auto second = saveOwnPreset(preset, folder_);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(*first, *second);
  EXPECT_EQ(readOwnPresets(folder_).presets.at(0).knobs.depth_mm, 150.0);
  // Another title that makes the same file name, and a file of somebody else that has it.
  preset.title = {"ABDOMEN - DEEP", "ABDOMEN - DEEP"};
  const auto third = saveOwnPreset(preset, folder_);
  ASSERT_TRUE(third);
  EXPECT_NE(*third, *first);
  std::ofstream(*third) << "something else";
  const auto fourth = saveOwnPreset(preset, folder_);
  ASSERT_TRUE(fourth);
  EXPECT_NE(*fourth, *third);
  EXPECT_EQ(readTextFile(*third).value(), "something else");
}

TEST_F(OwnFolder, ReadsTheOthersWhenOneIsDamaged) {
  Preset preset = deepAbdomen();
  ASSERT_TRUE(saveOwnPreset(preset, folder_));
  preset.title = {"Ältere", "Ältere"};
  const auto german = saveOwnPreset(preset, folder_);
  ASSERT_TRUE(german) << german.error();
  EXPECT_EQ(german->filename(), "c384ltere-convex-3-5.json");
  std::ofstream(folder_ / "broken.json") << "{";
  const OwnPresets own = readOwnPresets(folder_);
  EXPECT_EQ(own.presets.size(), 2u);
  ASSERT_EQ(own.problems.size(), 1u);
  EXPECT_NE(own.problems[0].sentence().find("broken.json"), std::string::npos);
}

TEST_F(OwnFolder, RefusesATitleWithoutALetter) {
  Preset preset = deepAbdomen();
  for (const std::string& title : {std::string(), std::string(" - ?"), std::string(81, 'x')}) {
    preset.title = {title, title};
    const auto saved = saveOwnPreset(preset, folder_);
    ASSERT_FALSE(saved) << title;
    EXPECT_EQ(saved.error().code, ErrorCode::badField);
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST(PresetSchema, AcceptsEveryShippedPresetAndRefusesWhatTheReaderRefuses) {
  const json text = json::parse(std::ifstream(kResources / "schemas" / "preset.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  const auto accepts = [&](const json& preset) {
    valijson::Validator validator;
    return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(preset), nullptr);
  };
  const auto reads = [](const json& preset) { return presetFromJson(preset, "x", verbatim("x.json")).has_value(); };
  int files = 0;
  for (const auto& entry : fs::directory_iterator(kResources / "presets")) {
    const json whole = json::parse(std::ifstream(entry.path()));
    EXPECT_TRUE(accepts(whole)) << entry.path();
    for (const auto& field : whole.items()) {
      json less = whole;
      less.erase(field.key());
      EXPECT_EQ(accepts(less), reads(less)) << entry.path() << " without " << field.key();
    }
    json more = whole;
    more["knobs"]["quality"] = "cubic";
    EXPECT_FALSE(accepts(more));
    EXPECT_FALSE(reads(more));
    ++files;
  }
  EXPECT_GE(files, 15);
}

}  // namespace
}  // namespace ew::preset_test
