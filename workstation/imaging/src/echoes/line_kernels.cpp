#include "line_kernels.h"

#include <algorithm>

#include "pairs.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/line_kernels.cpp"
#include "hwy/foreach_target.h"
//
#include "echoes/deposits-inl.h"
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // deposits-inl.h, powers-inl.h

/// Sums of one vector of columns over the rows around a line; `kVectors` side by side, so that sums do not wait for one another. Two rows
/// as far from the line are added up as whole numbers, which leaves a bit of their thirty-one for the sum.
template <int kVectors, class D>
HWY_INLINE void lateralSums(D d, const LateralTask& task, const std::int32_t* middle, int x, float* out) {
  const hn::RebindToSigned<D> di;
  const auto step = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  hn::Vec<D> sum[kVectors];
  for (std::ptrdiff_t v = 0; v < kVectors; ++v)
    sum[v] = hn::Mul(hn::LoadU(d, task.weights + x + v * step), hn::ConvertTo(d, hn::LoadU(di, middle + x + v * step)));
  for (int t = 1; t <= task.reach; ++t) {
    const std::ptrdiff_t off = t * task.stride, weights = static_cast<std::ptrdiff_t>(t) * task.width;
    for (std::ptrdiff_t v = 0; v < kVectors; ++v) {
      const auto both = hn::Add(hn::LoadU(di, middle - off + x + v * step), hn::LoadU(di, middle + off + x + v * step));
      sum[v] = hn::Add(sum[v], hn::Mul(hn::LoadU(d, task.weights + weights + x + v * step), hn::ConvertTo(d, both)));
    }
  }
  for (std::ptrdiff_t v = 0; v < kVectors; ++v) hn::StoreU(hn::Mul(sum[v], hn::Set(d, task.unit)), d, out + x + v * step);
}

void filterLaterallyOf(const LateralTask& task) {
  const hn::ScalableTag<float> whole;
  const auto lanes = static_cast<int>(hn::Lanes(whole));
  int row = task.beginCleared;
  // While they are near: rows that no later line asks.
  const auto emptyTo = [&](int end) {
    for (; row < end; ++row) std::fill_n(task.tile + row * task.stride, task.cleared, 0);
  };
  for (int line = task.beginLine; line < task.endLine; ++line) {
    const int at = task.firstRow + line * task.rowsPerLine;
    const std::int32_t* middle = task.tile + at * task.stride;
    float* out = task.out + line * task.outStride;
    int x = 0;
    for (; x + 4 * lanes <= task.width; x += 4 * lanes) lateralSums<4>(whole, task, middle, x, out);
    for (; x + lanes <= task.width; x += lanes) lateralSums<1>(whole, task, middle, x, out);
    const hn::CappedTag<float, 1> one;
    for (; x < task.width; ++x) lateralSums<1>(one, task, middle, x, out);
    emptyTo(std::min(at + task.rowsPerLine - task.reach, task.endCleared));
  }
  emptyTo(task.endCleared);
}

/// Two factors of a vector of columns, from the two vectors of steps that begin at the first one's.
template <class D>
HWY_INLINE hn::Vec<D> gainAt(D d, const GainSteps& gain, int column) {
  const hn::RebindToSigned<D> di;
  const auto columns = hn::ConvertTo(d, hn::Iota(di, column));
  const auto at = hn::Add(hn::Set(d, gain.first), hn::Mul(columns, hn::Set(d, gain.perColumn)));
  const auto step = hn::Min(hn::Max(at, hn::Zero(d)), hn::Set(d, static_cast<float>(gain.steps - 1) - 1e-3F));
  const auto whole = hn::ConvertTo(di, step);
  const auto part = hn::Sub(step, hn::ConvertTo(d, whole));
  const std::int32_t first = hn::GetLane(whole);
  const auto index = hn::Sub(whole, hn::Set(di, first));
  hn::Vec<D> here, next;
  if (HWY_LIKELY(hn::AllTrue(di, hn::Lt(index, hn::Set(di, static_cast<std::int32_t>(hn::Lanes(d))))))) {
    const auto indices = hn::IndicesFromVec(d, index);
    here = hn::TableLookupLanes(hn::LoadU(d, gain.ofSteps + first), indices);
    next = hn::TableLookupLanes(hn::LoadU(d, gain.ofSteps + first + 1), indices);
  } else {
    here = hn::GatherIndex(d, gain.ofSteps, whole);
    next = hn::GatherIndex(d, gain.ofSteps + 1, whole);
  }
  return hn::Add(here, hn::Mul(part, hn::Sub(next, here)));
}

