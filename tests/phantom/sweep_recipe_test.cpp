#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/phantom/virtual_sweep.h"
#include "places.h"
#include "recipes.h"

namespace ew::sweep_recipe_test {
namespace {

using nlohmann::json;
using testing::Folder;

json freehand() {
  return json::parse(R"({"format": 1, "name": "a sweep", "probe": "convex-3.5", "kind": "freehand",
    "stations": [{"near_mm": [0, -60, 0]}, {"near_mm": [10, -60, 0], "lateral": [0, 0, 1], "towards_mm": [0, 0, 0]}]})");
}

json everything() {
  json sweep = freehand();
  sweep["note"] = "all fields of a hand";
  sweep["frames"] = 7;
  sweep["frames_per_second"] = 12.5;
  sweep["machine"] = json::parse(R"({"depth_mm": 100, "focus_mm": 40, "carrier_hz": 5e6, "pulse_cycles": 3, "assumed_speed_m_per_s": 1500,
    "attenuation": false, "penumbra": false, "specular": false, "speed_of_sound": true, "noise_db": -50, "dynamic_range_db": 70, "gain_db": 3,
    "tgc": [{"depth_mm": 0, "gain_db": 1}, {"depth_mm": 50, "gain_db": 10}], "expected_db_per_cm_mhz": 0.7, "largest_tgc_db": 40,
    "noise_seed": 9})");
  sweep["unevenness"] = 0.5;
  sweep["hand_seed"] = 3;
  sweep["indentation_mm"] = 2;
  for (const char* name : {"breathing", "pulsating", "ecg", "respiration", "scan_lines"}) sweep[name] = true;
  sweep["tracker"] = json::parse(R"({"noise_mm": 0.1, "noise_deg": 0.2, "jitter_s": 0.003, "latency_s": 0.05, "drop_out_share": 0.1,
    "calibration_error": {"shift_mm": [1, 2, 3], "turn_deg": [0, 90, 0]}, "seed": 5})");
  sweep["pixel_mm"] = 0.5;
  sweep["seed"] = 11;
  return sweep;
}

json motor(const std::string& kind) {
  json sweep = freehand();
  sweep["kind"] = kind;
  sweep["stations"].erase(1);
  if (kind == "parallel") sweep["extent_mm"] = 40;
  if (kind != "parallel") sweep["extent_deg"] = 60;
  if (kind == "fan") sweep["axis_behind_face_mm"] = 12;
  return sweep;
}

Result<SweepRecipe> read(const json& sweep) {
  const Folder folder;
  return readSweepRecipe(folder.write("sweep.json", sweep.dump()));
}

TEST(SweepRecipe, HoldsEveryFieldOfItsFile) {
  const auto recipe = read(everything());
  ASSERT_TRUE(recipe) << recipe.error();
  SweepRecipe expected;
  expected.name = "a sweep";
  expected.probe = "convex-3.5";
  expected.frames = 7;
  expected.framesPerSecond = 12.5;
  expected.formation = {.depth_mm = 100,
                        .focus_mm = 40,
                        .carrier_hz = 5e6,
                        .pulseCycles = 3,
                        .assumedSpeed_mPerS = 1500,
                        .attenuation = false,
                        .penumbra = false,
                        .specular = false,
                        .speedOfSound = true,
                        .noise_db = -50,
                        .dynamicRange_db = 70,
                        .gain_db = 3,
                        .tgc = {{0, 1}, {50, 10}},
                        .expected_dbPerCmMhz = 0.7,
                        .largestTgc_db = 40,
                        .noiseSeed = 9};
  expected.stations = {{.near_mm = {0, -60, 0}}, {.near_mm = {10, -60, 0}, .lateral = {0, 0, 1}, .towards_mm = glm::dvec3(0)}};
  expected.unevenness = 0.5;
  expected.handSeed = 3;
  expected.indentation_mm = 2;
  expected.breathing = expected.pulsating = expected.ecg = expected.respiration = expected.scanLines = true;
  expected.tracker = {.noise_mm = 0.1, .noise_deg = 0.2, .jitter_s = 0.003, .latency_s = 0.05, .dropOutShare = 0.1, .seed = 5};
  expected.tracker.calibrationError = recipe->tracker.calibrationError;
  expected.pixel_mm = 0.5;
  expected.seed = 11;
  EXPECT_EQ(*recipe, expected);
  // A quarter turn about y takes x to -z, then the shift.
  const glm::dvec4 moved = recipe->tracker.calibrationError * glm::dvec4(1, 0, 0, 1);
  EXPECT_NEAR(glm::distance(moved, glm::dvec4(1, 2, 2, 1)), 0.0, 1e-12);
}

TEST(SweepRecipe, ReadsEveryKindOfMotor) {
  for (const auto& [kind, expected] :
       {std::pair{"parallel", SweepKind::parallel}, {"fan", SweepKind::fan}, {"rotational", SweepKind::rotational}}) {
    const auto recipe = read(motor(kind));
    ASSERT_TRUE(recipe) << recipe.error();
    EXPECT_EQ(recipe->kind, expected);
  }
}

