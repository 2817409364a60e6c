#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case.h"
#include "ew/library/checksums.h"

namespace ew {

/// That a manifest names no hidden file of the folder: filesOfCase leaves those out. @error badField
[[nodiscard]] Result<void> checkNothingHiddenIsNeeded(const nlohmann::json& manifest, const std::filesystem::path& folder);

/// What of a case's files is missing, changed or more than was kept: a sentence each, with its "file".
[[nodiscard]] std::vector<Error> differencesOf(const std::vector<FileSum>& kept, const std::vector<FileSum>& found);

/// A case that is to leave its folder: opened and checked, with every file that belongs to it.
struct CaseToHandOn {
  Case opened;
  std::vector<FileSum> files;
};
/// @error as loadCase and sumsOfCase; badField (a published revision that is not as its sums say: the first file that differs, and in the
///        context "problems" how many)
[[nodiscard]] Result<CaseToHandOn> caseToHandOn(const std::filesystem::path& folder, Progress& progress);

}  // namespace ew
