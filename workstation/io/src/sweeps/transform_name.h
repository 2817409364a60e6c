#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ew::detail {

struct TransformName {
  std::string from;
  std::string to;
};

/// "ProbeToTracker" into "Probe" and "Tracker": cut at the first "To" between two names, of which the second begins with a capital or a
/// digit. Empty when there is no such place.
[[nodiscard]] std::optional<TransformName> splitTransformName(std::string_view joined);

}  // namespace ew::detail
