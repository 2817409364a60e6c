#include "row_kernels.h"

#include <algorithm>

#include "bricks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "slicing/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail::HWY_NAMESPACE {

HWY_INLINE std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }

/// value / Bricks::kCells for value < Piece::kCellsAtMost.
HWY_INLINE VecU bricksIn(VecU value) {
  static_assert(Bricks::kCells == 13);
  constexpr std::uint16_t kThirteenth = 5042;  // of 2^16, rounded up
#if HWY_TARGET == HWY_SCALAR
  return hn::ShiftRight<16>(hn::Mul(value, set(std::uint32_t{kThirteenth})));
#else
  const hn::Repartition<std::uint16_t, U32> d;
  return hn::BitCast(U32(), hn::MulHigh(hn::BitCast(d, value), hn::Set(d, kThirteenth)));
#endif
}

/// Along j or k, where bricks are two high: bytes to index `at`, and from there to the next.
struct AlongBricks {
  VecU offset, toNext;
};
template <int kBytes>
HWY_INLINE AlongBricks alongBricks(VecU at, VecU stride) {
  const VecU odd = hn::And(at, set(1U));
  const VecU offset = hn::Add(hn::Mul(odd, set(std::uint32_t{kBytes})), hn::Mul(hn::ShiftRight<1>(at), stride));
  const VecU back = hn::And(hn::Sub(hn::Zero(U32()), odd), hn::Sub(stride, set(std::uint32_t{2 * kBytes})));
  return {offset, hn::Add(set(std::uint32_t{kBytes}), back)};
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
      if constexpr (quality != Quality::weave) {
        const VecU high = hn::And(sum[a], set(0x7fff0000U)), part = hn::ShiftRight<16>(high);
        hn::StoreU(hn::Or(high, part), d, piece.part[a].data() + n);
      }
    }
    const auto store = [&](VecU value, Piece::Values& values) { hn::StoreU(value, d, values.data() + n); };
    // The top bit of a sum of two 31 bit fractions says that they reach a whole voxel.
    if constexpr (layout == VoxelLayout::linear) {
      const auto carry = [&](VecU one, VecU stride) {
        const auto reached = hn::BroadcastSignBit(hn::BitCast(I32(), one));
        return hn::And(hn::BitCast(d, reached), stride);
      };
      const VecU carried = hn::Add(hn::ShiftRight<kFractionBits>(sum[0]), hn::Add(carry(sum[1], strideJ), carry(sum[2], strideK)));
      store(hn::Add(hn::Add(hn::LoadU(d, piece.templateOffset + n), set(piece.startOffset)), carried), piece.offset);
    } else {
      std::array<VecU, 3> whole = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
      for (std::size_t a = 0; a < 3; ++a)
        whole[a] =
            hn::Add(hn::Add(hn::LoadU(d, piece.templateWhole[a] + n), set(piece.startWhole[a])), hn::ShiftRight<kFractionBits>(sum[a]));
      const VecU alongI = hn::Add(whole[0], hn::Mul(bricksIn(whole[0]), set(std::uint32_t{Bricks::kBytes - Bricks::kCells})));
      const AlongBricks alongJ = alongBricks<Bricks::kRowBytes>(whole[1], strideJ),
                        alongK = alongBricks<Bricks::kSliceBytes>(whole[2], strideK);
      store(hn::Add(alongI, hn::Add(alongJ.offset, alongK.offset)), piece.offset);
      if constexpr (quality != Quality::weave) {
        store(alongJ.toNext, piece.toRow);
        store(alongK.toNext, piece.toSlice);
      }
    }
  }
}

/// Loads stand apart from arithmetic, in parts that stay in the first-level cache. Gathers would do both at once, but they wait for
/// their slowest element: on volumes beyond the first-level cache scalar loads were 1.7 times as fast (AVX-512, Zen 4).
constexpr int kPart = 64;

/// The four neighbours in slice k of the voxel, two rows of two, in the order i, j; then those in the next slice.
struct Squares {
  HWY_ALIGN std::uint32_t slice[2][kPart + kLanesAtMost];
};

