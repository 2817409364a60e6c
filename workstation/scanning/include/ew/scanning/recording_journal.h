#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "ew/scanning/recording.h"

namespace ew {

// A recording while it grows: a text file of one JSON object a line, to which lines are added, so that a crash leaves all but the line it
// fell into. The first says what is scanned ({"recording": 1, "case", "title", "size_px"}), each other one what happened, in its order.

/// The first line, with its end. Case, title and size of the images are those of `recording`; its log is not looked at.
[[nodiscard]] std::string journalHead(const ScanRecording& recording);
/// A line for each event from the n-th on.
[[nodiscard]] std::string journalLines(const ScanLog& log, std::size_t from);

/// What is whole of a journal: readJournal of head and lines gives the recording again, to the bit. A last line without its end is left
/// out; a line in the middle that cannot be read ends it, with a note.
/// @error notFound, notReadable, tooLarge (1 GiB), badHeader (no journal), badField, newerFormat, truncated (it ends before the first
/// frame, so nothing is in it)
[[nodiscard]] Result<ScanRecording> readJournal(const std::filesystem::path& file);
/// The same of a text. @param where how sentences name it
[[nodiscard]] Result<ScanRecording> recordingFromJournal(std::string_view text, const Message& where);

}  // namespace ew
