#include <gtest/gtest.h>

#include "rules/source_tree.h"

// JSON that others wrote is parsed in one place, which bounds its depth, and which says what is wrong with it.
namespace ew::rules::guarded_json_test {
namespace {

std::vector<Offence> bareParsing(const Source& source) { return matchesOf(source, "json::(parse|accept|sax_parse)\\("); }

TEST(GuardedJson, IsParsedInOnePlace) {
  const std::vector<Exception> exceptions = {
      {"workstation/core/src/json_fields.cpp", "The one place."},
      {"workstation/records/src/", "Still to go through parseJson()."},
      {"workstation/library/src/schema.cpp", "Still to go through parseJson()."},
      {"workstation/library/src/index_store.cpp", "Still to go through parseJson()."},
      {"workstation/export/src/outbox.cpp", "Still to go through parseJson()."},
      {"workstation/cli/src/", "Still to go through parseJson()."},
      {"workstation/stitching/src/", "Still to go through parseJson()."},
      {"workstation/io/src/step_store.cpp", "Still to go through parseJson()."},
      {"workstation/trackers/src/tracker_settings_json.cpp", "Still to go through parseJson()."},
      {"plugins/case_authoring/logic/kept_painting.cpp", "Still to go through parseJson()."},
      {"plugins/stitching/logic/stitch_document.cpp", "Still to go through parseJson()."},
  };
  EXPECT_EQ(brokenBy(bareParsing, exceptions, "parse it with parseJson() of ew/core/json_fields.h."), "");
}

TEST(GuardedJson, ABareParseIsFound) {
  EXPECT_EQ(bareParsing({"a.cpp", "const auto said = nlohmann::json::parse(text, nullptr, false);"}).size(), 1U);
  EXPECT_EQ(bareParsing({"a.cpp", "if (json::accept(text)) {"}).size(), 1U);
  EXPECT_TRUE(bareParsing({"a.cpp", "const auto said = parseJson(text, where);  // not json::parse(text)"}).empty());
}

}  // namespace
}  // namespace ew::rules::guarded_json_test
