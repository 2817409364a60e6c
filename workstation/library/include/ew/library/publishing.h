#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "ew/tracking/hand.h"

namespace ew {

/// One line of the list an author goes through before a case is published.
struct CheckItem {
  enum class State { missing, warning, done };
  Message what;  ///< a sentence: what is there, or what to do
  State state = State::done;
  /// Of case.json, to which a click leads: "indication", "volume.file", "targets[2]", "parts.lessons". "files": the files of its folder;
  /// "sealed": an examination
  std::string field;
  bool operator==(const CheckItem&) const = default;
};

/// What the list is made from beside the case; whatever is missing is read, or its lines are left out.
struct CheckSources {
  CaseById caseById = {};                     ///< for lessons that scan other cases
  std::shared_ptr<const Skin> skin = {};      ///< of the mannequin; null: read from its recipe
  std::shared_ptr<const Volume> volume = {};  ///< of a case with a file, in its own file's frame; null: read
};

/// What a case has and lacks before it can be handed to trainees, in the order of the form; lines that need a volume or a skin that
/// cannot be read say so. Reads the volume's file. Of an examination one line: that it is published as it was made.
/// @param opened with its folder
/// @error cancelled
[[nodiscard]] Result<std::vector<CheckItem>> publishingList(const Case& opened, const CheckSources& sources = {},
                                                            Progress& progress = noProgress());

/// Those of the list that keep a case from being published, found without reading a volume: what publishCase asks.
[[nodiscard]] std::vector<CheckItem> missingForPublishing(const Case& opened, const CaseById& caseById = {});

[[nodiscard]] std::size_t countOf(const std::vector<CheckItem>& list, CheckItem::State state);

}  // namespace ew
