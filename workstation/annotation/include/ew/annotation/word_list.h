#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"

namespace ew::annotation {

inline constexpr int kWordListFormat = 1;  ///< `format` of a word list; a file with a larger one is refused with newerFormat

/// What a console offers to be put on an image: "RT KIDNEY", as people write it there, in capitals.
struct Term {
  Words text;
  Words meaning;  ///< of an abbreviation: "longitudinal"; empty: the text says it
  bool operator==(const Term&) const = default;
};

struct TermGroup {
  Words title;
  std::vector<Term> terms;
  bool operator==(const TermGroup&) const = default;
};

/// The words of one region of the body: resources/annotations/*.json, resources/schemas/annotation.schema.json.
struct WordList {
  std::string id;  ///< file name without ending: "abdomen"
  Words title;
  std::vector<std::string> regions;  ///< of cases (Case::region) it is for; empty: it goes with every list ("common")
  std::string source;                ///< where the words come from
  std::vector<TermGroup> groups;
  bool operator==(const WordList&) const = default;
};

/// @param where how sentences name the document
/// @error badField (also a term that its list has already, in the same language), newerFormat
[[nodiscard]] Result<WordList> wordListFromJson(const nlohmann::json& document, const std::string& id, const Message& where);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as wordListFromJson
[[nodiscard]] Result<WordList> readWordList(const std::filesystem::path& file);
/// Every list of a folder, by id; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<WordList>> readWordLists(const std::filesystem::path& folder);

/// The list of that id, or else of that region of a case; null when there is none.
[[nodiscard]] const WordList* wordListOf(const std::vector<WordList>& lists, std::string_view region);

/// What may be written on an image, each once: the words of its list, then those that go with every list; without a list of its own the
/// words of all lists.
/// @param region of the case, or the id of a list
/// @param language "de" or "de_DE": German; else English
[[nodiscard]] std::vector<std::string> termsFor(const std::vector<WordList>& lists, std::string_view region, std::string_view language);

/// How a text that is being typed may go on: its last words, where they begin a term, replaced by the term. "RT KID" gives "RT KIDNEY",
/// also "rt kid"; what was typed before stays as it is. The longest beginning counts first, then the order of the terms. Nothing for an
/// empty text, one that ends with a blank, and one that says the term already.
[[nodiscard]] std::vector<std::string> completionsOf(std::string_view typed, const std::vector<std::string>& terms, std::size_t most = 8);

}  // namespace ew::annotation
