#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/checksums.h"
#include "ew/library/published.h"

namespace ew {

/// Whether a text can be a case's id, and with it the name of a folder: as case.schema.json has it.
[[nodiscard]] bool isCaseId(std::string_view text);

/// The revision that holds exactly these files, with the sizes they should have; the latest of them.
[[nodiscard]] std::optional<CaseRevision> revisionWith(const std::filesystem::path& library, const std::string& id,
                                                       const std::vector<FileSum>& files);

/// Makes a revision aside and puts it in place when it is whole: sums are written, the case can be opened from there. Takes away what
/// killed programs left. When somebody else took the revision's number meanwhile, it is made again with another one.
/// @param there  whether it is there already; asked again under the lock under which the revision gets its number, so that of two who hand
///               on the same at once one makes a revision and the other finds it
/// @param wanted its number; taken already, or 0: the one after the highest that was ever given
/// @param fill   puts every file into a new folder
/// @error notWritable, of `fill`, as loadCase; then everything is as it was before
[[nodiscard]] Result<CaseRevision> makeRevision(const std::filesystem::path& library, const std::string& id, int wanted,
                                                const std::vector<FileSum>& files,
                                                const std::function<std::optional<CaseRevision>()>& there,
                                                const std::function<Result<void>(const std::filesystem::path&)>& fill);

/// Takes all revisions of a case away, under the lock under which a revision gets its number. Their numbers stay taken, whatever becomes of
/// their folders: attempts name a revision, and must not find another content under it.
/// @param move moves published/ID
/// @error notWritable (then `move` was not called), of `move`
[[nodiscard]] Result<void> takeRevisionsAway(const std::filesystem::path& library, const std::string& id,
                                             const std::function<Result<void>()>& move);

/// The sums of a revision whose files are all there.
[[nodiscard]] std::optional<std::vector<FileSum>> sumsOfComplete(const std::filesystem::path& revision);

}  // namespace ew
