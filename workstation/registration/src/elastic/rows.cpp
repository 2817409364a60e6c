#include "elastic/rows.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "elastic/rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::registration::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;

using VecF = hn::Vec<Floats>;
using VecI = hn::Vec<Ints>;

/// Values at `start` and the one beside it, for each sample.
struct Pairs {
  VecF first, second;
};

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
// A gather of eight floats takes as long here as thirty loads (Zen 3: about nine cycles), and neighbours lie side by side.
HWY_INLINE hn::Vec<hn::FixedTag<std::uint64_t, 2>> twoPairs(const float* values, const std::int32_t* start) {
  const hn::FixedTag<std::uint64_t, 1> one;
  const auto pair = [&](int n) {
    std::uint64_t both;
    std::memcpy(&both, values + start[n], sizeof both);
    return hn::Set(one, both);
  };
  return hn::Combine(hn::FixedTag<std::uint64_t, 2>(), pair(1), pair(0));
}

HWY_INLINE Pairs pairsAt(const float* values, const std::int32_t* start) {
  const Floats d;
#if HWY_TARGET == HWY_AVX2
  const hn::FixedTag<std::uint64_t, 4> four;
  const auto low = hn::BitCast(d, hn::Combine(four, twoPairs(values, start + 2), twoPairs(values, start)));
  const auto high = hn::BitCast(d, hn::Combine(four, twoPairs(values, start + 6), twoPairs(values, start + 4)));
#else
  const auto low = hn::BitCast(d, twoPairs(values, start)), high = hn::BitCast(d, twoPairs(values, start + 2));
#endif
  return {hn::ConcatEven(d, high, low), hn::ConcatOdd(d, high, low)};
}
#else
HWY_INLINE Pairs pairsAt(const float* values, const std::int32_t* start) {
  const Floats d;
  const Ints di;
  const VecI at = hn::LoadU(di, start);
  return {hn::GatherIndex(d, values, at), hn::GatherIndex(d, values + 1, at)};
}
#endif

HWY_INLINE VecF lerp(VecF a, VecF b, VecF t) { return hn::MulAdd(t, hn::Sub(b, a), a); }

/// Between the eight neighbours of a vector of samples. An image one sample wide has no pair: its values stand for both.
template <bool wide>
HWY_INLINE VecF trilinear(const float* values, const std::int32_t* start, int below, int behind, VecF x, VecF y, VecF z) {
  const auto along = [&](const float* row) {
    if constexpr (wide) {
      const Pairs pairs = pairsAt(row, start);
      return lerp(pairs.first, pairs.second, x);
    } else {
      return hn::GatherIndex(Floats(), row, hn::LoadU(Ints(), start));
    }
  };
  const VecF low = lerp(along(values), along(values + below), y);
  const VecF high = lerp(along(values + behind), along(values + behind + below), y);
  return lerp(low, high, z);
}

/// Values of the cells that a vector of samples lies in: mostly one, or two.
class CellValues {
 public:
  explicit CellValues(const int* cell) : first_(cell[0]), last_(cell[hn::Lanes(Floats()) - 1]) {
    const Ints di;
    cell_ = hn::LoadU(di, cell);
    const auto inFirst = hn::Eq(cell_, hn::Set(di, first_));
    inFirst_ = hn::RebindMask(Floats(), inFirst);
    two_ = hn::AllTrue(di, hn::Or(inFirst, hn::Eq(cell_, hn::Set(di, last_))));
  }
  [[nodiscard]] HWY_INLINE VecF of(const float* values) const {
    const Floats d;
    if (two_) return hn::IfThenElse(inFirst_, hn::Set(d, values[first_]), hn::Set(d, values[last_]));
    return hn::GatherIndex(d, values, cell_);
  }

 private:
  int first_, last_;
  bool two_;
  VecI cell_;
  hn::Mask<Floats> inFirst_;
};

