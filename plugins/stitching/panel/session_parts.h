#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "panel/stitch_session.h"

/// What the files of StitchSession share among themselves.
namespace ew::stitching {

/// Levels on their way from the working thread to the window's.
struct StitchSession::Inbox {
  std::mutex mutex;
  std::vector<LevelSeen> levels;
};

/// What makes two lines of a project the same voxels.
[[nodiscard]] inline std::string keyOf(const ProjectVolume& volume) {
  return volume.file.string() + '\n' + volume.coverage.string() + '\n' + volume.confidence.string() + '\n' + volume.calibration.string() +
         '\n' + std::to_string(volume.spacing_mm);
}

}  // namespace ew::stitching
