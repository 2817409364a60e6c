#include "scatterers.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/scatterers.cpp"
#include "hwy/foreach_target.h"
//
#include "echoes/bytes-inl.h"
#include "echoes/deposits-inl.h"
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // bytes-inl.h, deposits-inl.h, powers-inl.h

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using F = hn::Vec<D>;
using I = hn::Vec<DI>;
using U = hn::Vec<DU>;

HWY_INLINE F set(float value) { return hn::Set(D(), value); }
HWY_INLINE F plus(F a, F b) { return hn::Add(a, b); }
HWY_INLINE F times(F a, F b) { return hn::Mul(a, b); }

HWY_INLINE U spread(U x) { return spreadOf(DU(), x); }

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

/// Asks for the voxels that a block will read.
HWY_INLINE void announce(const ScatterTask& task, const ScatterBlock& block) {
  const glm::ivec3 reach = glm::ivec3(task.voxelsPerCell * static_cast<float>(kBlockCells)) + 2;
  const glm::ivec3 from = glm::clamp(block.voxel, glm::ivec3(0), task.dims - 1),
                   to = glm::clamp(block.voxel + reach, glm::ivec3(0), task.dims - 1);
  for (int k = from.z; k <= to.z; ++k)
    for (int j = from.y; j <= to.y; ++j)
      __builtin_prefetch(task.level + (static_cast<std::ptrdiff_t>(k) * task.dims.y + j) * task.dims.x + from.x);
}

/// Asks for the scatterers of a block.
HWY_INLINE void announce(const BlockScatterers& block) {
  constexpr std::size_t kLine = 64;
  for (std::size_t offset = 0; offset < sizeof(block); offset += kLine) __builtin_prefetch(reinterpret_cast<const char*>(&block) + offset);
}

constexpr std::uint64_t kAllLanes = (std::uint64_t{1} << hn::MaxLanes(D())) - 1;

/// Where the scatterers of a vector are within their block, in cells.
struct Cells {
  I i, j, k;
};
/// In the order of a curve that fills little cubes one after another: a vector that the beams miss is missed as a whole.
HWY_INLINE Cells cellsFrom(int first) {
  static_assert(kBlockCells == 4);
  const DI di;
  const auto number = hn::Iota(di, first);
  const auto bit = [&](auto shifted, int value) { return hn::And(shifted, hn::Set(di, value)); };
  return {hn::Or(bit(number, 1), bit(hn::ShiftRight<2>(number), 2)),
          hn::Or(bit(hn::ShiftRight<1>(number), 1), bit(hn::ShiftRight<3>(number), 2)),
          hn::Or(bit(hn::ShiftRight<2>(number), 1), bit(hn::ShiftRight<4>(number), 2))};
}

constexpr std::uint32_t kTaken = 0x80000000U;  // BlockScatterers::place

HWY_INLINE U hashOf(const ScatterTask& task, const ScatterBlock& block, const Cells& cells) {
  const DU du;
  const auto term = [&](I at, std::size_t axis, std::uint32_t factor) {
    return hn::Mul(hn::Add(hn::BitCast(du, at), hn::Set(du, block.cell[axis])), hn::Set(du, factor));
  };
  return spread(hn::Add(hn::Add(term(cells.i, 0, 0x9E3779B1U), term(cells.j, 1, 0x85EBCA77U)),
                        hn::Add(term(cells.k, 2, 0xC2B2AE3DU), hn::Set(du, task.seed))));
}

/// Strengths and signs of a vector, which do not depend on where the probe is.
HWY_NOINLINE void makeStrengths(const ScatterTask& task, const ScatterBlock& block, std::size_t first, BlockScatterers& made) {
  const D d;
  const DI di;
  const DU du;
  // Offsets count from the block's first voxel inside the map, so that they stay small in a volume of any size.
  const glm::ivec3 base = glm::clamp(block.voxel, glm::ivec3(0), glm::max(task.dims - 1, 0));
  const std::uint8_t* from = task.level + (static_cast<std::ptrdiff_t>(base.z) * task.dims.y + base.y) * task.dims.x + base.x;
  const auto last = static_cast<std::int32_t>(std::min<std::ptrdiff_t>(task.levelEnd - from - 4, 1 << 30));
  const Cells cells = cellsFrom(static_cast<int>(first));
  const auto hash = hashOf(task, block, cells);
  const auto u = plus(hn::ConvertTo(d, cells.i), placeOf<0>(hash)), v = plus(hn::ConvertTo(d, cells.j), placeOf<10>(hash)),
             w = plus(hn::ConvertTo(d, cells.k), placeOf<20>(hash));
  const auto level = levelAt(task, block, from, last, base, u, v, w);
  const std::uint64_t sounding = bitsOf(d, hn::Gt(level, hn::Zero(d)));
  made.known |= kAllLanes << first;
  made.sounding |= sounding << first;
  if (sounding == 0) return;
  // Four bytes of another hash, each even: their sum is nearly normal.
  const auto other = spread(hash);
  const auto byte = [&](auto shifted) { return hn::And(shifted, hn::Set(du, 255U)); };
  const auto bytes = hn::Add(hn::Add(byte(other), byte(hn::ShiftRight<8>(other))),
                             hn::Add(byte(hn::ShiftRight<16>(other)), byte(hn::ShiftRight<24>(other))));
  const auto normal = times(hn::Sub(hn::ConvertTo(d, hn::BitCast(di, bytes)), set(510.0F)), set(1.0F / 147.8F));
  const auto strength = plus(plus(set(task.log2OfZero), times(level, set(task.log2PerLevel))), times(normal, set(task.log2OfTexture)));
  const auto sign = hn::And(spread(hn::Add(other, hn::Set(du, 0x9E3779B9U))), hn::Set(du, kTaken));
  hn::StoreU(hn::Or(hn::And(hash, hn::Set(du, kTaken - 1)), sign), du, made.place.data() + first);
  hn::StoreU(strength, d, made.strength_log2.data() + first);
}

