#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/repetition.h"

namespace ew {

// What is known of one person's exercises, on disk. Each try is added to what the file says at that moment, under a lock and by a file that
// is written whole or not at all: so neither a second window nor a kill loses a try that was kept.

/// LIBRARY/learning/repetition.json, or LIBRARY/learning/NAME/repetition.json of a person with a name, where NAME has letters that every
/// file system takes and is another one for every person.
[[nodiscard]] std::filesystem::path repetitionFile(const std::filesystem::path& library, const std::string& person);

struct RepetitionRecord {
  std::vector<RepetitionState> states;
  std::optional<Message> note;  ///< what a person should know: a file that could not be read was put aside
};

/// Of a file that is not there: nothing. One that cannot be read is put aside under another name in its folder, and `note` says so.
/// @error newerFormat (the file stays as it is, for the program that wrote it), notReadable, notWritable (it cannot be put aside)
[[nodiscard]] Result<RepetitionRecord> readRepetition(const std::filesystem::path& file);

/// Adds a try to the file. @return what it says then. @error as readRepetition, notWritable; then the file is as it was
[[nodiscard]] Result<RepetitionRecord> keepTry(const std::filesystem::path& file, const std::string& exerciseId, int grade,
                                               std::chrono::sys_seconds when);

/// `states` with one try more; its exercise comes to stand last.
[[nodiscard]] std::vector<RepetitionState> withTry(std::vector<RepetitionState> states, const std::string& exerciseId, int grade,
                                                   std::chrono::sys_seconds when);

}  // namespace ew
