#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "places.h"

// A text with a number reads "1 target" and "2 targets" in English too: Qt has the forms from a catalogue alone.
namespace ew::rules::english_numbers_test {
namespace {

std::string textOf(const std::string& name) {
  std::ifstream in(std::string(EW_SOURCE_DIR) + "/resources/translations/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Texts that have forms for numbers, by their context.
std::set<std::string> withNumbers(const std::string& catalogue) {
  static const std::regex part(R"(<name>([^<]*)</name>|<message numerus="yes">\s*(?:<location[^>]*>\s*)*<source>([^<]*)</source>)");
  std::set<std::string> found;
  std::string context;
  for (std::sregex_iterator at(catalogue.begin(), catalogue.end(), part), end; at != end; ++at) {
    if ((*at)[1].matched)
      context = (*at)[1];
    else
      found.insert(context + ": " + (*at)[2].str());
  }
  return found;
}

TEST(EnglishNumbers, HaveTheirFormsWhereGermanHas) {
  const auto german = withNumbers(textOf("echoweave_de.ts"));
  EXPECT_GT(german.size(), 10u);
  EXPECT_EQ(withNumbers(textOf("echoweave_en.ts")), german) << "put the text into echoweave_en.ts, with both forms";
}

TEST(EnglishNumbers, ATextWithoutItsFormsIsFound) {
  const std::string one = "<name>a</name><message numerus=\"yes\">\n<source>%n targets</source>", none = "<name>a</name>";
  EXPECT_EQ(withNumbers(one), (std::set<std::string>{"a: %n targets"}));
  EXPECT_TRUE(withNumbers(none).empty());
}

}  // namespace
}  // namespace ew::rules::english_numbers_test