TEST(SweepRecipe, NamesTheFieldThatCannotBeUsed) {
  const auto refusal = [](json sweep, const std::string& pointer, const json& value) {
    if (value.is_discarded()) {
      sweep.at(json::json_pointer(json::json_pointer(pointer).parent_pointer().to_string())).erase(json::json_pointer(pointer).back());
    } else {
      sweep[json::json_pointer(pointer)] = value;
    }
    const auto recipe = read(sweep);
    if (recipe) return std::string("was read");
    EXPECT_EQ(recipe.error().code, ErrorCode::badField);
    for (const auto& [name, text] : recipe.error().context)
      if (name == "field") return text;
    return std::string("no field named");
  };
  const json gone = json(json::value_t::discarded);
  EXPECT_EQ(refusal(everything(), "/probe", gone), "probe");
  EXPECT_EQ(refusal(everything(), "/probe", "../secret"), "probe");
  EXPECT_EQ(refusal(everything(), "/kind", "circular"), "kind");
  EXPECT_EQ(refusal(everything(), "/frames", 0), "frames");
  EXPECT_EQ(refusal(everything(), "/frames", 2.5), "frames");
  EXPECT_EQ(refusal(everything(), "/frames_per_second", -1), "frames_per_second");
  EXPECT_EQ(refusal(everything(), "/machine/pulse_cycles", 0.1), "machine.pulse_cycles");
  EXPECT_EQ(refusal(everything(), "/machine/tgc/1/depth_mm", 0), "machine.tgc[1].depth_mm");
  EXPECT_EQ(refusal(everything(), "/machine/colour", 1), "machine.colour");
  EXPECT_EQ(refusal(everything(), "/stations", json::array()), "stations");
  EXPECT_EQ(refusal(everything(), "/stations/0/near_mm", json({1, 2})), "stations[0].near_mm");
  EXPECT_EQ(refusal(everything(), "/stations/1/lateral", json({0, 0, 0})), "stations[1].lateral");
  EXPECT_EQ(refusal(everything(), "/extent_mm", 10), "extent_mm");
  EXPECT_EQ(refusal(everything(), "/tracker/drop_out_share", 1.5), "tracker.drop_out_share");
  EXPECT_EQ(refusal(everything(), "/tracker/calibration_error/scale", 2), "tracker.calibration_error.scale");
  EXPECT_EQ(refusal(everything(), "/seed", -1), "seed");
  EXPECT_EQ(refusal(everything(), "/on_skin", false), "stations[0].towards_mm");
  EXPECT_EQ(refusal(everything(), "/surprise", 1), "surprise");
  EXPECT_EQ(refusal(motor("parallel"), "/extent_mm", 0), "extent_mm");
  EXPECT_EQ(refusal(motor("parallel"), "/extent_mm", gone), "extent_mm");
  EXPECT_EQ(refusal(motor("fan"), "/extent_deg", 171), "extent_deg");
  EXPECT_EQ(refusal(motor("rotational"), "/axis_behind_face_mm", 10), "axis_behind_face_mm");
  EXPECT_EQ(refusal(motor("rotational"), "/stations/1", json({{"near_mm", {0, 0, 0}}})), "stations");
}

TEST(SweepRecipe, RefusesWhatIsNoSweepFile) {
  const Folder folder;
  EXPECT_EQ(readSweepRecipe(folder.path() / "none.json").error().code, ErrorCode::notFound);
  EXPECT_EQ(readSweepRecipe(folder.write("a.json", "{")).error().code, ErrorCode::badHeader);
  EXPECT_EQ(readSweepRecipe(folder.write("b.json", "[1]")).error().code, ErrorCode::badHeader);
  EXPECT_EQ(readSweepRecipe(folder.write("c.json", R"({"format": 2})")).error().code, ErrorCode::newerFormat);
}

class SweepSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    const json document = json::parse(std::ifstream(std::string(EW_SOURCE_DIR) + "/resources/schemas/sweep.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }
  bool accepts(const json& sweep) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(sweep), nullptr);
  }
  valijson::Schema schema_;
};

/// A sweep with one value somewhere in it replaced, and with it left out.
void eachChange(const json& whole, const json::json_pointer& at, const std::function<void(const json&, const std::string&)>& look) {
  const json& here = whole.at(at);
  if (here.is_object() || here.is_array()) {
    for (const auto& item : here.items()) {
      const auto place = here.is_array() ? at / static_cast<std::size_t>(std::stoul(item.key())) : at / item.key();
      json part = whole;
      if (here.is_array()) {
        part.at(at).erase(static_cast<std::size_t>(std::stoul(item.key())));
      } else {
        part.at(at).erase(item.key());
      }
      look(part, "without " + place.to_string());
      eachChange(whole, place, look);
    }
  }
  for (const json& value : {json(-1), json(0), json(10000000), json("text"), json(true), json::array(), json::object(), json()}) {
    json other = whole;
    other[at] = value;
    look(other, at.to_string() + " = " + value.dump());
  }
}

TEST_F(SweepSchema, DrawsTheSameLineAsTheReader) {
  json rising = everything();
  rising["machine"].erase("tgc");  // rising depths are beyond a schema
  int changes = 0, refused = 0;
  for (const json& whole : {rising, motor("parallel"), motor("fan"), motor("rotational")}) {
    ASSERT_TRUE(accepts(whole)) << whole.dump();
    ASSERT_TRUE(read(whole)) << whole.dump();
    eachChange(whole, json::json_pointer(), [&](const json& changed, const std::string& what) {
      if (what.find("lateral") != std::string::npos) return;  // that it must not vanish is beyond a schema
      const bool good = read(changed).has_value();
      EXPECT_EQ(accepts(changed), good) << what << " of " << whole.dump();
      ++changes;
      refused += good ? 0 : 1;
    });
  }
  EXPECT_GT(changes, 500);
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace ew::sweep_recipe_test
