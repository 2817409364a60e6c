#pragma once

#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Expected noise level (grey levels) of each row of a beam grid, before it is added as power; far below 0 where it cannot be seen.
[[nodiscard]] std::vector<float> noiseLevels(const NoiseEffect& effect, double carrier_hz, double recordedDynamicRange_db,
                                             const BeamGrid& grid);

/// Adds electronic noise: the power of a circular complex Gaussian (exponential), independent in each sample and frame, the same for the
/// same frame number on every machine and thread count.
/// @param firstRow the grid's row that echoes.row(0) is
void addNoise(const std::vector<float>& levels, double greyPerDb, std::uint64_t frameNumber, int firstRow, ImageView<float> echoes);

}  // namespace ew
