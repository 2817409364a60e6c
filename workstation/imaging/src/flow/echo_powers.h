#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "ew/imaging/slice_source.h"

namespace ew::detail {

// Powers of what Doppler receives, over full white's. Blood lies 30 to 60 dB below tissue (soft organs to walls) and grows with the fourth
// power of the frequency; tissue, whose level the maps have for every frequency alike, grows with about the second. The level is ours, for
// the maps' scale, on which parenchyma is at -49 dB.
inline constexpr double kBloodAt5MHz_db = -78.0;
inline constexpr double kMapRange_db = 60.0;      ///< that 255 levels of the maps span
inline constexpr double kFluidLevel = 14.0;       ///< of the maps: what is not brighter sends nothing back
inline constexpr double kDopplerCycles = 4.0;     ///< of a pulse, longer than the image's: what is lost in resolution is won over the noise
inline constexpr double kNarrowBand_db = 4.0;     ///< that is won, against the image's noise
inline constexpr double kCarrierShare = 2.0 / 3;  ///< of the image's: machines send lower for Doppler, as blood is faint and fast

[[nodiscard]] inline double powerOf(double level_db) { return std::pow(10.0, 0.1 * level_db); }
[[nodiscard]] inline double bloodPower(double carrier_hz) { return powerOf(kBloodAt5MHz_db + 20.0 * std::log10(carrier_hz / 5e6)); }

/// Power of tissue by the level of its maps; 0 for fluid.
[[nodiscard]] const std::array<float, 256>& tissuePowers();

/// The voxel nearest to a place; 0 outside.
[[nodiscard]] inline std::uint8_t nearestVoxel(const SliceSource& volume, const glm::vec3& at_voxel) {
  const glm::ivec3 voxel(glm::floor(at_voxel + 0.5F));
  return volume.grid.contains(voxel) ? volume.voxels[volume.grid.indexOf(voxel.x, voxel.y, voxel.z)] : std::uint8_t{0};
}

}  // namespace ew::detail
