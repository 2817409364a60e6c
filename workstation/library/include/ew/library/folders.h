#pragma once

#include <filesystem>
#include <vector>

#include "ew/core/result.h"

namespace ew {

struct Probe;

/// Where the program's own data are: $ECHOWEAVE_RESOURCES, beside the program, the source tree it was built from, or the installed place.
[[nodiscard]] Result<std::filesystem::path> resourceFolder();
/// The probes that come with the program. @error as resourceFolder, readProbes
[[nodiscard]] Result<std::vector<Probe>> shippedProbes();
[[nodiscard]] Result<std::filesystem::path> shippedCasesFolder();
/// Whether a folder is one of the shipped cases', or any other place below them: it belongs to the program, and a new version of the
/// program, or of its sources, replaces what is in it.
[[nodiscard]] bool isShipped(const std::filesystem::path& folder);
/// The user's library (published.h says what is in it): $ECHOWEAVE_LIBRARY, else ~/EchoWeave. It need not be there yet.
[[nodiscard]] std::filesystem::path libraryFolder();
/// Whether something is there that a new case must not be laid into; an empty folder may be.
[[nodiscard]] bool isTaken(const std::filesystem::path& folder);
/// Where a user's own cases are kept unless another folder is chosen: $ECHOWEAVE_CASES, else cases in the library. It need not be there
/// yet.
[[nodiscard]] std::filesystem::path ownCasesFolder();
/// $ECHOWEAVE_CACHE, else $XDG_CACHE_HOME/echoweave, else ~/.cache/echoweave.
[[nodiscard]] std::filesystem::path cacheFolder();

}  // namespace ew
