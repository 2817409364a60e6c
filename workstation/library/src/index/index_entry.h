#pragma once

#include <optional>
#include <string>

#include "ew/library/index.h"

namespace ew {

/// A case as the index stores it.
struct IndexEntry {
  CaseRow row;                     ///< without number; of a case that cannot be read the folder alone
  std::string openText;            ///< what a trainee may read, to be searched
  std::string closedText;          ///< what authors search as well: it gives answers away
  std::optional<Message> problem;  ///< why the case cannot be read
};

/// Reads what the index wants of a case.json and its words, and nothing else: no file that it names is looked for, and a field of a wrong
/// kind counts as not there. Whether the case is right is said when it is opened (loadCase) or checked.
/// A problem: no JSON, no id or title, written by a newer program.
[[nodiscard]] IndexEntry readIndexEntry(const std::filesystem::path& caseFolder, LibraryKind kind, int revision,
                                        const std::string& language);

/// A text for searching: sharp s written as it is sorted. Both what is stored and what is asked for go through it.
[[nodiscard]] std::string searchable(std::string text);

/// By which titles are sorted: small letters, those of Western Europe without their accents.
[[nodiscard]] std::string sortKey(const std::string& title);

}  // namespace ew
