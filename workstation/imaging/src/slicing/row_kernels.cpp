#include "row_kernels.h"

#include <algorithm>
#include <cstring>

#include "bricks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "slicing/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using U32 = hn::ScalableTag<std::uint32_t>;
using I32 = hn::RebindToSigned<U32>;
using F32 = hn::RebindToFloat<U32>;
using U8 = hn::Rebind<std::uint8_t, I32>;
using VecU = hn::Vec<U32>;
using VecI = hn::Vec<I32>;
using VecF = hn::Vec<F32>;

HWY_INLINE VecU set(std::uint32_t value) { return hn::Set(U32(), value); }
HWY_INLINE VecU set(int value) { return hn::Set(U32(), static_cast<std::uint32_t>(value)); }
HWY_INLINE VecF set(float value) { return hn::Set(F32(), value); }
HWY_INLINE std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
HWY_INLINE VecF toFloat(VecU value) { return hn::ConvertTo(F32(), hn::BitCast(I32(), value)); }

/// value / Bricks::kCells for value < 2^20.
HWY_INLINE VecU cellsIn(VecU value) {
  const VecF quotient = hn::Mul(hn::Add(toFloat(value), set(0.5F)), set(1.0F / Bricks::kCells));
  return hn::BitCast(U32(), hn::ConvertTo(I32(), quotient));
}
HWY_INLINE VecU brickOffsetI(VecU i) { return hn::Add(i, hn::Mul(cellsIn(i), set(Bricks::kBytes - Bricks::kCells))); }
HWY_INLINE VecU brickOffsetJ(VecU j, VecU stride) {
  return hn::Add(hn::Mul(hn::And(j, set(Bricks::kLastRow)), set(Bricks::kStored)), hn::Mul(hn::ShiftRight<Bricks::kRowBits>(j), stride));
}
HWY_INLINE VecU brickOffsetK(VecU k, VecU stride) {
  return hn::Add(hn::Mul(hn::And(k, set(Bricks::kLastSlice)), set(Bricks::kStored * Bricks::kRows)),
                 hn::Mul(hn::ShiftRight<Bricks::kSliceBits>(k), stride));
}

template <Quality quality, VoxelLayout layout>
void lay(Piece& piece) {
  const U32 d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VecU strideJ = set(low(piece.stride[1])), strideK = set(low(piece.stride[2]));
  for (int n = 0; n < piece.count; n += lanes) {
    std::array<VecU, 3> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (std::size_t a = 0; a < 3; ++a) {
      sum[a] = hn::Add(hn::LoadU(d, piece.templateFraction[a] + n), set(piece.startFraction[a]));
      if constexpr (quality != Quality::weave) hn::StoreU(hn::And(sum[a], set(kFractionMask)), d, piece.fraction[a].data() + n);
    }
    const auto store = [&](VecU value, Piece::Values& values) { hn::StoreU(value, d, values.data() + n); };
    // The top bit of a sum of two 31 bit fractions says that they reach a whole voxel.
    if constexpr (layout == VoxelLayout::linear) {
      const auto carry = [&](VecU one, VecU stride) {
        const auto reached = hn::BroadcastSignBit(hn::BitCast(I32(), one));
        return hn::And(hn::BitCast(d, reached), stride);
      };
      const VecU carried = hn::Add(hn::ShiftRight<kFractionBits>(sum[0]), hn::Add(carry(sum[1], strideJ), carry(sum[2], strideK)));
      store(hn::Add(hn::Add(hn::LoadU(d, piece.templateOffset + n), set(piece.startOffset)), carried), piece.offset[0]);
    } else {
      std::array<VecU, 3> whole = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
      for (std::size_t a = 0; a < 3; ++a)
        whole[a] =
            hn::Add(hn::Add(hn::LoadU(d, piece.templateWhole[a] + n), set(piece.startWhole[a])), hn::ShiftRight<kFractionBits>(sum[a]));
      const VecU alongI = brickOffsetI(whole[0]);
      const auto alongJ = [&](int step) { return hn::Add(alongI, brickOffsetJ(hn::Add(whole[1], set(step)), strideJ)); };
      const auto alongK = [&](int step) { return brickOffsetK(hn::Add(whole[2], set(step)), strideK); };
      if constexpr (quality == Quality::weave) {
        store(hn::Add(alongJ(0), alongK(0)), piece.offset[0]);
      } else {
        const VecU j0 = alongJ(0), j1 = alongJ(1), k0 = alongK(0), k1 = alongK(1);
        store(hn::Add(j0, k0), piece.offset[0]);
        store(hn::Add(j1, k0), piece.offset[1]);
        store(hn::Add(j0, k1), piece.offset[2]);
        store(hn::Add(j1, k1), piece.offset[3]);
      }
    }
  }
}

