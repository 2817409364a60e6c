#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/stitching/project.h"

/// What a project reads.
namespace ew::stitching {

/// Every file that a project reads: nothing may be saved over one.
[[nodiscard]] inline std::vector<std::filesystem::path> filesOf(const StitchProject& project) {
  std::vector<std::filesystem::path> files;
  for (const ProjectVolume& volume : project.volumes)
    for (const auto* file : {&volume.file, &volume.coverage, &volume.confidence, &volume.calibration})
      if (!file->empty()) files.push_back(*file);
  return files;
}

/// What makes two lines of a project the same voxels.
[[nodiscard]] inline std::string keyOf(const ProjectVolume& volume) {
  return volume.file.string() + '\n' + volume.coverage.string() + '\n' + volume.confidence.string() + '\n' + volume.calibration.string() +
         '\n' + std::to_string(volume.spacing_mm) + (volume.acceptsSmall ? "\naccepts small" : "");
}

}  // namespace ew::stitching