template <FanShape::Kind kKind, bool kSteers>
HWY_NOINLINE void addBlock(const ScatterTask& task, const ScatterBlock& block, BlockScatterers& scatterers, Pending& pending) {
  const D d;
  const DI di;
  const DU du;
  std::array<glm::vec3, 3> step_mm = task.cellToProbe_mm;
  for (std::size_t n = 0; n < step_mm.size(); ++n) step_mm[n] += block.stretch_mm[n];
  for (std::size_t first = 0; first < BlockScatterers::kCount; first += hn::Lanes(d)) {
    const std::uint64_t lanes = kAllLanes << first;
    const bool isKnown = (scatterers.known & lanes) != 0;
    if (isKnown && (scatterers.sounding & lanes) == 0) continue;
    const Cells cells = cellsFrom(static_cast<int>(first));
    U places;
    if (HWY_LIKELY((scatterers.placed & lanes) != 0)) {
      places = hn::LoadU(du, scatterers.place.data() + first);
    } else {
      places = hashOf(task, block, cells);
      hn::StoreU(places, du, scatterers.place.data() + first);
      scatterers.placed |= lanes;
    }
    const auto u = plus(hn::ConvertTo(d, cells.i), placeOf<0>(places)), v = plus(hn::ConvertTo(d, cells.j), placeOf<10>(places)),
               w = plus(hn::ConvertTo(d, cells.k), placeOf<20>(places));
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
    if (HWY_UNLIKELY(!isKnown)) {
      makeStrengths(task, block, first, scatterers);
      places = hn::LoadU(du, scatterers.place.data() + first);
    }
    const std::uint64_t added = bitsOf(d, inside) & (scatterers.sounding >> first);
    if (added == 0) continue;

    const auto strength = hn::LoadU(d, scatterers.strength_log2.data() + first);
    const auto fall = times(hn::IfThenElseZero(inside, exponent), set(1.44269504F));
    const auto amplitude = hn::Div(exp2Of(d, hn::Sub(strength, fall)), hn::Sqrt(hn::Sqrt(widening)));
    const auto kept = hn::Xor(amplitude, hn::BitCast(d, hn::And(places, hn::Set(du, kTaken))));
    F re, im, turns = times(path, set(task.turnsPerMm));
    if constexpr (kSteers) turns = plus(turns, times(across, set(task.leadTurns)));
    phaseOf(hn::IfThenElseZero(inside, turns), re, im);
    const auto wholeRow = roundedOf(d, hn::IfThenElseZero(inside, row));
    const auto insideColumn = hn::IfThenElseZero(inside, column);
    const auto wholeColumn = hn::ConvertTo(di, insideColumn);
    const auto part = hn::Sub(insideColumn, hn::ConvertTo(d, wholeColumn));
    const auto cell = hn::ShiftLeft<1>(hn::Add(hn::Mul(wholeRow, hn::Set(di, task.stride / 2)), wholeColumn));
    deposit(d, task.field, added, cell, part, times(kept, re), times(kept, im), pending);
  }
}

HWY_INLINE void addBlockOf(const ScatterTask& task, const ScatterBlock& block, BlockScatterers& scatterers, Pending& pending) {
  using Kind = FanShape::Kind;
  switch (task.kind) {
    case Kind::parallel:
      task.steers ? addBlock<Kind::parallel, true>(task, block, scatterers, pending)
                  : addBlock<Kind::parallel, false>(task, block, scatterers, pending);
      break;
    case Kind::trapezoid:
      addBlock<Kind::trapezoid, false>(task, block, scatterers, pending);
      break;
    case Kind::sector:
      task.steers ? addBlock<Kind::sector, true>(task, block, scatterers, pending)
                  : addBlock<Kind::sector, false>(task, block, scatterers, pending);
      break;
  }
}

void addScatterersOf(const ScatterTask& task, const std::vector<ScatterBlock>& blocks, ScattererStore& store) {
  Pending pending;
  store.begin(blocks.size());
  if (blocks.empty()) return;
  const auto ask = [&](std::size_t n) {
    bool isNew = false;
    BlockScatterers& asked = store.at(blocks[n].cell, isNew);
    if (isNew)
      announce(task, blocks[n]);
    else
      announce(asked);
    return &asked;
  };
  BlockScatterers* next = ask(0);
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    BlockScatterers& own = *next;
    if (n + 1 < blocks.size()) next = ask(n + 1);
    addBlockOf(task, blocks[n], own, pending);
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

void addScatterers(const ScatterTask& task, const std::vector<ScatterBlock>& blocks, ScattererStore& store) {
  HWY_DYNAMIC_DISPATCH(addScatterersOf)(task, blocks, store);
}

}  // namespace ew::detail
#endif
