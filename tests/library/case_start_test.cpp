#include "ew/library/case_start.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ew::case_start_test {
namespace {

using json = nlohmann::json;

json manifestWith(const json& presets, const json& marks) {
  return {{"format", 2}, {"id", "x"}, {"title", "X"}, {"volume", {{"file", "a.mha"}}}, {"presets", presets}, {"body_marks", marks}};
}

TEST(CaseStart, PresetsAndBodyMarksAreReadInTheirOrderAndKept) {
  const json manifest = manifestWith({"bladder-convex-3.5", "abdomen-convex-3.5"}, {"trunk"});
  const auto opened = caseFromManifest(manifest, {});
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(presetsOf(*opened), (std::vector<std::string>{"bladder-convex-3.5", "abdomen-convex-3.5"}));
  EXPECT_EQ(bodyMarksOf(*opened), std::vector<std::string>{"trunk"});
  const json written = manifestOf(*opened);
  EXPECT_EQ(written["presets"], manifest["presets"]);
  EXPECT_EQ(written["body_marks"], manifest["body_marks"]);
}

TEST(CaseStart, WithPresetsReplacesThemAndNoneLeavesNoField) {
  Case edited;
  EXPECT_TRUE(presetsOf(edited).empty());
  edited = withPresets(std::move(edited), {"trauma-convex-3.5"});
  EXPECT_EQ(presetsOf(edited), std::vector<std::string>{"trauma-convex-3.5"});
  edited = withPresets(std::move(edited), {});
  EXPECT_FALSE(edited.otherFields.contains("presets"));
}

TEST(CaseStart, OfPresetsOnlyThoseOfTheProgramAreForEverybody) {
  const Case opened = withPresets({}, {"stone-in-the-duct", "abdomen-convex-3.5", "../presets/aorta-convex-3.5", "trauma-convex-3.5"});
  EXPECT_EQ(shippedPresetsOf(opened), (std::vector<std::string>{"abdomen-convex-3.5", "trauma-convex-3.5"}));
}

TEST(CaseStart, WhatIsNoListOfIdsIsRefusedWithItsField) {
  for (const auto& [presets, marks, field] :
       {std::tuple{json("trunk"), json::array(), "presets"}, {json::array(), json({7}), "body_marks"}}) {
    const auto problems = checkManifest(manifestWith(presets, marks), {});
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems.front().sentence().find(field), std::string::npos) << problems.front();
  }
}

}  // namespace
}  // namespace ew::case_start_test
