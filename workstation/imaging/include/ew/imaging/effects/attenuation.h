#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// What the sound loses beyond what the machine's compensation expects, for each label (dB a sample) and on entering it (dB).
struct TissueLosses {
  std::array<float, 256> perSample_db{};
  std::array<float, 256> onEntering_db{};
  std::array<bool, 256> known{};  ///< labels without acoustics fall back to the grey level
};
[[nodiscard]] TissueLosses makeTissueLosses(const Scene& scene, double carrier_hz, double sampleSpacing_mm);

/// Shadow and posterior enhancement: every echo is changed by what the sound has lost, or not lost, on its way there and back.
/// Goes down the beams of `echoes` from its first row (the face) on; lines are independent, so parts of the lines may run in parallel.
/// @param labels   same size as echoes, or empty: then grey levels decide
/// @param db       grey levels a decibel: 255 / recorded dynamic range
/// @param lossSoFar_db scratch of echoes.width floats
/// Cost: a few operations a sample, no branch.
void attenuate(const AttenuationEffect& effect, const TissueLosses& losses, ImageView<const std::uint8_t> labels, double greyPerDb,
               double carrier_hz, double sampleSpacing_mm, ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
