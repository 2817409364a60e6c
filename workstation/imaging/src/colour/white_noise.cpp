#include "colour/white_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew::detail {
namespace {

/// Below which a share of normal numbers lies, by Newton's method.
double quantile(double share) {
  double x = 0.0;
  for (int step = 0; step < 60; ++step) {
    const double off = 0.5 * std::erfc(-x / std::numbers::sqrt2) - share;
    const double slope = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
    const double change = std::clamp(off / slope, -0.5, 0.5);
    x -= change;
    if (std::abs(change) < 1e-9) break;
  }
  return x;
}

}  // namespace

NormalTable::NormalTable() {
  std::array<double, 4096> exact{};
  double power = 0.0;
  // Both halves alike, so that their mean is 0 to the bit.
  for (std::size_t n = 0; n < exact.size() / 2; ++n) {
    exact[n] = quantile((static_cast<double>(n) + 0.5) / static_cast<double>(exact.size()));
    exact[exact.size() - 1 - n] = -exact[n];
    power += 2.0 * exact[n] * exact[n];
  }
  const double scale = std::sqrt(static_cast<double>(exact.size()) / power);
  for (std::size_t n = 0; n < exact.size(); ++n) values_[n] = static_cast<float>(scale * exact[n]);
}

const NormalTable& NormalTable::shared() {
  static const NormalTable table;
  return table;
}

}  // namespace ew::detail
