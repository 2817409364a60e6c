#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew {

// What the files of a case's folder are for, and how those leave it that nothing uses: whatever lies there is published and exported with
// the case.

/// One file of a case's folder.
struct CaseFileUse {
  std::string path;  ///< relative to the folder, as filesOfCase has it
  std::uint64_t size_bytes = 0;
  std::vector<Message> usedBy;        ///< "its volume", "the lesson 'First'", "the link 'media/a.png'"; empty: by nothing
  std::vector<std::string> linkedBy;  ///< links of the folder that lead to it, sorted, when `usedBy` is these alone; else none
};

/// Every file of the folder (filesOfCase), sorted by path. A file counts as used when the case or its lessons name it, also by way of
/// another one (samples beside a header, a link), when the case as it was saved last does, when any text of the manifest is its path, when
/// a link of the folder leads to it, and when nobody can tell: words, documents named README, LICENSE, SOURCE and the like, a recipe's
/// JSON, parts of plugins, lessons that cannot be read. Any other .txt or .md is used by nothing.
/// @param opened with its folder, and with edits that are not saved yet
/// @error as filesOfCase; as readJsonFile and caseFromManifest for what was saved last
[[nodiscard]] Result<std::vector<CaseFileUse>> fileUsesOf(const Case& opened);

/// Those that nothing of the case uses as it is now; sorted. None when the folder cannot be read.
[[nodiscard]] std::vector<std::string> unusedFiles(const Case& opened);

/// Files that were taken out of a case together.
struct WithdrawnFiles {
  std::filesystem::path caseFolder;
  std::filesystem::path folder;    ///< where they lie, each with its path: CASE/.withdrawn/STAMP
  std::vector<std::string> paths;  ///< sorted
};

/// Who edits the case's folder while files are taken out: nobody, or the caller, who holds its lease.
enum class CaseEditor { nobody, caller };

/// Takes files out of a case that nothing uses, so that they are no longer handed on: all or none. A link is no use of a file when it is
/// taken out with it. They are moved to kWithdrawnFiles; moved back, they are there again (putBack).
/// @param paths as in fileUsesOf
/// @error notWritable (a shipped or published case, an examination, somebody edits it, a file cannot be moved, kWithdrawnFiles is a link or
///        a file), notFound, badUsage (in use: the sentence says by what); as fileUsesOf. Then everything is where it was
[[nodiscard]] Result<WithdrawnFiles> withdrawFiles(const Case& opened, const std::vector<std::string>& paths, CaseEditor editor);
/// @error notWritable (another file has the place, or a file cannot be moved): then everything is where it was
[[nodiscard]] Result<void> putBack(const WithdrawnFiles& taken);
/// Of files that were taken out, those that a published revision of the case holds all the same: their content, under any name.
/// @return revision by revision, the lowest first, with the files as they were called in the case; revisions that hold none are left out
[[nodiscard]] std::vector<std::pair<int, std::vector<std::string>>> stillPublished(const WithdrawnFiles& taken, const std::string& caseId,
                                                                                   const std::filesystem::path& library);
/// What was taken out and lies aside, the latest first.
[[nodiscard]] std::vector<WithdrawnFiles> withdrawnFilesOf(const std::filesystem::path& caseFolder);

}  // namespace ew
