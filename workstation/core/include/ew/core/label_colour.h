#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace ew {

/// A colour for the number of a label, always the same: hues a golden angle apart, so that neighbours differ. Red, green, blue (sRGB), 0
/// to 1.
[[nodiscard]] inline glm::dvec3 colourOfLabel(int label) {
  constexpr double kGoldenTurn = 0.61803398874989485;
  constexpr double kSaturation = 0.45, kValue = 0.88;
  const double hue = 6.0 * std::fmod(static_cast<double>(label) * kGoldenTurn, 1.0);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.0);
    return kValue * (1.0 - kSaturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

}  // namespace ew
