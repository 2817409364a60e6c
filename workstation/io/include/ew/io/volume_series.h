#pragma once

#include <cstdint>
#include <filesystem>

#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

/// What the header of a volume file says of the volumes in it.
struct VolumeSeries {
  std::uint64_t volumes = 1;  ///< one after the other; VolumeReadOptions::timeStep is 1 to this
  Grid grid;                  ///< of each
  bool spacingKnown = true;   ///< as VolumeReadResult::spacingKnown
  Message spacingProblem;     ///< as VolumeReadResult::spacingProblem
};
/// @error as readVolumeHeader; unsupported (a recorded sweep)
[[nodiscard]] Result<VolumeSeries> readVolumeSeries(const std::filesystem::path& file);

}  // namespace ew