/// Asks for the line of every offset that lies on another line than the sample before it: a request costs as much as a load, and in
/// bricks most samples share their line with the one before.
/// @param rows where the offsets count from
template <std::size_t count>
HWY_INLINE void announce(const std::array<const std::uint8_t*, count>& rows, const Piece::Values& values, int samples) {
  const U32 d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::uint32_t* offset = values.data();
  // One list for the whole piece: a loop over the few changes of a vector would end at another place each time.
  Piece::Values changed;
  changed[0] = offset[0];
  std::size_t found = 1;
  for (int n = 1; n < samples; n += lanes) {
    const VecU here = hn::LoadU(d, offset + n), before = hn::LoadU(d, offset + n - 1);
    const auto differs =
        hn::And(hn::Ne(hn::ShiftRight<6>(here), hn::ShiftRight<6>(before)), hn::FirstN(d, static_cast<std::size_t>(samples - n)));
    hn::StoreU(hn::Compress(here, differs), d, changed.data() + found);  // into memory at once it takes 100 cycles on Zen 4
    found += hn::CountTrue(d, differs);
  }
  for (std::size_t m = 0; m < found; ++m)
    for (const std::uint8_t* row : rows) prefetch(row + changed[m]);
}

void announceAny(PieceKind kind, const Piece& piece) {
  if (piece.count == 0) return;
  const bool bricked = kind.layout == VoxelLayout::bricked;
  if (kind.quality == Quality::weave) return announce<1>({piece.voxels}, piece.offset[0], piece.count);
  if (kind.quality == Quality::linear) {
    if (bricked) {
      announce<1>({piece.voxels}, piece.offset[0], piece.count);
      return announce<1>({piece.voxels}, piece.offset[3], piece.count);
    }
    const std::uint8_t *next = piece.voxels + piece.stride[1], *above = piece.voxels + piece.stride[2];
    return announce<4>({piece.voxels, next, above, above + piece.stride[1]}, piece.offset[0], piece.count);
  }
  // The corners of the neighbourhood: what lies between them was a corner of samples before. All sixteen rows take 1.16 times the time.
  const std::uint8_t *first = piece.voxels, *last = first + 3 * piece.stride[2];
  announce<4>({first, first + 3 * piece.stride[1], last, last + 3 * piece.stride[1]}, piece.offset[0], piece.count);
}

/// Loads stand apart from arithmetic, in parts that stay in the first-level cache. Gathers would do both at once, but they wait for
/// their slowest element: on volumes beyond the first-level cache scalar loads were 1.7 times as fast (AVX-512, Zen 4).
constexpr int kPart = Loaded::kMost;

template <class Bytes>
HWY_INLINE void load(const std::uint8_t* from, Bytes& bytes) {
  std::memcpy(&bytes, from, sizeof bytes);
}

HWY_INLINE void storeGreys(VecI greys, int count, std::uint8_t* out) {
  const U8 d;
  const auto bytes = hn::DemoteTo(d, greys);
  if (count >= static_cast<int>(hn::Lanes(d))) return hn::StoreU(bytes, d, out);
  HWY_ALIGN std::uint8_t last[kLanesAtMost];
  hn::StoreU(bytes, d, last);
  std::memcpy(out, last, static_cast<std::size_t>(count));
}

