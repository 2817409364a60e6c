#include "ew/imaging/probe.h"
#include "places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

namespace ew::probe_test {
namespace {

using nlohmann::json;

const std::filesystem::path kShipped = std::filesystem::path(EW_SOURCE_DIR) / "resources" / "probes";

const std::set<std::string> kOptional = {
    "carriers_hz", "aperture_mm", "max_steering_deg", "trapezoid_deg", "elevational_focus_mm", "elevational_aperture_mm", "near_field_mm"};

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
  ASSERT_EQ(probes->size(), 7U);
  EXPECT_EQ(probes->front().name, "Convex 3.5 MHz Abdomen");
  EXPECT_EQ(probes->front().id, "convex-3.5");
  EXPECT_NEAR(probes->front().halfAngle_rad, 31.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_GE(probes->front().maxDepth_mm, 240.0);
  for (const Probe& probe : *probes) {
    EXPECT_LE(probe.minDepth_mm, probe.defaultDepth_mm);
    EXPECT_LE(probe.defaultDepth_mm, probe.maxDepth_mm);
    EXPECT_EQ(isSector(probe.kind) && probe.kind != ProbeKind::phased, probe.radius_mm > 0.0);
    EXPECT_EQ(isSector(probe.kind), probe.halfAngle_rad > 0.0);
    EXPECT_LE(probe.aperture_mm, probe.width_mm);
    EXPECT_NE(std::find(probe.carriers_hz.begin(), probe.carriers_hz.end(), probe.carrier_hz), probe.carriers_hz.end());
    // The lens makes the slice thickness that the file states: wavelength * focus / aperture, within a quarter.
    const double focused_mm = 1.54e6 / probe.carrier_hz * probe.elevationalFocus_mm / probe.elevationalAperture_mm;
    EXPECT_NEAR(focused_mm / probe.elevationalThickness_mm, 1.0, 0.25) << probe.id;
  }
}

TEST_F(ProbeFile, OfEveryKindIsShipped) {
  std::set<ProbeKind> kinds;
  const auto probes = readProbes(kShipped);
  for (const Probe& probe : *probes) kinds.insert(probe.kind);
  EXPECT_EQ(kinds.size(), 5U);
}

TEST_F(ProbeFile, FromBeforeTheNewFieldsIsReadWithUsualValues) {
  json older = shipped("convex-3.5.json");
  for (const char* field : {"carriers_hz", "aperture_mm", "elevational_focus_mm", "elevational_aperture_mm", "near_field_mm"})
    older.erase(field);
  const auto probe = read(older.dump());
  ASSERT_TRUE(probe) << probe.error();
  EXPECT_TRUE(probe->carriers_hz.empty());
  EXPECT_NEAR(probe->aperture_mm, 0.4 * probe->width_mm, 1e-12);
  EXPECT_EQ(probe->elevationalFocus_mm, 80.0);
  EXPECT_NEAR(probe->elevationalAperture_mm, 1.54 / 3.5 * 80.0 / 3.0, 1e-12);
  EXPECT_EQ(probe->nearField_mm, 2.0);
  older = shipped("linear-12.json");
  older.erase("max_steering_deg");
  older.erase("trapezoid_deg");
  EXPECT_EQ(read(older.dump())->maxSteering_rad, 0.0);
  EXPECT_EQ(read(older.dump())->trapezoidHalfAngle_rad, 0.0);
}

TEST_F(ProbeFile, WithAFieldOfAnotherKindIsRefusedWithASentenceThatNamesBoth) {
  for (const auto& [file, field] : {std::pair{"linear-12.json", "radius_mm"}, std::pair{"linear-12.json", "opening_deg"},
                                    std::pair{"phased-2.5.json", "radius_mm"}, std::pair{"phased-2.5.json", "max_steering_deg"},
                                    std::pair{"endocavity-6.5.json", "width_mm"}, std::pair{"swept-sector-3.5.json", "trapezoid_deg"}}) {
    json changed = shipped(file);
    changed[field] = 12.0;
    const auto read = this->read(changed.dump());
    ASSERT_FALSE(read) << field;
    EXPECT_EQ(read.error().code, ErrorCode::badField);
    EXPECT_NE(read.error().sentence().find(field), std::string::npos);
    EXPECT_NE(read.error().sentence().find(changed["kind"].get<std::string>()), std::string::npos) << read.error();
  }
}

TEST_F(ProbeFile, WithFrequenciesThatDoNotRiseOrMissTheFirstIsRefused) {
  const json whole = shipped("convex-3.5.json");
  for (const json& wrong : {json(3.5e6), json::array(), json{3.5e6, 2.5e6}, json{3.5e6, 3.5e6}, json{2.5e6, 5e6}, json{3.5e6, "5e6"},
                            json{3.5e6, 2e8}, json{1e6, 2e6, 3e6, 3.5e6, 4e6, 5e6, 6e6, 7e6, 8e6}}) {
    json changed = whole;
    changed["carriers_hz"] = wrong;
    const auto read = this->read(changed.dump());
    ASSERT_FALSE(read) << wrong;
    EXPECT_NE(read.error().sentence().find("rising"), std::string::npos) << read.error();
  }
}

TEST(ProbeFace, HasTheSameEndsInEveryDescription) {
  const auto probes = readProbes(kShipped);
  ASSERT_TRUE(probes) << probes.error();
  for (const Probe& probe : *probes) {
    const auto points = facePoints_mm(probe, 9);
    ASSERT_EQ(points.size(), 9U);
    EXPECT_EQ(points[4], glm::dvec3(0.0)) << probe.id;
    EXPECT_NEAR(points.back().x, faceHalfWidth_mm(probe), 1e-12);
    EXPECT_NEAR(points.back().y, -faceSagitta_mm(probe), 1e-12);
    for (std::size_t n = 0; n < 9; ++n) EXPECT_EQ(points[n], glm::dvec3(-points[8 - n].x, points[8 - n].y, 0.0));
  }
}

TEST_F(ProbeFile, ThatLacksAFieldIsRefusedWithTheFieldsName) {
  for (const char* name : {"convex-3.5.json", "linear-7.5.json", "phased-2.5.json", "endocavity-6.5.json", "swept-sector-3.5.json"}) {
    const json whole = shipped(name);
    for (const auto& item : whole.items()) {
      if (kOptional.contains(item.key())) continue;
      json part = whole;
      part.erase(item.key());
      const auto read = this->read(part.dump());
      ASSERT_FALSE(read) << item.key();
      EXPECT_EQ(read.error().code, ErrorCode::badField);
      EXPECT_NE(read.error().sentence().find(item.key()), std::string::npos) << read.error();
    }
  }
}

TEST_F(ProbeFile, ThatHasAnImpossibleValueIsRefused) {
  const json whole = shipped("convex-3.5.json");
  const std::pair<const char*, json> wrong[] = {
      {"radius_mm", -3},  {"opening_deg", 190},      {"lines", 12.5},      {"lines", "many"},
      {"carrier_hz", 0},  {"default_depth_mm", 500}, {"max_depth_mm", 10}, {"name", ""},
      {"kind", "phased"}, {"kind", "annular"},       {"kind", 3},          {"width_mm", 40},
      {"depht_mm", 3},    {"radius_mm", nullptr},    {"aperture_mm", 300}, {"near_field_mm", "2"}};
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
  for (const char* name : {"convex-3.5.json", "linear-7.5.json", "linear-12.json", "microconvex-6.json", "phased-2.5.json",
                           "endocavity-6.5.json", "swept-sector-3.5.json"}) {
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
}  // namespace ew::probe_test
