#include <gtest/gtest.h>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "measurement/packages.h"
#include "places.h"

namespace ew::measurement::package_schema_test {
namespace {

using nlohmann::json;

class PackageSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    const json text =
        json::parse(std::ifstream(std::filesystem::path(EW_SOURCE_DIR) / "resources" / "schemas" / "measurement.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
  }
  bool accepts(const json& package) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(package), nullptr);
  }
  static bool reads(const json& package) { return packageFromJson(package, "x", verbatim("x.json")).has_value(); }
  valijson::Schema schema_;
};

TEST_F(PackageSchema, AcceptsEveryShippedPackageAndRefusesWhatTheReaderRefuses) {
  for (const char* id : {"abdomen", "bladder", "fetal_doppler", "obstetric", "thyroid", "trauma", "vascular", "vessel"}) {
    const json whole = test::document(id);
    EXPECT_TRUE(accepts(whole)) << id;
    EXPECT_TRUE(reads(whole)) << id;
    for (const char* field : {"format", "version", "title", "source", "items", "worksheet"}) {
      json part = whole;
      part.erase(field);
      EXPECT_FALSE(accepts(part)) << id << " without " << field;
      EXPECT_FALSE(reads(part)) << id << " without " << field;
    }
    // Of the first entry of each list, every field there is, left out: items that formulas use stay, so that only the field is missed.
    for (const char* list : {"items", "formulas", "charts", "ranges", "summaries", "worksheet"}) {
      if (!whole.contains(list)) continue;
      for (const auto& field : whole[list][0].items()) {
        json part = whole;
        part[list][0].erase(field.key());
        EXPECT_EQ(accepts(part), reads(part)) << id << ": " << list << "[0] without " << field.key();
      }
      json more = whole;
      more[list][0]["surprise"] = 1;
      EXPECT_FALSE(accepts(more)) << id << ": " << list;
      EXPECT_FALSE(reads(more)) << id << ": " << list;
    }
  }
}

}  // namespace
}  // namespace ew::measurement::package_schema_test
