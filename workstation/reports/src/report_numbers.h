#pragma once

#include <string>

namespace ew::reports {

/// With so many decimals and a point, whatever the locale: the window sets its own. "-0.0" is "0.0"; not a number is "nan".
[[nodiscard]] std::string fixedText(double value, int decimals);
/// As a coordinate of a picture: one decimal at most.
[[nodiscard]] std::string coordinate(double value);

}  // namespace ew::reports
