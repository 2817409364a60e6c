#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew {

// What instructors change is written down: LIBRARY/assessment/changes.jsonl, a line of JSON for each change, only ever appended to.

/// What LIBRARY/assessment is for: instructors' files, mode 0700.
[[nodiscard]] std::filesystem::path assessmentFolder(const std::filesystem::path& library);
[[nodiscard]] std::filesystem::path instructorLogFile(const std::filesystem::path& library);

struct InstructorChange {
  std::chrono::sys_seconds at{};
  std::string who;   ///< the account, and the name its person gives, when there is one: "anna (Anna Quill)"
  std::string what;  ///< a word of the program's: "locked", "unlocked", "wrong passphrase", "key made", "examination made", "pass level" …
  std::string of;    ///< what was changed: "knee/first-look/widest"
  nlohmann::json before, after;  ///< null: there was nothing, there is nothing
  bool operator==(const InstructorChange&) const = default;
};

/// The account that the program runs as, with the name its person gives.
[[nodiscard]] std::string accountName(const std::string& person = {});

/// Appends a line, whole or not at all, on the medium before this returns; of several programs at once each line is whole.
/// @error notWritable: then whatever was to be changed is better left as it is
[[nodiscard]] Result<void> logChange(const std::filesystem::path& library, const InstructorChange& change);
/// The same, made of what is known here: now, and this account.
[[nodiscard]] Result<void> logChange(const std::filesystem::path& library, const std::string& what, const std::string& of = {},
                                     nlohmann::json before = {}, nlohmann::json after = {}, const std::string& person = {});

struct InstructorLog {
  std::vector<InstructorChange> changes;  ///< in the order they were written
  std::size_t damaged = 0;                ///< lines that cannot be read: torn by a crash, or edited
};
/// A log that is not there holds nothing. @error notReadable, tooLarge
[[nodiscard]] Result<InstructorLog> readInstructorLog(const std::filesystem::path& library);

}  // namespace ew
