// Logarithms and sums of powers in vector code, included once for every instruction set (Highway's foreach_target.h).
// Products and sums stay apart (these files are compiled with -ffp-contract=off), so that every instruction set gives the same bits.
#if defined(EW_IMAGING_POWERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EW_IMAGING_POWERS_INL_H_
#undef EW_IMAGING_POWERS_INL_H_
#else
#define EW_IMAGING_POWERS_INL_H_
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using FloatsOf = hn::Vec<D>;

/// log2(x) of normal x > 0. Relative error below 6e-5, also close to x = 1 (polynomial in x - 1 through Chebyshev nodes).
template <class D>
HWY_INLINE FloatsOf<D> log2Of(D d, FloatsOf<D> x) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  // Mantissas from sqrt(1/2) to sqrt(2), so that x - 1 is small on both sides of 1.
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
  const auto t = hn::Sub(hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent))), hn::Set(d, 1.0F));
  auto sum = hn::Set(d, 0.250287847F);
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, -0.389675224F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 0.485737842F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, -0.720629216F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 1.44264046F));
  return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(sum, t));
}

/// 2^x for |x| <= 120, relative error below 8e-6; exactly 1 for 0.
template <class D>
HWY_INLINE FloatsOf<D> exp2Of(D d, FloatsOf<D> x) {
  const hn::RebindToSigned<D> di;
  // Beside 3 * 2^22 a float has no fraction bits left: adding it rounds, and its last bits are the whole number.
  const auto shifter = hn::Set(d, 12582912.0F);
  const auto shifted = hn::Add(x, shifter);
  const auto f = hn::Sub(x, hn::Sub(shifted, shifter));
  auto power = hn::Set(d, 0.00965671029F);
  power = hn::Add(hn::Mul(power, f), hn::Set(d, 0.0558382829F));
  power = hn::Add(hn::Mul(power, f), hn::Set(d, 0.240225301F));
  power = hn::Add(hn::Mul(power, f), hn::Set(d, 0.693136734F));
  power = hn::Add(hn::Mul(power, f), hn::Set(d, 1.0F));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, power), hn::ShiftLeft<23>(hn::BitCast(di, shifted))));
}

/// The level of two powers together: log(10^(a/s) + 10^(b/s)) on a logarithmic scale of levels, where `levelsPerDoubling` = s log10(2) is
/// what twice the power adds. Error below 7e-5 levelsPerDoubling (0.001 grey levels at 60 dB). Exactly the larger one when the other is
/// 24 doublings (72 dB) below it.
template <class D>
HWY_INLINE FloatsOf<D> addPowers(D d, FloatsOf<D> a, FloatsOf<D> b, FloatsOf<D> levelsPerDoubling, FloatsOf<D> doublingsPerLevel) {
  const auto larger = hn::Max(a, b);
  const auto apart = hn::Mul(hn::Sub(hn::Min(a, b), larger), doublingsPerLevel);  // <= 0
  const auto lowest = hn::Set(d, -24.0F);
  const auto t = exp2Of(d, hn::Max(apart, lowest));
  auto sum = hn::Set(d, 0.0586649397F);  // log2(1 + t) / t
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, -0.225103025F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 0.440599033F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, -0.716714663F));
  sum = hn::Add(hn::Mul(sum, t), hn::Set(d, 1.44260389F));
  const auto more = hn::Mul(hn::Mul(sum, t), levelsPerDoubling);
  return hn::Add(larger, hn::IfThenElseZero(hn::Gt(apart, lowest), more));
}

/// Runs `part(tag, first column)` over `width` columns: whole vectors first, then shorter ones, at last single columns, so that nothing
/// outside the columns is read or written.
template <class Part>
HWY_INLINE void forColumns(int width, const Part& part) {
  const hn::ScalableTag<float> whole;
  const hn::CappedTag<float, 4> four;
  const hn::CappedTag<float, 1> one;
  int x = 0;
  for (const int step = static_cast<int>(hn::Lanes(whole)); x + step <= width; x += step) part(whole, x);
  for (const int step = static_cast<int>(hn::Lanes(four)); x + step <= width; x += step) part(four, x);
  for (; x < width; ++x) part(one, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#endif
