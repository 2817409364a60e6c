#include "line_kernels.h"

#include <algorithm>

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/line_kernels.cpp"
#include "hwy/foreach_target.h"
//
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // powers-inl.h

/// Sums of one vector of columns over the rows around a line; `kVectors` side by side, so that sums do not wait for one another.
template <int kVectors, class D>
HWY_INLINE void lateralSums(D d, const LateralTask& task, const std::int32_t* middle, int x, float* out) {
  const hn::RebindToSigned<D> di;
  const auto step = static_cast<int>(hn::Lanes(d));
  hn::Vec<D> sum[kVectors];
  for (int v = 0; v < kVectors; ++v)
    sum[v] = hn::Mul(hn::LoadU(d, task.weights + x + v * step), hn::BitCast(d, hn::LoadU(di, middle + x + v * step)));
  for (int t = 1; t <= task.reach; ++t) {
    const std::ptrdiff_t off = t * task.stride, weights = static_cast<std::ptrdiff_t>(t) * task.width;
    for (int v = 0; v < kVectors; ++v) {
      const auto above = hn::BitCast(d, hn::LoadU(di, middle - off + x + v * step)),
                 below = hn::BitCast(d, hn::LoadU(di, middle + off + x + v * step));
      sum[v] = hn::Add(sum[v], hn::Mul(hn::LoadU(d, task.weights + weights + x + v * step), hn::Add(above, below)));
    }
  }
  for (int v = 0; v < kVectors; ++v) hn::StoreU(sum[v], d, out + x + v * step);
}

void filterLaterallyOf(const LateralTask& task) {
  for (int row = 0; row < task.rows; ++row) {
    std::int32_t* values = task.tile + row * task.stride;
    forColumns(task.width, [&](auto d, int x) HWY_ATTR {
      const hn::RebindToSigned<decltype(d)> di;
      const auto amplitude = hn::Mul(hn::ConvertTo(d, hn::LoadU(di, values + x)), hn::Set(d, task.unit));
      hn::StoreU(hn::BitCast(di, amplitude), di, values + x);
    });
  }
  const hn::ScalableTag<float> whole;
  const auto lanes = static_cast<int>(hn::Lanes(whole));
  for (int line = 0; line < task.lines; ++line) {
    const std::int32_t* middle = task.tile + (task.firstRow + line * task.rowsPerLine) * task.stride;
    float* out = task.out + line * task.outStride;
    int x = 0;
    for (; x + 4 * lanes <= task.width; x += 4 * lanes) lateralSums<4>(whole, task, middle, x, out);
    for (; x + lanes <= task.width; x += lanes) lateralSums<1>(whole, task, middle, x, out);
    const hn::CappedTag<float, 1> one;
    for (; x < task.width; ++x) lateralSums<1>(one, task, middle, x, out);
  }
}

void scaleComplexOf(const float* factor, int count, float* inOut) {
  for (int n = 0; n < count; ++n) {
    inOut[2 * n] *= factor[n];
    inOut[2 * n + 1] *= factor[n];
  }
}

void addTurnedOf(const float* in, float weight, int quarter, int count, float* out) {
  const float re = quarter == 0 ? weight : quarter == 2 ? -weight : 0.0F, im = quarter == 1 ? weight : quarter == 3 ? -weight : 0.0F;
  if (im == 0.0F) {
    forColumns(2 * count, [&](auto d, int x) HWY_ATTR {
      hn::StoreU(hn::Add(hn::LoadU(d, out + x), hn::Mul(hn::LoadU(d, in + x), hn::Set(d, re))), d, out + x);
    });
    return;
  }
  for (int n = 0; n < count; ++n) {
    out[2 * n] -= im * in[2 * n + 1];
    out[2 * n + 1] += im * in[2 * n];
  }
}

