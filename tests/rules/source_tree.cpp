#include "rules/source_tree.h"
#include "places.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

namespace ew::rules {
namespace {

namespace fs = std::filesystem;

std::vector<Source> readTree() {
  std::vector<Source> read;
  const fs::path top = EW_SOURCE_DIR;
  for (const char* home : {"workstation", "plugins"})
    for (const auto& entry : fs::recursive_directory_iterator(top / home)) {
      const fs::path& file = entry.path();
      if (!entry.is_regular_file() || (file.extension() != ".cpp" && file.extension() != ".h")) continue;
      std::ifstream in(file, std::ios::binary);
      read.push_back({fs::relative(file, top).generic_string(), {std::istreambuf_iterator<char>(in), {}}});
    }
  std::ranges::sort(read, {}, &Source::path);
  return read;
}

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Blanks what the language does not run.
class Blanking {
 public:
  explicit Blanking(std::string_view text) : text_(text), made_(text) {}

  std::string done() {
    while (at_ < text_.size()) {
      if (begins("//"))
        blankTo(text_.find('\n', at_));
      else if (begins("/*"))
        blankTo(after("*/", at_ + 2));
      else if (begins("R\"") && (at_ == 0 || !isWord(text_[at_ - 1])))
        rawText();
      else if (text_[at_] == '"' || (text_[at_] == '\'' && (at_ == 0 || !isWord(text_[at_ - 1]))))  // 10'000 is a number
        quotedText(text_[at_]);
      else
        ++at_;
    }
    return made_;
  }

 private:
  [[nodiscard]] bool begins(std::string_view with) const { return text_.substr(at_, with.size()) == with; }
  [[nodiscard]] std::size_t after(std::string_view what, std::size_t from) const {
    const std::size_t found = text_.find(what, from);
    return found == std::string_view::npos ? found : found + what.size();
  }
  void blankTo(std::size_t end) {
    for (end = std::min(end, text_.size()); at_ < end; ++at_)
      if (text_[at_] != '\n') made_[at_] = ' ';
  }
  void rawText() {
    const std::size_t open = text_.find('(', at_);
    if (open == std::string_view::npos) return blankTo(open);
    const std::string close = ")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"";
    const std::size_t end = std::min(after(close, open), text_.size());
    at_ += 2;  // R"
    blankTo(end - 1);
    at_ = end;
  }
  void quotedText(char mark) {
    for (++at_; at_ < text_.size() && text_[at_] != mark && text_[at_] != '\n'; ++at_) {
      const bool isEscape = text_[at_] == '\\';
      made_[at_] = ' ';
      if (isEscape && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') made_[++at_] = ' ';
    }
    ++at_;
  }

  std::string_view text_;
  std::string made_;
  std::size_t at_ = 0;
};

std::string trimmed(std::string_view line) {
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.front())) != 0) line.remove_prefix(1);
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.remove_suffix(1);
  return std::string(line);
}

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

bool covers(const Exception& exception, const std::string& path) {
  const bool isBegin = exception.path.ends_with('/') || exception.path.ends_with('_');
  return isBegin ? path.starts_with(exception.path) : path == exception.path;
}

}  // namespace

const std::vector<Source>& sources() {
  static const std::vector<Source> tree = readTree();
  return tree;
}

std::string codeOf(std::string_view text) { return Blanking(text).done(); }

const std::string& codeOf(const Source& source) {
  static std::map<const char*, std::string> known;  // of the tree, which stays; a source made for a test is read anew
  const bool isOfTree = !sources().empty() && &source >= &sources().front() && &source <= &sources().back();
  static std::string made;
  if (!isOfTree) return made = codeOf(source.text);
  const auto [at, isNew] = known.try_emplace(source.text.data());
  if (isNew) at->second = codeOf(source.text);
  return at->second;
}

std::vector<Offence> matchesOf(const Source& source, const std::string& expression) {
  static std::map<std::string, std::regex> expressions;
  const auto [at, isNew] = expressions.try_emplace(expression);
  if (isNew) at->second = std::regex(expression, std::regex::ECMAScript | std::regex::optimize);
  const std::regex& wanted = at->second;
  const std::string& code = codeOf(source);
  const auto lines = linesOf(code), asWritten = linesOf(source.text);
  std::vector<Offence> found;
  for (std::size_t n = 0; n < lines.size(); ++n)
    if (std::regex_search(lines[n].begin(), lines[n].end(), wanted))
      found.push_back({source.path, static_cast<int>(n) + 1, trimmed(asWritten[n])});
  return found;
}

std::string brokenBy(const Rule& rule, const std::vector<Exception>& exceptions, const std::string& instead) {
  std::string said;
  std::vector<bool> isNeeded(exceptions.size(), false);
  for (const Source& source : sources())
    for (const Offence& offence : rule(source)) {
      const auto exception = std::ranges::find_if(exceptions, [&](const Exception& each) { return covers(each, source.path); });
      if (exception != exceptions.end())
        isNeeded[static_cast<std::size_t>(exception - exceptions.begin())] = true;
      else
        said += offence.path + ":" + std::to_string(offence.line) + ": " + offence.what + "\n";
    }
  if (!said.empty()) said += "Instead: " + instead + "\n";
  for (std::size_t n = 0; n < exceptions.size(); ++n)
    if (!isNeeded[n]) said += exceptions[n].path + " needs its exception no longer; take it out of the rule.\n";
  return said;
}

}  // namespace ew::rules
