#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "ew/core/result.h"

namespace ew {

/// Writes a file so that it is either complete or untouched: into a neighbour first, synced, then renamed over the target.
/// @error notWritable with the reason and the path
[[nodiscard]] Result<void> writeFileSafely(const std::filesystem::path& file, const std::function<Result<void>(std::ostream&)>& write);
[[nodiscard]] Result<void> writeFileSafely(const std::filesystem::path& file, std::string_view text);

/// @error notFound, notReadable, tooLarge (more than maxBytes)
[[nodiscard]] Result<std::string> readTextFile(const std::filesystem::path& file, std::size_t maxBytes = 64u << 20);

}  // namespace ew
