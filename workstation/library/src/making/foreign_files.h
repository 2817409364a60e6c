#pragma once

#include <filesystem>
#include <optional>

#include "ew/core/result.h"

namespace ew {

/// Why a file that no reader knows holds no samples that could be read without a header: another program's kind of file by its ending or
/// its first bytes, with what to make of it; a text; nothing or next to nothing. Empty: samples may be in it.
/// @error of the value: unsupported, truncated (it is empty), notReadable (it cannot be opened)
[[nodiscard]] std::optional<Error> whyNoSamples(const std::filesystem::path& file);

}  // namespace ew
