#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/imaging/probe.h"
#include "places.h"

namespace ew::probe_schema_test {
namespace {

using nlohmann::json;

const std::filesystem::path kResources = std::filesystem::path(EW_SOURCE_DIR) / "resources";

class ProbeSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    const json document = json::parse(std::ifstream(kResources / "schemas" / "probe.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }
  bool accepts(const json& probe) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(probe), nullptr);
  }
  /// The reader, which draws the same line.
  static bool reads(const json& probe) {
    const auto file = std::filesystem::path(::testing::TempDir()) / "ew_probe_schema_test.json";
    std::ofstream(file) << probe;
    const bool good = readProbe(file).has_value();
    std::filesystem::remove(file);
    return good;
  }
  valijson::Schema schema_;
};

TEST_F(ProbeSchema, AcceptsEveryShippedProbeAndRefusesWhatTheReaderRefuses) {
  int probes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kResources / "probes")) {
    const json whole = json::parse(std::ifstream(entry.path()));
    ++probes;
    EXPECT_TRUE(accepts(whole)) << entry.path();
    for (const auto& item : whole.items()) {
      json part = whole;
      part.erase(item.key());
      EXPECT_EQ(accepts(part), reads(part)) << entry.path() << " without " << item.key();
    }
    // A face long enough for every aperture: that rule spans two fields, so the reader alone knows it.
    for (const auto& [field, value] : {std::pair{"width_mm", 40.0}, std::pair{"radius_mm", 60.0}, std::pair{"opening_deg", 80.0},
                                       std::pair{"max_steering_deg", 20.0}, std::pair{"trapezoid_deg", 20.0}, std::pair{"surprise", 1.0}}) {
      json more = whole;
      more[field] = value;
      EXPECT_EQ(accepts(more), reads(more)) << entry.path() << " with " << field;
    }
    for (const char* kind : {"linear", "convex", "phased", "endocavity", "swept_sector", "annular"}) {
      json other = whole;
      other["kind"] = kind;
      EXPECT_EQ(accepts(other), reads(other)) << entry.path() << " as " << kind;
    }
  }
  EXPECT_EQ(probes, 7);
}

}  // namespace
}  // namespace ew::probe_schema_test
