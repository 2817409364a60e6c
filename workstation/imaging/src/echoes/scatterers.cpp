#include "scatterers.h"

#include <cstring>

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/scatterers.cpp"
#include "hwy/foreach_target.h"
//
#include "echoes/bytes-inl.h"
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // bytes-inl.h, powers-inl.h

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using F = hn::Vec<D>;
using I = hn::Vec<DI>;
using U = hn::Vec<DU>;

HWY_INLINE F set(float value) { return hn::Set(D(), value); }
HWY_INLINE F plus(F a, F b) { return hn::Add(a, b); }
HWY_INLINE F times(F a, F b) { return hn::Mul(a, b); }

/// A bijection that spreads every bit: multiply and shift, constants of C. Wellons' search for low bias (public domain).
HWY_INLINE U spread(U x) {
  const DU du;
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), hn::Set(du, 0x21f0aaadU));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), hn::Set(du, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

/// Ten bits of a hash as a place within a cell, 0..1.
template <int kShift>
HWY_INLINE F placeOf(U hash) {
  const auto bits = hn::And(hn::ShiftRight<kShift>(hash), hn::Set(DU(), 1023U));
  return times(plus(hn::ConvertTo(D(), hn::BitCast(DI(), bits)), set(0.5F)), set(1.0F / 1024.0F));
}

/// The first two of four bytes, blended.
HWY_INLINE F blendBytes(I word, F t) {
  const DI di;
  const auto low = hn::ConvertTo(D(), hn::And(word, hn::Set(di, 255)));
  const auto high = hn::ConvertTo(D(), hn::And(hn::ShiftRight<8>(word), hn::Set(di, 255)));
  return plus(low, times(hn::Sub(high, low), t));
}

/// NearestInt rounds halves differently on different instruction sets.
HWY_INLINE I roundedOf(F x) { return hn::ConvertTo(DI(), hn::Floor(plus(x, set(0.5F)))); }

HWY_INLINE F nearestWhole(F x) {
  const auto magic = set(12582912.0F);  // 1.5 * 2^23: adding it leaves no room for a fraction
  return hn::Sub(plus(x, magic), magic);
}

/// Arc tangent for |h| <= 0.8, error below 1e-7 (least squares at Chebyshev points).
HWY_INLINE F arcTangent(F h) {
  const auto u = times(h, h);
  auto p = set(0.015623872F);
  for (const float c : {-0.053944063F, 0.097827117F, -0.140202142F, 0.199736924F, -0.333323335F, 0.999999937F})
    p = plus(times(p, u), set(c));
  return times(p, h);
}

/// Arc sine for |x| <= 0.97: twice the angle whose tangent is x / (1 + cosine).
HWY_INLINE F arcSine(F x) {
  const auto cosine = hn::Sqrt(hn::Sub(set(1.0F), times(x, x)));
  return times(set(2.0F), arcTangent(hn::Div(x, plus(set(1.0F), cosine))));
}

/// Place across the lines (an angle or a width on the face), row and range (mm along its line) of points of the probe frame.
template <FanShape::Kind kKind, bool kSteers>
HWY_INLINE void placeOnLines(const ScatterTask& task, F x, F y, F& across, F& row, F& range) {
  const auto apex = set(task.apex_mm);
  if constexpr (kKind == FanShape::Kind::parallel) {
    across = hn::Sub(x, times(y, set(task.shear)));
    range = times(y, set(task.perCosine));
  } else if constexpr (kKind == FanShape::Kind::trapezoid) {
    const auto fromApex = hn::Max(plus(y, apex), set(1e-3F));
    across = hn::Div(times(x, apex), fromApex);
    range = hn::Div(times(y, hn::Sqrt(plus(times(across, across), times(apex, apex)))), apex);
  } else {
    const auto down = plus(y, apex);
    const auto radius = hn::Sqrt(plus(times(x, x), times(down, down)));
    // tan(angle / 2): no quadrants to tell apart. Behind the apex it grows without end and the row falls off the grid.
    const auto half = hn::Div(x, plus(plus(radius, down), set(1e-6F)));
    const auto clamped = hn::Min(hn::Max(half, set(-0.8F)), set(0.8F));
    across = plus(times(set(2.0F), arcTangent(clamped)), times(set(16.0F), hn::Sub(half, clamped)));
    if constexpr (kSteers) {
      const auto at = hn::Max(radius, set(1.05F * std::abs(task.touched_mm) + 1e-3F)), touched = set(task.touched_mm);
      across = plus(across, hn::Sub(arcSine(hn::Div(touched, at)), set(task.steering_rad)));
      range = hn::Sub(hn::Sqrt(hn::Sub(times(at, at), times(touched, touched))), set(task.cosine_mm));
    } else {
      range = hn::Sub(radius, apex);
    }
  }
  row = plus(set(task.middleRow), times(set(task.rowsPerUnit), across));
}

/// (cos, -sin) of the phase of so many turns.
HWY_INLINE void phaseOf(F turns, F& re, F& im) {
  const auto part = hn::Sub(turns, nearestWhole(turns));  // -0.5 .. 0.5
  const auto a = times(part, part);
  // sin and cos of pi * part, then of twice the angle.
  auto s = set(-0.0073704309F);
  for (const float c : {0.0821458866F, -0.5992645293F, 2.5501640399F, -5.1677127800F, 3.1415926536F}) s = plus(times(s, a), set(c));
  s = times(s, part);
  auto c = set(-0.0258068914F);
  for (const float k : {0.2353306304F, -1.3352627689F, 4.0587121264F, -4.9348022005F, 1.0F}) c = plus(times(c, a), set(k));
  re = hn::Sub(set(1.0F), times(set(2.0F), times(s, s)));
  im = times(set(-2.0F), times(s, c));
}

/// Mean level at places within a block, between the eight voxels around them; 0 outside.
HWY_INLINE F levelAt(const ScatterTask& task, const ScatterBlock& block, const std::uint8_t* from, std::int32_t last,
                     const glm::ivec3& base, F u, F v, F w) {
  const DI di;
  const auto x = plus(set(block.voxelFraction.x), times(u, set(task.voxelsPerCell.x)));
  const auto y = plus(set(block.voxelFraction.y), times(v, set(task.voxelsPerCell.y)));
  const auto z = plus(set(block.voxelFraction.z), times(w, set(task.voxelsPerCell.z)));
  const auto i = hn::ConvertTo(di, x), j = hn::ConvertTo(di, y), k = hn::ConvertTo(di, z);
  const auto tx = hn::Sub(x, hn::ConvertTo(D(), i)), ty = hn::Sub(y, hn::ConvertTo(D(), j)), tz = hn::Sub(z, hn::ConvertTo(D(), k));
  const auto wholeI = hn::Add(i, hn::Set(di, block.voxel.x)), wholeJ = hn::Add(j, hn::Set(di, block.voxel.y)),
             wholeK = hn::Add(k, hn::Set(di, block.voxel.z));
  const auto outside = [&](I at, int voxels) { return hn::Or(hn::Lt(at, hn::Zero(di)), hn::Gt(at, hn::Set(di, voxels - 2))); };
  const auto missed = hn::Or(hn::Or(outside(wholeI, task.dims.x), outside(wholeJ, task.dims.y)), outside(wholeK, task.dims.z));
  const std::int32_t row = task.dims.x, plane = task.dims.x * task.dims.y;
  const auto offset =
      hn::Add(hn::Sub(wholeI, hn::Set(di, base.x)), hn::Add(hn::Mul(hn::Sub(wholeJ, hn::Set(di, base.y)), hn::Set(di, row)),
                                                            hn::Mul(hn::Sub(wholeK, hn::Set(di, base.z)), hn::Set(di, plane))));
  const auto safe = hn::IfThenZeroElse(missed, offset);
  const auto at = [&](std::int32_t more) { return blendBytes(bytesAt(di, from, hn::Add(safe, hn::Set(di, more)), last), tx); };
  const auto near = at(0), far = at(plane);
  const auto nearer = plus(near, times(hn::Sub(at(row), near), ty));
  const auto farther = plus(far, times(hn::Sub(at(row + plane), far), ty));
  return hn::IfThenZeroElse(hn::RebindMask(D(), missed), plus(nearer, times(hn::Sub(farther, nearer), tz)));
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

/// Queues what is inside, shared by two neighbouring columns.
HWY_INLINE void deposit(const ScatterTask& task, hn::Mask<D> inside, I cell, F part, F re, F im, Pending& pending) {
  const D d;
  const DI di;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  static_assert(2 * kLanes <= Pending::kMost);
  if (pending.count + kLanes > Pending::kMost) pending.flush();
  HWY_ALIGN std::int32_t cells[kLanes], quads[4 * kLanes];
  const auto laterRe = times(re, part), laterIm = times(im, part);
  hn::Store(cell, di, cells);
  hn::StoreInterleaved4(roundedOf(hn::Sub(re, laterRe)), roundedOf(hn::Sub(im, laterIm)), roundedOf(laterRe), roundedOf(laterIm), di,
                        quads);
  for (std::uint64_t left = bitsOf(d, inside); left != 0; left &= left - 1) {
    const auto n = static_cast<std::size_t>(__builtin_ctzll(left));
    std::int32_t* at = task.field + cells[n];
    __builtin_prefetch(at, 1);
    pending.at[pending.count] = at;
    std::memcpy(pending.quads + 4 * pending.count, quads + 4 * n, 4 * sizeof(std::int32_t));
    ++pending.count;
  }
}

/// Asks for the voxels that a block will read.
HWY_INLINE void announce(const ScatterTask& task, const ScatterBlock& block) {
  const glm::ivec3 reach = glm::ivec3(task.voxelsPerCell * static_cast<float>(kBlockCells)) + 2;
  const glm::ivec3 from = glm::clamp(block.voxel, glm::ivec3(0), task.dims - 1),
                   to = glm::clamp(block.voxel + reach, glm::ivec3(0), task.dims - 1);
  for (int k = from.z; k <= to.z; ++k)
    for (int j = from.y; j <= to.y; ++j)
      __builtin_prefetch(task.level + (static_cast<std::ptrdiff_t>(k) * task.dims.y + j) * task.dims.x + from.x);
}

template <FanShape::Kind kKind, bool kSteers>
HWY_NOINLINE void addBlock(const ScatterTask& task, const ScatterBlock& block, Pending& pending) {
  const D d;
  const DI di;
  const DU du;
  constexpr int kCells = kBlockCells * kBlockCells * kBlockCells;
  static_assert(kBlockCells == 4);
  // Offsets count from the block's first voxel inside the map, so that they stay small in a volume of any size.
  const glm::ivec3 base = glm::clamp(block.voxel, glm::ivec3(0), glm::max(task.dims - 1, 0));
  const std::uint8_t* from = task.level + (static_cast<std::ptrdiff_t>(base.z) * task.dims.y + base.y) * task.dims.x + base.x;
  const auto last = static_cast<std::int32_t>(std::min<std::ptrdiff_t>(task.levelEnd - from - 4, 1 << 30));
  std::array<glm::vec3, 3> step_mm = task.cellToProbe_mm;
  for (std::size_t n = 0; n < step_mm.size(); ++n) step_mm[n] += block.stretch_mm[n];
  for (int first = 0; first < kCells; first += static_cast<int>(hn::Lanes(d))) {
    // In the order of a curve that fills little cubes one after another: a vector that the beams miss is missed as a whole.
    const auto number = hn::Iota(di, first);
    const auto bit = [&](auto shifted, int value) { return hn::And(shifted, hn::Set(di, value)); };
    const auto i = hn::Or(bit(number, 1), bit(hn::ShiftRight<2>(number), 2)),
               j = hn::Or(bit(hn::ShiftRight<1>(number), 1), bit(hn::ShiftRight<3>(number), 2)),
               k = hn::Or(bit(hn::ShiftRight<2>(number), 1), bit(hn::ShiftRight<4>(number), 2));
    const auto term = [&](I at, std::size_t axis, std::uint32_t factor) {
      return hn::Mul(hn::Add(hn::BitCast(du, at), hn::Set(du, block.cell[axis])), hn::Set(du, factor));
    };
    const auto hash = spread(
        hn::Add(hn::Add(term(i, 0, 0x9E3779B1U), term(j, 1, 0x85EBCA77U)), hn::Add(term(k, 2, 0xC2B2AE3DU), hn::Set(du, task.seed))));
    const auto u = plus(hn::ConvertTo(d, i), placeOf<0>(hash)), v = plus(hn::ConvertTo(d, j), placeOf<10>(hash)),
               w = plus(hn::ConvertTo(d, k), placeOf<20>(hash));
    const auto along = [&](int axis) {
      return plus(plus(set(block.probe_mm[axis]), times(u, set(step_mm[0][axis]))),
                  plus(times(v, set(step_mm[1][axis])), times(w, set(step_mm[2][axis]))));
    };
    const auto z = along(2);
    if (hn::AllTrue(d, hn::Gt(hn::Abs(z), set(block.reach_mm)))) continue;
    const auto x = along(0), y = along(1);
    F across, row, range;
    placeOnLines<kKind, kSteers>(task, x, y, across, row, range);

    // Elevational beam: amplitude, and the lens' wavefront, r + z^2 / 2R with R = (off^2 + range^2) / off.
    const auto off = hn::Sub(range, set(task.lensFocus_mm));
    const auto perRange = hn::IfThenElse(hn::Lt(off, hn::Zero(d)), set(task.nearPerMm), set(task.farPerMm));
    const auto q = times(off, perRange);
    const auto widening = plus(set(1.0F), times(q, q));
    const auto z2 = times(z, z);
    const auto exponent = hn::Div(times(z2, set(task.waistPerMm2)), widening);
    const auto path = plus(range, hn::Div(times(times(set(0.5F), z2), times(q, perRange)), widening));
    const auto column = plus(set(task.firstColumn), times(set(task.columnsPerMm), path));
    const auto inside = hn::And(hn::And(hn::Lt(exponent, set(task.cut)), hn::And(hn::Gt(row, set(-0.4F)), hn::Lt(row, set(task.lastRow)))),
                                hn::And(hn::Ge(column, hn::Zero(d)), hn::Lt(column, set(task.lastColumn))));
    if (hn::AllFalse(d, inside)) continue;
    const auto level = levelAt(task, block, from, last, base, u, v, w);
    const auto sounding = hn::And(inside, hn::Gt(level, hn::Zero(d)));
    if (hn::AllFalse(d, sounding)) continue;

    // Four bytes of another hash, each even: their sum is nearly normal.
    const auto other = spread(hash);
    const auto byte = [&](auto shifted) { return hn::And(shifted, hn::Set(du, 255U)); };
    const auto bytes = hn::Add(hn::Add(byte(other), byte(hn::ShiftRight<8>(other))),
                               hn::Add(byte(hn::ShiftRight<16>(other)), byte(hn::ShiftRight<24>(other))));
    const auto normal = times(hn::Sub(hn::ConvertTo(d, hn::BitCast(di, bytes)), set(510.0F)), set(1.0F / 147.8F));
    const auto strength = plus(plus(set(task.log2OfZero), times(level, set(task.log2PerLevel))), times(normal, set(task.log2OfTexture)));
    const auto fall = times(hn::IfThenElseZero(inside, exponent), set(1.44269504F));
    const auto amplitude = hn::Div(exp2Of(d, hn::Sub(strength, fall)), hn::Sqrt(hn::Sqrt(widening)));
    const auto sign = hn::BitCast(d, hn::And(spread(hn::Add(other, hn::Set(du, 0x9E3779B9U))), hn::Set(du, 0x80000000U)));
    const auto kept = hn::Xor(hn::IfThenElseZero(sounding, amplitude), sign);
    F re, im, turns = times(path, set(task.turnsPerMm));
    if constexpr (kSteers) turns = plus(turns, times(across, set(task.leadTurns)));
    phaseOf(hn::IfThenElseZero(inside, turns), re, im);
    const auto wholeRow = roundedOf(hn::IfThenElseZero(inside, row));
    const auto insideColumn = hn::IfThenElseZero(inside, column);
    const auto wholeColumn = hn::ConvertTo(di, insideColumn);
    const auto part = hn::Sub(insideColumn, hn::ConvertTo(d, wholeColumn));
    const auto cell = hn::ShiftLeft<1>(hn::Add(hn::Mul(wholeRow, hn::Set(di, task.stride / 2)), wholeColumn));
    deposit(task, sounding, cell, part, times(kept, re), times(kept, im), pending);
  }
}

void addScatterersOf(const ScatterTask& task, const ScatterBlock* blocks, std::size_t count) {
  Pending pending;
  for (std::size_t n = 0; n < count; ++n) {
    if (n + 1 < count) announce(task, blocks[n + 1]);
    switch (task.kind) {
      case FanShape::Kind::parallel:
        task.steers ? addBlock<FanShape::Kind::parallel, true>(task, blocks[n], pending)
                    : addBlock<FanShape::Kind::parallel, false>(task, blocks[n], pending);
        break;
      case FanShape::Kind::trapezoid:
        addBlock<FanShape::Kind::trapezoid, false>(task, blocks[n], pending);
        break;
      case FanShape::Kind::sector:
        task.steers ? addBlock<FanShape::Kind::sector, true>(task, blocks[n], pending)
                    : addBlock<FanShape::Kind::sector, false>(task, blocks[n], pending);
        break;
    }
  }
  pending.flush();
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(addScatterersOf);

void addScatterers(const ScatterTask& task, const ScatterBlock* blocks, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(addScatterersOf)(task, blocks, count);
}

}  // namespace ew::detail
#endif