template <bool wide>
void sampleRowOf(const RowField& field, const RowSource& source, int count, float* values, float* weights) {
  const Floats d;
  const Ints di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0F), slack = hn::Set(d, 1e-3F);
  const auto iota = hn::Iota(d, 0.0F);
  const int below = source.dims[1] > 1 ? source.rowStride : 0, behind = source.dims[2] > 1 ? source.sliceStride : 0;
  for (int i = 0; i < count; i += lanes) {
    const CellValues cell(field.cell + i);
    const auto share = hn::LoadU(d, field.share + i);
    const auto along = hn::Add(iota, hn::Set(d, static_cast<float>(i)));
    decltype(hn::Zero(d)) u[4];
    for (std::size_t c = 0; c < 4; ++c) u[c] = hn::MulAdd(share, cell.of(field.rise[c]), cell.of(field.low[c]));
    decltype(hn::Zero(d)) part[3];
    decltype(hn::Zero(di)) low[3];
    auto inside = one;
    for (int axis = 0; axis < 3; ++axis) {
      auto at = hn::MulAdd(along, hn::Set(d, source.step[axis]), hn::Set(d, source.first[axis]));
      for (int c = 0; c < 3; ++c) at = hn::MulAdd(u[c], hn::Set(d, source.perMm[3 * axis + c]), at);
      const int last = source.dims[axis] - 1;
      // A single layer is as thick as it says.
      const auto edge = last == 0 ? hn::Set(d, 0.5F) : slack, end = hn::Set(d, static_cast<float>(last));
      inside = hn::IfThenZeroElse(hn::Or(hn::Lt(hn::Add(at, edge), zero), hn::Gt(hn::Sub(at, edge), end)), inside);
      const auto held = hn::Min(hn::Max(at, zero), end);
      low[axis] = hn::Min(hn::ConvertTo(di, held), hn::Set(di, std::max(last - 1, 0)));
      part[axis] = hn::Sub(held, hn::ConvertTo(d, low[axis]));
    }
    const auto start =
        hn::Add(hn::Add(low[0], hn::Mul(low[1], hn::Set(di, source.rowStride))), hn::Mul(low[2], hn::Set(di, source.sliceStride)));
    HWY_ALIGN std::int32_t from[hn::MaxLanes(Floats())];
    hn::Store(start, di, from);
    const VecF value = trilinear<wide>(source.values, from, below, behind, part[0], part[1], part[2]);
    hn::StoreU(hn::Add(value, u[3]), d, values + i);
    if (source.weights != nullptr)
      inside = hn::Mul(inside, trilinear<wide>(source.weights, from, below, behind, part[0], part[1], part[2]));
    hn::StoreU(inside, d, weights + i);
  }
}

void sampleRow(const RowField& field, const RowSource& source, int count, float* values, float* weights) {
  if (source.dims[0] > 1) return sampleRowOf<true>(field, source, count, values, weights);
  sampleRowOf<false>(field, source, count, values, weights);
}

/// What the rows of a line of cells add up to at a vector of samples: it stays in the first-level cache while row after row is added, which
/// whole rows of forty floats a sample do not.
struct Column {
  HWY_ALIGN float products[3 * kProducts][hn::MaxLanes(Floats())];
  HWY_ALIGN float right[2 * 4][hn::MaxLanes(Floats())];
};

HWY_INLINE void addTo(float* sum, VecF weight, VecF value) {
  const Floats d;
  hn::Store(hn::MulAdd(weight, value, hn::Load(d, sum)), d, sum);
}

