// What the kernels of slicing share, included once for every instruction set (Highway's foreach_target.h): lanes of 32 and of 16 bits, and
// the arithmetic in which every instruction set gives the same bits.
#if defined(EW_IMAGING_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EW_IMAGING_LANES_INL_H_
#undef EW_IMAGING_LANES_INL_H_
#else
#define EW_IMAGING_LANES_INL_H_
#endif

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "hwy/highway.h"
#include "template_line.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using U32 = hn::ScalableTag<std::uint32_t>;
using I32 = hn::RebindToSigned<U32>;
using F32 = hn::RebindToFloat<U32>;
using VecU = hn::Vec<U32>;
using VecI = hn::Vec<I32>;
using VecF = hn::Vec<F32>;

HWY_INLINE VecU set(std::uint32_t value) { return hn::Set(U32(), value); }
HWY_INLINE VecF set(float value) { return hn::Set(F32(), value); }
HWY_INLINE VecF toFloat(VecU value) { return hn::ConvertTo(F32(), hn::BitCast(I32(), value)); }

template <class Bytes>
HWY_INLINE void load(const std::uint8_t* from, Bytes& bytes) {
  std::memcpy(&bytes, from, sizeof bytes);
}

/// Stores the first `count` of the values, cut off at 0 and 255; all when there are more.
template <class D, class V>
HWY_INLINE void storeGreys(D d, V greys, int count, std::uint8_t* out) {
  const hn::Rebind<std::uint8_t, D> d8;
  const auto bytes = hn::DemoteTo(d8, greys);
  if (count >= static_cast<int>(hn::Lanes(d))) return hn::StoreU(bytes, d8, out);
  HWY_ALIGN std::uint8_t last[kLanesAtMost];
  hn::StoreU(bytes, d8, last);
  std::memcpy(out, last, static_cast<std::size_t>(std::max(count, 0)));
}

/// a + (b - a) x, where x is a fraction of kPartBits bits, rounded to the nearest whole number.
HWY_INLINE std::int32_t lerp(std::int32_t a, std::int32_t b, std::int32_t x) {
  return a + (((b - a) * x + (1 << (kPartBits - 1))) >> kPartBits);
}

#if HWY_TARGET != HWY_SCALAR
using I16 = hn::ScalableTag<std::int16_t>;
using VecS = hn::Vec<I16>;
HWY_INLINE VecS lerp(VecS a, VecS b, VecS x) { return hn::Add(a, hn::MulFixedPoint15(hn::Sub(b, a), x)); }
HWY_INLINE VecS halves(const std::uint32_t* from) { return hn::BitCast(I16(), hn::LoadU(U32(), from)); }
#endif

}  // namespace ew::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
