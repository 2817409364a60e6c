#include "logic/class_overview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/contract.h"

namespace ew::review {

Distribution distributionOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  Distribution made{fiveNumbersOf(values), {}};
  made.values = std::move(values);
  return made;
}

std::vector<std::size_t> histogramOf(std::span<const double> values, double lowest, double highest, int bins) {
  EW_EXPECTS(bins > 0);
  const auto parts = static_cast<std::size_t>(bins);
  if (highest > lowest) return countsIn(values, lowest, highest, parts);
  std::vector<std::size_t> counts(parts, 0);
  counts.front() = static_cast<std::size_t>(std::count(values.begin(), values.end(), lowest));
  return counts;
}

}  // namespace ew::review
