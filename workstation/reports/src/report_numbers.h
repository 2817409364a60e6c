#pragma once

#include <string>

#include "ew/core/figures.h"

namespace ew::reports {

/// As a coordinate of an image: one decimal at most.
[[nodiscard]] std::string coordinate(double value);

}  // namespace ew::reports
