#pragma once

#include <filesystem>
#include <vector>

#include "logic/project.h"

namespace ew::stitching {

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

}  // namespace ew::stitching
