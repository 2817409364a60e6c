#include "ew/core/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ew/core/contract.h"

namespace ew {
namespace {

constexpr double kRounding = 1e-9;  // of a quotient: 0.3 / 0.1 is three steps, though 2.9999999999999996

/// A number of the series ..., 0.5, 1, 2, 5, 10, ...: leading digit times 10^power.
struct RoundNumber {
  int digit = 1;
  int power = 0;

  /// `times` of it, rounded once: three steps of 0.1 are 0.3.
  [[nodiscard]] double times(double count) const {
    return power >= 0 ? count * digit * std::pow(10.0, power) : count * digit / std::pow(10.0, -power);
  }
  [[nodiscard]] double value() const { return times(1.0); }
  [[nodiscard]] RoundNumber next() const {
    return digit == 1 ? RoundNumber{2, power} : digit == 2 ? RoundNumber{5, power} : RoundNumber{1, power + 1};
  }
  [[nodiscard]] RoundNumber previous() const {
    return digit == 5 ? RoundNumber{2, power} : digit == 2 ? RoundNumber{1, power} : RoundNumber{5, power - 1};
  }
  [[nodiscard]] ChartTick tick(double count = 1.0) const { return {times(count), std::max(0, -power)}; }
};

/// The smallest of the series that is not below `least` > 0.
RoundNumber roundAtLeast(double least) {
  RoundNumber number{1, static_cast<int>(std::floor(std::log10(least)))};
  while (number.value() < least * (1.0 - kRounding)) number = number.next();
  return number;
}

RoundNumber roundAtMost(double most) {
  const RoundNumber number = roundAtLeast(most);
  return number.value() > most * (1.0 + kRounding) ? number.previous() : number;
}

struct Ends {
  double low, high;
};

std::optional<Ends> endsOf(std::span<const double> values, double above) {
  std::optional<Ends> ends;
  for (const double value : values) {
    if (!std::isfinite(value) || !(value > above)) continue;
    if (!ends) ends = {value, value};
    ends->low = std::min(ends->low, value);
    ends->high = std::max(ends->high, value);
  }
  return ends;
}

}  // namespace

double ChartAxis::share(double value) const {
  if (!isLogarithmic) return std::isnan(value) ? 0.0 : (value - low) / (high - low);
  return value > 0.0 ? std::log(value / low) / std::log(high / low) : 0.0;
}

ChartAxis linearAxis(std::span<const double> values, const LinearAxisOptions& options) {
  EW_EXPECTS(options.steps >= 1);
  Ends ends = endsOf(values, -std::numeric_limits<double>::infinity()).value_or(Ends{0.0, 1.0});
  // Apart by rounding alone they are one value: steps between them could not be told apart either.
  if (ends.high - ends.low <= kRounding * std::max(std::abs(ends.low), std::abs(ends.high))) ends.high = ends.low;
  double least = std::max(ends.high / options.steps - ends.low / options.steps, options.smallestStep);
  if (!(least > 0.0)) least = ends.low != 0.0 ? std::abs(ends.low) / options.steps : 1.0;
  const RoundNumber step = roundAtLeast(least);
  double first = std::floor(ends.low / step.value() - options.below + kRounding);
  double last = std::ceil(ends.high / step.value() + options.above - kRounding);
  if (first == last) {
    first -= 1.0;
    last += 1.0;
  }
  ChartAxis axis;
  for (double n = first; n <= last; n += 1.0) axis.ticks.push_back(step.tick(n));
  axis.low = axis.ticks.front().value;
  axis.high = axis.ticks.back().value;
  return axis;
}

ChartAxis logarithmicAxis(std::span<const double> values, double room) {
  EW_EXPECTS(room >= 1.0);
  const std::optional<Ends> ends = endsOf(values, 0.0);
  RoundNumber first{1, 0}, last{1, 1};
  if (ends) {
    first = roundAtMost(ends->low / room);
    last = roundAtLeast(ends->high * room);
    if (first.value() == last.value()) {
      first = first.previous();
      last = last.next();
    }
  }
  ChartAxis axis;
  axis.isLogarithmic = true;
  for (RoundNumber n = first; n.value() <= last.value(); n = n.next()) axis.ticks.push_back(n.tick());
  axis.low = axis.ticks.front().value;
  axis.high = axis.ticks.back().value;
  return axis;
}

}  // namespace ew
