#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>

#include "rules/source_tree.h"

// A class of more than sixty methods is several: nobody reads what it does before adding the sixty-first.
namespace ew::rules::class_size_test {
namespace {

constexpr int kMostMethods = 60;

bool opensBody(const std::string& head) {
  static const std::regex type(R"(\b(class|struct|enum|union|namespace)\b)");
  static const std::regex method(R"(\)\s*(const\s*)?(noexcept\s*)?(override\s*|final\s*)*(->[^;{]*)?(:[^:][^;]*)?$)");
  return !std::regex_search(head, type) && std::regex_search(head, method);
}

bool declaresMethod(const std::string& statement) {
  static const std::regex other(
      R"(^\s*((public|private|protected|Q_SIGNALS)[^:]*:\s*)*(using|friend|typedef|static_assert|Q_|enum|struct|class)\b)");
  static const std::regex function(
      R"(\w\s*\([^=]*\)\s*(const\s*)?(noexcept\s*)?(override\s*|final\s*)*(->[^;]*)?(=\s*(0|default|delete)\s*)?$)");
  static const std::regex member(R"(std::function<.*>\s+\w+\s*(=.*)?$)");
  const std::string line = std::regex_replace(statement, std::regex(R"(\s+)"), " ");
  return !std::regex_search(line, other) && std::regex_search(line, function) && !std::regex_search(line, member);
}

/// Methods of the class whose body begins at `begin`, those of classes within it left out.
int methodsFrom(std::string_view code, std::size_t begin) {
  int methods = 0, depth = 1;
  std::string statement;
  for (std::size_t n = begin; n < code.size() && depth > 0; ++n) {
    const char c = code[n];
    if (c == '{') {
      if (depth++ == 1) methods += opensBody(statement) ? 1 : 0;
    } else if (c == '}') {
      if (--depth == 1) statement.clear();
    } else if (depth == 1 && c == ';') {
      methods += declaresMethod(statement) ? 1 : 0;
      statement.clear();
    } else if (depth == 1) {
      statement += c;
    }
  }
  return methods;
}

/// Every class of a header with its methods.
std::map<std::string, int> methodsOfClasses(const std::string& code) {
  static const std::regex head(R"(\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^:;{][^;{]*)?\{)");
  std::map<std::string, int> found;
  for (std::sregex_iterator each(code.begin(), code.end(), head), end; each != end; ++each)
    found[(*each)[1]] = methodsFrom(code, static_cast<std::size_t>(each->position() + each->length()));
  return found;
}

TEST(ClassSize, CountsWhatAClassDeclares) {
  const auto found = methodsOfClasses(R"(
    class Small final : public Base {
     public:
      explicit Small(int size = 3) : size_(size) {}
      ~Small() override;
      [[nodiscard]] int size() const { return size_; }
      virtual bool isThere(const std::vector<int>& of) const = 0;
      Small& operator=(const Small&) = delete;
     Q_SIGNALS:
      void changed();
     private:
      struct Inner { void of(); int at = 0; };
      enum class Kind { one, two };
      friend class Other;
      std::function<void(int)> told_;
      int size_{0}, more_ = std::max(1, 2);
    };)");
  EXPECT_EQ(found.at("Small"), 6);
  EXPECT_EQ(found.at("Inner"), 1);
}

TEST(ClassSize, IsAtMostSixtyMethods) {
  // What is larger may only shrink: the number is what it has.
  const std::map<std::string, int> larger;
  std::string tooLarge;
  std::map<std::string, int> sizes;
  for (const Source& source : sources()) {
    if (!source.path.ends_with(".h")) continue;
    for (const auto& [name, methods] : methodsOfClasses(codeOf(source))) {
      sizes[name] = std::max(sizes[name], methods);
      const auto known = larger.find(name);
      if (methods > (known != larger.end() ? known->second : kMostMethods))
        tooLarge += source.path + ": " + name + " has " + std::to_string(methods) + " methods; give its topics to objects of their own.\n";
    }
  }
  EXPECT_EQ(tooLarge, "");
  for (const auto& [name, methods] : larger) EXPECT_EQ(sizes[name], methods) << name << " shrank: write its new number down here";
  EXPECT_GT(sizes["MainWindow"], 20) << "nothing is counted";
}

TEST(ClassSize, OnePlaceAsksForTheNameOfAFileToSave) {
  EXPECT_EQ(brokenBy([](const Source& source) { return matchesOf(source, R"(getSaveFileName|AcceptSave)"); },
                     {{"workstation/widgets/src/save_file.cpp", "It is the place."}}, "Use askSaveFile() of ew/widgets/save_file.h."),
            "");
}

TEST(ClassSize, OnePlaceKnowsWhatTheStyleSheetCallsALook) {
  // In the text as it is written: codeOf() blanks what stands between quotation marks.
  const std::regex hook(
      R"re(setProperty\("(heading|quiet|small|primary|compact|flat|fold|listed|segment|onScan|panels|edge|workspace)")re");
  EXPECT_TRUE(std::regex_search(R"(hint->setProperty("quiet", true);)", hook));
  const auto hooksOf = [&](const Source& source) {
    std::vector<Offence> found;
    std::istringstream lines(source.text);
    int number = 0;
    for (std::string line; std::getline(lines, line);)
      if (++number; std::regex_search(line, hook)) found.push_back({source.path, number, line});
    return found;
  };
  EXPECT_EQ(brokenBy(hooksOf, {}, "Use setLook() of ew/widgets/look.h."), "");
}

}  // namespace
}  // namespace ew::rules::class_size_test
