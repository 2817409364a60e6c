#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

// A library is a folder:
//   cases/FOLDER/                   the author's own cases, which are edited
//   published/CASE-ID/REVISION/     copies that never change again, each with sums.json; trainees see the highest complete one
//   published/.numbers/CASE-ID/     numbers of revisions that were withdrawn, an empty file each: no other revision gets them
//   attempts/ATTEMPT-ID/            what trainees did (attempt.h)
// Where it is: libraryFolder() (case.h).

[[nodiscard]] std::filesystem::path publishedFolder(const std::filesystem::path& library);

/// One revision of a case.
struct CaseRevision {
  std::string id;
  int revision = 0;  ///< from 1; the name of its folder
  std::filesystem::path folder;
  bool wasThere = false;  ///< of publishing and importing: this very content was published before, and nothing was done
  bool operator==(const CaseRevision&) const = default;
};

/// Makes the next revision of a case: a complete copy of what belongs to it (filesOfCase) with its sums, made aside, on the medium before
/// it gets its name. A program killed at any moment leaves the revisions that were there, and aside what the next one takes away. A volume
/// that the latest revision has, too, shares its room on the medium where there are hard links.
/// @return that revision; or, when the case is as the latest one has it, the latest, with wasThere
/// @error as loadCase and sumsOfCase; badField (missingForPublishing finds something: the first of it, and in the context "missing" how
///        many); notWritable, cancelled (then nothing is there that was not before)
[[nodiscard]] Result<CaseRevision> publishCase(const std::filesystem::path& caseFolder, const std::filesystem::path& library,
                                               Progress& progress = noProgress());

/// The latest revision, when it holds what the case folder holds now.
/// @error as loadCase and sumsOfCase; cancelled (within 0.5 s)
[[nodiscard]] Result<std::optional<CaseRevision>> publishedAsItIs(const std::filesystem::path& caseFolder,
                                                                  const std::filesystem::path& library, Progress& progress = noProgress());

/// The complete revisions of a case, the lowest first. Complete: sums.json can be read, and every file it names is there with its size
/// (verifyCase reads them, too).
[[nodiscard]] std::vector<CaseRevision> publishedRevisions(const std::filesystem::path& library, const std::string& id);
/// Every revision that is there, the lowest first, also those that are no longer complete. An empty folder is none.
[[nodiscard]] std::vector<CaseRevision> takenPublished(const std::filesystem::path& library, const std::string& id);
/// The highest that is complete.
[[nodiscard]] std::optional<CaseRevision> latestPublished(const std::filesystem::path& library, const std::string& id);
/// The highest complete revision of every case, by id. Takes away what killed programs left behind.
[[nodiscard]] std::vector<CaseRevision> listPublished(const std::filesystem::path& library);

/// Whether a folder is a revision, or lies in one, of any library: it is not edited in place; to edit it, save it as a case of your own.
[[nodiscard]] bool isPublished(const std::filesystem::path& folder);

}  // namespace ew
