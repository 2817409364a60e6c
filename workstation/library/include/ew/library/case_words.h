#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>

#include "ew/library/case.h"
#include "ew/library/lesson.h"

namespace ew {

/// The texts of a case and its lessons in another language: words/LANGUAGE.json in the case folder, which says for a text what stands in
/// its place, {"format": 1, "words": {"Liver": "Leber"}}. By the text itself, so that nothing has to be numbered and a text that was
/// changed is shown as it is rather than with a translation of what it said before.
class CaseWords {
 public:
  CaseWords() = default;
  explicit CaseWords(std::unordered_map<std::string, std::string> words) : words_(std::move(words)) {}
  /// The text in the language, or as it is.
  [[nodiscard]] const std::string& of(const std::string& text) const;
  [[nodiscard]] bool has(const std::string& text) const { return words_.count(text) > 0; }
  [[nodiscard]] bool empty() const { return words_.empty(); }
  [[nodiscard]] std::size_t size() const { return words_.size(); }

 private:
  std::unordered_map<std::string, std::string> words_;
};

/// @param language as in a locale: "de", or "de_AT", of which "de" is tried when the whole is not there
/// @return without words when the case has none in that language, or in no form that can be read: whoever only reads a case is not stopped
[[nodiscard]] CaseWords wordsOf(const std::filesystem::path& caseFolder, const std::string& language);
/// @error notFound, badHeader, badField, newerFormat
[[nodiscard]] Result<CaseWords> readCaseWords(const std::filesystem::path& file);
/// Writes what stands in place of a text into words/LANGUAGE.json of a case, whole or not at all; everything else in the file stays. An
/// empty translation takes it away. Words of texts that the case has no longer stay, too: undo may bring the text back.
/// @error badUsage (not a language), as readCaseWords but for notFound, notWritable
[[nodiscard]] Result<void> setCaseWord(const std::filesystem::path& caseFolder, const std::string& language, const std::string& text,
                                       const std::string& translation);

/// What people read, in the language; names by which things refer to each other (of targets and measurements) stay.
[[nodiscard]] Case translated(Case shown, const CaseWords& words);
[[nodiscard]] Lesson translated(Lesson shown, const CaseWords& words);

/// Every text of a case and its lessons that a trainee may read, once each: what a translation has to hold.
[[nodiscard]] std::vector<std::string> textsOf(const Case& shown, const std::vector<Lesson>& lessons);

}  // namespace ew
