#include <gtest/gtest.h>

#include <algorithm>

#include "rules/source_tree.h"

namespace ew::rules::source_tree_test {
namespace {

TEST(SourceTree, HoldsTheLibrariesAndThePlugins) {
  const auto has = [](const char* path) { return std::ranges::find(sources(), path, &Source::path) != sources().end(); };
  EXPECT_TRUE(has("workstation/core/src/json_fields.cpp"));
  EXPECT_TRUE(has("workstation/core/include/ew/core/json_fields.h"));
  EXPECT_TRUE(has("plugins/stitching/logic/stitch_document.cpp"));
}

TEST(SourceTree, LeavesTheCodeAndTheMarksOfATextAndBlanksTheRest) {
  EXPECT_EQ(codeOf("a(\"b\\\"c\"); // d\ne"), "a(\"    \");     \ne");
  EXPECT_EQ(codeOf("a /* b\nc */ d"), "a     \n     d");
  EXPECT_EQ(codeOf("x = R\"z(a\"b)z\" + 1;"), "x = R\"       \" + 1;");
  EXPECT_EQ(codeOf("n = 10'000 + '\"' + f(\"c\");"), "n = 10'000 + ' ' + f(\" \");");
}

TEST(SourceTree, ALineIsNamedByItsPlaceAndOnlyWhenItsCodeMatches) {
  const Source made{"workstation/core/src/made.cpp", "// bad(\nauto text = \"bad(\";\n  bad(1);\n"};
  EXPECT_EQ(matchesOf(made, "bad\\("), (std::vector<Offence>{{made.path, 3, "bad(1);"}}));
}

TEST(SourceTree, AnExceptionThatNothingNeedsIsNamed) {
  const Rule nothing = [](const Source&) { return std::vector<Offence>(); };
  EXPECT_EQ(brokenBy(nothing, {{"workstation/core/src/pose.cpp", "It was once needed."}}, "do it right"),
            "workstation/core/src/pose.cpp needs its exception no longer; take it out of the rule.\n");
}

TEST(SourceTree, WhatBreaksARuleIsSaidWithItsPlaceAndWhatToDo) {
  const Rule one = [](const Source& source) {
    return source.path == "workstation/core/src/pose.cpp" ? std::vector<Offence>{{source.path, 7, "x"}} : std::vector<Offence>();
  };
  EXPECT_EQ(brokenBy(one, {}, "do it right"), "workstation/core/src/pose.cpp:7: x\nInstead: do it right\n");
  EXPECT_EQ(brokenBy(one, {{"workstation/core/src/", "All of them."}}, "do it right"), "");
  const Rule begun = [](const Source& source) {
    return source.path == "workstation/core/src/json_fields.cpp" ? std::vector<Offence>{{source.path, 7, "x"}} : std::vector<Offence>();
  };
  EXPECT_EQ(brokenBy(begun, {{"workstation/core/src/json_", "All whose names begin so."}}, "do it right"), "");
  EXPECT_EQ(brokenBy(begun, {{"workstation/core/src/json", "No such file."}}, "do it right"),
            "workstation/core/src/json_fields.cpp:7: x\nInstead: do it right\n"
            "workstation/core/src/json needs its exception no longer; take it out of the rule.\n");
}

}  // namespace
}  // namespace ew::rules::source_tree_test
