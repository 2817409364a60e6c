// What is added to the fine grid of live echoes from vector code, included once for every instruction set (Highway's foreach_target.h).
#if defined(EW_IMAGING_DEPOSITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EW_IMAGING_DEPOSITS_INL_H_
#undef EW_IMAGING_DEPOSITS_INL_H_
#else
#define EW_IMAGING_DEPOSITS_INL_H_
#endif

#include <cstdint>
#include <cstring>

#include "echoes/bytes-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {

/// A bijection that spreads every bit: multiply and shift, constants of C. Wellons' search for low bias (public domain).
template <class DU>
HWY_INLINE hn::Vec<DU> spreadOf(DU du, hn::Vec<DU> x) {
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), hn::Set(du, 0x21f0aaadU));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), hn::Set(du, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

/// NearestInt rounds halves differently on different instruction sets.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> roundedOf(D d, hn::Vec<D> x) {
  return hn::ConvertTo(hn::RebindToSigned<D>(), hn::Floor(hn::Add(x, hn::Set(d, 0.5F))));
}

/// Deposits that wait until the memory has answered.
struct Pending {
  static constexpr std::size_t kMost = 96;
  std::size_t count = 0;
  std::int32_t* at[kMost];
  HWY_ALIGN std::int32_t quads[4 * kMost];

  HWY_INLINE void flush() {
    for (std::size_t n = 0; n < count; ++n) {
#if HWY_TARGET == HWY_SCALAR
      for (std::size_t part = 0; part < 4; ++part) at[n][part] += quads[4 * n + part];
#else
      const hn::CappedTag<std::int32_t, 4> quad;
      hn::StoreU(hn::Add(hn::LoadU(quad, at[n]), hn::Load(quad, quads + 4 * n)), quad, at[n]);
#endif
    }
    count = 0;
  }
};

/// Queues complex numbers of those lanes of which `added` has a bit, shared by two neighbouring columns.
/// @param cell in `field`, of the first of the two
/// @param part of the number that is the second's
template <class D>
HWY_INLINE void deposit(D d, std::int32_t* field, std::uint64_t added, hn::Vec<hn::RebindToSigned<D>> cell, hn::Vec<D> part, hn::Vec<D> re,
                        hn::Vec<D> im, Pending& pending) {
  const hn::RebindToSigned<D> di;
  constexpr std::size_t kLanes = hn::MaxLanes(D());
  static_assert(2 * kLanes <= Pending::kMost);
  if (pending.count + kLanes > Pending::kMost) pending.flush();
  HWY_ALIGN std::int32_t cells[kLanes], quads[4 * kLanes];
  const auto laterRe = hn::Mul(re, part), laterIm = hn::Mul(im, part);
  hn::Store(cell, di, cells);
  hn::StoreInterleaved4(roundedOf(d, hn::Sub(re, laterRe)), roundedOf(d, hn::Sub(im, laterIm)), roundedOf(d, laterRe),
                        roundedOf(d, laterIm), di, quads);
  for (std::uint64_t left = added; left != 0; left &= left - 1) {
    const auto n = static_cast<std::size_t>(__builtin_ctzll(left));
    std::int32_t* at = field + cells[n];
    __builtin_prefetch(at, 1);
    pending.at[pending.count] = at;
    std::memcpy(pending.quads + 4 * pending.count, quads + 4 * n, 4 * sizeof(std::int32_t));
    ++pending.count;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#endif
