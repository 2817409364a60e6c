#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/phantom/patient.h"

namespace ew {

/// Labels of the resting body on any grid: of each voxel what labelAt says of its centre. No echo is made, so it is much quicker than
/// voxelise, and the grid may lie as a reconstruction needs it.
/// Works in blocks, with a list of the organs that can reach each; threads 0 means all cores and does not change the labels.
/// @return grid.voxelCount() labels
/// @error what checkGrid says, tooLarge (more than `maxBytes`), cancelled (within 0.1 s)
[[nodiscard]] Result<std::vector<std::uint8_t>> labelsOn(const Patient& patient, const Grid& grid, int threads, Progress& progress,
                                                         std::uint64_t maxBytes = 4ull << 30);

}  // namespace ew
