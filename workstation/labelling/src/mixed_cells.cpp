#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mixed_cells.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "mixed_cells.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace ew::labelling::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void findMixedIn(const std::uint8_t* const* rows, int voxels, std::uint64_t* bits) {
  static_assert(std::endian::native == std::endian::little, "bytes of a mask are those of a number, the lowest first");
  const hn::CappedTag<std::uint8_t, 64> d;
  const int lanes = static_cast<int>(hn::Lanes(d)), cells = voxels - 1;
  const auto maskFrom = [&](int n) HWY_ATTR {
    const auto first = hn::LoadU(d, rows[0] + n);
    auto differs = hn::Xor(first, hn::LoadU(d, rows[0] + n + 1));
    for (int row = 1; row < 4; ++row)
      differs = hn::Or(differs, hn::Or(hn::Xor(first, hn::LoadU(d, rows[row] + n)), hn::Xor(first, hn::LoadU(d, rows[row] + n + 1))));
    std::uint64_t mask = 0;
    hn::StoreMaskBits(d, hn::Ne(differs, hn::Zero(d)), reinterpret_cast<std::uint8_t*>(&mask));
    return mask;
  };
  const auto add = [&](int n, std::uint64_t mask) {
    bits[n / 64] |= mask << (n % 64);
    if (n % 64 != 0 && mask >> (64 - n % 64) != 0) bits[n / 64 + 1] |= mask >> (64 - n % 64);
  };
  if (cells >= lanes) {
    for (int n = 0; n < cells - lanes; n += lanes) add(n, maskFrom(n));
    add(cells - lanes, maskFrom(cells - lanes));  // overlaps those before
    return;
  }
  for (int n = 0; n < cells; ++n) {
    bool differs = false;
    for (int row = 0; row < 4; ++row) differs = differs || rows[row][n] != rows[0][n] || rows[row][n + 1] != rows[0][n];
    if (differs) add(n, 1);
  }
}

}  // namespace
}  // namespace ew::labelling::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::labelling {

HWY_EXPORT(findMixedIn);

void findMixed(const std::uint8_t* const (&rows)[4], int voxels, std::span<std::uint64_t> bits) {
  std::fill(bits.begin(), bits.end(), std::uint64_t{0});
  HWY_DYNAMIC_DISPATCH(findMixedIn)(rows, voxels, bits.data());
}

}  // namespace ew::labelling
#endif
