#pragma once

#include <complex>

namespace ew::detail {

/// Both for one y, 0..1.
struct WomersleyValue {
  std::complex<double> profile;  ///< f: velocity over its mean across the section
  std::complex<double> within;   ///< 2 int_0^y f(y') y' dy': the share of the flow that passes within y; 1 at the wall
};
[[nodiscard]] WomersleyValue womersleyAt(double alpha, double y);

}  // namespace ew::detail
