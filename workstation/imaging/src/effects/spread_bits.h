#pragma once

#include <cstdint>

namespace ew::detail {

/// Finalizer of SplitMix64 (Steele, Lea & Flood, OOPSLA 2014): a bijection that spreads every bit.
inline std::uint64_t spreadBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace ew::detail
