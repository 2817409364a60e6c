#pragma once

#include "ew/core/figures.h"

namespace ew {

[[nodiscard]] inline Message tenths(double value) { return fixedNumeral(value, 1); }

}  // namespace ew
