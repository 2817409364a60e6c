#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "effects/apply_table.cpp"
// Ice Lake and Zen 4 look 64 bytes up in 128 entries at once; Highway compiles for them only when asked.
#define HWY_WANT_AVX3_DL
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "ew/imaging/effects/gain.h"

HWY_BEFORE_NAMESPACE();
namespace ew::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX3_DL

void lookUp(const std::uint8_t* table, std::uint8_t* pixels, int count) {
  constexpr int kLanes = 64;
  if (count < kLanes) {
    for (int x = 0; x < count; ++x) pixels[x] = table[pixels[x]];
    return;
  }
  const auto quarter = [table](int n) { return _mm512_loadu_si512(table + kLanes * n); };
  const __m512i dark0 = quarter(0), dark1 = quarter(1), bright0 = quarter(2), bright1 = quarter(3);
  const auto looked = [&](const std::uint8_t* at) {
    const __m512i grey = _mm512_loadu_si512(at);
    return _mm512_mask_blend_epi8(_mm512_movepi8_mask(grey), _mm512_permutex2var_epi8(dark0, grey, dark1),
                                  _mm512_permutex2var_epi8(bright0, grey, bright1));
  };
  // The last 64 overlap those before: they are looked up while they still are what they were.
  const __m512i last = looked(pixels + count - kLanes);
  for (int x = 0; x < count - kLanes; x += kLanes) _mm512_storeu_si512(pixels + x, looked(pixels + x));
  _mm512_storeu_si512(pixels + count - kLanes, last);
}

#elif HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

// Sixteen shuffles of sixteen entries each: 2.7 times the speed of single look-ups with 32 bytes a vector, 1.5 times with 16.
void lookUp(const std::uint8_t* table, std::uint8_t* pixels, int count) {
  const hn::ScalableTag<std::uint8_t> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  if (count < lanes) {
    for (int x = 0; x < count; ++x) pixels[x] = table[pixels[x]];
    return;
  }
  const auto looked = [&](const std::uint8_t* at) HWY_ATTR {
    auto index = hn::LoadU(d, at);
    auto result = hn::Zero(d);
    for (int n = 0; n < 16; ++n) {
      // Saturated, an index into another part has its highest bit set, which gives 0.
      const auto part = hn::LoadDup128(d, table + 16 * n);
      result = hn::Or(result, hn::TableLookupBytesOr0(part, hn::SaturatedAdd(index, hn::Set(d, 0x70))));
      index = hn::Sub(index, hn::Set(d, 16));
    }
    return result;
  };
  // As above: the last ones first.
  const auto last = looked(pixels + count - lanes);
  for (int x = 0; x < count - lanes; x += lanes) hn::StoreU(looked(pixels + x), d, pixels + x);
  hn::StoreU(last, d, pixels + count - lanes);
}

#else

void lookUp(const std::uint8_t* table, std::uint8_t* pixels, int count) {
  for (int x = 0; x < count; ++x) pixels[x] = table[pixels[x]];
}

#endif

void lookUpSpans(const ImageView<std::uint8_t>& image, const std::vector<RowSpan>* spans, const std::uint8_t* table) {
  for (int y = 0; y < image.height; ++y, table += 256)
    for (const RowSpan& span : spans[y]) lookUp(table, image.row(y) + span.begin, span.end - span.begin);
}

}  // namespace
}  // namespace ew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew {

HWY_EXPORT(lookUpSpans);

void applyGainTable(ImageView<std::uint8_t> image, std::span<const std::vector<RowSpan>> spans, std::span<const std::uint8_t> table) {
  EW_EXPECTS(table.size() >= 256 * static_cast<std::size_t>(image.height));
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(image.height));
  HWY_DYNAMIC_DISPATCH(lookUpSpans)(image, spans.data(), table.data());
}

}  // namespace ew
#endif
