#pragma once

#include <cstddef>

namespace ew::detail {

/// Where the n-th of complex numbers stands that follow one another as real and imaginary parts.
template <class Number>
[[nodiscard]] Number* pairAt(Number* numbers, std::ptrdiff_t n) {
  return numbers + 2 * n;
}

}  // namespace ew::detail
