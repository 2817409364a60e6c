#include "ew/core/foreign_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ew::foreign_json_test {
namespace {

using nlohmann::json;

const json kOdd = json::parse(
    R"({"text": "a", "number": 2.5, "whole": 7, "flag": true, "list": [1], "nothing": null, "big": 18446744073709551615, "object": {"x": 1}})");

TEST(ForeignJson, NeitherParsesNorWritesWhatNestsWithoutBound) {
  for (const std::string& open : {std::string("["), std::string("{\"a\":")}) {
    std::string deep;
    for (int n = 0; n < 150'000; ++n) deep += open;
    EXPECT_TRUE(jsonOrNull(deep).is_null());
    ASSERT_FALSE(parseJson(deep, verbatim("it"), {}));
  }
  const std::string three = "[[[1]]]";
  EXPECT_TRUE(parseJson(three, verbatim("it"), {.depth = 3}));
  const auto refused = parseJson(three, verbatim("it"), {.depth = 2});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence(), "it nests deeper than 2 levels, which no such document does; check that it is the right one.");
  EXPECT_FALSE(parseJson(std::string(kDeepestNesting + 1, '['), verbatim("it"), {.depth = 100'000})) << "no limit goes beyond the stack";
}

TEST(ForeignJson, RefusesWhatIsLongerThanItsLimit) {
  EXPECT_TRUE(parseJson("[1, 2]", verbatim("it"), {.bytes = 6}));
  const auto refused = parseJson("[1, 2]", verbatim("it"), {.bytes = 5});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_EQ(refused.error().sentence(), "it is longer than 5 bytes, which no such document is; check that it is the right one.");
}

TEST(ForeignJson, WhatIsNotValidIsNull) {
  for (const char* text : {"", "{", "\"\xff\"", "{\"a\": 1e999}", "nul"}) EXPECT_TRUE(jsonOrNull(text).is_null()) << text;
  EXPECT_EQ(jsonOrNull("[1]"), json::array({1}));
}

TEST(ForeignJson, AFieldOfAnotherKindIsAsGoodAsNone) {
  EXPECT_EQ(textAt(kOdd, "text"), "a");
  EXPECT_EQ(numberAt(kOdd, "number"), 2.5);
  EXPECT_EQ(wholeAt(kOdd, "whole"), 7);
  EXPECT_TRUE(flagAt(kOdd, "flag"));
  EXPECT_EQ(listAt(kOdd, "list"), json::array({1}));
  EXPECT_EQ(memberOf(memberOf(kOdd, "object"), "x"), 1);
  EXPECT_EQ(textsAt(json({{"a", {"x", 1, "y"}}}), "a"), (std::vector<std::string>{"x", "y"}));
  for (const auto& [name, value] : kOdd.items()) {
    if (name != "text") {
      EXPECT_EQ(textAt(kOdd, name, "other"), "other") << name;
    }
    if (!value.is_number()) {
      EXPECT_FALSE(numberAt(kOdd, name)) << name;
    }
    if (name != "whole") {
      EXPECT_FALSE(wholeAt(kOdd, name)) << name;
    }
    if (name != "flag") {
      EXPECT_FALSE(flagAt(kOdd, name)) << name;
    }
    if (name != "list") {
      EXPECT_TRUE(listAt(kOdd, name).empty()) << name;
    }
  }
  for (const json& none : {json(), json(5), json("text"), json::array({1})}) {
    EXPECT_TRUE(memberOf(none, "text").is_null());
    EXPECT_EQ(textAt(none, "text", "other"), "other");
    EXPECT_FALSE(numberAt(none, "number"));
    EXPECT_TRUE(flagAt(none, "flag", true));
    EXPECT_TRUE(listAt(none, "list").empty());
  }
  EXPECT_TRUE(memberOf(kOdd, "missing").is_null());
}

TEST(ForeignJson, WordsAreWhateverStandsThere) {
  EXPECT_EQ(wordsAt(kOdd, "text"), "a");
  EXPECT_EQ(wordsAt(kOdd, "number"), "2.5");
  EXPECT_EQ(wordsAt(kOdd, "object"), R"({"x":1})");
  EXPECT_EQ(wordsAt(kOdd, "nothing"), "");
  EXPECT_EQ(wordsAt(json({{"a", "\xff"}}), "a"), "\xff");
  EXPECT_EQ(wordsAt(json({{"a", {"\xff"}}}), "a"), "[\"\xef\xbf\xbd\"]");
}

}  // namespace
}  // namespace ew::foreign_json_test
