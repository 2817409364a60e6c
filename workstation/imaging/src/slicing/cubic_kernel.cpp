#include <algorithm>
#include <array>

#include "row_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "slicing/cubic_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail::HWY_NAMESPACE {

// Cubic convolution of a sample's 4 x 4 x 4 voxels: along i in exact products of bytes and weights of 14 bits, eight or four rows in a
// vector, then along j and k at once with the products of their weights. All in integers.
constexpr int kSamples = 64;  // that are weighed at a time, so that the weights stay in the first-level cache
constexpr int kWeightBits = 14;
constexpr std::int32_t kOne = 1 << kWeightBits;
constexpr int kOffRow = 8;                            // bits taken off a row's sum, which leaves 6 below a grey level in 16
constexpr int kBelowSum = 2 * kWeightBits - kOffRow;  // bits of a sum below a grey level
// What taking bits off leaves out is half a step on average.
constexpr std::int32_t kRounding = (1 << (kBelowSum - 1)) + (1 << (kWeightBits - 1));

/// Where the rows and slices of a sample lie, counted from its first: steps to the second and third; the fourth is as far from the third as
/// the second from the first.
struct Steps {
  std::uint64_t row[2], slice[2];
};
template <VoxelLayout layout>
HWY_INLINE Steps stepsOf(const Piece& piece, int n) {
  if constexpr (layout == VoxelLayout::linear) return {{piece.stride[1], 2 * piece.stride[1]}, {piece.stride[2], 2 * piece.stride[2]}};
  const auto at = static_cast<std::size_t>(n);
  return {{piece.toRow[at], piece.stride[1]}, {piece.toSlice[at], piece.stride[2]}};
}

#if HWY_TARGET == HWY_SCALAR

/// Keys, a = -1/2, of a fraction of 15 bits: weights of 14 bits of the neighbours at -1, 0, 1, 2, which add up to 1.
std::array<std::int32_t, 4> weightsAt(std::uint32_t part) {
  const auto product = [](std::int32_t a, std::int32_t b) { return (a * b + (1 << 14)) >> 15; };
  const auto t = static_cast<std::int32_t>(part & 0x7fffU);
  const std::int32_t t2 = product(t, t), rest = t2 - product(t, t2);
  const std::int32_t before = -((t - t2 - rest + 2) >> 2), at = kOne - ((t2 + rest + (rest >> 1) + 1) >> 1), beyond = -((rest + 2) >> 2);
  return {before, at, kOne - before - at - beyond, beyond};
}

template <VoxelLayout layout>
void sampleCubic(const Piece& piece, const Announcer& next) {
  for (int n = 0; n < piece.count; ++n) {
    if (n < next.count()) next.ask(n);
    const auto index = static_cast<std::size_t>(n);
    const auto i = weightsAt(piece.part[0][index]), j = weightsAt(piece.part[1][index]), k = weightsAt(piece.part[2][index]);
    const Steps steps = stepsOf<layout>(piece, n);
    std::int32_t sum = kRounding;
    for (std::size_t slice = 0; slice < 4; ++slice)
      for (std::size_t row = 0; row < 4; ++row) {
        const std::uint8_t* at = piece.voxels + piece.offset[index] + (row & 1) * steps.row[0] + row / 2 * steps.row[1] +
                                 (slice & 1) * steps.slice[0] + slice / 2 * steps.slice[1];
        std::int32_t along = 0;
        for (std::size_t m = 0; m < 4; ++m) along += at[m] * i[m];
        const std::int32_t twice = std::min(2 * j[row], 32767);
        sum += (along >> kOffRow) * ((twice * k[slice] + (1 << 14)) >> 15);
      }
    piece.out[n] = static_cast<std::uint8_t>(std::clamp(sum >> kBelowSum, 0, 255));
  }
}

#else

// Vectors of at most 256 bits: eight rows, two slices; or four, one slice.
#if HWY_CAP_GE256
constexpr std::size_t kSlices = 2;
#else
constexpr std::size_t kSlices = 1;
#endif
using Words = hn::FixedTag<std::int16_t, 8 * kSlices>;
using Sums = hn::FixedTag<std::int32_t, 4 * kSlices>;
using Rows = hn::FixedTag<std::uint32_t, 4 * kSlices>;
using Fours = hn::FixedTag<std::uint64_t, 2 * kSlices>;
using Bytes = hn::FixedTag<std::uint8_t, 16 * kSlices>;
using VecWords = hn::Vec<Words>;
using VecSums = hn::Vec<Sums>;

/// Weights of a few samples, each twice 16 bits or four times: 0 and 2, 1 and 3 along i, as the bytes of a row come apart; 0 to 3 along j
/// and k.
struct CubicWeights {
  HWY_ALIGN std::uint32_t even[kSamples + kLanesAtMost], odd[kSamples + kLanesAtMost];
  HWY_ALIGN std::uint64_t j[kSamples + kLanesAtMost], k[kSamples + kLanesAtMost];
};

