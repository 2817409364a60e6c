#include "ew/reports/distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ew/core/contract.h"

namespace ew {
namespace {

double quantileOf(const std::vector<double>& rising, double share) {
  const double place = share * static_cast<double>(rising.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, rising.size() - 1);
  return rising[below] + (place - static_cast<double>(below)) * (rising[above] - rising[below]);
}

}  // namespace

FiveNumbers fiveNumbersOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {values.size(),
          values.front(),
          quantileOf(values, 0.25),
          quantileOf(values, 0.5),
          quantileOf(values, 0.75),
          values.back(),
          sum / static_cast<double>(values.size())};
}

std::vector<std::size_t> countsIn(std::span<const double> values, double low, double high, std::size_t parts) {
  EW_EXPECTS(parts > 0 && high > low);
  std::vector<std::size_t> counts(parts, 0);
  for (const double value : values) {
    if (!(value >= low && value <= high)) continue;
    const double place = (value - low) / (high - low) * static_cast<double>(parts);
    ++counts[std::min(static_cast<std::size_t>(place), parts - 1)];
  }
  return counts;
}

}  // namespace ew