/// Adds samples i and following of a row.
template <bool withProducts>
HWY_INLINE void accumulate(const RowPair& pair, int i, VecF (&total)[kSums], [[maybe_unused]] Column& column) {
  const Floats d;
  auto weight = hn::LoadU(d, pair.movedWeights + i);
  if (pair.fixedWeights != nullptr) weight = hn::Mul(weight, hn::LoadU(d, pair.fixedWeights + i));
  const auto f = hn::LoadU(d, pair.fixed + i), w = hn::LoadU(d, pair.moved + i);
  const auto r = hn::Sub(f, w);
  const auto rr = hn::Mul(r, r);
  const auto one = hn::Set(d, 1.0F);
  const auto robust = hn::Div(one, hn::MulAdd(rr, hn::Set(d, pair.perScale2), one));
  total[0] = hn::Add(total[0], weight);
  total[1] = hn::MulAdd(weight, hn::Mul(rr, robust), total[1]);
  total[2] = hn::MulAdd(weight, f, total[2]);
  total[3] = hn::MulAdd(weight, w, total[3]);
  total[4] = hn::MulAdd(weight, hn::Mul(f, f), total[4]);
  total[5] = hn::MulAdd(weight, hn::Mul(w, w), total[5]);
  total[6] = hn::MulAdd(weight, hn::Mul(f, w), total[6]);
  if constexpr (withProducts) {
    const auto fRight = hn::LoadU(d, pair.fixed + i + 1), wRight = hn::LoadU(d, pair.moved + i + 1);
    const auto fBelow = hn::LoadU(d, pair.fixedNear[1] + i), wBelow = hn::LoadU(d, pair.movedNear[1] + i);
    const auto fBehind = hn::LoadU(d, pair.fixedNear[3] + i), wBehind = hn::LoadU(d, pair.movedNear[3] + i);
    const auto sx = hn::Set(d, pair.slope[0]), sy = hn::Set(d, pair.slope[1]), sz = hn::Set(d, pair.slope[2]);
    const auto fx = hn::Mul(sx, hn::Sub(fRight, hn::LoadU(d, pair.fixed + i - 1)));
    const auto wx = hn::Mul(sx, hn::Sub(wRight, hn::LoadU(d, pair.moved + i - 1)));
    const auto fy = hn::Mul(sy, hn::Sub(fBelow, hn::LoadU(d, pair.fixedNear[0] + i)));
    const auto wy = hn::Mul(sy, hn::Sub(wBelow, hn::LoadU(d, pair.movedNear[0] + i)));
    const auto fz = hn::Mul(sz, hn::Sub(fBehind, hn::LoadU(d, pair.fixedNear[2] + i)));
    const auto wz = hn::Mul(sz, hn::Sub(wBehind, hn::LoadU(d, pair.movedNear[2] + i)));
    const auto weighted = hn::Mul(weight, hn::Mul(robust, robust)), wr = hn::Mul(weight, r);
    total[7] = hn::MulAdd(weight, rr, total[7]);
    total[8] = hn::MulAdd(wr, hn::Sub(fRight, wRight), total[8]);
    total[9] = hn::MulAdd(wr, hn::Sub(fBelow, wBelow), total[9]);
    total[10] = hn::MulAdd(wr, hn::Sub(fBehind, wBehind), total[10]);
    total[11] = hn::MulAdd(weighted, hn::MulAdd(fx, wx, hn::MulAdd(fy, wy, hn::Mul(fz, wz))), total[11]);
    const auto energy =
        hn::Add(hn::MulAdd(fx, fx, hn::MulAdd(fy, fy, hn::Mul(fz, fz))), hn::MulAdd(wx, wx, hn::MulAdd(wy, wy, hn::Mul(wz, wz))));
    total[12] = hn::MulAdd(weighted, hn::Mul(hn::Set(d, 0.5F), energy), total[12]);
    total[13] = hn::Add(total[13], weighted);
    total[14] = hn::MulAdd(weighted, rr, total[14]);
    const auto ofFixed = hn::Set(d, pair.ofFixed), ofMoved = hn::Set(d, 1.0F - pair.ofFixed);
    const VecF gx = hn::MulAdd(ofFixed, fx, hn::Mul(ofMoved, wx)), gy = hn::MulAdd(ofFixed, fy, hn::Mul(ofMoved, wy)),
               gz = hn::MulAdd(ofFixed, fz, hn::Mul(ofMoved, wz));
    const VecF ax = hn::Mul(weighted, gx), ay = hn::Mul(weighted, gy), az = hn::Mul(weighted, gz);
    const float t = pair.share;
    const auto t0 = hn::Set(d, (1.0F - t) * (1.0F - t)), t1 = hn::Set(d, t * (1.0F - t)), t2 = hn::Set(d, t * t);
    const auto addProduct = [&](int q, VecF product) {
      addTo(column.products[q], t0, product);
      addTo(column.products[kProducts + q], t1, product);
      addTo(column.products[2 * kProducts + q], t2, product);
    };
    addProduct(0, hn::Mul(ax, gx));
    addProduct(1, hn::Mul(ax, gy));
    addProduct(2, hn::Mul(ax, gz));
    addProduct(3, ax);
    addProduct(4, hn::Mul(ay, gy));
    addProduct(5, hn::Mul(ay, gz));
    addProduct(6, ay);
    addProduct(7, hn::Mul(az, gz));
    addProduct(8, az);
    addProduct(9, weighted);
    const auto r0 = hn::Set(d, 1.0F - t), r1 = hn::Set(d, t);
    const auto addRight = [&](int q, VecF value) {
      addTo(column.right[q], r0, value);
      addTo(column.right[4 + q], r1, value);
    };
    addRight(0, hn::Mul(ax, r));
    addRight(1, hn::Mul(ay, r));
    addRight(2, hn::Mul(az, r));
    addRight(3, hn::Mul(weighted, r));
  }
}

