#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ew {

/// A smooth curve through values at rising places that never leaves the range of two neighbours: cubic Hermite interpolation, slopes the
/// mean of the neighbouring secants, 0 where they differ in sign, limited so that each interval is monotone (Fritsch & Carlson, SIAM J.
/// Numer. Anal. 17(2), 1980). Constant beyond the ends.
template <std::size_t N>
struct MonotoneCurve {
  std::array<double, N> place{};
  std::array<double, N> value{};
  std::array<double, N> slope{};

  /// @param first, last slopes wanted at the two ends
  MonotoneCurve(const std::array<double, N>& places, const std::array<double, N>& values, double first, double last)
      : place(places), value(values) {
    slope.front() = first;
    slope.back() = last;
    for (std::size_t k = 1; k + 1 < N; ++k) {
      const double before = secant(k - 1);
      const double after = secant(k);
      slope[k] = before * after > 0.0 ? 0.5 * (before + after) : 0.0;
    }
    // Fritsch & Carlson, section 4: slopes inside the circle of radius three secants keep each interval monotone.
    for (std::size_t k = 0; k + 1 < N; ++k) {
      const double along = secant(k);
      if (along == 0.0) {
        slope[k] = slope[k + 1] = 0.0;
        continue;
      }
      const double length = std::hypot(slope[k] / along, slope[k + 1] / along);
      if (length > 3.0) {
        slope[k] *= 3.0 / length;
        slope[k + 1] *= 3.0 / length;
      }
    }
  }

  [[nodiscard]] double at(double where) const {
    if (!(where > place.front())) return value.front();
    if (where >= place.back()) return value.back();
    std::size_t k = N - 2;
    while (where < place[k]) --k;
    const double width = place[k + 1] - place[k];
    const double s = (where - place[k]) / width;
    const double r = 1.0 - s;
    const double found = (1.0 + 2.0 * s) * r * r * value[k] + s * r * r * (slope[k] * width) + s * s * (3.0 - 2.0 * s) * value[k + 1] -
                         s * s * r * (slope[k + 1] * width);
    // In exact arithmetic the curve is inside; this keeps the last bit inside as well.
    const auto [low, high] = std::minmax(value[k], value[k + 1]);
    return std::clamp(found, low, high);
  }

 private:
  [[nodiscard]] double secant(std::size_t k) const { return (value[k + 1] - value[k]) / (place[k + 1] - place[k]); }
};

}  // namespace ew
