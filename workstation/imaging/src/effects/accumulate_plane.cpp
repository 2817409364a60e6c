#include <algorithm>
#include <cstdint>

#include "ew/imaging/effects/slice_thickness.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/accumulate_plane.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
void transpose16(const std::uint8_t* in, std::ptrdiff_t stride, std::uint8_t* out) {
  for (int k = 0; k < 16; ++k)
    for (int s = 0; s < 16; ++s) out[16 * s + k] = in[k * stride + s];
}
#else
using Bytes = hn::FixedTag<std::uint8_t, 16>;

/// Perfect shuffles: four rounds of interleaving rows k and k + 8 turn 16 rows of 16 into their columns.
void transpose16(const std::uint8_t* in, std::ptrdiff_t stride, std::uint8_t* out) {
  const Bytes d;
  hn::Vec<Bytes> a[16], b[16];
  for (int k = 0; k < 16; ++k) a[k] = hn::LoadU(d, in + k * stride);
  const auto interleave = [d](const hn::Vec<Bytes>* from, hn::Vec<Bytes>* to) HWY_ATTR {
    for (std::size_t k = 0; k < 8; ++k) {
      to[2 * k] = hn::InterleaveLower(d, from[k], from[k + 8]);
      to[2 * k + 1] = hn::InterleaveUpper(d, from[k], from[k + 8]);
    }
  };
  interleave(a, b);
  interleave(b, a);
  interleave(a, b);
  interleave(b, a);
  for (std::size_t k = 0; k < 16; ++k) hn::Store(a[k], d, out + 16 * k);
}
#endif

template <bool first>
HWY_INLINE void addBlock(const std::uint8_t* columns, float weight, ImageView<float> echoes, int line, int sample) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::Rebind<std::uint8_t, decltype(d)> du8;
  const auto factor = hn::Set(d, weight);
  for (int s = 0; s < 16; ++s) {
    float* out = echoes.row(sample + s) + line;
    for (std::size_t n = 0; n < 16; n += hn::Lanes(d)) {
      const auto level = hn::ConvertTo(d, hn::PromoteTo(di, hn::Load(du8, columns + 16 * static_cast<std::size_t>(s) + n)));
      if constexpr (first)
        hn::StoreU(hn::Mul(factor, level), d, out + n);
      else
        hn::StoreU(hn::MulAdd(factor, level, hn::LoadU(d, out + n)), d, out + n);
    }
  }
}

template <bool first>
void addPlane(ImageView<const std::uint8_t> linesAsRows, float weight, ImageView<float> echoes) {
  const int wholeLines = echoes.width / 16 * 16, wholeSamples = echoes.height / 16 * 16;
  HWY_ALIGN std::uint8_t columns[16 * 16];
  for (int sample = 0; sample < wholeSamples; sample += 16)
    for (int line = 0; line < wholeLines; line += 16) {
      transpose16(linesAsRows.row(line) + sample, linesAsRows.stride, columns);
      addBlock<first>(columns, weight, echoes, line, sample);
    }
  const auto addOneByOne = [&](int firstLine, int firstSample, int endSample) {
    for (int sample = firstSample; sample < endSample; ++sample) {
      float* out = echoes.row(sample);
      for (int line = firstLine; line < echoes.width; ++line) {
        const float level = weight * static_cast<float>(linesAsRows.data[line * linesAsRows.stride + sample]);
        out[line] = first ? level : out[line] + level;
      }
    }
  };
  addOneByOne(wholeLines, 0, wholeSamples);
  addOneByOne(0, wholeSamples, echoes.height);
}

void firstPlane(ImageView<const std::uint8_t> linesAsRows, float weight, ImageView<float> echoes) {
  addPlane<true>(linesAsRows, weight, echoes);
}
void nextPlane(ImageView<const std::uint8_t> linesAsRows, float weight, ImageView<float> echoes) {
  addPlane<false>(linesAsRows, weight, echoes);
}

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {
namespace {

HWY_EXPORT(firstPlane);
HWY_EXPORT(nextPlane);

}  // namespace

void accumulatePlane(ImageView<const std::uint8_t> linesAsRows, float weight, bool first, ImageView<float> echoes) {
  EW_EXPECTS(linesAsRows.width == echoes.height && linesAsRows.height == echoes.width);
  if (first)
    HWY_DYNAMIC_DISPATCH(firstPlane)(linesAsRows, weight, echoes);
  else
    HWY_DYNAMIC_DISPATCH(nextPlane)(linesAsRows, weight, echoes);
}

}  // namespace ew
#endif