template <bool withProducts>
void accumulateAll(const RowPair* pairs, int rowCount, int count, const RowSums& rows, Sums& sums) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  VecF total[kSums];
  for (VecF& s : total) s = hn::Zero(d);
  Column column;
  for (int i = 0; i < count; i += lanes) {
    if constexpr (withProducts) column = Column{};
    for (int n = 0; n < rowCount; ++n) accumulate<withProducts>(pairs[n], i, total, column);
    if constexpr (withProducts) {
      for (std::ptrdiff_t q = 0; q < std::ptrdiff_t{3} * kProducts; ++q)
        hn::StoreU(hn::Load(d, column.products[q]), d, rows.products + q * rows.stride + i);
      for (std::ptrdiff_t q = 0; q < 8; ++q) hn::StoreU(hn::Load(d, column.right[q]), d, rows.right + q * rows.stride + i);
    }
  }
  for (std::size_t s = 0; s < kSums; ++s) sums[s] += hn::GetLane(hn::SumOfLanes(d, total[s]));
}

void accumulateRows(const RowPair* pairs, int rowCount, int count, const RowSums& rows, Sums& sums) {
  accumulateAll<true>(pairs, rowCount, count, rows, sums);
}
void sumRows(const RowPair* pairs, int rowCount, int count, Sums& sums) { accumulateAll<false>(pairs, rowCount, count, {}, sums); }