/// The same of a vector of fractions. Written with t^2 - t^3, which nothing overflows.
HWY_INLINE std::array<VecS, 4> weightsAt(VecS t) {
  const I16 d;
  const hn::RebindToUnsigned<I16> du;
  const VecS one = hn::Set(d, static_cast<std::int16_t>(kOne)), two = hn::Set(d, 2);
  const VecS t2 = hn::MulFixedPoint15(t, t), rest = hn::Sub(t2, hn::MulFixedPoint15(t, t2));
  const auto quarter = [&](VecS v) { return hn::ShiftRight<2>(hn::Add(v, two)); };
  const VecS before = hn::Neg(quarter(hn::Sub(hn::Sub(t, t2), rest))), beyond = hn::Neg(quarter(rest));
  const VecS most = hn::Add(hn::Add(t2, rest), hn::ShiftRight<1>(rest));
  const VecS at = hn::Sub(one, hn::BitCast(d, hn::AverageRound(hn::BitCast(du, most), hn::Zero(du))));
  return {before, at, hn::Sub(hn::Sub(one, before), hn::Add(at, beyond)), beyond};
}

HWY_INLINE void weigh(const Piece& piece, int begin, int count, CubicWeights& out) {
  const U32 d;
  const auto together = [&](VecS low, VecS high) { return hn::BitCast(d, hn::OddEven(high, low)); };
  const auto storeFours = [&](const std::array<VecS, 4>& w, std::uint64_t* to) {
    hn::StoreInterleaved2(together(w[0], w[1]), together(w[2], w[3]), d, reinterpret_cast<std::uint32_t*>(to));
  };
  for (int n = 0; n < count; n += static_cast<int>(hn::Lanes(d))) {
    const auto along = [&](std::size_t axis) { return weightsAt(halves(piece.part[axis].data() + begin + n)); };
    const std::array<VecS, 4> i = along(0);
    hn::StoreU(together(i[0], i[2]), d, out.even + n);
    hn::StoreU(together(i[1], i[3]), d, out.odd + n);
    storeFours(along(1), out.j + n);
    storeFours(along(2), out.k + n);
  }
}

/// Four bytes each of four rows. As a vector of the compiler's own it is put together in registers; through memory the rows would have to
/// reach the cache first.
typedef std::uint32_t FourRows __attribute__((vector_size(16)));
HWY_INLINE hn::Vec<hn::FixedTag<std::uint32_t, 4> > loadSlice(const std::uint8_t* from, const Steps& steps) {
  std::uint32_t first, second, third, fourth;
  load(from, first);
  load(from + steps.row[0], second);
  load(from + steps.row[1], third);
  load(from + steps.row[1] + steps.row[0], fourth);
  const FourRows rows = {first, second, third, fourth};
  return hn::LoadU(hn::FixedTag<std::uint32_t, 4>(), reinterpret_cast<const std::uint32_t*>(&rows));
}

/// Sums along i of the rows of the slice at `from` and, where a vector holds two, of the next.
HWY_INLINE VecSums sumRows(const std::uint8_t* from, const Steps& steps, VecWords even, VecWords odd) {
  const Words d;
  const Sums dSums;
#if HWY_CAP_GE256
  const auto rows = hn::BitCast(d, hn::Combine(Rows(), loadSlice(from + steps.slice[0], steps), loadSlice(from, steps)));
#else
  const auto rows = hn::BitCast(d, loadSlice(from, steps));
#endif
  const auto low = hn::And(rows, hn::Set(d, 0xff));
  const auto high = hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(hn::RebindToUnsigned<Words>(), rows)));
  VecSums rest = hn::Zero(dSums);
  const VecSums sum = hn::ReorderWidenMulAccumulate(dSums, low, even, hn::Zero(dSums), rest);
  return hn::ReorderWidenMulAccumulate(dSums, high, odd, sum, rest);
}

/// The sums of slices `low` and two further on side by side in 16 bits.
HWY_INLINE VecWords sideBySide(VecSums low, VecSums high) {
  const Words d;
  return hn::OddEven(hn::BitCast(d, hn::ShiftLeft<16 - kOffRow>(high)), hn::BitCast(d, hn::ShiftRight<kOffRow>(low)));
}

/// How the four weights along j and k of a sample are spread over what sideBySide gives: j over pairs, k over slices s and s + 2.
#if HWY_CAP_GE256
HWY_ALIGN constexpr std::uint8_t kSpreadJ[32] = {0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 4, 5, 6, 7, 6, 7,
                                                 0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 4, 5, 6, 7, 6, 7};
