#pragma once

#include <cstddef>

#include "ew/acquisition/fan_outline.h"

namespace ew::test {

/// Pixels inside both over pixels inside either (Jaccard): how much of a fan was found where it is.
inline double overlapOf(const FanOutline& a, const FanOutline& b, int width_px, int height_px) {
  const GreyImage first = maskOf(a, width_px, height_px), second = maskOf(b, width_px, height_px);
  std::size_t both = 0, either = 0;
  for (std::size_t n = 0; n < first.pixels.size(); ++n) {
    both += first.pixels[n] & second.pixels[n];
    either += first.pixels[n] | second.pixels[n];
  }
  return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace ew::test
