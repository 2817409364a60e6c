#pragma once

#include <filesystem>

#include "ew/core/result.h"

namespace ew {

/// Why a file could not be opened for reading, and what to do about it: ErrorCode::notReadable.
/// @param number errno of the attempt; 0: the system did not say
[[nodiscard]] tl::unexpected<Error> notOpened(const std::filesystem::path& file, int number);

/// Why a folder could not be listed: ErrorCode::notReadable. @param number as notOpened
[[nodiscard]] tl::unexpected<Error> notListed(const std::filesystem::path& folder, int number);

/// Why a file could not be written: ErrorCode::notWritable.
/// @param reason in words, for the brackets of a sentence
[[nodiscard]] tl::unexpected<Error> notWritable(const std::filesystem::path& file, Message reason);
/// @param number errno of the attempt
[[nodiscard]] tl::unexpected<Error> notWritable(const std::filesystem::path& file, int number);

}  // namespace ew
