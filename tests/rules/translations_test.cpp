#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "places.h"
#include "rules/source_tree.h"

// A translation is found by its English text, letter by letter: where that is worded anew in the code and not in the catalogue, the window
// says it in English and nobody is told.
namespace ew::rules::translations_test {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What stands between quotation marks, as it is written; of neighbours that the compiler joins each, and all together.
std::set<std::string> literalsOf(const Source& source) {
  const std::string& code = codeOf(source);
  std::set<std::string> found;
  std::string all;
  std::size_t last = std::string::npos;
  for (std::size_t open = code.find('"'); open != std::string::npos;) {
    const std::size_t close = code.find('"', open + 1);
    if (close == std::string::npos) break;
    const bool isOneMore = last != std::string::npos && code.find_first_not_of(" \n", last + 1) == open;
    const std::string each = source.text.substr(open + 1, close - open - 1);
    all = isOneMore ? all + each : each;
    found.insert(each);
    found.insert(all);
    last = close;
    open = code.find('"', close + 1);
  }
  return found;
}

/// English texts of a catalogue, as C++ and JSON write them.
std::vector<std::string> textsOf(const std::string& catalogue) {
  static const std::regex part("<name>([^<]*)</name>|<source>([^<]*)</source>");
  std::vector<std::string> texts;
  bool isOfQt = false;
  for (std::sregex_iterator at(catalogue.begin(), catalogue.end(), part), end; at != end; ++at) {
    if ((*at)[1].matched) {
      isOfQt = (*at)[1] == "QShortcut";
      continue;
    }
    std::string text = (*at)[2];
    for (const auto& [what, with] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}})
      text = replaced(text, what, with);
    for (const auto& [what, with] : {std::pair{"\\", "\\\\"}, {"\"", "\\\""}, {"\n", "\\n"}}) text = replaced(text, what, with);
    if (!isOfQt) texts.push_back(text);
  }
  return texts;
}

/// Those of them that are neither a literal of the program nor a text of its data.
std::vector<std::string> unsaid(const std::string& catalogue, const std::set<std::string>& literals, const std::string& data) {
  std::vector<std::string> found;
  for (const std::string& text : textsOf(catalogue))
    if (!literals.contains(text) && data.find("\"" + text + "\"") == std::string::npos) found.push_back(text);
  return found;
}

TEST(Translations, TranslateWhatTheProgramSays) {
  std::set<std::string> literals;
  for (const Source& source : sources()) literals.merge(literalsOf(source));
  const fs::path resources = fs::path(EW_SOURCE_DIR) / "resources";
  std::string data;
  for (const std::string& literal : literals)
    if (literal.find('\n') != std::string::npos) data += literal;  // the schema of a plugin
  for (const char* folder : {"probes", "schemas"})
    for (const auto& entry : fs::directory_iterator(resources / folder)) data += textOf(entry.path());
  const std::string catalogue = textOf(resources / "translations/echoweave_de.ts");
  EXPECT_GT(textsOf(catalogue).size(), 3000u);
  EXPECT_EQ(unsaid(catalogue, literals, data), std::vector<std::string>{}) << "give the entry the text of the code, or take it out";
}

TEST(Translations, ATextThatWasWordedAnewIsFound) {
  const Source source{"a.cpp", "// \"gone\"\ntr(\"one \\\"text\\\" \"\n   \"of two\"); say<\"a < b\">(); const char mark = '\"';"};
  const auto catalogue = [](const std::string& text) { return "<name>a</name><source>" + text + "</source>"; };
  const auto found = [&](const std::string& text) { return unsaid(catalogue(text), literalsOf(source), R"({"name": "Linear 12"})"); };
  for (const char* said : {"one &quot;text&quot; of two", "a &lt; b", "Linear 12"}) EXPECT_TRUE(found(said).empty()) << said;
  for (const char* none : {"gone", "one", "Linear"}) EXPECT_EQ(found(none), std::vector<std::string>{none});
  EXPECT_TRUE(unsaid("<name>QShortcut</name><source>Ctrl</source>", {}, {}).empty());
}

}  // namespace
}  // namespace ew::rules::translations_test