template <VoxelLayout layout>
HWY_INLINE void loadSquares(const Piece& piece, int begin, int count, Squares& squares) {
  const std::uint32_t *HWY_RESTRICT offset = piece.offset.data() + begin, *HWY_RESTRICT toRow = piece.toRow.data() + begin,
                                    *HWY_RESTRICT toSlice = piece.toSlice.data() + begin;
  const std::uint8_t* HWY_RESTRICT voxels = piece.voxels;
  for (int n = 0; n < count; ++n) {
    const std::uint64_t row = layout == VoxelLayout::linear ? piece.stride[1] : toRow[n];
    const std::uint64_t slice = layout == VoxelLayout::linear ? piece.stride[2] : toSlice[n];
    const std::uint8_t *near = voxels + offset[n], *far = near + slice;
    std::uint16_t near0, near1, far0, far1;
    load(near, near0);
    load(near + row, near1);
    load(far, far0);
    load(far + row, far1);
    squares.slice[0][n] = near0 | std::uint32_t{near1} << 16;
    squares.slice[1][n] = far0 | std::uint32_t{far1} << 16;
  }
}

using Parts = std::array<const std::uint32_t*, 3>;
constexpr int kBelowGrey = 7;  // bits of a level below a grey level: the most that a difference of two leaves in 16 bits

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void blendSquares(const Squares& squares, const Parts& part, int count, std::uint8_t* out) {
  for (int n = 0; n < count; ++n) {
    const auto partOf = [&](std::size_t axis) { return static_cast<std::int32_t>(part[axis][n] & 0xffffU); };
    const auto level = [&](std::size_t k, int byte) {
      return static_cast<std::int32_t>((squares.slice[k][n] >> (8 * byte)) & 0xffU) << kBelowGrey;
    };
    const auto row = [&](int j) {
      return lerp(lerp(level(0, 2 * j), level(0, 2 * j + 1), partOf(0)), lerp(level(1, 2 * j), level(1, 2 * j + 1), partOf(0)), partOf(2));
    };
    out[n] = static_cast<std::uint8_t>((lerp(row(0), row(1), partOf(1)) + (1 << (kBelowGrey - 1))) >> kBelowGrey);
  }
}
#else
/// Along i and k for a vector of samples: two numbers of 16 bits each, for row j and the next.
HWY_INLINE VecS blendRows(const Squares& squares, const Parts& part, int n) {
  const I16 d;
  const VecS inNumber = hn::Set(d, 0xff << kBelowGrey), x = halves(part[0] + n), z = halves(part[2] + n);
  const auto alongI = [&](std::size_t k) {
    const VecS pair = halves(squares.slice[k] + n);
    const VecS first = hn::And(hn::ShiftLeft<kBelowGrey>(pair), inNumber), second = hn::And(hn::ShiftRight<8 - kBelowGrey>(pair), inNumber);
    return lerp(first, second, x);
  };
  return lerp(alongI(0), alongI(1), z);
}

HWY_INLINE void blendSquares(const Squares& squares, const Parts& part, int count, std::uint8_t* out) {
  const I16 d;
  const U32 d32;
  const int lanes = static_cast<int>(hn::Lanes(d32));
  for (int n = 0; n < count; n += 2 * lanes) {
    // Two vectors of samples side by side: the first in the even numbers, the second in the odd ones.
    const VecS first = blendRows(squares, part, n), second = blendRows(squares, part, n + lanes);
    const VecS near = hn::OddEven(hn::BitCast(d, hn::ShiftLeft<16>(hn::BitCast(d32, second))), first);
    const VecS far = hn::OddEven(second, hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(d32, first))));
    const VecS y = hn::OddEven(halves(part[1] + n + lanes), halves(part[1] + n));
    const VecS level = lerp(near, far, y);
    const auto greys = hn::BitCast(d32, hn::ShiftRight<kBelowGrey>(hn::Add(level, hn::Set(d, 1 << (kBelowGrey - 1)))));
    storeGreys(I32(), hn::BitCast(I32(), hn::And(greys, set(0xffffU))), count - n, out + n);
    storeGreys(I32(), hn::BitCast(I32(), hn::ShiftRight<16>(greys)), count - n - lanes, out + n + lanes);
  }
}
#endif

