#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

// Values by their place in the order, of a vector, a deque, an array: they are copied and stay as they are. Of a std::span nothing is
// copied, and what it looks at is put into another order. None of the values is NaN.

/// The value with `rank` smaller ones or equals before it. @param values more than `rank`
template <class Values>
[[nodiscard]] auto valueAtRank(Values values, std::size_t rank) {
  EW_EXPECTS(rank < std::size(values));
  const auto at = std::begin(values) + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(std::begin(values), at, std::end(values));
  return *at;
}

/// The value that as many lie below as above; of an even number the upper of the two in the middle, so it is always one of the values.
/// @param values not empty
template <class Values>
[[nodiscard]] auto upperMedianOf(Values values) {
  const std::size_t rank = std::size(values) / 2;
  return valueAtRank(std::move(values), rank);
}

/// The median of statistics: of an even number half way between the two in the middle. @param values floating point, not empty
template <class Values>
[[nodiscard]] auto medianOf(Values values) {
  static_assert(std::is_floating_point_v<std::remove_cvref_t<decltype(*std::begin(values))>>);
  EW_EXPECTS(std::size(values) > 0);
  const std::size_t count = std::size(values);
  const auto middle = std::begin(values) + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(std::begin(values), middle, std::end(values));
  if (count % 2 == 1) return *middle;
  return (*middle + *std::max_element(std::begin(values), middle)) / 2;
}

/// The value that at least `share` of the others do not exceed, one of the values: 0 the smallest, 1 the largest.
/// @param values not empty @param share 0..1
template <class Values>
[[nodiscard]] auto quantileOf(Values values, double share) {
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(std::size(values) - 1));
  return valueAtRank(std::move(values), rank);
}

}  // namespace ew