HWY_INLINE VecI rounded(VecF value) { return hn::ConvertTo(I32(), hn::Add(value, set(0.5F))); }
HWY_INLINE VecF blend(VecF a, VecF b, VecF weight) { return hn::Add(a, hn::Mul(weight, hn::Sub(b, a))); }
template <int kByte>
HWY_INLINE VecF byteOf(VecU four) {
  if constexpr (kByte == 0) return toFloat(hn::And(four, set(0xffU)));
  if constexpr (kByte == 3) return toFloat(hn::ShiftRight<24>(four));
  return toFloat(hn::And(hn::ShiftRight<8 * kByte>(four), set(0xffU)));
}
using Fractions = std::array<const std::uint32_t*, 3>;
HWY_INLINE VecF weightAt(const Fractions& fraction, std::size_t axis, int n) {
  return hn::Mul(toFloat(hn::LoadU(U32(), fraction[axis] + n)), set(kPerFraction));
}
HWY_INLINE Fractions fractionsFrom(const Piece& piece, int begin) {
  return {piece.fraction[0].data() + begin, piece.fraction[1].data() + begin, piece.fraction[2].data() + begin};
}

/// Between the eight neighbours of samples n and following; `pairOf` gives the two of a row, the first in the low byte.
template <class PairOf>
HWY_INLINE VecF trilinear(const Fractions& fraction, int n, const PairOf& pairOf) {
  const VecF weightI = weightAt(fraction, 0, n), weightJ = weightAt(fraction, 1, n), weightK = weightAt(fraction, 2, n);
  const auto alongI = [&](std::size_t row) {
    const VecU pair = pairOf(row);
    return blend(byteOf<0>(pair), toFloat(hn::ShiftRight<8>(pair)), weightI);
  };
  const VecF near = blend(alongI(0), alongI(1), weightJ), far = blend(alongI(2), alongI(3), weightJ);
  return blend(near, far, weightK);
}

void blendPairs(const Loaded& loaded, const Fractions& fraction, int count, std::uint8_t* out) {
  const U32 d;
  for (int n = 0; n < count; n += static_cast<int>(hn::Lanes(d))) {
    const auto pairOf = [&](std::size_t row) {
      return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint16_t, U32>(), loaded.pairs[row] + n));
    };
    storeGreys(rounded(trilinear(fraction, n, pairOf)), count - n, out + n);
  }
}

void blendLevels(const Loaded& echo, const Loaded* coverage, const Fractions& fraction, int count, float* out) {
  const U32 d;
  const hn::Rebind<std::uint16_t, U32> pairs;
  for (int n = 0; n < count; n += static_cast<int>(hn::Lanes(d))) {
    const auto echoOf = [&](std::size_t row) { return hn::PromoteTo(d, hn::LoadU(pairs, echo.pairs[row] + n)); };
    if (coverage == nullptr) {
      hn::StoreU(trilinear(fraction, n, echoOf), F32(), out + n);
      continue;
    }
    const auto presentOf = [&](std::size_t row) {  // 0 or 1 in each of the two bytes; Coverage goes up to 2
      const VecU covered = hn::PromoteTo(d, hn::LoadU(pairs, coverage->pairs[row] + n));
      return hn::And(hn::Or(covered, hn::ShiftRight<1>(covered)), set(0x0101U));
    };
    const auto presentEchoOf = [&](std::size_t row) {
      const VecU present = presentOf(row);
      return hn::And(echoOf(row), hn::Sub(hn::ShiftLeft<8>(present), present));
    };
    hn::StoreU(hn::Div(trilinear(fraction, n, presentEchoOf), trilinear(fraction, n, presentOf)), F32(), out + n);
  }
}

void sampleWeave(const Piece& piece) {
  const std::uint8_t* HWY_RESTRICT from = piece.voxels;
  const std::uint32_t* HWY_RESTRICT offset = piece.offset[0].data();
  std::uint8_t* HWY_RESTRICT out = piece.out;
  const int count = piece.count;
  for (int n = 0; n < count; ++n) out[n] = from[offset[n]];
}