HWY_ALIGN constexpr std::uint8_t kSpreadK[1][32] = {
    {0, 1, 4, 5, 0, 1, 4, 5, 0, 1, 4, 5, 0, 1, 4, 5, 2, 3, 6, 7, 2, 3, 6, 7, 2, 3, 6, 7, 2, 3, 6, 7}};
#else
HWY_ALIGN constexpr std::uint8_t kSpreadJ[16] = {0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 4, 5, 6, 7, 6, 7};
HWY_ALIGN constexpr std::uint8_t kSpreadK[2][16] = {{0, 1, 4, 5, 0, 1, 4, 5, 0, 1, 4, 5, 0, 1, 4, 5},
                                                    {2, 3, 6, 7, 2, 3, 6, 7, 2, 3, 6, 7, 2, 3, 6, 7}};
#endif

/// The sum over a sample's rows, in parts that are still to be added up.
HWY_INLINE VecSums sumSample(const std::uint8_t* from, const Steps& steps, const CubicWeights& weights, int n) {
  const Words d;
  const Sums dSums;
  const VecWords even = hn::BitCast(d, hn::Set(Rows(), weights.even[n])), odd = hn::BitCast(d, hn::Set(Rows(), weights.odd[n]));
  const auto spread = [&](std::uint64_t four, const std::uint8_t* pattern) {
    return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(Bytes(), hn::Set(Fours(), four)), hn::Load(Bytes(), pattern)));
  };
  const VecWords j = spread(weights.j[n], kSpreadJ), twice = hn::SaturatedAdd(j, j);
  VecSums sum = hn::Zero(dSums), rest = hn::Zero(dSums);
  for (std::size_t s = 0; s < 2; s += kSlices) {
    const std::uint8_t* slice = from + s * steps.slice[0];
    const VecWords levels = sideBySide(sumRows(slice, steps, even, odd), sumRows(slice + steps.slice[1], steps, even, odd));
    const VecWords across = hn::MulFixedPoint15(twice, spread(weights.k[n], kSpreadK[s / kSlices]));
    sum = hn::ReorderWidenMulAccumulate(dSums, levels, across, sum, rest);
  }
  return sum;
}

/// Adds up the four parts of each of four samples; of eight, in their order, where a vector holds eight.
HWY_INLINE VecSums addUp(const std::int32_t* parts) {
  const Sums d;
  const Fours d64;
  const auto of = [&](std::size_t sample) { return hn::Load(d, parts + 4 * kSlices * sample); };
  const auto two = [&](VecSums a, VecSums b) { return hn::Add(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b)); };
  const auto four = [&](std::size_t first) {
    const auto low = hn::BitCast(d64, two(of(first), of(first + 1))), high = hn::BitCast(d64, two(of(first + 2), of(first + 3)));
    return hn::Add(hn::BitCast(d, hn::InterleaveLower(d64, low, high)), hn::BitCast(d, hn::InterleaveUpper(d64, low, high)));
  };
#if HWY_CAP_GE256
  const VecSums low = four(0), high = four(4);
  return hn::Add(hn::ConcatLowerLower(d, high, low), hn::ConcatUpperUpper(d, high, low));
#else
  return four(0);
#endif
}

template <VoxelLayout layout>
void sampleCubic(const Piece& piece, const Announcer& next) {
  constexpr int kTogether = 4 * kSlices;
  const Sums d;
  CubicWeights weights;
  HWY_ALIGN std::int32_t parts[kSamples * kTogether];
  for (int begin = 0; begin < piece.count; begin += kSamples) {
    const int count = std::min(kSamples, piece.count - begin);
    weigh(piece, begin, count, weights);
    for (int n = 0; n < count; ++n) {
      if (begin + n < next.count()) next.ask(begin + n);
      const std::uint8_t* from = piece.voxels + piece.offset[static_cast<std::size_t>(begin + n)];
      hn::Store(sumSample(from, stepsOf<layout>(piece, begin + n), weights, n), d, parts + kTogether * static_cast<std::ptrdiff_t>(n));
    }
    for (int n = 0; n < count; n += kTogether) {
      const VecSums sum = hn::Add(addUp(parts + kTogether * static_cast<std::ptrdiff_t>(n)), hn::Set(d, kRounding));
      storeGreys(d, hn::ShiftRight<kBelowSum>(sum), count - n, piece.out + begin + n);
    }
  }
}

#endif

void sampleCubicAny(VoxelLayout layout, const Piece& piece, const Announcer& next) {
  if (layout == VoxelLayout::bricked) return sampleCubic<VoxelLayout::bricked>(piece, next);
  sampleCubic<VoxelLayout::linear>(piece, next);
}

}  // namespace ew::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(sampleCubicAny);

void sampleCubicPiece(VoxelLayout layout, const Piece& piece, const Announcer& next) {
  HWY_DYNAMIC_DISPATCH(sampleCubicAny)(layout, piece, next);
}

}  // namespace ew::detail
#endif
