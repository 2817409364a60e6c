#pragma once

#include <array>
#include <glm/glm.hpp>

#include "ew/phantom/patient.h"

namespace ew::phantom {

/// Power of the echoes of fully developed speckle whose mean grey level after log compression is `level`, 1 for full white: 60 dB over 255
/// levels, and the mean of the logarithm of an exponential variable lies 2.507 dB below the logarithm of its mean.
[[nodiscard]] double specklePowerAt(double level);
/// Amplitude of a steady echo at a grey level, and back.
[[nodiscard]] double amplitudeAt(double level);
[[nodiscard]] double levelOf(double amplitude);

/// Mean grey level of the echoes of tissue `number` at a place, with its texture: as scatterers are weighed and as TissueMaps keeps it.
[[nodiscard]] double tissueLevelAt(const Patient& patient, std::size_t number, const glm::dvec3& place_mm);
/// The same where the depth of the place is known.
[[nodiscard]] double tissueLevelAt(const Tissue& tissue, std::size_t number, const glm::dvec3& place_mm, double skin_mm);

/// Amplitude of what a smooth surface between two impedances mirrors; 0 where they hardly differ.
[[nodiscard]] double mirroredBetween(double inside_mrayl, double outside_mrayl);

/// Grey levels as powers and back, in steps of a quarter of a level: what lies in one voxel adds up as power. A table, so that the last bit
/// of a machine's logarithm does not reach the voxels.
class PowerOfLevel {
 public:
  PowerOfLevel();
  /// 0 for level 0 and below.
  [[nodiscard]] double of(double level) const;
  /// Whole levels, 0 to 255.
  [[nodiscard]] int level(double power) const;

 private:
  static constexpr int kSteps = 4;
  std::array<float, 255 * kSteps + 1> powers_{};
};

}  // namespace ew::phantom