template <VoxelLayout layout>
void sampleLinear(const Piece& piece) {
  HWY_ALIGN Loaded loaded;
  auto& [pair00, pair10, pair01, pair11] = loaded.pairs;
  for (int begin = 0; begin < piece.count; begin += kPart) {
    const int count = std::min(kPart, piece.count - begin);
    if constexpr (layout == VoxelLayout::linear) {
      const std::uint32_t* HWY_RESTRICT offset = piece.offset[0].data() + begin;
      const std::uint8_t *HWY_RESTRICT at00 = piece.voxels, *HWY_RESTRICT at10 = at00 + piece.stride[1],
                                       *HWY_RESTRICT at01 = at00 + piece.stride[2], *HWY_RESTRICT at11 = at10 + piece.stride[2];
      for (int n = 0; n < count; ++n) {
        const std::size_t o = offset[n];
        load(at00 + o, pair00[n]);
        load(at10 + o, pair10[n]);
        load(at01 + o, pair01[n]);
        load(at11 + o, pair11[n]);
      }
    } else {
      const std::uint32_t *HWY_RESTRICT o00 = piece.offset[0].data() + begin, *HWY_RESTRICT o10 = piece.offset[1].data() + begin,
                                        *HWY_RESTRICT o01 = piece.offset[2].data() + begin,
                                        *HWY_RESTRICT o11 = piece.offset[3].data() + begin;
      const std::uint8_t* HWY_RESTRICT from = piece.voxels;
      for (int n = 0; n < count; ++n) {
        load(from + o00[n], pair00[n]);
        load(from + o10[n], pair10[n]);
        load(from + o01[n], pair01[n]);
        load(from + o11[n], pair11[n]);
      }
    }
    blendPairs(loaded, fractionsFrom(piece, begin), count, piece.out + begin);
  }
}

/// Keys, a = -1/2: weights of the neighbours at -1, 0, 1, 2; the scalar form stands in row_sampler.cpp.
HWY_INLINE std::array<VecF, 4> cubicWeights(VecF t) {
  const VecF one = set(1.0F), half = set(0.5F), minusHalf = set(-0.5F);
  return {hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(minusHalf, t), one), t), minusHalf), t),
          hn::Add(hn::Mul(hn::Mul(hn::Add(hn::Mul(set(1.5F), t), set(-2.5F)), t), t), one),
          hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(set(-1.5F), t), set(2.0F)), t), half), t),
          hn::Mul(hn::Mul(hn::Add(hn::Mul(half, t), minusHalf), t), t)};
}

/// Products of bytes and weights of 14 bits, summed over the four voxels of a row: exact in integers. Weights come in pairs, 0 and 2, 1 and
/// 3, as 16 bit halves, because that is how the bytes come apart most easily.
HWY_INLINE VecI rowSum(VecU four, VecU weights02, VecU weights13) {
  const I32 d;
  const VecU even = hn::And(four, set(0x00ff00ffU)), odd = hn::And(hn::ShiftRight<8>(four), set(0x00ff00ffU));
#if HWY_TARGET == HWY_SCALAR
  const auto product = [&](VecU bytes, VecU weights) {
    const VecI first = hn::Mul(hn::BitCast(d, hn::And(bytes, set(0xffU))), hn::ShiftRight<16>(hn::ShiftLeft<16>(hn::BitCast(d, weights))));
    return hn::Add(first, hn::Mul(hn::BitCast(d, hn::ShiftRight<16>(bytes)), hn::ShiftRight<16>(hn::BitCast(d, weights))));
  };
  return hn::Add(product(even, weights02), product(odd, weights13));
#else
  const hn::Repartition<std::int16_t, I32> d16;
  VecI rest = hn::Zero(d);
  const VecI sum = hn::ReorderWidenMulAccumulate(d, hn::BitCast(d16, even), hn::BitCast(d16, weights02), hn::Zero(d), rest);
  return hn::ReorderWidenMulAccumulate(d, hn::BitCast(d16, odd), hn::BitCast(d16, weights13), sum, rest);
#endif
}

