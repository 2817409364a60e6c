#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>

#include "effects/spread_bits.h"

namespace ew::detail {

/// Normal numbers by table: the middles of 4096 equally likely parts, scaled to a variance of 1; none is farther from 0 than 3.7.
class NormalTable {
 public:
  NormalTable();
  [[nodiscard]] float at(std::uint64_t bits) const { return values_[bits & 4095U]; }
  [[nodiscard]] static const NormalTable& shared();

 private:
  std::array<float, 4096> values_{};
};

/// Adds `weight` times complex normal numbers of power 1 to `out`: for the same key always the same, for another one independent of them.
inline void addWhite(const NormalTable& normals, std::uint64_t key, float weight, std::span<std::complex<float>> out) {
  constexpr float kEachPart = 0.70710678F;
  for (std::size_t n = 0; n < out.size(); n += 2) {
    const std::uint64_t bits = spreadBits(key + (n + 1) * 0x9e3779b97f4a7c15ULL);
    out[n] += weight * kEachPart * std::complex<float>(normals.at(bits), normals.at(bits >> 12));
    if (n + 1 < out.size()) out[n + 1] += weight * kEachPart * std::complex<float>(normals.at(bits >> 24), normals.at(bits >> 36));
  }
}

}  // namespace ew::detail
