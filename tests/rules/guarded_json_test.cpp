#include <gtest/gtest.h>

#include "rules/source_tree.h"

// JSON that others wrote is parsed in one place, which bounds its depth and its size, and fields of it are asked for by what cannot throw.
namespace ew::rules::guarded_json_test {
namespace {

std::vector<Offence> bareParsing(const Source& source) { return matchesOf(source, R"(json::(parse|accept|sax_parse)\()"); }

/// Getters of the JSON library that throw when a field is missing or of another kind: value("name", ...), at("name"), value(kName, ...).
std::vector<Offence> bareGetters(const Source& source) {
  auto found = matchesOf(source, R"((\.|->)(value|at)\(")");
  for (Offence& offence : matchesOf(source, R"((\.|->)value\(k[A-Z]\w*,.*json)")) found.push_back(std::move(offence));
  return found;
}

TEST(GuardedJson, IsParsedInOnePlace) {
  const std::vector<Exception> exceptions = {
      {"workstation/core/src/json_fields.cpp", "The one place."},
      {"workstation/library/src/schema.cpp", "The schemas are texts of the program itself."},
      {"workstation/stitching/src/chain/provenance.cpp", "The text is what projectText() has just made; its fields keep their order."},
  };
  EXPECT_EQ(brokenBy(bareParsing, exceptions, "parseJson() of ew/core/json_fields.h, or jsonOrNull() of ew/core/foreign_json.h."), "");
}

TEST(GuardedJson, ABareParseIsFound) {
  EXPECT_EQ(bareParsing({"a.cpp", "const auto said = nlohmann::json::parse(text, nullptr, false);"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "if (json::accept(text)) {"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "auto made = ordered_json::parse(text);"}).size(), 1u);
  EXPECT_TRUE(bareParsing({"a.cpp", "const auto said = parseJson(text, where);  // not json::parse(text)"}).empty());
}

TEST(GuardedJson, ItsFieldsAreAskedForByWhatCannotThrow) {
  const std::vector<Exception> exceptions = {
      {"workstation/stitching/src/chain/",
       "What a run kept of itself, under a sum of its content; readBack() and resultFilesFrom() catch."},
      {"workstation/io/src/step_store.cpp", "What the store kept, under a sum of its content; find() catches."},
      {"workstation/library/src/kept_motion.cpp", "What the library kept, under a sum of its content; readKeptMotion() catches."},
      {"workstation/library/src/kept_maps.cpp", "What the library kept, under a sum of its content; readKeptMaps() catches."},
      {"workstation/library/src/case_truth.cpp", "What truthOfPatient() made, or the library kept of it under a sum of its content."},
      {"workstation/library/src/schema.cpp", "The schemas are texts of the program itself."},
      {"workstation/records/src/cmi5.cpp", "A map of parameters, each looked for before."},
      {"workstation/scanning/src/preset.cpp", "A field that was asked for before."},
      {"workstation/cli/src/bench_slicing.cpp", "A map of the benchmark's own."},
  };
  EXPECT_EQ(
      brokenBy(bareGetters, exceptions,
               "JsonFields of ew/core/json_fields.h for files of a user, textAt(), numberAt() ... of ew/core/foreign_json.h otherwise."),
      "");
}

TEST(GuardedJson, AGetterThatThrowsIsFound) {
  EXPECT_EQ(bareGetters({"a.cpp", R"(if (json.value("format", 0) > 1))"}).size(), 1u);
  EXPECT_EQ(bareGetters({"a.cpp", R"(made.name = said.at("name");)"}).size(), 1u);
  EXPECT_EQ(bareGetters({"a.cpp", R"(made.name = said->at("name");)"}).size(), 1u);
  EXPECT_EQ(bareGetters({"a.cpp", R"(if (read.value(kContent, json()) == sum))"}).size(), 1u);
  EXPECT_TRUE(bareGetters({"a.cpp", R"(made.name = textAt(said, "name");)"}).empty());
  EXPECT_TRUE(bareGetters({"a.cpp", R"(QSettings().value(kShown, true).toBool();)"}).empty());
}

}  // namespace
}  // namespace ew::rules::guarded_json_test