void blendFours(const Loaded& loaded, const Fractions& fraction, int count, std::uint8_t* out) {
  const U32 d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int n = 0; n < count; n += lanes) {
    const std::array<VecF, 4> weightI = cubicWeights(weightAt(fraction, 0, n)), weightJ = cubicWeights(weightAt(fraction, 1, n)),
                              weightK = cubicWeights(weightAt(fraction, 2, n));
    // To the nearest of 2^14 steps; the second takes what is left, so that constants stay exact.
    const auto fixed = [&](VecF weight) {
      const VecF shifted = hn::Add(hn::Mul(weight, set(16384.0F)), set(16384.5F));
      return hn::BitCast(d, hn::Sub(hn::ConvertTo(I32(), shifted), hn::Set(I32(), 16384)));
    };
    const VecU w0 = fixed(weightI[0]), w2 = fixed(weightI[2]), w3 = fixed(weightI[3]);
    const VecU w1 = hn::Sub(set(16384U), hn::Add(w0, hn::Add(w2, w3)));
    const VecU lowHalf = set(0xffffU);
    const VecU weights02 = hn::Or(hn::And(w0, lowHalf), hn::ShiftLeft<16>(w2));
    const VecU weights13 = hn::Or(hn::And(w1, lowHalf), hn::ShiftLeft<16>(w3));
    VecF sum = set(0.0F);
    for (std::size_t k = 0; k < 4; ++k) {
      VecF slice = set(0.0F);
      for (std::size_t j = 0; j < 4; ++j) {
        const VecF row = hn::ConvertTo(F32(), rowSum(hn::LoadU(d, loaded.fours[4 * k + j] + n), weights02, weights13));
        slice = hn::Add(slice, hn::Mul(weightJ[j], row));
      }
      sum = hn::Add(sum, hn::Mul(weightK[k], slice));
    }
    sum = hn::Mul(sum, set(1.0F / 16384.0F));
    storeGreys(rounded(hn::Min(hn::Max(sum, set(0.0F)), set(255.0F))), count - n, out + n);
  }
}

void sampleCubic(const Piece& piece) {
  HWY_ALIGN Loaded loaded;
  const std::uint8_t* HWY_RESTRICT from = piece.voxels;
  const std::uint64_t strideJ = piece.stride[1], strideK = piece.stride[2];
  for (int begin = 0; begin < piece.count; begin += kPart) {
    const int count = std::min(kPart, piece.count - begin);
    const std::uint32_t* HWY_RESTRICT offset = piece.offset[0].data() + begin;
    for (int n = 0; n < count; ++n)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t j = 0; j < 4; ++j) load(from + offset[n] + k * strideK + j * strideJ, loaded.fours[4 * k + j][n]);
    blendFours(loaded, fractionsFrom(piece, begin), count, piece.out + begin);
  }
}

void layAny(PieceKind kind, Piece& piece) {
  const bool bricked = kind.layout == VoxelLayout::bricked;
  switch (kind.quality) {
    case Quality::weave:
      return bricked ? lay<Quality::weave, VoxelLayout::bricked>(piece) : lay<Quality::weave, VoxelLayout::linear>(piece);
    case Quality::linear:
      return bricked ? lay<Quality::linear, VoxelLayout::bricked>(piece) : lay<Quality::linear, VoxelLayout::linear>(piece);
    case Quality::cubic:
      return lay<Quality::cubic, VoxelLayout::linear>(piece);
  }
}

void sampleAny(PieceKind kind, const Piece& piece) {
  const bool bricked = kind.layout == VoxelLayout::bricked;
  switch (kind.quality) {
    case Quality::weave:
      return sampleWeave(piece);
    case Quality::linear:
      return bricked ? sampleLinear<VoxelLayout::bricked>(piece) : sampleLinear<VoxelLayout::linear>(piece);
    case Quality::cubic:
      return sampleCubic(piece);
  }
}

void blendAny(Quality quality, const Loaded& loaded, const Fractions& fraction, int count, std::uint8_t* out) {
  if (quality == Quality::linear) return blendPairs(loaded, fraction, count, out);
  blendFours(loaded, fraction, count, out);
}