/// As in scatterers.cpp.
template <class D>
HWY_INLINE hn::Vec<D> spread(D d, hn::Vec<D> x) {
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), hn::Set(d, 0x21f0aaadU));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), hn::Set(d, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

void addComplexNoiseOf(std::uint64_t key, const float* strength, int count, float* inOut) {
  // Two even 16-bit numbers have the variance 2^32 / 6 together; the pulse's filter makes their sum Gaussian enough.
  constexpr float kPerDeviation = 3.7376e-5F;
  HWY_ALIGN float noise[2 * hn::MaxLanes(hn::ScalableTag<float>())];
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::RebindToSigned<decltype(d)> di;
    const auto first = spread(du, hn::Add(hn::Iota(du, static_cast<std::uint32_t>(x)), hn::Set(du, static_cast<std::uint32_t>(key))));
    const auto second = spread(du, hn::Xor(first, hn::Set(du, static_cast<std::uint32_t>(key >> 32))));
    const auto part = [&](auto hash) HWY_ATTR {
      const auto sum = hn::Add(hn::ShiftRight<16>(hash), hn::And(hash, hn::Set(du, 0xFFFFU)));
      return hn::Mul(hn::Sub(hn::ConvertTo(d, hn::BitCast(di, sum)), hn::Set(d, 65535.0F)), hn::Set(d, kPerDeviation));
    };
    const auto scale = hn::LoadU(d, strength + x);
    hn::StoreInterleaved2(hn::Mul(part(first), scale), hn::Mul(part(second), scale), d, noise);
    for (int half = 0; half < 2; ++half) {
      float* at = inOut + 2 * x + half * static_cast<int>(hn::Lanes(d));
      hn::StoreU(hn::Add(hn::LoadU(d, at), hn::LoadU(d, noise + half * static_cast<int>(hn::Lanes(d)))), d, at);
    }
  });
}

void turnComplexOf(const float* in, const float* turn, int count, float* out) {
  forColumns(count, [&](auto d, int n) HWY_ATTR {
    hn::Vec<decltype(d)> re, im, c, s;
    hn::LoadInterleaved2(d, in + 2 * n, re, im);
    hn::LoadInterleaved2(d, turn + 2 * n, c, s);
    hn::StoreInterleaved2(hn::Sub(hn::Mul(re, c), hn::Mul(im, s)), hn::Add(hn::Mul(re, s), hn::Mul(im, c)), d, out + 2 * n);
  });
}

void addEnvelopeOf(const float* in, const float* pulse, int reach, float share, int samples, float* out) {
  forColumns(samples, [&](auto d, int s) HWY_ATTR {
    const auto lanes = static_cast<int>(hn::Lanes(d));
    // Two vectors of interleaved numbers become one of real and one of imaginary parts at the end.
    const float* at = in + 2 * s;
    const auto p0 = hn::Set(d, pulse[0]);
    auto low = hn::Mul(hn::LoadU(d, at), p0), high = hn::Mul(hn::LoadU(d, at + lanes), p0);
    for (int t = 1; t <= reach; ++t) {
      const auto p = hn::Set(d, pulse[t]);
      low = hn::Add(low, hn::Mul(hn::Add(hn::LoadU(d, at - 2 * t), hn::LoadU(d, at + 2 * t)), p));
      high = hn::Add(high, hn::Mul(hn::Add(hn::LoadU(d, at + lanes - 2 * t), hn::LoadU(d, at + lanes + 2 * t)), p));
    }
    HWY_ALIGN float parts[2 * hn::MaxLanes(hn::ScalableTag<float>())];
    hn::StoreU(low, d, parts);
    hn::StoreU(high, d, parts + lanes);
    hn::Vec<decltype(d)> re, im;
    hn::LoadInterleaved2(d, parts, re, im);
    const auto amplitude = hn::Sqrt(hn::Add(hn::Mul(re, re), hn::Mul(im, im)));
    hn::StoreU(hn::Add(hn::LoadU(d, out + s), hn::Mul(amplitude, hn::Set(d, share))), d, out + s);
  });
}

void toLevelsOf(const float* in, float aside, float perDoubling, int count, float* out) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto around = hn::Mul(hn::Add(hn::LoadU(d, in + x - 1), hn::LoadU(d, in + x + 1)), hn::Set(d, aside));
    const auto mean = hn::Add(hn::Mul(hn::LoadU(d, in + x), hn::Set(d, 1.0F - 2.0F * aside)), around);
    const auto amplitude = hn::Max(mean, hn::Set(d, 1e-9F));
    hn::StoreU(hn::Add(hn::Set(d, 255.0F), hn::Mul(log2Of(d, amplitude), hn::Set(d, perDoubling))), d, out + x);
  });
}

void toAmplitudesOf(float perLevel, int count, float* inOut) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto doublings = hn::Mul(hn::Sub(hn::LoadU(d, inOut + x), hn::Set(d, 255.0F)), hn::Set(d, perLevel));
    hn::StoreU(exp2Of(d, hn::Min(hn::Max(doublings, hn::Set(d, -100.0F)), hn::Set(d, 100.0F))), d, inOut + x);
  });
}

