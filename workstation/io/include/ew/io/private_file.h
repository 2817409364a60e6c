#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "ew/core/result.h"

namespace ew {

// Files that belong to one account of a shared machine. Modes are set, not asked of the umask; links are not followed; what has another
// owner or lets others in is refused rather than trusted.

/// Makes a folder of mode 0700, and those above it that are missing; one that is there and is ours is closed to others.
/// @error notWritable (also: a link, no folder, another account's)
[[nodiscard]] Result<void> makePrivateFolder(const std::filesystem::path& folder);

/// Writes a file of mode 0600, whole or not at all: aside, synced, renamed. A link of that name is replaced, not followed.
/// @error notWritable
[[nodiscard]] Result<void> writePrivateFile(const std::filesystem::path& file, std::string_view text);
/// The same of what `write` puts into the stream; an error of it leaves everything as it was.
[[nodiscard]] Result<void> writePrivateFile(const std::filesystem::path& file, const std::function<Result<void>(std::ostream&)>& write);
/// How a file of writePrivateFile begins until it has its name: one that is found was left by a program that was ended meanwhile.
inline constexpr std::string_view kPrivateAside = ".ew-private-";

/// Reads a file that only its owner, who is the account the program runs as, can read or write.
/// @error notFound, notReadable (a link, no regular file, another account's, a mode wider than 0600: with what to do), tooLarge
[[nodiscard]] Result<std::string> readPrivateFile(const std::filesystem::path& file, std::size_t maxBytes = 1u << 20);

/// Appends to a file of mode 0600, which is made when it is not there, in one write under a lock and synced: of two programs at once each
/// appends whole. A line that an earlier program left without its end is ended first.
/// @param line without its end @error notWritable (also: a link, another account's)
[[nodiscard]] Result<void> appendPrivateLine(const std::filesystem::path& file, std::string_view line);

/// Closes a folder of this account and everything in it to others: folders 0700, files 0600. Links stay as they are and are not followed.
/// @error notWritable
[[nodiscard]] Result<void> closeToOthers(const std::filesystem::path& folder);
/// The same of one file (0600), so far as it can be: links and what another account owns stay as they are.
void closeFileToOthers(const std::filesystem::path& file);

}  // namespace ew