void scaleComplexOf(const GainSteps& gain, int count, float* inOut) {
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const auto factor = gainAt(d, gain, x);
    const auto lanes = static_cast<int>(hn::Lanes(d));
    HWY_ALIGN float twice[2 * hn::MaxLanes(hn::ScalableTag<float>())];
    hn::StoreInterleaved2(factor, factor, d, twice);
    for (std::ptrdiff_t half = 0; half < 2; ++half) {
      float* at = pairAt(inOut, x) + half * lanes;
      hn::StoreU(hn::Mul(hn::LoadU(d, at), hn::LoadU(d, twice + half * lanes)), d, at);
    }
  });
}

struct QuarterTurnWeight {
  float ofEven, ofOdd;  ///< of the real and of the imaginary part
  bool swaps;           ///< the two parts of what is added
};
QuarterTurnWeight weightOf(const QuarterTurnRow& row) {
  const float weight = row.quarter == 2 || row.quarter == 3 ? -row.weight : row.weight;
  return row.quarter % 2 == 1 ? QuarterTurnWeight{-weight, weight, true} : QuarterTurnWeight{weight, weight, false};
}

/// @return how many numbers were added
template <class D>
HWY_INLINE int addTurnedRows(D d, const QuarterTurnRow* rows, const QuarterTurnWeight* weights, int rowCount, int numbers, float* out) {
  const auto lanes = static_cast<int>(hn::Lanes(d));
  if constexpr (hn::MaxLanes(D()) > 1) {
    hn::Vec<D> weight[kMostQuarterTurnRows];
    for (int n = 0; n < rowCount; ++n) weight[n] = hn::OddEven(hn::Set(d, weights[n].ofOdd), hn::Set(d, weights[n].ofEven));
    int x = 0;
    for (; x + lanes <= numbers; x += lanes) {
      auto sum = hn::LoadU(d, out + x);
      for (int n = 0; n < rowCount; ++n) {
        const auto in = hn::LoadU(d, rows[n].in + x);
        sum = hn::Add(sum, hn::Mul(weights[n].swaps ? hn::Reverse2(d, in) : in, weight[n]));
      }
      hn::StoreU(sum, d, out + x);
    }
    return x;
  }
  return 0;
}

void addTurnedOf(const QuarterTurnRow* rows, int rowCount, int count, float* out) {
  QuarterTurnWeight weights[kMostQuarterTurnRows];
  for (int n = 0; n < rowCount; ++n) weights[n] = weightOf(rows[n]);
  for (int x = addTurnedRows(hn::ScalableTag<float>(), rows, weights, rowCount, 2 * count, out); x < 2 * count; x += 2)
    for (int n = 0; n < rowCount; ++n) {
      const QuarterTurnWeight& weight = weights[n];
      const float* in = rows[n].in + x;
      out[x] += in[weight.swaps ? 1 : 0] * weight.ofEven;
      out[x + 1] += in[weight.swaps ? 0 : 1] * weight.ofOdd;
    }
}

void addComplexNoiseOf(std::uint64_t key, const float* strength, int count, float* inOut) {
  // Two even 16-bit numbers have the variance 2^32 / 6 together; the pulse's filter makes their sum Gaussian enough.
  constexpr float kPerDeviation = 3.7376e-5F;
  HWY_ALIGN float noise[2 * hn::MaxLanes(hn::ScalableTag<float>())];
  forColumns(count, [&](auto d, int x) HWY_ATTR {
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::RebindToSigned<decltype(d)> di;
    const auto first = spreadOf(du, hn::Add(hn::Iota(du, static_cast<std::uint32_t>(x)), hn::Set(du, static_cast<std::uint32_t>(key))));
    const auto second = spreadOf(du, hn::Xor(first, hn::Set(du, static_cast<std::uint32_t>(key >> 32))));
    const auto part = [&](auto hash) HWY_ATTR {
      const auto sum = hn::Add(hn::ShiftRight<16>(hash), hn::And(hash, hn::Set(du, 0xFFFFU)));
      return hn::Mul(hn::Sub(hn::ConvertTo(d, hn::BitCast(di, sum)), hn::Set(d, 65535.0F)), hn::Set(d, kPerDeviation));
    };
    const auto scale = hn::LoadU(d, strength + x);
    hn::StoreInterleaved2(hn::Mul(part(first), scale), hn::Mul(part(second), scale), d, noise);
    for (std::size_t half = 0; half < 2; ++half) {
      float* at = pairAt(inOut, x) + half * hn::Lanes(d);
      hn::StoreU(hn::Add(hn::LoadU(d, at), hn::LoadU(d, noise + half * hn::Lanes(d))), d, at);
    }
  });
}

