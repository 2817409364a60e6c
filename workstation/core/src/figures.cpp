#include "ew/core/figures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ew {

std::string figureText(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
  digits = std::clamp(digits, 1, 15);
  std::array<char, 64> room{};
  // Rounded to its digits first; what they do not reach are zeros.
  const auto rounded = std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::scientific, digits - 1);
  double figure = 0.0;
  std::from_chars(room.data(), rounded.ptr, figure);
  const double size = std::abs(figure);
  const auto format = figure == 0.0 || (size >= 1e-4 && size < 1e15) ? std::chars_format::fixed : std::chars_format::scientific;
  const auto written = std::to_chars(room.data(), room.data() + room.size(), figure == 0.0 ? 0.0 : figure, format);
  return {room.data(), written.ptr};
}

}  // namespace ew
