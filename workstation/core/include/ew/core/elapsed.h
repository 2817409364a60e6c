#pragma once

#include <chrono>

namespace ew {

/// By the clock on the wall, whatever sets that clock meanwhile.
[[nodiscard]] inline double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ew
