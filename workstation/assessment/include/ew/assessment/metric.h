#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"

namespace ew {

/// Which way a figure is better.
enum class Better { less, more };

/// A figure of one step of an attempt: what it is, exactly, so that an instructor can question it. A change of how it is worked out gives
/// it the next version; figures of two versions are not compared.
struct Metric {
  std::string_view id;  ///< "path_length"; stays the same
  int version = 1;
  std::string_view unit;  ///< "mm", "deg", "s", "%", "ml", "dB"; empty: a number without one
  Better better = Better::less;
  std::vector<std::string_view> stepKinds;  ///< taskWord of the steps that have it
  Message name;                             ///< "Path length"
  Message definition;
  Message source;    ///< where it comes from, or that it is ours
  Message validity;  ///< what is known, and what is not, of what it says about skill
};

/// All there are, in the order in which they are shown.
[[nodiscard]] const std::vector<Metric>& metrics();
/// Null: there is none.
[[nodiscard]] const Metric* metricOf(std::string_view id);
[[nodiscard]] bool isFor(const Metric& metric, std::string_view stepKind);

/// One of them, as it was worked out.
struct MetricValue {
  std::string id;
  int version = 1;
  double value = 0.0;  ///< in the metric's unit
  bool operator==(const MetricValue&) const = default;
};
[[nodiscard]] std::optional<double> valueOf(const std::vector<MetricValue>& values, std::string_view id);

}  // namespace ew
