#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/acquisition/import.h"
#include "ew/core/beams.h"
#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// A subvolume for joining with others: beside the echoes, how far each may be trusted and along which beams it was seen.
struct SweepVolume {
  Volume volume;                         ///< with coverage
  std::vector<std::uint8_t> confidence;  ///< per voxel, 255 for 1: how far the echoes may be trusted; less in shadow and without contact
  std::optional<Beams> beams;            ///< in the volume's own frame; empty: they cancel out
  std::vector<Message> notes;
};

/// How a sweep becomes a subvolume when nothing else is known of it.
struct SweepVolumeOptions {
  double spacing_mm = 0.0;            ///< of the volume; 0: as defaultsFor says
  std::filesystem::path calibration;  ///< device set; empty: the recording says everything itself
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
  bool acceptsSmall = false;  ///< a volume is made also when there is something to ask about it (checkMeant)
};

/// Opens a sweep to be made into a volume as defaultsFor (import.h) says.
/// @error as openSweep; a volume over maxBytes, or of too little, is not an error here
[[nodiscard]] Result<SweepInput> openSweepVolume(const std::filesystem::path& sweep, const SweepVolumeOptions& options, Progress& progress);

/// Memory at the peak of makeSweepVolume: the maps of all frames, and while they are pasted the finished volume.
[[nodiscard]] std::uint64_t sweepVolumeBytes(const ImportPlan& plan);

/// Reconstructs an opened sweep by its plan, the confidence of its frames the same way, so that it lies where the echoes do. The voxels do
/// not depend on the number of threads.
/// @error as reconstructOnto and confidenceOfFrames; those of checkMeant; tooLarge
/// (sweepVolumeBytes above the plan's maxBytes); cancelled
[[nodiscard]] Result<SweepVolume> makeSweepVolume(const SweepInput& opened, Progress& progress);

}  // namespace ew
