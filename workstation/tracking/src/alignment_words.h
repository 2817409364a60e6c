#pragma once

#include <cstdio>

#include "ew/core/message.h"

namespace ew {

[[nodiscard]] inline Message tenths(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return numeral(text);
}

}  // namespace ew
