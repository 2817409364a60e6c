#pragma once

#include <filesystem>

#include "ew/core/message.h"

namespace ew::door {

/// Why a file cannot be a complete library of this machine, in a few words; empty when it can. The loader trusts a library's headers: one
/// that was cut off maps memory behind the end of the file and kills the program with SIGBUS, which no error code reports.
[[nodiscard]] Message whyNotALibrary(const std::filesystem::path& file);

}  // namespace ew::door
