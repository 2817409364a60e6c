#include "ew/core/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace ew {
namespace {

std::vector<std::string_view> pieces(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  std::vector<std::string_view> found;
  for (auto start = text.find_first_not_of(blanks); start != std::string_view::npos; start = text.find_first_not_of(blanks, start)) {
    const auto end = std::min(text.find_first_of(blanks, start), text.size());
    found.push_back(text.substr(start, end - start));
    start = end;
  }
  return found;
}

template <class T>
std::optional<T> parsed(std::string_view piece) {
  if (piece.starts_with('+')) piece.remove_prefix(1);  // from_chars takes no plus sign, files do
  T value{};
  const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), value);
  if (error != std::errc{} || end != piece.data() + piece.size()) return std::nullopt;
  return value;
}

template <class T>
std::optional<std::vector<T>> parsedAll(std::string_view text) {
  std::vector<T> values;
  for (const auto piece : pieces(text)) {
    const auto value = parsed<T>(piece);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  return values;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  const auto found = pieces(text);
  return found.size() == 1 ? parsed<double>(found.front()) : std::nullopt;
}

std::optional<std::vector<double>> parseNumbers(std::string_view text) { return parsedAll<double>(text); }

std::optional<std::vector<long long>> parseIntegers(std::string_view text) { return parsedAll<long long>(text); }

std::string textOf(double value) {
  std::array<char, 32> buffer{};
  if (value == 0.0) value = 0.0;  // of the two zeros the one without a sign
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("nan");
}

double decimalOf(float value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  double decimal = static_cast<double>(value);
  if (error == std::errc{} && std::isfinite(value)) std::from_chars(buffer.data(), end, decimal);
  return decimal;
}

double factorGiving(double product, double factor) {
  const double middle = product / factor;
  double below = middle, above = middle;
  for (int n = 0; n < 4; ++n) {
    if (below * factor == product) return below;
    if (above * factor == product) return above;
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return middle;
}

}  // namespace ew
