#include "ew/imaging/effects/stretch.h"

#include <cstddef>

#include "ew/core/contract.h"

namespace ew {

void stretch(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) {
  EW_EXPECTS(!in.empty());
  if (in.empty() || out.empty()) return;
  const std::size_t m = in.size();
  const std::size_t n = out.size();
  out[0] = in[0];
  if (n == 1) return;
  out[n - 1] = in[m - 1];
  constexpr std::uint64_t kOne = std::uint64_t{1} << 32;
  // Rounded down, so that no position passes the last value; the remainder is at most n - 1 times 2^-32 of an interval.
  const std::uint64_t intervals = m - 1;
  const std::uint64_t steps = n - 1;
  const std::uint64_t wholeStep = intervals / steps;
  const std::uint64_t fractionStep = ((intervals % steps) << 32) / steps;
  // Both ends at once, so that mirrored values are stretched to the mirrored ones.
  std::size_t left = 0;
  std::uint64_t w = 0;
  for (std::size_t x = 1; x < n - 1 - x; ++x) {
    left += wholeStep;
    w += fractionStep;
    if (w >= kOne) {
      w -= kOne;
      ++left;
    }
    // Eq. 2 with the two ends of the interval in their order; left < m - 1 here unless m = 1, where w stays 0.
    const std::size_t right = m > 1 ? left + 1 : left;
    out[x] = static_cast<std::uint8_t>((in[left] * (kOne - w) + in[right] * w + kOne / 2) >> 32);
    out[n - 1 - x] = static_cast<std::uint8_t>((in[m - 1 - left] * (kOne - w) + in[m - 1 - right] * w + kOne / 2) >> 32);
  }
  if (n % 2 == 1 && n > 2) out[n / 2] = static_cast<std::uint8_t>((in[intervals / 2] + in[m / 2] + 1) / 2);
}

}  // namespace ew
