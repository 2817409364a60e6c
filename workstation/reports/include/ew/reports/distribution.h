#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ew {

/// Five numbers of many, and their mean: quartiles by linear interpolation between the values in order (Hyndman & Fan, Am Stat 50:361,
/// 1996, type 7).
struct FiveNumbers {
  std::size_t count = 0;
  double lowest = 0.0, lowerQuartile = 0.0, median = 0.0, upperQuartile = 0.0, highest = 0.0, mean = 0.0;
  bool operator==(const FiveNumbers&) const = default;
};
/// Values that are not finite are left out. @return all 0 of none
[[nodiscard]] FiveNumbers fiveNumbersOf(std::vector<double> values);

/// How many values lie in each of `parts` even parts from `low` to `high`; one on an inner border counts above it, one outside not at all.
/// @param parts > 0; @param high > low
[[nodiscard]] std::vector<std::size_t> countsIn(std::span<const double> values, double low, double high, std::size_t parts);

}  // namespace ew
