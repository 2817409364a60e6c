#pragma once

#include <filesystem>

#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/library/case.h"
#include "ew/scanning/contents_for_images.h"
#include "ew/scanning/subject.h"
#include "run/command.h"

namespace ew::cli {

/// How much of a command's progress the reading below takes; the rest is for what follows.
inline constexpr double kShareOfReading = 0.8;

/// Reads a volume as a command's input: named in the report, timed, its reader's notes told as remarks.
[[nodiscard]] Result<Volume> readInputVolume(Run& run, const std::filesystem::path& file);

/// From this size on an uncompressed volume stays in its file and is read by the page.
inline constexpr std::uint64_t kMapFrom_bytes = 1ull << 30;

/// As readInputVolume, to be sliced; an uncompressed file stays where it is when it is large, or when `map` asks
/// for it.
/// @error as readVolume, as mapVolume when `map`
[[nodiscard]] Result<ScanVoxels> openInputVoxels(Run& run, const std::filesystem::path& file, bool map);

/// That a case is not named by a bundle (.ewcase), which has to be imported first. @error badUsage
[[nodiscard]] Result<void> expectNoBundle(const std::string& caseOrId);

/// A case by folder, by case.json, or by the id of a shipped case.
/// @error as loadCase and expectNoBundle; notFound names the shipped ids
[[nodiscard]] Result<Case> findCase(const std::string& caseOrId);

/// The poses of `--pose`; a file of poses is a command's input. @error as posesOf
[[nodiscard]] Result<std::vector<Pose>> readPoses(Run& run, const std::string& argument);

/// True when `argument` can only mean a case: a folder, a .json file, or a word that is no file.
[[nodiscard]] bool meansCase(const std::string& argument);

/// What a case's manifest names, made first when it has to be; timed, notes told as remarks.
[[nodiscard]] Result<CaseContents> readCaseContents(Run& run, const Case& opened);

/// The same, and of a case that would take long no more than these images of it show (readContentsFor), which is said.
[[nodiscard]] Result<CaseContents> readCaseContentsFor(Run& run, const Case& opened, const StillImages& images);

/// Makes the level of a recorded volume where a scene asks for live echoes and none is known, and gives the subject both; timed and told.
/// @error as recordedTissueOf
[[nodiscard]] Result<void> formEchoes(Run& run, ScanSubject& subject, const Scene& asked);

}  // namespace ew::cli
