#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/measurement/criteria.h"
#include "places.h"

namespace ew::measurement::criteria_schema_test {
namespace {

using nlohmann::json;

const std::filesystem::path kResources = std::filesystem::path(EW_SOURCE_DIR) / "resources";

class CriteriaSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    const json text = json::parse(std::ifstream(kResources / "schemas" / "criteria.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
  }
  bool accepts(const json& criteria) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(criteria), nullptr);
  }
  static bool reads(const json& criteria) { return criteriaFromJson(criteria, "x", verbatim("x.json")).has_value(); }
  valijson::Schema schema_;
};

TEST_F(CriteriaSchema, AcceptsEveryShippedFileAndRefusesWhatTheReaderRefuses) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kResources / "criteria")) {
    ++files;
    const json whole = json::parse(std::ifstream(entry.path()));
    EXPECT_TRUE(accepts(whole)) << entry.path();
    EXPECT_TRUE(reads(whole)) << entry.path();
    for (const char* field : {"format", "version", "name", "vessel", "vessel_title", "source", "status", "inputs", "grades", "tests"}) {
      json part = whole;
      part.erase(field);
      EXPECT_FALSE(accepts(part)) << entry.path() << " without " << field;
      EXPECT_FALSE(reads(part)) << entry.path() << " without " << field;
    }
    for (const char* list : {"inputs", "formulas", "grades"}) {
      if (!whole.contains(list)) continue;
      for (const char* field : {"name", "word", "title", "role", "unit", "valid", "expression", "tests", "when"}) {
        if (!whole[list][0].contains(field)) continue;
        json part = whole;
        part[list][0].erase(field);
        EXPECT_FALSE(accepts(part)) << entry.path() << ": " << list << "[0] without " << field;
        EXPECT_FALSE(reads(part)) << entry.path() << ": " << list << "[0] without " << field;
      }
      json more = whole;
      more[list][0]["surprise"] = 1;
      EXPECT_FALSE(accepts(more)) << entry.path() << ": " << list;
      EXPECT_FALSE(reads(more)) << entry.path() << ": " << list;
    }
  }
  EXPECT_EQ(files, 6);
}

TEST_F(CriteriaSchema, AsksForAnEndWithItsUnitOrForWords) {
  const json whole = json::parse(std::ifstream(kResources / "criteria" / "carotid-sru-2003.json"));
  const auto both = [&](const json& condition) {
    json other = whole;
    other["grades"][0]["when"]["all"][0] = condition;
    return std::pair(accepts(other), reads(other));
  };
  const std::pair<bool, bool> yes{true, true}, no{false, false};
  EXPECT_EQ(both({{"of", "PSV"}, {"below", 125}, {"unit", "cm/s"}}), yes);
  EXPECT_EQ(both({{"of", "PSV"}, {"below", 125}}), no);
  EXPECT_EQ(both({{"of", "PSV"}, {"unit", "cm/s"}}), no);
  EXPECT_EQ(both({{"of", "PSV"}, {"below", 125}, {"to", 120}, {"unit", "cm/s"}}), no);
  EXPECT_EQ(both({{"of", "PSV"}, {"is", {"open"}}}).second, false);
  EXPECT_EQ(both({{"of", "LUMEN"}, {"is", {"open"}}, {"unit", "1"}}), no);
}

}  // namespace
}  // namespace ew::measurement::criteria_schema_test
