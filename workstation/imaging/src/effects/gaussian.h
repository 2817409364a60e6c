#pragma once

#include <cmath>

namespace ew::detail {

/// Standard deviations of a normal distribution in its full width at half maximum: sqrt(8 ln 2).
inline constexpr double kWidthOfSigma = 2.3548200450309493;

/// A weight as the nearest whole multiple of 2^-16: sums of such weights times levels 0..255 are exact in floats, whatever their order.
inline double quantised(double weight) {
  constexpr double kQuantum = 1.0 / 65536.0;
  return kQuantum * std::round(weight / kQuantum);
}

}  // namespace ew::detail
