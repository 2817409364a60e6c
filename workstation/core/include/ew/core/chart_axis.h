#pragma once

#include <span>
#include <vector>

namespace ew {

/// A labelled place on an axis.
struct ChartTick {
  double value = 0.0;
  int decimals = 0;  ///< that a label needs
  bool operator==(const ChartTick&) const = default;
};

/// One axis of a chart: which values it spans, where its labels stand, and where a value is drawn.
struct ChartAxis {
  double low = 0.0;
  double high = 1.0;  ///< > low; a logarithmic axis has low > 0
  bool isLogarithmic = false;
  std::vector<ChartTick> ticks;  ///< ascending; the first is `low`, the last `high`

  /// How much of the way from `low` to `high` a value is: 0 and 1 at the ends, outside of them beyond them; of a value that a logarithmic
  /// axis cannot hold (<= 0, not a number) 0.
  [[nodiscard]] double share(double value) const;
  /// Where the value is drawn when `low` is drawn at `atLow` and `high` at `atHigh`; an axis that grows upwards has atLow > atHigh.
  [[nodiscard]] double at(double value, double atLow, double atHigh) const { return atLow + (atHigh - atLow) * share(value); }
  bool operator==(const ChartAxis&) const = default;
};

struct LinearAxisOptions {
  int steps = 5;              ///< at most between the lowest and the highest value, >= 1
  double smallestStep = 0.0;  ///< labels stand no closer
  double below = 0.0;         ///< room for marks and names below the lowest value, in steps
  double above = 0.0;         ///< and above the highest
};

/// From a round number at or below every value to one at or above, in steps of the series 1, 2, 5, 10, 20, 50 ... Values that are not
/// finite do not count; without any the axis is 0 to 1. One value alone has a step's room on both sides when it is round itself.
[[nodiscard]] ChartAxis linearAxis(std::span<const double> values, const LinearAxisOptions& options = {});

/// From a number of the series 1, 2, 5, 10, 20, 50 ... at or below every value to one at or above, with all of the series between as
/// ticks. Values that are not finite or not above 0 do not count; without any the axis is 1 to 10.
/// @param room a factor >= 1 that is left free below the lowest and above the highest value
[[nodiscard]] ChartAxis logarithmicAxis(std::span<const double> values, double room = 1.0);

}  // namespace ew
