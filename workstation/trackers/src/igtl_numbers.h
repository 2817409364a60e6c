#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers and names as OpenIGTLink writes them: most significant byte first, names padded with zeros.
namespace ew {

template <class Unsigned>
[[nodiscard]] Unsigned igtlUnsignedAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t n = 0; n < sizeof(Unsigned); ++n) value = static_cast<Unsigned>(value << 8u) | bytes[at + n];
  return value;
}
[[nodiscard]] inline double igtlFloatAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<double>(std::bit_cast<float>(igtlUnsignedAt<std::uint32_t>(bytes, at)));
}
/// The name that stands in `length` bytes, up to the first zero; what is not printable in ASCII reads "?".
[[nodiscard]] inline std::string igtlNameAt(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t length) {
  std::string name;
  for (std::size_t n = 0; n < length && bytes[at + n] != 0; ++n) {
    const char letter = static_cast<char>(bytes[at + n]);
    name.push_back(letter >= ' ' && letter <= '~' ? letter : '?');
  }
  return name;
}

template <class Unsigned>
void igtlPut(std::vector<std::uint8_t>& bytes, Unsigned value) {
  for (std::size_t n = sizeof(Unsigned); n-- > 0;)
    bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8u * n)));
}
inline void igtlPutFloat(std::vector<std::uint8_t>& bytes, double value) {
  igtlPut(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}
inline void igtlPutName(std::vector<std::uint8_t>& bytes, std::string_view name, std::size_t length) {
  for (std::size_t n = 0; n < length; ++n) bytes.push_back(n < name.size() ? static_cast<std::uint8_t>(name[n]) : std::uint8_t{0});
}

/// Seconds since 1970 as 32 bits before and 32 bits behind the point; zero: no stamp.
[[nodiscard]] inline double igtlSecondsOf(std::uint64_t stamp) {
  return stamp == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(stamp) / 4294967296.0;
}
[[nodiscard]] inline std::uint64_t igtlStampOf(double time_s) {
  if (!(time_s > 0.0 && time_s < 4294967295.0)) return 0;
  const double whole = std::floor(time_s);
  return static_cast<std::uint64_t>(whole) << 32u | static_cast<std::uint64_t>((time_s - whole) * 4294967296.0);
}

}  // namespace ew