void fromAmplitudesOf(float perDoubling, int count, float* inOut) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto amplitude = hn::Max(hn::LoadU(d, inOut + x), hn::Set(d, 1e-9F));
    hn::StoreU(hn::Add(hn::Set(d, 255.0F), hn::Mul(log2Of(d, amplitude), hn::Set(d, perDoubling))), d, inOut + x);
  });
}

void keptOfLoss(const float* loss_log2, int count, float* kept) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto loss = hn::Min(hn::Max(hn::LoadU(d, loss_log2 + x), hn::Set(d, -100.0F)), hn::Set(d, 100.0F));
    hn::StoreU(exp2Of(d, hn::Neg(loss)), d, kept + x);
  });
}

void passRayOf(const float* kept, float most, int count, float* left) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto now = hn::Mul(hn::LoadU(d, left + x), hn::LoadU(d, kept + x));
    hn::StoreU(hn::Max(hn::Min(now, hn::Set(d, most)), hn::Set(d, 1e-12F)), d, left + x);
  });
}

void addWeightedOf(const float* in, float weight, int count, float* out) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    hn::StoreU(hn::Add(hn::LoadU(d, out + x), hn::Mul(hn::LoadU(d, in + x), hn::Set(d, weight))), d, out + x);
  });
}

void addSquaresOf(const float* in, float weight, int count, float* out) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto around = hn::Mul(hn::Add(hn::LoadU(d, in + x - 1), hn::LoadU(d, in + x + 1)), hn::Set(d, 0.25F));
    const auto blurred = hn::Add(hn::Mul(hn::LoadU(d, in + x), hn::Set(d, 0.5F)), around);
    hn::StoreU(hn::Add(hn::LoadU(d, out + x), hn::Mul(hn::Mul(blurred, blurred), hn::Set(d, weight))), d, out + x);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(filterLaterallyOf);
HWY_EXPORT(scaleComplexOf);
HWY_EXPORT(addTurnedOf);
HWY_EXPORT(addComplexNoiseOf);
HWY_EXPORT(turnComplexOf);
HWY_EXPORT(addEnvelopeOf);
HWY_EXPORT(toLevelsOf);
HWY_EXPORT(toAmplitudesOf);
HWY_EXPORT(fromAmplitudesOf);
HWY_EXPORT(keptOfLoss);
HWY_EXPORT(passRayOf);
HWY_EXPORT(addWeightedOf);
HWY_EXPORT(addSquaresOf);

void filterLaterally(const LateralTask& task) { HWY_DYNAMIC_DISPATCH(filterLaterallyOf)(task); }
void scaleComplex(const float* factor, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(scaleComplexOf)(factor, count, inOut); }
void addTurned(const float* in, float weight, int quarter, int count, float* out) {
  HWY_DYNAMIC_DISPATCH(addTurnedOf)(in, weight, quarter, count, out);
}
void addComplexNoise(std::uint64_t key, const float* strength, int count, float* inOut) {
  HWY_DYNAMIC_DISPATCH(addComplexNoiseOf)(key, strength, count, inOut);
}
void turnComplex(const float* in, const float* turn, int count, float* out) { HWY_DYNAMIC_DISPATCH(turnComplexOf)(in, turn, count, out); }
void addEnvelope(const float* in, const float* pulse, int reach, float share, int samples, float* out) {
  HWY_DYNAMIC_DISPATCH(addEnvelopeOf)(in, pulse, reach, share, samples, out);
}
void toLevels(const float* in, float aside, float perDoubling, int count, float* out) {
  HWY_DYNAMIC_DISPATCH(toLevelsOf)(in, aside, perDoubling, count, out);
}
void toAmplitudes(float perLevel, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(toAmplitudesOf)(perLevel, count, inOut); }
void fromAmplitudes(float perDoubling, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(fromAmplitudesOf)(perDoubling, count, inOut); }
void keptOf(const float* loss_log2, int count, float* kept) { HWY_DYNAMIC_DISPATCH(keptOfLoss)(loss_log2, count, kept); }
void passRay(const float* kept, float most, int count, float* left) { HWY_DYNAMIC_DISPATCH(passRayOf)(kept, most, count, left); }
void addWeighted(const float* in, float weight, int count, float* out) { HWY_DYNAMIC_DISPATCH(addWeightedOf)(in, weight, count, out); }
void addSquares(const float* in, float weight, int count, float* out) { HWY_DYNAMIC_DISPATCH(addSquaresOf)(in, weight, count, out); }

}  // namespace ew::detail
#endif
