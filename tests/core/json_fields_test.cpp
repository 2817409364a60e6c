#include "ew/core/json_fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "ew/core/frames.h"
#include "ew/core/nesting.h"

namespace ew::json_fields_test {
namespace {

using nlohmann::json;

enum class Colour { red, green, blue };
constexpr std::array<std::pair<std::string_view, Colour>, 3> kColours{
    {{"red", Colour::red}, {"green", Colour::green}, {"blue", Colour::blue}}};

/// The sentence with which `read` is refused; empty when it is not.
template <class Read>
std::string refusal(const json& document, const Read& read) {
  JsonReading reading(verbatim("a.json"));
  read(JsonFields(document, reading));
  return reading.problem() ? reading.problem()->sentence() : std::string();
}

TEST(JsonFields, GivesWhatStandsThere) {
  const json document = {{"width_mm", 4.5},
                         {"count", 3.0},
                         {"name", "liver"},
                         {"on", true},
                         {"kind", "green"},
                         {"at", {1, 2, -3}},
                         {"depths", {1, 2.5}},
                         {"names", {"a", "b"}},
                         {"in", {{"x", 7}}},
                         {"list", {{{"x", 1}}, {{"x", 2}}}},
                         {"pose", rowsOf(glm::dmat4(1.0))}};
  JsonReading reading(verbatim("a.json"));
  const JsonFields fields(document, reading);
  EXPECT_EQ(fields.number("width_mm", 0.0, 10.0), 4.5);
  EXPECT_EQ(fields.whole("count", 1, 10), 3) << "3.0 is a whole number, as JSON schemas have it";
  EXPECT_EQ(fields.text("name"), "liver");
  EXPECT_TRUE(fields.flag("on"));
  EXPECT_EQ(fields.word("kind", kColours), Colour::green);
  EXPECT_EQ(fields.point("at", 10.0), glm::dvec3(1, 2, -3));
  EXPECT_EQ(fields.numbers("depths", 1, 4, 0.0, 10.0), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(fields.texts("names", 1, 4), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(fields.object("in").number("x", 0.0, 10.0), 7.0);
  const auto list = fields.objects("list", 1, 4);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].whole("x", 0, 10), 2);
  EXPECT_EQ(list[1].placeOf("x"), "list[1].x");
  EXPECT_EQ(fields.rigid("pose"), glm::dmat4(1.0));
  EXPECT_TRUE(reading.good()) << *reading.problem();
}

TEST(JsonFields, GivesTheFallbackOfWhatIsNotThere) {
  const json document = json::object();
  JsonReading reading(verbatim("a.json"));
  const JsonFields fields(document, reading);
  EXPECT_EQ(fields.number("a", 0.0, 1.0, 0.5), 0.5);
  EXPECT_EQ(fields.whole("a", 0, 1, 7), 7);
  EXPECT_EQ(fields.text("a", "none"), "none");
  EXPECT_TRUE(fields.flag("a", true));
  EXPECT_EQ(fields.word("a", kColours, std::optional(Colour::blue)), Colour::blue);
  EXPECT_EQ(fields.point("a", 1.0, glm::dvec3(1, 2, 3)), glm::dvec3(1, 2, 3));
  EXPECT_TRUE(fields.numbers("a", 1, 2, 0.0, 1.0, false).empty());
  EXPECT_TRUE(fields.texts("a", 0, 2).empty());
  EXPECT_TRUE(fields.objects("a", 0, 2).empty());
  EXPECT_FALSE(fields.object("a").has("b"));
  EXPECT_FALSE(fields.rigid("a"));
  EXPECT_TRUE(reading.good());
}

TEST(JsonFields, NamesThePlaceWhatWasFoundAndWhatIsExpected) {
  const auto of = [](const json& document, const auto& read) { return refusal(document, read); };
  EXPECT_EQ(of({{"a", "wide"}}, [](const JsonFields& f) { f.number("a", 0.0, 1.0); }),
            "'a' in a.json is \"wide\"; it must be a number from 0 to 1.");
  EXPECT_EQ(of(json::object(), [](const JsonFields& f) { f.number("a", 0.0, 1.0); }),
            "'a' in a.json is missing; it must be a number from 0 to 1.");
  EXPECT_EQ(of({{"a", 1e300}}, [](const JsonFields& f) { f.number("a", 0.0, 1.0, 0.5, verbatim("a share")); }),
            "'a' in a.json is 1e+300; it must be a share.");
  EXPECT_EQ(of({{"a", 2.5}}, [](const JsonFields& f) { f.whole("a", 1, 8); }),
            "'a' in a.json is 2.5; it must be a whole number from 1 to 8.");
  EXPECT_EQ(of({{"a", "pink"}}, [](const JsonFields& f) { f.word("a", kColours); }),
            "'a' in a.json is \"pink\"; it must be \"red\", \"green\" or \"blue\".");
  EXPECT_EQ(of({{"a", 1}}, [](const JsonFields& f) { f.flag("a", true); }), "'a' in a.json is 1; it must be true or false.");
  EXPECT_EQ(of({{"a", ""}}, [](const JsonFields& f) { f.text("a"); }), "'a' in a.json is \"\"; it must be a text of 1 to 200 bytes.");
  EXPECT_EQ(of({{"a", {1, 2}}}, [](const JsonFields& f) { f.point("a", 9.0); }),
            "'a' in a.json is [1,2]; it must be three numbers from -9 to 9.");
  EXPECT_EQ(of({{"a", {1, 2, 3}}}, [](const JsonFields& f) { f.numbers("a", 1, 2, 0.0, 9.0); }),
            "'a' in a.json is [1,2,3]; it must be a list of 1 to 2 numbers from 0 to 9.");
  EXPECT_EQ(of({{"a", {1, 2}}}, [](const JsonFields& f) { static_cast<void>(f.objects("a", 1, 4)); }),
            "'a[0]' in a.json is 1; it must be an object.");
  EXPECT_EQ(of({{"a", {"x", 3}}}, [](const JsonFields& f) { f.texts("a", 1, 4); }),
            "'a[1]' in a.json is 3; it must be a text of 1 to 200 bytes.");
  EXPECT_EQ(of({{"a", json::array()}}, [](const JsonFields& f) { f.texts("a", 1, 4); }),
            "'a' in a.json is a list of 0; it must be a list of 1 to 4 entries.");
  EXPECT_EQ(of({{"in", {{"b", 1}}}}, [](const JsonFields& f) { f.object("in").flag("b"); }),
            "'in.b' in a.json is 1; it must be true or false.");
  EXPECT_EQ(of({{"in", 3}}, [](const JsonFields& f) { f.object("in").flag("b"); }), "'in' in a.json is 3; it must be an object.");
  EXPECT_EQ(of({{"wdith", 3}},
               [](const JsonFields& f) {
                 f.only({"width", "height"});
               }),
            "'wdith' in a.json is not known here; it must be one of width, height.");
  EXPECT_EQ(of(3, [](const JsonFields& f) { f.number("a", 0.0, 1.0); }), "a.json is 3; it must be an object.");
}

TEST(JsonFields, RefuseAPoseThatIsNotRigid) {
  json mirrored = rowsOf(glm::dmat4(1.0));
  mirrored[0] = -1.0;
  const json document = {{"pose", mirrored}, {"short", {1, 2}}};
  JsonReading reading(verbatim("a.json")), other(verbatim("a.json"));
  EXPECT_FALSE(JsonFields(document, reading).rigid("pose"));
  ASSERT_TRUE(reading.problem());
  EXPECT_EQ(reading.problem()->code, ErrorCode::notRigid);
  EXPECT_EQ(reading.problem()->sentence().rfind("'pose' in a.json cannot be used. ", 0), 0u) << *reading.problem();
  JsonReading endless(verbatim("a.json"));
  mirrored[0] = std::nan("");
  const json unbounded = {{"pose", mirrored}};
  EXPECT_FALSE(JsonFields(unbounded, endless).rigid("pose"));
  EXPECT_EQ(endless.problem()->code, ErrorCode::notRigid) << "16 numbers, but not of a pose";
  EXPECT_FALSE(JsonFields(document, other).rigid("short"));
  EXPECT_EQ(other.problem()->code, ErrorCode::badField);
}

TEST(JsonFields, KeepTheFirstProblemAndAskNothingAfterIt) {
  const json document = {{"a", "x"}, {"b", "y"}, {"c", 0.25}};
  JsonReading reading(verbatim("a.json"));
  const JsonFields fields(document, reading);
  fields.number("a", 0.0, 1.0);
  fields.number("b", 0.0, 1.0);
  fields.only({"nothing"});
  EXPECT_EQ(reading.problem()->context.front(), (std::pair<std::string, std::string>("field", "a")));
  EXPECT_EQ(fields.number("c", 0.0, 1.0, 0.75), 0.75) << "nobody works on with half a document";
}

TEST(JsonFields, WelcomeNotesEverywhereAsTexts) {
  const json good = {{"note", "by hand"}, {"in", {{"note", ""}, {"x", 1}}}}, bad = {{"in", {{"note", 3}}}};
  const auto read = [](const json& document) {
    JsonReading reading(verbatim("a.json"), {"note"});
    const JsonFields fields(document, reading);
    fields.only({"in"});
    fields.object("in").only({"x"});
    return reading.problem();
  };
  EXPECT_FALSE(read(good));
  ASSERT_TRUE(read(bad));
  EXPECT_EQ(read(bad)->sentence(), "'in.note' in a.json is 3; it must be a text.");
}

TEST(Shown, KeepsASentenceShortWhateverTheValue) {
  EXPECT_EQ(shown(json::object()).english(), "{}");
  EXPECT_EQ(shown({{"a", 1}}).english(), "{\"a\":1}");
  EXPECT_EQ(shown(std::string(1000, 'x')).english(), "a text of 1000 bytes");
  EXPECT_EQ(shown(json(std::vector<int>(300, 1))).english(), "a list of 300");
  EXPECT_EQ(shown({{"a", std::string(100, 'x')}}).english(), "an object with 1 fields");
  EXPECT_EQ(shown("\xff").english(), "\"\xEF\xBF\xBD\"") << "not UTF-8";
}

TEST(ParseJson, NamesTheLineAndRefusesDepth) {
  EXPECT_TRUE(parseJson("[1, 2]", verbatim("a.json")));
  EXPECT_EQ(parseJsonObject("[1, 2]", verbatim("a.json")).error().code, ErrorCode::badHeader);
  EXPECT_EQ(parseJson("{\n \"a\": 1,\n \"b\" 2}", verbatim("a.json")).error().sentence(),
            "a.json is not valid JSON: it breaks at line 3, column 6; correct it there or restore an earlier copy.");
  EXPECT_EQ(parseJson("[1e999]", verbatim("a.json")).error().code, ErrorCode::badHeader) << "no number of a document is infinite";
  EXPECT_EQ(parseJson(std::string(100000, '['), verbatim("a.json")).error().code, ErrorCode::badHeader);
}

/// Any value of JSON, with texts that are not UTF-8 and numbers that no file can hold among them.
json anyJson(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 8 : 6)) {
    case 0:
      return nullptr;
    case 1:
      return *rc::gen::arbitrary<bool>();
    case 2:
      return *rc::gen::arbitrary<std::int64_t>();
    case 3:
      return *rc::gen::arbitrary<double>();
    case 4:
      return *rc::gen::element(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), std::nan(""), 1e300, 0.5);
    case 5:
      return *rc::gen::arbitrary<std::string>();
    case 6: {
      json list = json::array();
      for (int n = *rc::gen::inRange(0, 5); n > 0; --n) list.push_back(anyJson(depth - 1));
      return list;
    }
    default: {
      json object = json::object();
      for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
        object[*rc::gen::element<std::string>("a", "b", "note", "\xff")] = anyJson(depth - 1);
      return object;
    }
  }
}

