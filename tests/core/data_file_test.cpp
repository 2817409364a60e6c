#include "ew/core/data_file.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

namespace ew::data_file_test {
namespace {

using nlohmann::json;

TEST(Words, AreSaidInTheLanguageOfTheProgram) {
  const Words words{"kidney", "Niere"};
  EXPECT_EQ(words.in("de"), "Niere");
  EXPECT_EQ(words.in("de_AT"), "Niere");
  EXPECT_EQ(words.in("en_GB"), "kidney");
  EXPECT_EQ(words.in("fr"), "kidney");
}

std::string problemOf(const json& document, const std::function<void(const JsonFields&)>& read) {
  JsonReading reading(verbatim("x.json"));
  read(JsonFields(document, reading));
  return reading.problem() ? reading.problem()->sentence() : "none";
}

TEST(WordsIn, NeedBothLanguages) {
  const auto read = [](const JsonFields& fields) { static_cast<void>(wordsIn(fields, "title", 10)); };
  EXPECT_EQ(problemOf({{"title", {{"en", "kidney"}, {"de", "Niere"}}}}, read), "none");
  EXPECT_NE(problemOf({{"title", {{"en", "kidney"}}}}, read).find("'title.de' in x.json is missing"), std::string::npos);
  EXPECT_NE(problemOf({{"title", {{"en", "kidney"}, {"de", "lang und breit"}}}}, read).find("'title.de'"), std::string::npos);
  EXPECT_NE(problemOf(json::object(), read), "none");
  const auto optional = [](const JsonFields& fields) { EXPECT_EQ(wordsIn(fields, "title", 10, false), Words{}); };
  EXPECT_EQ(problemOf(json::object(), optional), "none");
}

TEST(RequireFormat, RefusesWhatANewerProgramWrote) {
  const auto read = [](const JsonFields& fields) { requireFormat(fields, 2); };
  EXPECT_EQ(problemOf({{"format", 2}}, read), "none");
  EXPECT_EQ(problemOf({{"format", 3}}, read), "x.json has format 3, this program reads up to 2; update EchoWeave.");
  EXPECT_NE(problemOf({{"format", 0}}, read), "none");
  EXPECT_NE(problemOf(json::object(), read), "none");
  JsonReading reading(verbatim("x.json"));
  const json newer{{"format", 9}};
  requireFormat(JsonFields(newer, reading), 2);
  EXPECT_EQ(reading.problem()->code, ErrorCode::newerFormat);
}

}  // namespace
}  // namespace ew::data_file_test
