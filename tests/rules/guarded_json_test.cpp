#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>

#include "rules/source_tree.h"

// JSON that others wrote is parsed in one place, which bounds its depth and its size, and fields of it are asked for by what cannot throw.
namespace ew::rules::guarded_json_test {
namespace {

/// Under any name that says what it is; a name that does not would hide from this rule, so it is an offence itself.
std::vector<Offence> bareParsing(const Source& source) {
  auto found = matchesOf(source, R"([Jj]son\w*(<.*>)?::(parse|accept|sax_parse)\s*\()");
  for (Offence& offence : matchesOf(source, R"(using\s+(?!\w*[Jj]son)\w+\s*=\s*(nlohmann::)?\w*json\b(?!::))"))
    found.push_back(std::move(offence));
  return found;
}

/// Getters of the JSON library that throw when a field is missing or of another kind: value("name", ...), at("name"), value(kName, ...).
std::vector<Offence> bareGetters(const Source& source) {
  auto found = matchesOf(source, R"((\.|->)(value|at)\(")");
  for (Offence& offence : matchesOf(source, R"((\.|->)value\(k[A-Z]\w*,.*json)")) found.push_back(std::move(offence));
  return found;
}

constexpr int kGuardLines = 4;  ///< before a line, in which the kind of what it takes may have been asked for

/// The line of an offence as it is written, with those before it: "answer["unit"]" of the code alone is any key of four letters.
std::string withLinesBefore(const Source& source, const Offence& offence) {
  std::size_t begin = 0;
  for (int line = 1; line < offence.line - kGuardLines; ++line) begin = source.text.find('\n', begin) + 1;
  std::size_t end = begin;
  for (int line = std::max(1, offence.line - kGuardLines); line <= offence.line && end < source.text.size(); ++line)
    end = std::min(source.text.find('\n', end), source.text.size() - 1) + 1;
  return source.text.substr(begin, end - begin);
}

/// Whether all that a line takes was asked for its kind just before, under the same name: answer["unit"].is_string().
bool isAskedBefore(const Source& source, const Offence& offence) {
  static const std::regex taking(R"(\]\s*\.get(<|_to\(|_ref<))"), taken(R"((\w+\)?(\[[^\[\]]*\])+)\s*\.get(<|_to\(|_ref<))");
  const std::string text = withLinesBefore(source, offence);
  const std::sregex_iterator none, all(offence.what.begin(), offence.what.end(), taking),
      named(offence.what.begin(), offence.what.end(), taken);
  if (std::distance(all, none) != std::distance(named, none)) return false;
  return std::all_of(named, none, [&](const std::smatch& one) { return text.find(one[1].str() + ".is_") != std::string::npos; });
}

/// What throws when the value is of another kind, or when there is none: said["x"].get<int>(), said[0].get_to(x). Whatever reads what
/// others wrote asks before, and so that one sees it.
std::vector<Offence> bareValues(const Source& source) {
  auto found = matchesOf(source, R"(\]\s*\.get(<|_to\(|_ref<))");
  std::erase_if(found, [&](const Offence& offence) { return isAskedBefore(source, offence); });
  for (Offence& offence : matchesOf(source, R"((\.|->)at\(.*\)\s*\.get(<|_to\(|_ref<))")) found.push_back(std::move(offence));
  return found;
}

/// Exceptions of both rules below: JSON that the program itself has made. @param others of the one rule
std::vector<Exception> withOwnWork(std::vector<Exception> others) {
  const std::vector<Exception> own = {
      {"workstation/stitching/src/chain/",
       "What a run kept of itself, under a sum of its content; readBack() and resultFilesFrom() catch."},
      {"workstation/io/src/files/step_store.cpp", "What the store kept, under a sum of its content; find() catches."},
      {"workstation/library/src/case/kept_motion.cpp", "What the library kept, under a sum of its content; readKeptMotion() catches."},
      {"workstation/library/src/case/kept_maps.cpp", "What the library kept, under a sum of its content; readKeptMaps() catches."},
      {"workstation/library/src/making/case_truth.cpp",
       "What truthOfPatient() made, or the library kept of it under a sum of its content; loadCaseTruth() catches."},
      {"workstation/library/src/files/schema.cpp", "The schemas are texts of the program itself."},
      {"workstation/library/src/files/value_rules.cpp", "The schemas are texts of the program itself."},
  };
  others.insert(others.begin(), own.begin(), own.end());
  return others;
}

TEST(GuardedJson, IsParsedInOnePlace) {
  const std::vector<Exception> exceptions = {
      {"workstation/core/src/json_fields.cpp", "The one place."},
      {"workstation/library/src/files/schema.cpp", "The schemas are texts of the program itself."},
      {"workstation/stitching/src/chain/provenance.cpp", "The text is what projectText() has just made; its fields keep their order."},
  };
  EXPECT_EQ(brokenBy(bareParsing, exceptions, "parseJson() of ew/core/json_fields.h, or jsonOrNull() of ew/core/foreign_json.h."), "");
}

TEST(GuardedJson, ABareParseIsFound) {
  EXPECT_EQ(bareParsing({"a.cpp", "const auto said = nlohmann::json::parse(text, nullptr, false);"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "if (json::accept(text)) {"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "auto made = ordered_json::parse(text);"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "return Json::parse(text);"}).size(), 1u) << "by another name";
  EXPECT_EQ(bareParsing({"a.cpp", "return JsonOfServer::sax_parse (text, &reader);"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "auto made = nlohmann::basic_json<std::map>::parse(text);"}).size(), 1u);
  EXPECT_EQ(bareParsing({"a.cpp", "using Document = nlohmann::ordered_json;"}).size(), 1u) << "a name under which nobody would find it";
  EXPECT_TRUE(bareParsing({"a.cpp", "using Json = nlohmann::json;\nusing nlohmann::json;"}).empty());
  EXPECT_TRUE(bareParsing({"a.cpp", "const auto said = parseJson(text, where);  // not json::parse(text)"}).empty());
}

TEST(GuardedJson, ItsFieldsAreAskedForByWhatCannotThrow) {
  const std::vector<Exception> exceptions = withOwnWork({
      {"workstation/records/src/cmi5.cpp", "A map of parameters, each looked for before."},
      {"workstation/scanning/src/preset.cpp", "A field that was asked for before."},
      {"workstation/cli/src/bench/images/bench_slicing.cpp", "A map of the benchmark's own."},
  });
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

TEST(GuardedJson, ItsValuesAreTakenWhereTheirKindWasAskedFor) {
  const std::vector<Exception> exceptions = withOwnWork({
      {"workstation/core/src/json_fields.cpp", "What others are to use; `fits` asks."},
      {"workstation/library/src/case/manifest.cpp", "After schemaProblems() and rigid(), which have refused every other kind."},
      {"workstation/sdk/door/src/manifest.cpp", "After schemaProblems(), which has refused every other kind."},
      {"workstation/cli/src/commands/records_launch_command.cpp",
       "An agent with an account, or cmi5LaunchOf() would have refused the launch."},
      {"workstation/cli/src/commands/tracker_command.cpp", "Rows that list() itself has just made."},
      {"workstation/cli/src/commands/phantom_command.cpp", "The truth that the command itself has just worked out."},
      {"workstation/cli/src/bench/", "Reports that the benchmark itself has just made."},
      {"plugins/stitching/logic/stitch_document.cpp", "leftIn() has asked for the field and its kind before it reads the project."},
  });
  EXPECT_EQ(
      brokenBy(bareValues, exceptions,
               "textAt(), numberAt() ... of ew/core/foreign_json.h, JsonFields of ew/core/json_fields.h, or said[x].is_number() in the "
               "lines just before."),
      "");
}

TEST(GuardedJson, AValueThatIsTakenUnaskedIsFound) {
  EXPECT_EQ(bareValues({"a.cpp", R"(made.count = said["x"].get<int>();)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", R"(made.count = (*said)[kCount].get<int>();)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", R"(said["x"].get_to(made.count);)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", R"(const auto& text = said[0].get_ref<const std::string&>();)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", R"(made.at_s = said.at(kTime).get<double>();)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", "if (said[\"x\"].is_number())\n  return said[\"y\"].get<int>();"}).size(), 1u)
      << "another one was asked for";
  EXPECT_EQ(bareValues({"a.cpp", R"(if (said["x"].is_number()) return said["x"].get<int>() + said["y"].get<int>();)"}).size(), 1u);
  EXPECT_EQ(bareValues({"a.cpp", "const bool is = said[\"x\"].is_number();\n\n\n\n\nreturn said[\"x\"].get<int>();"}).size(), 1u)
      << "so far away nobody sees it";
}

TEST(GuardedJson, AValueWhoseKindWasAskedForIsFine) {
  EXPECT_TRUE(bareValues({"a.cpp", R"(return said["x"].is_number() ? said["x"].get<int>() : 0;)"}).empty());
  EXPECT_TRUE(bareValues({"a.cpp", "if (!said[name].is_number()) return 0;\nreturn said[name].get<int>();"}).empty());
  EXPECT_TRUE(bareValues({"a.cpp", R"(if ((*said)["x"].is_string()) text = words((*said)["x"].get<std::string>());)"}).empty());
  EXPECT_TRUE(bareValues({"a.cpp", "made.count = wholeAt(said, \"x\");  // not said[\"x\"].get<int>()"}).empty());
  EXPECT_TRUE(bareValues({"a.cpp", "made = std::get<Fan>(shapes[0]); widgets[0].get();"}).empty());
}

}  // namespace
}  // namespace ew::rules::guarded_json_test