/// Two vectors of interleaved numbers.
template <class D>
struct Interleaved {
  hn::Vec<D> low, high;
};
template <class D>
HWY_INLINE Interleaved<D> loadInterleaved(D d, const float* at) {
  return {hn::LoadU(d, at), hn::LoadU(d, at + hn::Lanes(d))};
}
template <class D>
HWY_INLINE Interleaved<D> scaled(D d, const Interleaved<D>& in, float weight) {
  const auto factor = hn::Set(d, weight);
  return {hn::Mul(in.low, factor), hn::Mul(in.high, factor)};
}
template <class D>
HWY_INLINE void addScaled(D d, const Interleaved<D>& in, float weight, Interleaved<D>& sum) {
  const auto more = scaled(d, in, weight);
  sum = {hn::Add(sum.low, more.low), hn::Add(sum.high, more.high)};
}
template <class D>
HWY_INLINE void partsOf(D d, const Interleaved<D>& in, hn::Vec<D>& re, hn::Vec<D>& im) {
  HWY_ALIGN float parts[2 * hn::MaxLanes(hn::ScalableTag<float>())];
  hn::StoreU(in.low, d, parts);
  hn::StoreU(in.high, d, parts + hn::Lanes(d));
  hn::LoadInterleaved2(d, parts, re, im);
}
template <class V>
HWY_INLINE V lengthOf(V re, V im) {
  return hn::Sqrt(hn::Add(hn::Mul(re, re), hn::Mul(im, im)));
}

template <int kPairs, bool kMiddle>
void envelopeOfLooks(const EnvelopeTask& task, const float* in, int samples, float* levels) {
  const float *cosine[kPairs + 1], *sine[kPairs + 1];
  for (std::size_t p = 0; p != kPairs; ++p) {
    cosine[p] = task.pairs[p].cosine.data();
    sine[p] = task.pairs[p].sine.data();
  }
  forColumns(samples, [&](auto d, int s) HWY_ATTR {
    using D = decltype(d);
    const float* at = pairAt(in, s);
    const Interleaved<D> own = loadInterleaved(d, at);
    Interleaved<D> middle{hn::Zero(d), hn::Zero(d)}, even[kPairs + 1], odd[kPairs + 1];
    if constexpr (kMiddle) middle = scaled(d, own, task.pulse[0]);
    for (std::size_t p = 0; p != kPairs; ++p) {
      even[p] = scaled(d, own, cosine[p][0]);
      odd[p] = {hn::Zero(d), hn::Zero(d)};
    }
    for (int t = 1; t <= task.reach; ++t) {
      const Interleaved<D> before = loadInterleaved(d, pairAt(at, -t)), after = loadInterleaved(d, pairAt(at, t));
      const Interleaved<D> sum{hn::Add(before.low, after.low), hn::Add(before.high, after.high)};
      if constexpr (kMiddle) addScaled(d, sum, task.pulse[t], middle);
      if constexpr (kPairs > 0) {
        const Interleaved<D> apart{hn::Sub(after.low, before.low), hn::Sub(after.high, before.high)};
        for (std::size_t p = 0; p != kPairs; ++p) {
          addScaled(d, sum, cosine[p][t], even[p]);
          addScaled(d, apart, sine[p][t], odd[p]);
        }
      }
    }
    hn::Vec<D> re, im;
    auto level = hn::Zero(d);
    if constexpr (kMiddle) {
      partsOf(d, middle, re, im);
      level = hn::Mul(lengthOf(re, im), hn::Set(d, task.middleShare));
    }
    for (std::size_t p = 0; p != kPairs; ++p) {
      hn::Vec<D> oddRe, oddIm;
      partsOf(d, even[p], re, im);
      partsOf(d, odd[p], oddRe, oddIm);
      // A - iB and A + iB.
      const auto above = lengthOf(hn::Add(re, oddIm), hn::Sub(im, oddRe)), below = lengthOf(hn::Sub(re, oddIm), hn::Add(im, oddRe));
      level = hn::Add(level, hn::Mul(hn::Add(above, below), hn::Set(d, task.pairs[p].share)));
    }
    hn::StoreU(level, d, levels + s);
  });
}

