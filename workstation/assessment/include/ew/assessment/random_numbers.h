#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>

namespace ew::assessment {

/// SplitMix64 (Steele, Lea, Flood 2014; public domain): the same numbers from every compiler, which std::uniform_real_distribution does
/// not promise.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  [[nodiscard]] double unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  [[nodiscard]] double between(double lowest, double highest) { return lowest + (highest - lowest) * unit(); }
  /// Normally distributed, standard deviation 1 (Box and Muller 1958).
  [[nodiscard]] double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
    return radius * std::cos(2.0 * std::numbers::pi * unit());
  }
  /// Evenly in a disc.
  [[nodiscard]] glm::dvec2 inDisc(double radius) {
    const double r = radius * std::sqrt(unit());
    const double angle = 2.0 * std::numbers::pi * unit();
    return {r * std::cos(angle), r * std::sin(angle)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace ew::assessment
