#include "ew/core/figures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "ew/core/numbers.h"

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

std::string fixedText(double value, int decimals) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
  std::array<char, 400> room{};
  const auto written = std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::fixed, decimals);
  std::string text(room.data(), written.ptr);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

Message fixedNumeral(double value, int decimals) { return numeral(fixedText(value, decimals)); }

std::string roundedText(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return textOf(std::round(value * scale) / scale);
}

std::string mebibytesText(double bytes) { return textOf(std::ceil(bytes / 1048576.0)) + " MiB"; }

MemoryFigure memoryFigure(double bytes) {
  const double mebibytes = bytes / 1048576.0;
  if (mebibytes >= 1024.0) return {mebibytes / 1024.0, 1, true};
  return {mebibytes, mebibytes < 10.0 ? 1 : 0, false};
}

std::string minutesText(double time_s) {
  const long long tenths = std::llround(10.0 * std::abs(time_s));
  std::string seconds = std::to_string(tenths / 10 % 60);
  seconds.insert(0, 2 - seconds.size(), '0');
  return (time_s < 0.0 && tenths > 0 ? "-" : "") + std::to_string(tenths / 600) + ":" + seconds + "." + std::to_string(tenths % 10);
}

}  // namespace ew
