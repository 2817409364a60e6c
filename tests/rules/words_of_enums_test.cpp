#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "rules/source_tree.h"

// An enumerator that is added later has to be given its word: -Wswitch, an error in every preset, asks for it where words are chosen by a
// switch without a default, wordIn() where they stand in a WordTable (core/word_table.h), and nothing does elsewhere. An array of words
// that an enumerator indexes is read beyond its end, and the last of several questions gives the new one the word of another.
namespace ew::rules::words_of_enums_test {
namespace {

using Matches = std::sregex_iterator;

int lineOf(const std::string& text, std::ptrdiff_t at) { return 1 + static_cast<int>(std::count(text.begin(), text.begin() + at, '\n')); }

std::string lineAt(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int n = 1; n < line; ++n) begin = text.find('\n', begin) + 1;
  const std::string found = text.substr(begin, text.find('\n', begin) - begin);
  return found.substr(std::min(found.size(), found.find_first_not_of(' ')));
}

Offence offenceAt(const Source& source, std::ptrdiff_t at) {
  const int line = lineOf(source.text, at);
  return {source.path, line, lineAt(source.text, line)};
}

/// Names of arrays whose first element is a word: `kWords[] = {"`, `std::array names{tr("`.
std::set<std::string> wordArraysIn(const std::string& code) {
  static const std::regex array(
      R"((\w+)\s*(?:\[[^\]\n]*\])?\s*(?:=\s*)?\{\{?\s*(?:(?:\w+::)*(?:tr|QStringLiteral|QLatin1String|QT_TR_NOOP|words)\(|say<)?")",
      std::regex::optimize);
  std::set<std::string> names;
  for (Matches at(code.begin(), code.end(), array), end; at != end; ++at) names.insert((*at)[1]);
  return names;
}

/// Arrays of words of headers, which any source may index.
const std::set<std::string>& wordArraysOfHeaders() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const Source& source : sources())
      if (source.path.ends_with(".h"))
        for (const std::string& name : wordArraysIn(codeOf(source)))
          if (name.size() > 1 && name.front() == 'k') all.insert(name);
    return all;
  }();
  return names;
}

std::vector<Offence> castsIntoWords(const Source& source) {
  static const std::regex cast(R"((\w+)(?:\[|\.at\()\s*(?:static_cast<|int\(|(?:std::)?size_t\(|unsigned\(|(?:std::)?to_underlying\())",
                               std::regex::optimize);
  const std::string& code = codeOf(source);
  const auto own = wordArraysIn(code);
  std::vector<Offence> found;
  for (Matches at(code.begin(), code.end(), cast), end; at != end; ++at)
    if (own.contains((*at)[1]) || wordArraysOfHeaders().contains((*at)[1])) found.push_back(offenceAt(source, at->position()));
  return found;
}

const std::set<std::string>& enums() {
  static const std::set<std::string> names = [] {
    static const std::regex definition(R"(\benum\s+(?:class\s+)?(\w+))", std::regex::optimize);
    std::set<std::string> all;
    for (const Source& source : sources()) {
      const std::string& code = codeOf(source);
      for (Matches at(code.begin(), code.end(), definition), end; at != end; ++at) all.insert((*at)[1]);
    }
    return all;
  }();
  return names;
}

/// The body that begins behind the brace at `open`.
std::string bodyFrom(const std::string& code, std::size_t open) {
  std::size_t end = open + 1;
  for (int depth = 1; depth > 0 && end < code.size(); ++end) depth += code[end] == '{' ? 1 : code[end] == '}' ? -1 : 0;
  return code.substr(open + 1, end - open - 1);
}

/// Functions from an enumerator to words that ask for it by == or !=, or whose switch has a default.
std::vector<Offence> questionsForWords(const Source& source, const std::set<std::string>& known) {
  static const std::regex head(
      R"(\b(?:const char\*|std::string_view|std::string|QString|Message)\s+(?:\w+::)*\w+\(([^(){};]*)\)\s*(?:const\s*)?\{)",
      std::regex::optimize);
  static const std::regex parameter(R"((?:^|,)\s*(?:const\s+)?(?:\w+::)*(\w+)&?\s+(\w+)\s*(?=,|$))", std::regex::optimize);
  const std::string& code = codeOf(source);
  std::vector<Offence> found;
  for (Matches at(code.begin(), code.end(), head), end; at != end; ++at) {
    const std::string parameters = (*at)[1];
    for (Matches each(parameters.begin(), parameters.end(), parameter); each != end; ++each) {
      if (!known.contains((*each)[1])) continue;
      const std::string name = (*each)[2];
      const std::string body = bodyFrom(code, static_cast<std::size_t>(at->position() + at->length()) - 1);
      const std::size_t chosen = body.find("switch (" + name + ")");
      const bool hasDefault = chosen != std::string::npos && bodyFrom(body, body.find('{', chosen)).find("default:") != std::string::npos;
      const bool asks = chosen == std::string::npos && std::regex_search(body, std::regex("\\b" + name + "\\s*(==|!=)"));
      if (hasDefault || asks) found.push_back(offenceAt(source, at->position()));
    }
  }
  return found;
}

