#pragma once

#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Expected noise level (grey levels) of each row of a beam grid, before it is added as power; far below 0 where it cannot be seen:
///   255 (1 + min(atFace_db + 2 growth f d, largest_db) / range), f in MHz, d in cm.
/// @param recordedDynamicRange_db > 0
[[nodiscard]] std::vector<float> noiseLevels(const NoiseEffect& effect, double carrier_hz, double recordedDynamicRange_db,
                                             const BeamGrid& grid);

/// Adds electronic noise: the power of a circular complex Gaussian, which is exponential (Wagner, Smith, Sandrik & Lopez, IEEE Trans.
/// Sonics Ultrason. 30(3), 1983), independent in each sample and frame:
///   10^(level' / s) = 10^(level / s) + 10^(levels[row] / s) (-ln u),  s = 10 greyPerDb, u even in (0, 1) from a hash of frame, row and
///   line.
/// The same bits for the same frame number on every instruction set, in every band and with any number of threads. Error below 0.003
/// levels at 60 dB. Rows whose level lies 28 dB or more below black are left as they are: at 60 dB no sample would change by half a level.
/// @param levels      of the whole grid
/// @param greyPerDb   > 0
/// @param firstRow    the grid's row that echoes.row(0) is; echoes holds all lines
/// Cost on one core of a server of 2023 (AVX-512, shared): 2.4 ns a sample that is not left as it is.
void addNoise(const std::vector<float>& levels, double greyPerDb, std::uint64_t frameNumber, int firstRow, ImageView<float> echoes);

}  // namespace ew