void fillAny(std::int64_t high, std::int32_t lowPart, int count, std::uint32_t* whole, std::uint32_t* fraction) {
  using U64 = hn::ScalableTag<std::uint64_t>;
  const U64 d;
  const hn::Rebind<std::uint32_t, U64> half;
  const int lanes = static_cast<int>(hn::Lanes(d));
  // The low parts are kept 2^40 too high, so that they are never negative; 16 bits further down that is 2^24.
  constexpr std::uint64_t kHigher = std::uint64_t{1} << 40;
  const auto step = static_cast<std::uint64_t>(high), lowStep = static_cast<std::uint64_t>(std::int64_t{lowPart});
  HWY_ALIGN std::uint64_t firstHigh[kLanesAtMost], firstLow[kLanesAtMost];
  for (int n = 0; n < lanes; ++n) {
    firstHigh[n] = static_cast<std::uint64_t>(n) * step - (kHigher >> 16);
    firstLow[n] = static_cast<std::uint64_t>(n) * lowStep + kHigher + (1U << 15);
  }
  auto highSum = hn::Load(d, firstHigh), lowSum = hn::Load(d, firstLow);
  const auto highStep = hn::Set(d, static_cast<std::uint64_t>(lanes) * step),
             lowSteps = hn::Set(d, static_cast<std::uint64_t>(lanes) * lowStep);
  const auto mask = hn::Set(d, std::uint64_t{kFractionMask});
  for (int n = 0; n < count; n += lanes) {
    const auto position = hn::Add(highSum, hn::ShiftRight<16>(lowSum));
    hn::StoreU(hn::TruncateTo(half, hn::ShiftRight<kFractionBits>(position)), half, whole + n);
    hn::StoreU(hn::TruncateTo(half, hn::And(position, mask)), half, fraction + n);
    highSum = hn::Add(highSum, highStep);
    lowSum = hn::Add(lowSum, lowSteps);
  }
}

void offsetsAny(const std::array<const std::uint32_t*, 3>& whole, const std::array<std::uint64_t, 3>& stride, int count,
                std::uint32_t* offset) {
  const U32 d;
  const VecU strideJ = set(low(stride[1])), strideK = set(low(stride[2]));
  for (int n = 0; n < count; n += static_cast<int>(hn::Lanes(d))) {
    const VecU j = hn::Mul(hn::LoadU(d, whole[1] + n), strideJ), k = hn::Mul(hn::LoadU(d, whole[2] + n), strideK);
    hn::StoreU(hn::Add(hn::LoadU(d, whole[0] + n), hn::Add(j, k)), d, offset + n);
  }
}

}  // namespace ew::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(layAny);
HWY_EXPORT(announceAny);
HWY_EXPORT(sampleAny);
HWY_EXPORT(blendAny);
HWY_EXPORT(blendLevels);
HWY_EXPORT(fillAny);
HWY_EXPORT(offsetsAny);

void layPiece(PieceKind kind, Piece& piece) { HWY_DYNAMIC_DISPATCH(layAny)(kind, piece); }
void announcePiece(PieceKind kind, const Piece& piece) { HWY_DYNAMIC_DISPATCH(announceAny)(kind, piece); }
void samplePiece(PieceKind kind, const Piece& piece) { HWY_DYNAMIC_DISPATCH(sampleAny)(kind, piece); }
void blendLoaded(Quality quality, const Loaded& loaded, const std::array<const std::uint32_t*, 3>& fraction, int count, std::uint8_t* out) {
  HWY_DYNAMIC_DISPATCH(blendAny)(quality, loaded, fraction, count, out);
}
void blendLoadedLevels(const Loaded& echo, const Loaded* coverage, const std::array<const std::uint32_t*, 3>& fraction, int count,
                       float* out) {
  HWY_DYNAMIC_DISPATCH(blendLevels)(echo, coverage, fraction, count, out);
}
void fillTemplate(std::int64_t high, std::int32_t low, int count, std::uint32_t* whole, std::uint32_t* fraction) {
  HWY_DYNAMIC_DISPATCH(fillAny)(high, low, count, whole, fraction);
}

void fillOffsets(const std::array<const std::uint32_t*, 3>& whole, const std::array<std::uint64_t, 3>& stride, int count,
                 std::uint32_t* offset) {
  HWY_DYNAMIC_DISPATCH(offsetsAny)(whole, stride, count, offset);
}

}  // namespace ew::detail
#endif