void envelopeOfLine(const EnvelopeTask& task, const float* in, int samples, float* levels) {
  const bool hasMiddle = task.middleShare > 0.0F;
  switch (task.pairs.size()) {
    case 0:
      return envelopeOfLooks<0, true>(task, in, samples, levels);
    case 1:
      return hasMiddle ? envelopeOfLooks<1, true>(task, in, samples, levels) : envelopeOfLooks<1, false>(task, in, samples, levels);
    default:
      return hasMiddle ? envelopeOfLooks<2, true>(task, in, samples, levels) : envelopeOfLooks<2, false>(task, in, samples, levels);
  }
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

void addFallingOf(const float* in, const float* factor, float weight, int count, float* out) {
  forColumns(count, [&](auto d, int n) HWY_ATTR {
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto strength = hn::Mul(hn::LoadU(d, factor + n), hn::Set(d, weight));
    HWY_ALIGN float twice[2 * hn::MaxLanes(hn::ScalableTag<float>())];
    hn::StoreInterleaved2(strength, strength, d, twice);
    for (std::ptrdiff_t half = 0; half < 2; ++half) {
      float* at = pairAt(out, n) + half * lanes;
      const auto more = hn::Mul(hn::LoadU(d, pairAt(in, n) + half * lanes), hn::LoadU(d, twice + half * lanes));
      hn::StoreU(hn::Add(hn::LoadU(d, at), more), d, at);
    }
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
HWY_EXPORT(envelopeOfLine);
HWY_EXPORT(toLevelsOf);
HWY_EXPORT(toAmplitudesOf);
HWY_EXPORT(fromAmplitudesOf);
HWY_EXPORT(keptOfLoss);
HWY_EXPORT(passRayOf);
HWY_EXPORT(addWeightedOf);
HWY_EXPORT(addFallingOf);
HWY_EXPORT(addSquaresOf);

void filterLaterally(const LateralTask& task) { HWY_DYNAMIC_DISPATCH(filterLaterallyOf)(task); }
void scaleComplex(const GainSteps& gain, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(scaleComplexOf)(gain, count, inOut); }
void addTurned(const QuarterTurnRow* rows, int rowCount, int count, float* out) {
  HWY_DYNAMIC_DISPATCH(addTurnedOf)(rows, rowCount, count, out);
}
void addComplexNoise(std::uint64_t key, const float* strength, int count, float* inOut) {
  HWY_DYNAMIC_DISPATCH(addComplexNoiseOf)(key, strength, count, inOut);
}
void envelopeOf(const EnvelopeTask& task, const float* in, int samples, float* levels) {
  HWY_DYNAMIC_DISPATCH(envelopeOfLine)(task, in, samples, levels);
}
void toLevels(const float* in, float aside, float perDoubling, int count, float* out) {
  HWY_DYNAMIC_DISPATCH(toLevelsOf)(in, aside, perDoubling, count, out);
}
void toAmplitudes(float perLevel, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(toAmplitudesOf)(perLevel, count, inOut); }
void fromAmplitudes(float perDoubling, int count, float* inOut) { HWY_DYNAMIC_DISPATCH(fromAmplitudesOf)(perDoubling, count, inOut); }
void keptOf(const float* loss_log2, int count, float* kept) { HWY_DYNAMIC_DISPATCH(keptOfLoss)(loss_log2, count, kept); }
void passRay(const float* kept, float most, int count, float* left) { HWY_DYNAMIC_DISPATCH(passRayOf)(kept, most, count, left); }
void addWeighted(const float* in, float weight, int count, float* out) { HWY_DYNAMIC_DISPATCH(addWeightedOf)(in, weight, count, out); }
void addFalling(const float* in, const float* factor, float weight, int count, float* out) {
  HWY_DYNAMIC_DISPATCH(addFallingOf)(in, factor, weight, count, out);
}
void addSquares(const float* in, float weight, int count, float* out) { HWY_DYNAMIC_DISPATCH(addSquaresOf)(in, weight, count, out); }

}  // namespace ew::detail
#endif
