#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "ew/phantom/speckle.h"

namespace ew::phantom {

/// A number in [0, 1) that looks random, from seed and place.
[[nodiscard]] inline double evenAt(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  return static_cast<double>(hashOfPlace(seed, i, j, 0) >> 11) * 0x1.0p-53;
}

/// A normally distributed number of standard deviation 1, from seed and place (Box and Muller).
[[nodiscard]] inline double normalAt(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  return std::sqrt(-2.0 * std::log(1.0 - evenAt(seed, i, 2 * j))) * std::cos(2.0 * std::numbers::pi * evenAt(seed, i, 2 * j + 1));
}

/// Noise without kinks between two frequencies, of standard deviation 1 over long times: a sum of oscillations of equal strength whose
/// frequencies and phases come from the seed.
class SmoothNoise {
 public:
  SmoothNoise(std::uint64_t seed, std::int64_t stream, double lowest_hz, double highest_hz) {
    for (std::size_t n = 0; n < waves_.size(); ++n) {
      const auto wave = static_cast<std::int64_t>(n);
      const double share = (static_cast<double>(n) + evenAt(seed, stream, 2 * wave)) / static_cast<double>(waves_.size());
      waves_[n] = {2.0 * std::numbers::pi * (lowest_hz + share * (highest_hz - lowest_hz)),
                   2.0 * std::numbers::pi * evenAt(seed, stream, 2 * wave + 1)};
    }
  }
  [[nodiscard]] double at(double time_s) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.rate_radPerS * time_s + wave.phase_rad);
    return sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
  }

 private:
  struct Wave {
    double rate_radPerS = 0.0;
    double phase_rad = 0.0;
  };
  std::array<Wave, 5> waves_;
};

}  // namespace ew::phantom