void gatherCell(const RowSums& rows, const float* along, int begin, int end, float* products, float* right) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto total = [&](auto v) { return hn::GetLane(hn::SumOfLanes(d, v)); };
  const std::ptrdiff_t stride = rows.stride;
  for (int y = 0; y < 3; ++y) {
    for (int q = 0; q < kProducts; ++q) {
      const float* row = rows.products + (y * kProducts + q) * stride;
      auto s0 = hn::Zero(d), s1 = s0, s2 = s0;
      for (int i = begin; i < end; i += lanes) {
        auto v = hn::LoadU(d, row + i);
        if (i + lanes > end) v = hn::IfThenElseZero(hn::FirstN(d, static_cast<std::size_t>(end - i)), v);
        s0 = hn::MulAdd(v, hn::LoadU(d, along + i), s0);
        s1 = hn::MulAdd(v, hn::LoadU(d, along + stride + i), s1);
        s2 = hn::MulAdd(v, hn::LoadU(d, along + 2 * stride + i), s2);
      }
      products[(0 * 3 + y) * kProducts + q] = total(s0);
      products[(1 * 3 + y) * kProducts + q] = total(s1);
      products[(2 * 3 + y) * kProducts + q] = total(s2);
    }
  }
  for (int y = 0; y < 2; ++y) {
    for (int q = 0; q < 4; ++q) {
      const float* row = rows.right + (y * 4 + q) * stride;
      auto s0 = hn::Zero(d), s1 = s0;
      for (int i = begin; i < end; i += lanes) {
        auto v = hn::LoadU(d, row + i);
        if (i + lanes > end) v = hn::IfThenElseZero(hn::FirstN(d, static_cast<std::size_t>(end - i)), v);
        s0 = hn::MulAdd(v, hn::LoadU(d, along + 3 * stride + i), s0);
        s1 = hn::MulAdd(v, hn::LoadU(d, along + 4 * stride + i), s1);
      }
      right[(0 * 2 + y) * 4 + q] = total(s0);
      right[(1 * 2 + y) * 4 + q] = total(s1);
    }
  }
}

void addMoments(const float* fixed, const float* fixedWeights, const float* moved, const float* movedWeights, int count, float* moments,
                int stride) {
  const Floats d;
  using V = decltype(hn::Zero(d));
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    V weight = hn::LoadU(d, movedWeights + i);
    if (fixedWeights != nullptr) weight = hn::Mul(weight, hn::LoadU(d, fixedWeights + i));
    if (i + lanes > count) weight = hn::IfThenElseZero(hn::FirstN(d, static_cast<std::size_t>(count - i)), weight);
    const V f = hn::LoadU(d, fixed + i), m = hn::LoadU(d, moved + i);
    const V wf = hn::Mul(weight, f), wm = hn::Mul(weight, m);
    const V part[kMoments] = {weight, wf, wm, hn::Mul(wf, f), hn::Mul(wm, m), hn::Mul(wf, m)};
    for (int q = 0; q < kMoments; ++q) {
      float* at = moments + i + static_cast<std::ptrdiff_t>(q) * stride;
      hn::StoreU(hn::Add(part[q], hn::LoadU(d, at)), d, at);
    }
  }
}

}  // namespace
}  // namespace ew::registration::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::registration {

HWY_EXPORT(sampleRow);
HWY_EXPORT(accumulateRows);
HWY_EXPORT(sumRows);
HWY_EXPORT(gatherCell);
HWY_EXPORT(addMoments);

void sampleRow(const RowField& field, const RowSource& source, int count, float* values, float* weights) {
  HWY_DYNAMIC_DISPATCH(sampleRow)(field, source, count, values, weights);
}
void accumulateRows(std::span<const RowPair> pairs, int count, const RowSums& rows, Sums& sums) {
  HWY_DYNAMIC_DISPATCH(accumulateRows)(pairs.data(), static_cast<int>(pairs.size()), count, rows, sums);
}
void sumRows(std::span<const RowPair> pairs, int count, Sums& sums) {
  HWY_DYNAMIC_DISPATCH(sumRows)(pairs.data(), static_cast<int>(pairs.size()), count, sums);
}
void gatherCell(const RowSums& rows, const float* along, int begin, int end, float* products, float* right) {
  HWY_DYNAMIC_DISPATCH(gatherCell)(rows, along, begin, end, products, right);
}
void addMoments(const float* fixed, const float* fixedWeights, const float* moved, const float* movedWeights, int count, float* moments,
                int stride) {
  HWY_DYNAMIC_DISPATCH(addMoments)(fixed, fixedWeights, moved, movedWeights, count, moments, stride);
}

}  // namespace ew::registration
#endif