void sampleWeave(const Piece& piece) {
  const std::uint8_t* HWY_RESTRICT from = piece.voxels;
  const std::uint32_t* HWY_RESTRICT offset = piece.offset.data();
  std::uint8_t* HWY_RESTRICT out = piece.out;
  const int count = piece.count;
  // Two loads and a store a pixel: counting and branching for each would be as many instructions again.
#pragma GCC unroll 8
  for (int n = 0; n < count; ++n) out[n] = from[offset[n]];
}

template <VoxelLayout layout>
void sampleLinear(const Piece& piece) {
  Squares squares;
  for (int begin = 0; begin < piece.count; begin += kPart) {
    const int count = std::min(kPart, piece.count - begin);
    loadSquares<layout>(piece, begin, count, squares);
    const Parts part = {piece.part[0].data() + begin, piece.part[1].data() + begin, piece.part[2].data() + begin};
    blendSquares(squares, part, count, piece.out + begin);
  }
}

using Fractions = std::array<const std::uint32_t*, 3>;

HWY_INLINE VecF blend(VecF a, VecF b, VecF weight) { return hn::Add(a, hn::Mul(weight, hn::Sub(b, a))); }

/// Between the eight neighbours of samples n and following; `pairOf` gives the two of a row, the first in the low byte.
template <class PairOf>
HWY_INLINE VecF trilinear(const Fractions& fraction, int n, const PairOf& pairOf) {
  const auto weightAt = [&](std::size_t axis) { return hn::Mul(toFloat(hn::LoadU(U32(), fraction[axis] + n)), set(kPerFraction)); };
  const VecF weightI = weightAt(0), weightJ = weightAt(1), weightK = weightAt(2);
  const auto alongI = [&](std::size_t row) {
    const VecU pair = pairOf(row);
    return blend(toFloat(hn::And(pair, set(0xffU))), toFloat(hn::ShiftRight<8>(pair)), weightI);
  };
  const VecF near = blend(alongI(0), alongI(1), weightJ), far = blend(alongI(2), alongI(3), weightJ);
  return blend(near, far, weightK);
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

template <VoxelLayout layout>
void layKind(Quality quality, Piece& piece) {
  switch (quality) {
    case Quality::weave:
      return lay<Quality::weave, layout>(piece);
    case Quality::linear:
      return lay<Quality::linear, layout>(piece);
    case Quality::cubic:
      return lay<Quality::cubic, layout>(piece);
  }
}

void layAny(PieceKind kind, Piece& piece) {
  if (kind.layout == VoxelLayout::bricked) return layKind<VoxelLayout::bricked>(kind.quality, piece);
  layKind<VoxelLayout::linear>(kind.quality, piece);
}

void sampleAny(PieceKind kind, const Piece& piece) {
  if (kind.quality == Quality::weave) return sampleWeave(piece);
  if (kind.layout == VoxelLayout::bricked) return sampleLinear<VoxelLayout::bricked>(piece);
  sampleLinear<VoxelLayout::linear>(piece);
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
HWY_EXPORT(sampleAny);
HWY_EXPORT(blendLevels);
HWY_EXPORT(fillAny);
HWY_EXPORT(offsetsAny);

void layPiece(PieceKind kind, Piece& piece) { HWY_DYNAMIC_DISPATCH(layAny)(kind, piece); }
void samplePiece(PieceKind kind, const Piece& piece, const Piece* ahead) {
  const Announcer next(kind, ahead);
  if (kind.quality == Quality::cubic) {
    sampleCubicPiece(kind.layout, piece, next);
    return next.askFrom(piece.count);
  }
  // Apart from the samples: a loop of few instructions waits for its own loads where requests stand between them (2 times the time, Zen 3).
  next.askFrom(0);
  HWY_DYNAMIC_DISPATCH(sampleAny)(kind, piece);
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