/// `x == E::a ? "..." : x == E::b ? "..." : "..."`
std::vector<Offence> chainsOfWords(const Source& source) {
  static const std::regex question(R"(([\w.\->]+) == *(?:\w+::)+[a-z]\w*\s*\?)", std::regex::optimize);
  const std::string& code = codeOf(source);
  std::vector<Offence> found;
  std::string before;
  std::ptrdiff_t begin = 0, last = 0;
  for (Matches at(code.begin(), code.end(), question), end; at != end; ++at) {
    const std::string between = code.substr(static_cast<std::size_t>(last), static_cast<std::size_t>(at->position() - last));
    const bool goesOn = (*at)[1] == before && between.find('"') != std::string::npos &&
                        between.find_last_not_of(" \n") != std::string::npos && between[between.find_last_not_of(" \n")] == ':' &&
                        between.find_first_of(";{}") == std::string::npos;
    if (goesOn && (found.empty() || found.back() != offenceAt(source, begin))) found.push_back(offenceAt(source, begin));
    if (!goesOn) begin = at->position();
    before = (*at)[1];
    last = at->position() + at->length();
  }
  return found;
}

TEST(WordsOfEnums, AreNotReadOutOfArrays) {
  const std::vector<Exception> exceptions = {
      {"workstation/registration/src/remark.cpp", "The array has as many places as the enum, and a static_assert that each holds a name."},
      {"workstation/cli/src/bench/bench_library.cpp", "Any of the words, by a number drawn below their count."},
      {"plugins/case_authoring/panel/place_panel.cpp", "Six sides by axis and direction, which are no enum."},
  };
  EXPECT_EQ(brokenBy(castsIntoWords, exceptions, "a switch without a default, so that the compiler asks for the word of a new enumerator."),
            "");
}

TEST(WordsOfEnums, AnArrayThatAnEnumeratorIndexesIsFound) {
  EXPECT_EQ(castsIntoWords({"a.cpp", "const char* words[] = {\"passed\",\n  \"failed\"};\nreturn words[static_cast<int>(verdict)];"}),
            (std::vector<Offence>{{"a.cpp", 3, "return words[static_cast<int>(verdict)];"}}));
  EXPECT_EQ(castsIntoWords({"a.cpp", "constexpr std::array names{\"a\"};\nreturn names.at(static_cast<std::size_t>(kind));"}).size(), 1u);
  EXPECT_EQ(castsIntoWords({"a.cpp", "const QString texts[] = {tr(\"a\")};\nput(texts[int(kind)]);"}).size(), 1u);
  EXPECT_TRUE(castsIntoWords({"a.cpp", "const double parts[] = {1.0};\nreturn parts[static_cast<int>(kind)];"}).empty());
}

TEST(WordsOfEnums, AreNotWhatIsLeftAfterTheLastQuestion) {
  const Rule rule = [](const Source& source) { return questionsForWords(source, enums()); };
  const std::vector<Exception> exceptions = {
      {"workstation/registration/src/remark.cpp",
       "How long a sentence is, of two lengths; what it says is chosen by the code of the remark."},
      {"workstation/measurement/src/value_text.h", "Whether a figure has a unit at all."},
  };
  EXPECT_EQ(brokenBy(rule, exceptions, "a switch without a default, so that the compiler asks for the word of a new enumerator."), "");
}

TEST(WordsOfEnums, AQuestionForAnEnumeratorAndADefaultAreFound) {
  const std::set<std::string> known{"Verdict"};
  EXPECT_EQ(questionsForWords({"a.cpp",
                               "std::string wordOf(Verdict verdict) {\n  if (verdict == Verdict::passed) return \"passed\";\n"
                               "  return \"skipped\";\n}"},
                              known),
            (std::vector<Offence>{{"a.cpp", 1, "std::string wordOf(Verdict verdict) {"}}));
  EXPECT_EQ(
      questionsForWords({"a.cpp", "Message Words::of(int n, ew::Verdict is) const { return is == ew::Verdict::good ? a() : b(); }"}, known)
          .size(),
      1u);
  EXPECT_EQ(questionsForWords({"a.cpp",
                               "QString wordOf(Verdict verdict) { switch (verdict) { case Verdict::a: return tr(\"a\"); default: "
                               "return {}; } }"},
                              known)
                .size(),
            1u);
  EXPECT_TRUE(questionsForWords({"a.cpp",
                                 "QString wordOf(Verdict verdict) { switch (verdict) { case Verdict::a: return tr(\"a\"); } "
                                 "return {}; }"},
                                known)
                  .empty());
  EXPECT_TRUE(questionsForWords({"a.cpp", "QString wordOf(int verdict) { return verdict == 1 ? tr(\"a\") : tr(\"b\"); }"}, known).empty());
}

TEST(WordsOfEnums, AreNoChainOfQuestions) {
  EXPECT_EQ(brokenBy(chainsOfWords, {}, "a switch without a default, so that the compiler asks for the word of a new enumerator."), "");
}

TEST(WordsOfEnums, AChainOfQuestionsIsFound) {
  EXPECT_EQ(chainsOfWords({"a.cpp",
                           "const auto text = each.kind == Kind::a   ? tr(\"a\")\n                  : each.kind == Kind::b ? "
                           "tr(\"b\")\n                                         : tr(\"c\");"})
                .size(),
            1u);
  EXPECT_TRUE(chainsOfWords({"a.cpp", "f(a.kind == Kind::a ? \"a\" : \"b\");\ng(a.kind == Kind::b ? \"c\" : \"d\");"}).empty());
  EXPECT_TRUE(chainsOfWords({"a.cpp", "const double n = kind == Kind::a ? 1.0 : kind == Kind::b ? 2.0 : 3.0;"}).empty());
}

}  // namespace
}  // namespace ew::rules::words_of_enums_test
