#pragma once

#include <filesystem>

#include "ew/core/result.h"

namespace ew {

/// Where cases lie that were taken out of a library: LIBRARY/withdrawn/STAMP-NAME. Nothing reads it; nothing in it is ever removed here.
[[nodiscard]] std::filesystem::path withdrawnFolder(const std::filesystem::path& library);

/// Takes a case out of a library, so that nobody sees it any more: a folder of the author's own (cases/FOLDER), or every revision of a
/// published one. It is moved, in one step, and moving it back brings it back; what trainees did with it stays.
/// @param caseFolder of an own case, or of any revision of a published one, in `library`
/// @return where it lies now
/// @error badUsage (a shipped case, or one that lies elsewhere: the sentence says where), notFound, notWritable (somebody edits it; the
///        folder cannot be moved)
[[nodiscard]] Result<std::filesystem::path> withdrawCase(const std::filesystem::path& caseFolder, const std::filesystem::path& library);

}  // namespace ew
