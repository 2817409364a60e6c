#include "ew/imaging/probe.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

namespace ew {
namespace {

using nlohmann::json;

const std::filesystem::path kShipped = std::filesystem::path(EW_SOURCE_DIR) / "resources" / "probes";

class ProbeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("ew_probe_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Result<Probe> read(const std::string& text) {
    std::ofstream(folder_ / "probe.json") << text;
    return readProbe(folder_ / "probe.json");
  }
  static json shipped(const char* name) { return json::parse(std::ifstream(kShipped / name)); }

  std::filesystem::path folder_;
};

TEST_F(ProbeFile, OfEveryShippedProbeIsReadAndPlausible) {
  const auto probes = readProbes(kShipped);
  ASSERT_TRUE(probes) << probes.error();
  ASSERT_EQ(probes->size(), 4U);
  EXPECT_EQ(probes->front().name, "Convex 3.5 MHz Abdomen");
  EXPECT_EQ(probes->front().id, "convex-3.5");
  EXPECT_NEAR(probes->front().halfAngle_rad, 31.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_GE(probes->front().maxDepth_mm, 240.0);
  for (const Probe& probe : *probes) {
    EXPECT_LE(probe.minDepth_mm, probe.defaultDepth_mm);
    EXPECT_LE(probe.defaultDepth_mm, probe.maxDepth_mm);
    EXPECT_EQ(probe.kind == ProbeKind::convex, probe.radius_mm > 0.0);
  }
}

TEST_F(ProbeFile, ThatLacksAFieldIsRefusedWithTheFieldsName) {
  for (const char* name : {"convex-3.5.json", "linear-7.5.json"}) {
    const json whole = shipped(name);
    for (const auto& item : whole.items()) {
      json part = whole;
      part.erase(item.key());
      const auto read = this->read(part.dump());
      ASSERT_FALSE(read) << item.key();
      EXPECT_EQ(read.error().code, ErrorCode::badField);
      EXPECT_NE(read.error().sentence.find(item.key()), std::string::npos) << read.error();
    }
  }
}

TEST_F(ProbeFile, ThatHasAnImpossibleValueIsRefused) {
  const json whole = shipped("convex-3.5.json");
  const std::pair<const char*, json> wrong[] = {
      {"radius_mm", -3},    {"opening_deg", 190}, {"lines", 12.5},          {"lines", "many"}, {"carrier_hz", 0}, {"default_depth_mm", 500},
      {"max_depth_mm", 10}, {"name", ""},         {"kind", "phased-array"}, {"width_mm", 40},  {"depht_mm", 3},   {"radius_mm", nullptr}};
  for (const auto& [field, value] : wrong) {
    json changed = whole;
    changed[field] = value;
    const auto read = this->read(changed.dump());
    ASSERT_FALSE(read) << field;
    EXPECT_EQ(read.error().code, ErrorCode::badField) << read.error();
  }
}

TEST_F(ProbeFile, OfANewerFormatSaysSo) {
  json newer = shipped("linear-12.json");
  newer["format"] = 2;
  newer["surprise"] = true;
  const auto read = this->read(newer.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::newerFormat);
}

TEST_F(ProbeFile, ThatIsNotJsonOrNotThereOrHugeIsRefused) {
  EXPECT_EQ(read("{ \"name\": ").error().code, ErrorCode::badHeader);
  EXPECT_EQ(read("[1, 2]").error().code, ErrorCode::badHeader);
  EXPECT_EQ(read("").error().code, ErrorCode::badHeader);
  EXPECT_EQ(read("{\"name\": " + std::string(400000, '[') + std::string(400000, ']') + "}").error().code, ErrorCode::badHeader);
  EXPECT_EQ(read(std::string(2 << 20, ' ')).error().code, ErrorCode::badHeader);
  EXPECT_EQ(readProbe(folder_ / "none.json").error().code, ErrorCode::notFound);
  EXPECT_EQ(readProbes(folder_ / "none").error().code, ErrorCode::notFound);
}

TEST_F(ProbeFile, ThatIsBrokenMakesTheWholeFolderAnError) {
  std::filesystem::copy(kShipped / "linear-12.json", folder_ / "a.json");
  EXPECT_EQ(readProbes(folder_)->size(), 1U);
  std::ofstream(folder_ / "b.json") << "{}";
  EXPECT_FALSE(readProbes(folder_));
}

TEST_F(ProbeFile, SchemaNamesTheSameFieldsAsTheReader) {
  const json schema = json::parse(std::ifstream(std::filesystem::path(EW_SOURCE_DIR) / "resources" / "schemas" / "probe.schema.json"));
  for (const char* name : {"convex-3.5.json", "linear-7.5.json", "linear-12.json", "microconvex-6.json"}) {
    const json whole = shipped(name);
    for (const auto& item : whole.items()) {
      const auto property = schema["properties"].find(item.key());
      ASSERT_NE(property, schema["properties"].end()) << item.key();
      if (!property->contains("minimum") || item.key() == "format") continue;
      // The reader draws its line where the schema draws it.
      json changed = whole;
      changed[item.key()] = (*property)["minimum"].get<double>() * 0.99 - 1e-9;
      EXPECT_FALSE(read(changed.dump())) << item.key();
      changed[item.key()] = (*property)["maximum"].get<double>() * 1.01;
      EXPECT_FALSE(read(changed.dump())) << item.key();
    }
  }
}

}  // namespace
}  // namespace ew
