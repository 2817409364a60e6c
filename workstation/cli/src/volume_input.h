#pragma once

#include <filesystem>

#include "command.h"
#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/io/mapped_volume.h"
#include "ew/library/case.h"

namespace ew::cli {

/// How much of a command's progress the reading below takes; the rest is for what follows.
inline constexpr double kShareOfReading = 0.8;

/// Reads a volume as a command's input: named in the report, timed, its reader's notes told as remarks.
[[nodiscard]] Result<Volume> readInputVolume(Run& run, const std::filesystem::path& file);

/// From this size on an uncompressed volume stays in its file and is read by the page.
inline constexpr std::uint64_t kMapFrom_bytes = 1ull << 30;

/// A volume to look at, in memory or in its file.
struct InputVolume {
  Volume volume;                       ///< empty when it is mapped
  std::optional<MappedVolume> mapped;  ///< when it stays in its file
  [[nodiscard]] VolumeView<const std::uint8_t> view() const { return mapped ? mapped->view() : volume.view(); }
  [[nodiscard]] const Grid& grid() const { return mapped ? mapped->grid() : volume.grid; }
  /// @error notReadable when a mapped file was changed since
  [[nodiscard]] Result<void> unchanged() const { return mapped ? mapped->unchanged() : Result<void>(); }
};

/// As readInputVolume; an uncompressed file is mapped when it is large, or when `map` asks for it.
/// @error as readVolume, as mapVolume when `map`
[[nodiscard]] Result<InputVolume> openInputVolume(Run& run, const std::filesystem::path& file, bool map);

/// A case by folder, by case.json, or by the id of a shipped case.
/// @error as loadCase; notFound names the shipped ids
[[nodiscard]] Result<Case> findCase(const std::string& caseOrId);

/// The poses of `--pose`; a file of poses is a command's input. @error as posesOf
[[nodiscard]] Result<std::vector<Pose>> readPoses(Run& run, const std::string& argument);

/// True when `argument` can only mean a case: a folder, a .json file, or a word that is no file.
[[nodiscard]] bool meansCase(const std::string& argument);

/// The case's echo and labels placed in the world, made first when they have to be; timed, notes told as remarks.
[[nodiscard]] Result<CaseEcho> readCaseEcho(Run& run, const Case& opened);

}  // namespace ew::cli
