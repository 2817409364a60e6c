#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ew/reports/distribution.h"

namespace ew::review {

// How the values of a class are shown. What they are is class_figures.h.

struct Distribution : FiveNumbers {
  std::vector<double> values;  ///< rising
};
/// @return all 0 of no values; values that are not finite are left out
[[nodiscard]] Distribution distributionOf(std::vector<double> values);
/// As countsIn; where lowest and highest are one, all values of that lie in the first part. @param bins > 0
[[nodiscard]] std::vector<std::size_t> histogramOf(std::span<const double> values, double lowest, double highest, int bins);

}  // namespace ew::review
