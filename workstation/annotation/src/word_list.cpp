#include "ew/annotation/word_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "kept_limits.h"
#include "utf8.h"

namespace ew::annotation {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestTerm = 40, kLongestSource = 600;
constexpr std::size_t kMostGroups = 40, kMostTerms = 200;

bool isOneLine(const std::string& text) { return oneLine(text, kLongestTerm) == text; }

/// The terms of one list, so that none stands in it twice.
struct Known {
  std::set<std::string> english, german;
};

Term termIn(const JsonFields& fields, Known& known) {
  fields.only({"en", "de", "means"});
  Term term;
  const Message expected = say<"one line of 1 to %1 bytes that no other term of the list says">(kLongestTerm);
  const auto textIn = [&](std::string_view key, std::set<std::string>& others) {
    std::string text = fields.text(key, {}, 1, kLongestTerm, expected);
    if (fields.good() && (!isOneLine(text) || !others.insert(smallLetters(text)).second)) fields.refuse(key, expected);
    return text;
  };
  term.text.english = textIn("en", known.english);
  term.text.german = textIn("de", known.german);
  term.meaning = wordsIn(fields, "means", kLongestTitle, false);
  return term;
}

}  // namespace

Result<WordList> wordListFromJson(const json& document, const std::string& id, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kWordListFormat);
  fields.only({"format", "title", "regions", "source", "groups"});
  WordList list;
  list.id = id;
  list.title = wordsIn(fields, "title", kLongestTitle);
  list.regions = fields.texts("regions", 0, kMostRegions);
  list.source = fields.text("source", {}, 1, kLongestSource);
  Known known;
  for (const JsonFields& each : fields.objects("groups", 1, kMostGroups)) {
    each.only({"title", "terms"});
    TermGroup group;
    group.title = wordsIn(each, "title", kLongestTitle);
    for (const JsonFields& term : each.objects("terms", 1, kMostTerms)) group.terms.push_back(termIn(term, known));
    list.groups.push_back(std::move(group));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return list;
}

Result<WordList> readWordList(const std::filesystem::path& file) {
  const Message where = say<"the word list %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return wordListFromJson(*document, file.stem().string(), where);
}

Result<std::vector<WordList>> readWordLists(const std::filesystem::path& folder) {
  return readEvery<WordList>(folder, say<"word lists">(), readWordList);
}

const WordList* wordListOf(const std::vector<WordList>& lists, std::string_view region) {
  const auto first = [&](auto&& isFor) {
    const auto found = std::find_if(lists.begin(), lists.end(), isFor);
    return found == lists.end() ? nullptr : &*found;
  };
  const WordList* named = first([&](const WordList& list) { return list.id == region; });
  if (named != nullptr) return named;
  return first([&](const WordList& list) { return std::find(list.regions.begin(), list.regions.end(), region) != list.regions.end(); });
}

std::vector<std::string> termsFor(const std::vector<WordList>& lists, std::string_view region, std::string_view language) {
  std::vector<std::string> terms;
  std::set<std::string> said;
  const auto add = [&](const WordList& list) {
    for (const TermGroup& group : list.groups)
      for (const Term& term : group.terms)
        if (const std::string& text = term.text.in(language); said.insert(text).second) terms.push_back(text);
  };
  const WordList* own = wordListOf(lists, region);
  if (own != nullptr) add(*own);
  for (const WordList& list : lists)
    if (own == nullptr || list.regions.empty()) add(list);
  return terms;
}

std::vector<std::string> completionsOf(std::string_view typed, const std::vector<std::string>& terms, std::size_t most) {
  std::vector<std::string> completions;
  if (typed.empty() || typed.ends_with(' ')) return completions;
  const std::string small = smallLetters(typed);
  // From the first word on to the last one alone: the longest beginning first.
  for (std::size_t from = 0; from < small.size();) {
    const std::string_view begun = std::string_view(small).substr(from);
    for (const std::string& term : terms) {
      if (completions.size() >= most) return completions;
      if (term.size() <= begun.size() || !smallLetters(term).starts_with(begun)) continue;
      std::string whole = std::string(typed.substr(0, from)) + term;
      if (std::find(completions.begin(), completions.end(), whole) == completions.end()) completions.push_back(std::move(whole));
    }
    const auto blank = small.find(' ', from);
    if (blank == std::string::npos) break;
    from = small.find_first_not_of(' ', blank);
  }
  return completions;
}

}  // namespace ew::annotation
