#pragma once

#include <filesystem>

#include "command.h"
#include "ew/core/volume.h"
#include "ew/library/case.h"

namespace ew::cli {

/// How much of a command's progress the reading below takes; the rest is for what follows.
inline constexpr double kShareOfReading = 0.8;

/// Reads a volume as a command's input: named in the report, timed, its reader's notes told as remarks.
[[nodiscard]] Result<Volume> readInputVolume(Run& run, const std::filesystem::path& file);

/// A case by folder, by case.json, or by the id of a shipped case.
/// @error as loadCase; notFound names the shipped ids
[[nodiscard]] Result<Case> findCase(const std::string& caseOrId);

/// True when `argument` can only mean a case: a folder, a .json file, or a word that is no file.
[[nodiscard]] bool meansCase(const std::string& argument);

/// The case's volume placed in the world, made first when it has to be; timed, notes told as remarks.
[[nodiscard]] Result<Volume> readCaseVolume(Run& run, const Case& opened);

}  // namespace ew::cli
