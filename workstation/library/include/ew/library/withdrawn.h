#pragma once

#include <filesystem>
#include <string>

#include "ew/core/result.h"

namespace ew {

/// Where cases lie that were taken out of a library: LIBRARY/withdrawn/STAMP-NAME. Nothing reads it; nothing in it is ever removed here.
[[nodiscard]] std::filesystem::path withdrawnFolder(const std::filesystem::path& library);

/// A case that was taken out of a library.
struct WithdrawnCase {
  std::string id;                ///< of the case; of an own one that cannot be opened, its folder's name
  std::filesystem::path from;    ///< where it lay; moved back to there, it is there again
  std::filesystem::path folder;  ///< where it lies now
};

/// Takes a case out of a library, so that nobody sees it any more: a folder of the author's own (cases/FOLDER), or every revision of a
/// published one. It is moved, in one step, and moving it back brings it back; what trainees did with it stays, and so do the numbers of
/// its revisions, which no other revision gets. Written into the instructors' log: what cannot be written down is not done.
/// @param caseFolder of an own case, of a published one (published/CASE-ID), or of any revision of it, in `library`
/// @param person     whom the window greets; empty on the command line
/// @error badUsage (a shipped case, or one that lies elsewhere: the sentence says where), notFound, notWritable (somebody edits it; the
///        folder cannot be moved, or the log not be written): then everything is where it was
[[nodiscard]] Result<WithdrawnCase> withdrawCase(const std::filesystem::path& caseFolder, const std::filesystem::path& library,
                                                 const std::string& person = {});

/// The folder that an id means to withdrawCase: the author's own case, else the published one, else the shipped one (as findCase), also
/// when it cannot be opened or no revision is complete.
/// @error badUsage (cases of the library share the id: the sentence names their folders), notFound
[[nodiscard]] Result<std::filesystem::path> caseToWithdraw(const std::string& id, const std::filesystem::path& library);

}  // namespace ew
