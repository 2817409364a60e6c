#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Expected noise level at a depth, dB (0: full white): min(atFace_db + 2 growth f d, largest_db), f in MHz, d in cm.
[[nodiscard]] inline double noiseLevel_db(const NoiseEffect& effect, double carrier_hz, double depth_mm) {
  const double depth_cm = 0.1 * depth_mm;
  return std::min(effect.atFace_db + 2.0 * effect.growth_dbPerCmMhz * 1e-6 * carrier_hz * depth_cm, effect.largest_db);
}

/// From this far below black on, dB, noise is left out. The largest power is 24 ln 2 = 16.6 (12.2 dB) above the mean, and at 60 dB black
/// becomes half a level of 42.5 a decade brighter at -15.6 dB: no sample would be rounded to another level.
inline constexpr double kNoiseUnseen_db = 28.0;

/// The same for each row of a beam grid in grey levels, before it is added as power; far below 0 where it cannot be seen:
///   255 (1 + noiseLevel_db / range).
/// @param recordedDynamicRange_db > 0
[[nodiscard]] std::vector<float> noiseLevels(const NoiseEffect& effect, double carrier_hz, double recordedDynamicRange_db,
                                             const BeamGrid& grid);

/// Adds electronic noise: the power of a circular complex Gaussian, which is exponential (Wagner, Smith, Sandrik & Lopez, IEEE Trans.
/// Sonics Ultrason. 30(3), 1983), independent in each sample and frame:
///   10^(level' / s) = 10^(level / s) + 10^(levels[row] / s) (-ln u),  s = 10 greyPerDb, u even in (0, 1) from a hash of frame, row and
///   line.
/// The same bits for the same frame number on every instruction set, in every band and with any number of threads. Error below 0.003
/// levels at 60 dB. Rows whose level lies kNoiseUnseen_db or more below what is black at last are left as they are.
/// @param levels      of the whole grid
/// @param greyPerDb   > 0
/// @param firstRow    the grid's row that echoes.row(0) is; echoes holds all lines
/// @param lift_db     how far below recorded black levels will come into sight at most (BeamGainSetting::largestLift_db)
/// Cost on one core of a server of 2023 (AVX-512, shared): 2.4 ns a sample that is not left as it is.
void addNoise(const std::vector<float>& levels, double greyPerDb, std::uint64_t frameNumber, int firstRow, ImageView<float> echoes,
              double lift_db = 0.0);

}  // namespace ew
