#include "paste_rows.h"

#include "paste_modes.h"

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__SANITIZE_ADDRESS__)
#define EW_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define EW_WIDE_VECTORS
#endif

namespace ew::paste {

EW_WIDE_VECTORS void cellsOfRow(const std::int64_t at[3], const std::int64_t step[3], std::uint32_t rowStride, std::uint32_t layerStride,
                                int count, std::uint32_t* cells) {
  // Unsigned: 64-bit vectors shift in zeros only. The positions are in the brick, so none is negative.
  std::uint64_t x = static_cast<std::uint64_t>(at[0]), y = static_cast<std::uint64_t>(at[1]), z = static_cast<std::uint64_t>(at[2]);
  const std::uint64_t dx = static_cast<std::uint64_t>(step[0]), dy = static_cast<std::uint64_t>(step[1]),
                      dz = static_cast<std::uint64_t>(step[2]);
  for (int n = 0; n < count; ++n) {
    cells[n] = static_cast<std::uint32_t>(z >> kFractionBits) * layerStride + static_cast<std::uint32_t>(y >> kFractionBits) * rowStride +
               static_cast<std::uint32_t>(x >> kFractionBits);
    x += dx;
    y += dy;
    z += dz;
  }
}

EW_WIDE_VECTORS std::size_t roundSums(const SmallSum* cells, int count, std::uint8_t measured, std::uint8_t* echo, std::uint8_t* coverage) {
  // Sums below 2^20 and counts below 2^12 are exact in float. A mean that is no tie is at least 1 / (2 * 4095) from one, eight times what
  // division and addition can be off.
  std::int32_t found = 0;
  for (int n = 0; n < count; ++n) {
    const auto pixels = static_cast<std::int32_t>(cells[n] >> kSmallSumBits);
    const auto sum = static_cast<std::int32_t>(cells[n] & ((SmallSum{1} << kSmallSumBits) - 1));
    const std::int32_t any = pixels > 0 ? 1 : 0;
    const float mean = static_cast<float>(sum) / static_cast<float>(pixels + 1 - any);
    echo[n] = static_cast<std::uint8_t>(static_cast<std::int32_t>(mean + 0.5F * static_cast<float>(any)));
    coverage[n] = static_cast<std::uint8_t>(any * measured);
    found += any;
  }
  return static_cast<std::size_t>(found);
}

EW_WIDE_VECTORS bool anySum(const SmallSum* cells, int count) {
  SmallSum all = 0;
  for (int n = 0; n < count; ++n) all |= cells[n];
  return all != 0;
}

}  // namespace ew::paste
