#include <gtest/gtest.h>

#include "rules/source_tree.h"

// A case crosses the plugins' door, and goes through an edit, as a value: no JSON is made of it and none is read. Files of cases are read
// and written in the library; the window and the plugins ask it for values.
namespace ew::rules::case_value_test {
namespace {

std::vector<Offence> throughJson(const Source& source) {
  const bool isBound =
      source.path.starts_with("plugins/") || source.path.starts_with("workstation/ui/") || source.path.starts_with("workstation/sdk/");
  if (!isBound) return {};
  return matchesOf(source, R"(\b(caseFromManifest|manifestOf|orderedManifestOf|checkManifest)\b)");
}

TEST(CaseValue, GoesThroughNoJsonInWindowDoorAndPlugins) {
  const std::vector<Exception> exceptions = {
      {"workstation/ui/src/window/features/case_saving.cpp", "Takes over edits from the file in which a crash has left them."},
  };
  EXPECT_EQ(brokenBy(throughJson, exceptions, "change the Case itself; checkCase() says what is wrong with it."), "");
}

TEST(CaseValue, AWayThroughJsonIsFound) {
  EXPECT_EQ(throughJson({"plugins/made/panel/made.cpp", "auto next = caseFromManifest(manifest, folder);"}).size(), 1u);
  EXPECT_EQ(throughJson({"workstation/ui/src/plugins/made.cpp", "return manifestOf(*document_.current());"}).size(), 1u);
  EXPECT_EQ(throughJson({"workstation/sdk/door/src/made.cpp", "return checkManifest(manifest, {});"}).size(), 1u);
  EXPECT_TRUE(throughJson({"workstation/library/src/case/made.cpp", "return manifestOf(edited);"}).empty());
  EXPECT_TRUE(throughJson({"plugins/made/panel/made.cpp", "edited.title = title;  // as manifestOf() writes it"}).empty());
}

}  // namespace
}  // namespace ew::rules::case_value_test
