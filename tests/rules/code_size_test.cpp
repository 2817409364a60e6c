#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "rules/source_tree.h"

// A function longer than a screen or two does several things, and a file longer than 600 lines has several subjects.
namespace ew::rules::code_size_test {
namespace {

constexpr int kMostLinesOfFunction = 80;
constexpr int kMostLinesOfFile = 600;

int lineAt(std::string_view text, std::size_t at) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Whether the body that follows this text, back to the statement before it, is a function's.
bool beginsFunction(const std::string& head) {
  static const std::regex other(R"(\b(class|struct|enum|union|namespace)\b|^catch\b)");
  static const std::regex function(R"(\)\s*(const\s*)?(noexcept\s*)?(override\s*|final\s*)*(->[^;{]*)?(:[^:][^;]*)?(\btry\b)?\s*$)");
  return !std::regex_search(head, other) && std::regex_search(head, function);
}

/// A function of a source, in lines from its first to its closing one.
struct Function {
  std::string head;
  int line = 0;  ///< from 1
  int lines = 0;
};

std::vector<Function> functionsOf(const std::string& code) {
  std::vector<Function> found;
  int depth = 0, functionDepth = -1;
  std::size_t statement = 0;
  for (std::size_t n = 0; n < code.size(); ++n) {
    if (code[n] == '{') {
      if (functionDepth < 0) {
        const std::size_t begin = std::min(code.find_first_not_of(" \n", statement), n);
        std::string head = code.substr(begin, n - begin);
        if (beginsFunction(head)) {
          functionDepth = depth;
          found.push_back({std::move(head), lineAt(code, begin) + 1, 0});
        }
      }
      ++depth;
    } else if (code[n] == '}' && --depth == functionDepth) {
      found.back().lines = lineAt(code, n) + 2 - found.back().line;
      functionDepth = -1;
    }
    if (code[n] == ';' || code[n] == '{' || code[n] == '}') statement = n + 1;
  }
  return found;
}

TEST(CodeSize, CountsTheLinesOfFunctions) {
  const auto found =
      functionsOf(codeOf("namespace a {\nclass B {\n  int c() const { return 1; }\n  int d = 2;\n};\n\n"
                         "B::B(int e)\n    : e_(e) {\n  for (;;) {\n  }\n}\n\nint f() try {\n} catch (int) {\n}\n}\n"));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].lines, 1);
  EXPECT_EQ(found[1].head, "B::B(int e)\n    : e_(e) ");
  EXPECT_EQ(found[1].line, 7);
  EXPECT_EQ(found[1].lines, 5);
  EXPECT_EQ(found[2].lines, 2);
}

TEST(CodeSize, NoFunctionHasMoreThanEightyLines) {
  std::size_t counted = 0;
  std::string tooLong;
  for (const Source& source : sources())
    for (const Function& each : functionsOf(codeOf(source))) {
      ++counted;
      if (each.lines > kMostLinesOfFunction)
        tooLong += source.path + ":" + std::to_string(each.line) + ": " + std::to_string(each.lines) + " lines; give its steps names.\n";
    }
  EXPECT_EQ(tooLong, "");
  EXPECT_GT(counted, 5000u) << "nothing is counted";
}

TEST(CodeSize, NoFileHasMoreThanSixHundredLines) {
  std::string tooLong;
  for (const Source& source : sources()) {
    const int lines = lineAt(source.text, source.text.size());
    if (lines > kMostLinesOfFile) tooLong += source.path + ": " + std::to_string(lines) + " lines; divide it by subject.\n";
  }
  EXPECT_EQ(tooLong, "");
}

}  // namespace
}  // namespace ew::rules::code_size_test