RC_GTEST_PROP(JsonFieldsProperty, WhateverStandsThereTheValueIsWithinItsLimitsOrTheFieldIsNamed, ()) {
  const json document = {{"a", anyJson(3)}};
  const double lowest = *rc::gen::inRange(-100, 100), highest = lowest + *rc::gen::inRange(0, 100);
  JsonReading reading(verbatim("a.json"), {"note"});
  const JsonFields fields(document, reading);
  switch (*rc::gen::inRange(0, 10)) {
    case 0: {
      const double value = fields.number("a", lowest, highest);
      RC_ASSERT(value >= lowest && value <= highest);
      break;
    }
    case 1: {
      const auto value = fields.whole("a", -5, 5);
      RC_ASSERT(value >= -5 && value <= 5);
      break;
    }
    case 2: {
      const auto values = fields.numbers("a", 1, 3, lowest, highest);
      RC_ASSERT(values.empty() != reading.good());
      for (const double value : values) RC_ASSERT(value >= lowest && value <= highest);
      break;
    }
    case 3: {
      const auto text = fields.text("a", {}, 1, 4);
      RC_ASSERT(text.size() <= 4u && text.empty() != reading.good());
      break;
    }
    case 4: {
      const glm::dvec3 point = fields.point("a", 50.0);
      for (int axis = 0; axis < 3; ++axis) RC_ASSERT(std::abs(point[axis]) <= 50.0);
      break;
    }
    case 5: {
      const auto pose = fields.rigid("a");
      RC_ASSERT(!pose || checkRigid(*pose));
      break;
    }
    case 6:
      static_cast<void>(fields.word("a", kColours));
      break;
    case 7:
      static_cast<void>(fields.flag("a"));
      break;
    case 8:
      for (const JsonFields& each : fields.objects("a", 0, 3)) each.only({"a"});
      break;
    default: {
      const auto texts = fields.texts("a", 1, 3);
      RC_ASSERT(texts.empty() != reading.good());
    }
  }
  if (reading.good()) return;
  const Error& problem = *reading.problem();
  RC_ASSERT(problem.context.front().first == "field");
  RC_ASSERT(problem.context.front().second.rfind("a", 0) == 0);
  RC_ASSERT(problem.sentence().rfind("'a", 0) == 0);
  RC_ASSERT(problem.sentence().back() == '.');
  RC_ASSERT(problem.sentence().find('\n') == std::string::npos);
  RC_ASSERT(problem.sentence().size() < 400u);
  RC_ASSERT(!json(problem.sentence()).dump(-1, ' ', false, json::error_handler_t::replace).empty());
}

RC_GTEST_PROP(JsonFieldsProperty, ANumberWithinItsLimitsIsReadToTheLastBit, (double value)) {
  RC_PRE(std::isfinite(value));
  JsonReading reading(verbatim("a.json"));
  const auto parsed = parseJson(json{{"a", value}}.dump(), verbatim("a.json"));
  RC_ASSERT(parsed.has_value());
  RC_ASSERT(JsonFields(*parsed, reading).number("a", -std::abs(value), std::abs(value)) == value);
  RC_ASSERT(reading.good());
}

}  // namespace
}  // namespace ew::json_fields_test
