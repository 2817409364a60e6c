#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ew {

/// Of seed and place, what hashOfPlace mixes; a step along i, j or k adds a constant.
inline constexpr std::array<std::uint64_t, 3> kStepsOfPlace{0xD1B54A32D192ED03ull, 0xABC98388FB8FAC03ull, 0x8CB92BA72F3D8DD7ull};
[[nodiscard]] constexpr std::uint64_t sumOfPlace(std::uint64_t seed, std::int64_t i, std::int64_t j, std::int64_t k) {
  return seed * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(i) * kStepsOfPlace[0] +
         static_cast<std::uint64_t>(j) * kStepsOfPlace[1] + static_cast<std::uint64_t>(k) * kStepsOfPlace[2];
}
[[nodiscard]] constexpr std::uint64_t hashOfSum(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}
/// A 64-bit number that looks random for each place of an integer lattice. Integers only: the same on every machine.
[[nodiscard]] constexpr std::uint64_t hashOfPlace(std::uint64_t seed, std::int64_t i, std::int64_t j, std::int64_t k) {
  return hashOfSum(sumOfPlace(seed, i, j, k));
}

/// Smooth noise in [-1, 1]: random values on the integer lattice, joined without kinks.
[[nodiscard]] double valueNoise(std::uint64_t seed, const glm::dvec3& at);

/// Memory of specklePower between calls.
struct SpeckleScratch {
  std::vector<std::int32_t> row, plane, stack;
};

/// Echo power of fully developed speckle: a complex scatterer in every voxel, hashed from seed and place, summed coherently through a
/// separable binomial point spread function (1 4 6 4 1)/16 in each direction, that is a standard deviation of one voxel and no direction
/// preferred. The power is exponential with mean 1, its root (the envelope) Rayleigh: mean over standard deviation 1.91.
/// Source: Burckhardt, IEEE Trans. Sonics Ultrason. 25(1), 1978. Ours differs: the scatterers sit on the grid.
/// @param first place of the lattice where the box begins; the field has no edges, so neighbouring boxes fit together
/// @param size  places along i, j, k, each > 0
/// @param power size.x * size.y * size.z values, i fastest
void specklePower(std::uint64_t seed, const glm::ivec3& first, const glm::ivec3& size, SpeckleScratch& scratch, std::vector<float>& power);

/// Decibels of a power, from a table of 2048 mantissas (error below 0.002 dB); powers below 2^-20 count as 2^-20.
class Decibel {
 public:
  Decibel();
  [[nodiscard]] float of(float power) const;

 private:
  std::array<float, 2048> mantissa_;
};

}  // namespace ew
