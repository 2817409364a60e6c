#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "panel/stitch_session.h"

/// What the files of StitchSession share among themselves.
namespace ew::stitching {

/// Levels on their way from the working thread to the window's.
struct StitchSession::Inbox {
  std::mutex mutex;
  std::vector<LevelSeen> levels;
};

/// Files that were read before they become lines of the project.
struct FilesRead {
  std::vector<std::pair<ProjectVolume, std::shared_ptr<const Volume>>> volumes;  ///< null: a sweep that still needs something
  std::map<std::string, Message> reasons;                                        ///< of these, by keyOf
  std::set<std::string> little;  ///< keyOf those that are asked about: too little of them is kept
  std::set<std::filesystem::path> sweeps;
  int failed = 0;
};

/// What a run of the chain brought.
struct ChainMade {
  ChainState state;
  bool any = false;
  std::shared_ptr<const Volume> result;  ///< null: it did not come so far
};

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
