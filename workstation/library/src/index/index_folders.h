#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/library/index.h"

namespace ew {

/// A case folder as a look at it from outside shows it: nothing was read.
struct CaseFolder {
  std::filesystem::path folder;
  LibraryKind kind = LibraryKind::own;
  int revision = 0;
  std::string stamp;  ///< of what the index reads of it; another stamp: something has changed
};

struct CaseFolders {
  std::vector<CaseFolder> cases;      ///< sorted by the bytes of the folder, each once
  std::vector<CaseProblem> problems;  ///< roots that are there and cannot be listed
};

/// @param language whose words files count for the stamps
[[nodiscard]] CaseFolders findCases(const std::vector<LibraryRoot>& roots, const std::string& language);

/// Times of files are coarse: what was written a moment ago may be written again without another stamp.
/// @return whether the manifest was written so long before `now` that its stamp tells any later change
[[nodiscard]] bool isSettled(const std::filesystem::path& caseFolder, const std::string& language,
                             std::chrono::system_clock::time_point now);

}  // namespace ew
