#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/edge_enhancement.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ew/imaging/effects/edge_enhancement.h"

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

constexpr int kReach = 2;  // pixels the kernel looks at on each side
constexpr int kPiece = 512;

// Sums with the weights 1 4 6 4 1 down the rows reach 16 * 255, those of five of them along a row 256 * 255: all of it fits 16 bits.
// Half of the latter from 128 v is the difference in 128ths of a grey level, in 16 bits with its sign.

void sumDown(const std::uint8_t* in, std::ptrdiff_t stride, int count, std::uint16_t* down) {
  for (int n = 0; n < count; ++n, ++in)
    down[n] = static_cast<std::uint16_t>(in[-2 * stride] + in[2 * stride] + 4 * (in[-stride] + in[stride]) + 6 * in[0]);
}

void sharpen(const std::uint16_t* down, const std::uint8_t* in, int strength, int count, std::uint8_t* out) {
  for (int n = 0; n < count; ++n, ++down) {
    const int mean256 = down[0] + down[4] + 4 * (down[1] + down[3]) + 6 * down[2];
    const int difference128 = 128 * in[n] - (mean256 >> 1);
    const int scaled128 = (difference128 * strength + (1 << 14)) >> 15;
    out[n] = static_cast<std::uint8_t>(std::clamp(in[n] + ((scaled128 + 32) >> 6), 0, 255));
  }
}

#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR

void sumDownVectors(const std::uint8_t* in, std::ptrdiff_t stride, int count, std::uint16_t* down) { sumDown(in, stride, count, down); }
void sharpenVectors(const std::uint16_t* down, const std::uint8_t* in, int strength, int count, std::uint8_t* out) {
  sharpen(down, in, strength, count, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
V weigh(V a, V b, V c, V d, V e) {
  // 4 (b + d) + 6 c = 4 (b + c + d) + 2 c
  return hn::Add(hn::Add(hn::Add(a, e), hn::Add(c, c)), hn::ShiftLeft<2>(hn::Add(hn::Add(b, d), c)));
}

void sumDownVectors(const std::uint8_t* in, std::ptrdiff_t stride, int count, std::uint16_t* down) {
  const hn::ScalableTag<std::uint16_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> pixels;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto at = [&](int row, int n) HWY_ATTR { return hn::PromoteTo(d, hn::LoadU(pixels, in + row * stride + n)); };
  int n = 0;
  for (; n + lanes <= count; n += lanes) hn::StoreU(weigh(at(-2, n), at(-1, n), at(0, n), at(1, n), at(2, n)), d, down + n);
  sumDown(in + n, stride, count - n, down + n);
}

void sharpenVectors(const std::uint16_t* down, const std::uint8_t* in, int strength, int count, std::uint8_t* out) {
  const hn::ScalableTag<std::uint16_t> d;
  const hn::RebindToSigned<decltype(d)> sign;
  const hn::Rebind<std::uint8_t, decltype(d)> pixels;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto share = hn::Set(sign, static_cast<std::int16_t>(strength));
  const auto at = [&](int n) HWY_ATTR { return hn::LoadU(d, down + n); };
  int n = 0;
  for (; n + lanes <= count; n += lanes) {
    const auto mean256 = weigh(at(n), at(n + 1), at(n + 2), at(n + 3), at(n + 4));
    const auto v = hn::PromoteTo(sign, hn::LoadU(pixels, in + n));
    const auto difference128 = hn::Sub(hn::ShiftLeft<7>(v), hn::BitCast(sign, hn::ShiftRight<1>(mean256)));
    const auto scaled128 = hn::MulFixedPoint15(difference128, share);
    const auto shown = hn::Add(v, hn::ShiftRight<6>(hn::Add(scaled128, hn::Set(sign, 32))));
    hn::StoreU(hn::DemoteTo(pixels, shown), pixels, out + n);
  }
  sharpen(down + n, in + n, strength, count - n, out + n);
}

#endif

/// `count` pixels from `in` on, all of whose surroundings may be read.
/// @param strength 15 fraction bits
void enhanceRun(const std::uint8_t* in, std::ptrdiff_t stride, int strength, int count, std::uint8_t* out) {
  std::array<std::uint16_t, kPiece + 2 * kReach> down;
  for (int x = 0; x < count; x += kPiece) {
    const int piece = std::min(kPiece, count - x);
    sumDownVectors(in + x - kReach, stride, piece + 2 * kReach, down.data());
    sharpenVectors(down.data(), in + x, strength, piece, out + x);
  }
}

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {

using HWY_NAMESPACE::kReach;
HWY_EXPORT(enhanceRun);

void enhanceEdges(double strength, std::span<const std::vector<RowSpan>> spans, ImageView<const std::uint8_t> in, int firstRow, int rows,
                  ImageView<std::uint8_t> out) {
  EW_EXPECTS(in.width == out.width && in.height == out.height && in.data != out.data);
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(in.height));
  EW_EXPECTS(firstRow >= 0 && rows >= 0 && firstRow + rows <= in.height);
  const double usable = strength > 0.0 ? std::min(strength, 1.0) : 0.0;
  const int fixedStrength = std::min(static_cast<int>(std::lround(usable * 32768.0)), 32767);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const std::uint8_t* source = in.row(y);
    std::uint8_t* target = out.row(y);
    const bool hasRows = y >= kReach && y + kReach < in.height;
    for (const RowSpan& span : spans[static_cast<std::size_t>(y)]) {
      std::memcpy(target + span.begin, source + span.begin, static_cast<std::size_t>(span.end - span.begin));
      if (!hasRows || fixedStrength == 0) continue;
      // Walk through the runs that all five rows have in common.
      int x = span.begin;
      while (x < span.end) {
        int begin = x, end = span.end;
        for (int dy = -kReach; dy <= kReach && begin < end; ++dy) {
          const auto& row = spans[static_cast<std::size_t>(y + dy)];
          const auto found = std::find_if(row.begin(), row.end(), [begin](const RowSpan& other) { return other.end > begin; });
          if (found == row.end()) {
            begin = end = span.end;
            break;
          }
          // A later start may lie beyond the runs that earlier rows gave; then the walk goes on from there.
          begin = std::max(begin, found->begin);
          end = std::min(end, found->end);
        }
        if (begin < end) {
          if (const int count = end - begin - 2 * kReach; count > 0)
            HWY_DYNAMIC_DISPATCH(enhanceRun)(source + begin + kReach, in.stride, fixedStrength, count, target + begin + kReach);
          x = end;
        } else {
          x = std::max(begin, x + 1);
        }
      }
    }
  }
}

}  // namespace ew
#endif
