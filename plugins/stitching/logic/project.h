#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/sdk/host.h"
#include "ew/stitching/stitch.h"

namespace ew::stitching {

inline constexpr int kProjectFormat = 1;

/// One line of a project: a volume file, optionally its coverage, and where it lies.
struct ProjectVolume {
  std::filesystem::path file;
  std::filesystem::path coverage;  ///< empty: every voxel counts as measured
  glm::dmat4 toWorld{1.0};
  std::string name;  ///< the file's name when the project gives none
  bool operator==(const ProjectVolume&) const = default;
};

/// The stitch project:
/// {"format": 1, "volumes": [{"file": "a.mha", "coverage": "a-coverage.mha", "name": "right", "to_world": [16 numbers] or "a.txt"}, …],
///  "spacing_mm": 0, "feather_mm": 10, "interpolated_weight": 0.25, "axes": "first" or "world"}
/// Only `volumes` with `file` is required. Files are relative to the project's folder. A transform file holds 16 numbers, row by row.
struct StitchProject {
  std::vector<ProjectVolume> volumes;
  StitchOptions options;  ///< threads and maxBytes are not part of the file
  bool operator==(const StitchProject&) const = default;
};

/// @param folder against which relative paths are resolved
/// @error badHeader (not JSON), badField (field, value found, value expected; also a field nobody knows), newerFormat, notRigid, and what
///        reading a transform file says
[[nodiscard]] Result<StitchProject> parseProject(const std::string& text, const std::filesystem::path& folder, sdk::Files& files);

/// The project as text that parseProject reads back to an equal one. Paths below `folder` are written relative to it.
[[nodiscard]] std::string projectText(const StitchProject& project, const std::filesystem::path& folder);

/// A rigid matrix from text: 16 numbers, row by row, separated by blanks or line ends.
/// @error badField, notRigid
[[nodiscard]] Result<glm::dmat4> parseTransform(const std::string& text, const std::string& name);

/// Reads the volumes of a project, each with its coverage.
[[nodiscard]] Result<std::vector<PlacedVolume>> readVolumes(const StitchProject& project, sdk::Volumes& volumes, Progress& progress);

/// Where writeStitch puts things, and how they are called there.
struct StitchFiles {
  std::filesystem::path volume;      ///< volume.mha
  std::filesystem::path coverage;    ///< coverage.mha
  std::filesystem::path source;      ///< source.mha: the input that weighed most, 0 absent, 1 the first
  std::filesystem::path provenance;  ///< provenance.json: inputs, places, options, what each gave; the same for the same inputs
};

/// Writes a result into `folder`, all four files or none: they are made aside and moved in together at the end.
/// @error notWritable, cancelled
[[nodiscard]] Result<StitchFiles> writeStitch(const StitchResult& result, const StitchProject& project, const std::filesystem::path& folder,
                                              sdk::Volumes& volumes, sdk::Files& files, Progress& progress);

/// `echoweave stitch PROJECT.json -o DIR [--threads N]`
[[nodiscard]] Result<sdk::Commands::Outcome> runStitchCommand(const std::vector<std::string>& args, sdk::Volumes& volumes,
                                                              sdk::Files& files, sdk::Log& log, Progress& progress);
inline constexpr const char* kStitchUsage = "stitch PROJECT.json -o DIR [--threads N]";
/// What `--help` says after the usage: how a project is written and what lies in DIR afterwards.
inline constexpr const char* kStitchHelp =
    "  -o, --output DIR  Folder for volume.mha, coverage.mha, source.mha and provenance.json; made when it is not there\n"
    "  --threads N       Threads; 0: all cores; the voxels do not depend on it (0)\n"
    "\n"
    "PROJECT.json; only the volumes and their files are required, files are relative to it:\n"
    "  { \"format\": 1,\n"
    "    \"volumes\": [\n"
    "      { \"file\": \"right.mha\", \"coverage\": \"right-coverage.mha\" },\n"
    "      { \"file\": \"left.mha\", \"to_world\": \"left-to-right.txt\" } ],\n"
    "    \"spacing_mm\": 0, \"feather_mm\": 10, \"interpolated_weight\": 0.25, \"axes\": \"first\" }\n"
    "to_world is a list of 16 numbers, row by row, or a text file that holds them; spacing_mm 0 takes the finest volume's;\n"
    "axes is \"first\" (of the first volume) or \"world\".";

}  // namespace ew::stitching
