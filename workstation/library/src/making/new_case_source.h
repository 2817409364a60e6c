#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/new_case.h"

namespace ew {

/// A source as it lies in a case folder.
struct SourceInCase {
  std::string file;    ///< "volumes/….mha"
  std::string level;   ///< the same of its level; empty: none was wanted
  std::string images;  ///< the same of the recorded images; empty: none were wanted
  std::optional<SweepAxes> axes = {};
  bool assumesAxes = false;  ///< nobody said them; a note tells what was taken
  PlacingShape shape = {};
  std::optional<SweepCounts> frames = {};
  std::vector<Message> notes = {};
};

/// Makes a volume and its level of a source and puts both into a case folder.
/// @param scratch a folder for what is only needed meanwhile; made when it is needed, left to the caller
/// @param source not monostate
/// @error as makeCase
[[nodiscard]] Result<SourceInCase> putSource(const CaseSource& source, bool makesLevel, const std::filesystem::path& caseFolder,
                                             const std::filesystem::path& scratch, Progress& progress);

/// What putSource will take. @error as putSource, as far as it goes
[[nodiscard]] Result<NewCasePlan> planSource(const CaseSource& source, bool makesLevel, Progress& progress);

/// Where a volume comes to lie when nobody says: at the usual place of a region.
/// @return the identity and a note where the mannequin has no named places or no skin
struct DefaultPlacement {
  Transform<frame::World, frame::File> fileToWorld = {};
  std::optional<Contact> contact = {};
  std::vector<Message> notes = {};
};
[[nodiscard]] DefaultPlacement choosePlace(const PlacingShape& shape, const std::string& mannequin, const std::filesystem::path& caseFolder,
                                           const std::string& region, const std::optional<Transform<frame::World, frame::File>>& given);

}  // namespace ew
