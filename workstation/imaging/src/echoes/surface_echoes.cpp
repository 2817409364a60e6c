#include "surface_echoes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/surface_echoes.cpp"
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
using Places = std::array<F, 3>;

constexpr float kGrain_mm = 4.5F;         // of unevenness
constexpr float kNextSheet = 0.75F;       // as strong as the one in front of it
constexpr float kSheetsApart_mm = 97.0F;  // each is uneven at places of its own
constexpr float kMostDeposit = 0x1p28F;

HWY_INLINE F set(float value) { return hn::Set(D(), value); }
HWY_INLINE F plus(F a, F b) { return hn::Add(a, b); }
HWY_INLINE F times(F a, F b) { return hn::Mul(a, b); }
HWY_INLINE F mixed(F a, F b, F part) { return plus(a, times(part, hn::Sub(b, a))); }

/// Between 0 and 1, smooth, fixed in the tissue: hashed at the corners of cells of kGrain_mm.
HWY_INLINE F unevenAt(const Places& mm) {
  const D d;
  const DI di;
  const DU du;
  constexpr std::array<std::uint32_t, 3> kFactors{0x9E3779B1U, 0x85EBCA77U, 0xC2B2AE3DU};
  Places t;
  std::array<U, 3> low;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto cell = times(mm[axis], set(1.0F / kGrain_mm)), whole = hn::Floor(cell);
    const auto part = hn::Sub(cell, whole);
    t[axis] = times(times(part, part), hn::Sub(set(3.0F), plus(part, part)));
    low[axis] = hn::Mul(hn::BitCast(du, hn::ConvertTo(di, whole)), hn::Set(du, kFactors[axis]));
  }
  const auto cornerAt = [&](std::uint32_t more) {
    const auto hash = spreadOf(du, hn::Add(hn::Add(low[0], low[1]), hn::Add(low[2], hn::Set(du, more))));
    return hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<8>(hash)));
  };
  std::array<F, 4> along;
  for (std::size_t n = 0; n < along.size(); ++n) {
    const std::uint32_t more = (n & 1U ? kFactors[1] : 0U) + (n & 2U ? kFactors[2] : 0U);
    along[n] = mixed(cornerAt(more), cornerAt(more + kFactors[0]), t[0]);
  }
  return times(mixed(mixed(along[0], along[1], t[1]), mixed(along[2], along[3], t[1]), t[2]), set(0x1p-24F));
}
/// Of a surface's amplitude, by 4 dB at most.
HWY_INLINE F shareOf(const Places& mm) { return hn::Min(hn::Max(plus(times(set(1.2F), unevenAt(mm)), set(0.3F)), set(0.6F)), set(1.0F)); }

/// The eight voxels around a place, the lowest of them within the map.
struct Around {
  std::array<I, 3> low;
  Places t;
};
HWY_INLINE Around around(const ByteMap& map, const Places& at) {
  const DI di;
  Around result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<std::int32_t>(map.last[static_cast<int>(axis)]) - 1;
    result.low[axis] = hn::Min(hn::Max(hn::ConvertTo(di, at[axis]), hn::Zero(di)), hn::Set(di, last));
    result.t[axis] = hn::Sub(at[axis], hn::ConvertTo(D(), result.low[axis]));
  }
  return result;
}

HWY_INLINE I firstByte(I word) { return hn::And(word, hn::Set(DI(), 0xFF)); }
HWY_INLINE I secondByte(I word) { return hn::And(hn::ShiftRight<8>(word), hn::Set(DI(), 0xFF)); }

/// Number of the surface between whose voxels a crossing lies, from 0 on; below 0 where those of several surfaces mix, between which
/// distances jump.
HWY_INLINE I surfaceAt(const ByteMap& kinds, const Around& here, const Places& at) {
  const DI di;
  auto isIn = hn::Eq(at[0], at[0]);
  std::array<hn::Mask<DI>, 3> isHigh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto last = kinds.last[static_cast<int>(axis)];
    isIn = hn::And(isIn, hn::And(hn::Ge(at[axis], set(-0.5F)), hn::Lt(at[axis], set(last + 0.5F))));
    isHigh[axis] = hn::RebindMask(di, hn::Ge(here.t[axis], set(0.5F)));
  }
  const auto pairs = pairsAround(di, kinds, here.low[0], here.low[1], here.low[2]);
  const auto near = hn::IfThenElse(isHigh[1], pairs[1], pairs[0]), far = hn::IfThenElse(isHigh[1], pairs[3], pairs[2]);
  const auto nearest = hn::IfThenElse(isHigh[2], far, near);
  const auto kind = hn::IfThenElse(isHigh[0], secondByte(nearest), firstByte(nearest));
  auto same = hn::Zero(di);
  for (const I& pair : pairs)  // a mask that is set counts as -1
    same = hn::Sub(same, hn::Add(hn::VecFromMask(di, hn::Eq(firstByte(pair), kind)), hn::VecFromMask(di, hn::Eq(secondByte(pair), kind))));
  constexpr int kEnough = 6;
  const auto isOne = hn::And(hn::RebindMask(di, isIn), hn::Gt(same, hn::Set(di, kEnough - 1)));
  return hn::Sub(hn::IfThenElseZero(isOne, kind), hn::Set(di, 1));
}

/// Slope of the distance, in steps of the map over voxels.
HWY_INLINE Places slopeAt(const ByteMap& distances, const Around& here) {
  const D d;
  const DI di;
  const auto pairs = pairsAround(di, distances, here.low[0], here.low[1], here.low[2]);
  std::array<F, 4> step, along;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    step[n] = hn::ConvertTo(d, hn::Sub(secondByte(pairs[n]), firstByte(pairs[n])));
    along[n] = plus(hn::ConvertTo(d, firstByte(pairs[n])), times(here.t[0], step[n]));
  }
  const F y = here.t[1], z = here.t[2];
  return {mixed(mixed(step[0], step[1], y), mixed(step[2], step[3], y), z),
          mixed(hn::Sub(along[1], along[0]), hn::Sub(along[3], along[2]), z),
          mixed(hn::Sub(along[2], along[0]), hn::Sub(along[3], along[1]), y)};
}

/// 2^(-fall sine2).
HWY_INLINE F fallen(const std::vector<float>& fall, I surface, F sine2) {
  const auto doublings = times(hn::GatherIndex(D(), fall.data(), surface), sine2);
  return exp2Of(D(), hn::Neg(hn::Min(doublings, set(100.0F))));
}

/// One sheet of a surface, in every row of its lines.
struct Sheet {
  F range_mm;
  F side_mm;  ///< how much farther it is met on one side of the slice, nearer on the other
  F lean;     ///< mm along the line, for a mm across: neighbouring rows meet the surface a little earlier or later
  F mirror, rough;
};
HWY_INLINE void addRows(const SurfaceEchoTask& task, I line, hn::Mask<DI> isSeen, const Sheet& sheet, F weight, Pending& pending) {
  const D d;
  const DI di;
  const int middleRow = task.rowsPerLine / 2;
  const auto firstRow = hn::Add(hn::Mul(line, hn::Set(di, task.rowsPerLine)), hn::Set(di, task.rowPadding - middleRow));
  const auto leanOfRow = times(sheet.lean, plus(set(task.spacingAtFace_mm), times(sheet.range_mm, set(task.spacingPerMm))));
  for (int n = 0; n < task.rowsPerLine; ++n) {
    const auto range_mm = plus(sheet.range_mm, times(leanOfRow, set(static_cast<float>(n - middleRow))));
    const auto column = plus(set(task.firstColumn), times(range_mm, set(task.columnsPerMm)));
    const auto row = hn::Add(firstRow, hn::Set(di, n));
    const auto isOnRow = hn::And(hn::Gt(row, hn::Set(di, -1)), hn::Lt(row, hn::Set(di, task.rows)));
    const auto isOnColumn = hn::And(hn::Ge(column, hn::Zero(d)), hn::Lt(column, set(static_cast<float>(task.columns - 1))));
    const auto inside = hn::And(hn::And(isSeen, isOnRow), hn::RebindMask(di, isOnColumn));
    const std::uint64_t added = bitsOf(di, inside);
    if (added == 0) continue;
    const auto insideColumn = hn::IfThenElseZero(hn::RebindMask(d, inside), column);
    const auto whole = hn::ConvertTo(di, insideColumn);
    const auto scale = times(hn::GatherIndex(d, task.scale, whole), weight);
    const auto cell = hn::ShiftLeft<1>(hn::Add(hn::Mul(row, hn::Set(di, task.stride / 2)), whole));
    deposit(d, task.field, added, cell, hn::Sub(insideColumn, hn::ConvertTo(d, whole)),
            hn::Min(times(sheet.mirror, scale), set(kMostDeposit)), hn::Min(times(sheet.rough, scale), set(kMostDeposit)), pending);
  }
}

HWY_INLINE void addSheet(const SurfaceEchoTask& task, I line, hn::Mask<DI> isSeen, const Sheet& sheet, Pending& pending) {
  // A tenth of a column is none.
  const auto isAside = hn::Gt(times(hn::Abs(sheet.side_mm), set(task.columnsPerMm)), set(0.1F));
  addRows(task, line, isSeen, sheet, hn::IfThenElse(isAside, set(1.0F - 2.0F * task.sideShare), set(1.0F)), pending);
  const auto isMetAside = hn::And(isSeen, hn::RebindMask(DI(), isAside));
  if (hn::AllFalse(DI(), isMetAside)) return;
  for (const float side : {-1.0F, 1.0F}) {
    Sheet aside = sheet;
    aside.range_mm = plus(sheet.range_mm, times(set(side), sheet.side_mm));
    addRows(task, line, isMetAside, aside, set(task.sideShare), pending);
  }
}

void addCrossings(const SurfaceEchoTask& task, const SurfaceCrossings& met, std::size_t first, Pending& pending) {
  const D d;
  const DI di;
  Places at;
  for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = hn::LoadU(d, met.at[axis].data() + first);
  const Around here = around(task.kinds, at);
  const auto surface = surfaceAt(task.kinds, here, at);
  auto isSeen =
      hn::And(hn::Gt(surface, hn::Set(di, -1)), hn::Lt(surface, hn::Set(di, static_cast<std::int32_t>(task.strengths.mirror.size()))));
  if (hn::AllFalse(di, isSeen)) return;
  const auto known = hn::IfThenElseZero(isSeen, surface);
  const auto entering = hn::LoadU(d, met.entering.data() + first);
  const auto isFrontOnly = hn::Gt(hn::GatherIndex(di, task.strengths.frontOnly.data(), known), hn::Zero(di));
  isSeen = hn::AndNot(hn::And(isFrontOnly, hn::RebindMask(di, hn::Lt(entering, hn::Zero(d)))), isSeen);

  const Places ofVoxels = slopeAt(task.distances, here);
  Places slope;
  for (int axis = 0; axis < 3; ++axis)
    slope[static_cast<std::size_t>(axis)] =
        plus(plus(times(set(task.slopeToProbe[0][axis]), ofVoxels[0]), times(set(task.slopeToProbe[1][axis]), ofVoxels[1])),
             times(set(task.slopeToProbe[2][axis]), ofVoxels[2]));
  for (std::size_t axis = 0; axis < met.turned.size(); ++axis) {
    const auto turned = hn::LoadU(d, met.turned[axis].data() + first);
    slope[axis] = hn::IfThenElse(hn::Eq(turned, turned), turned, slope[axis]);
  }
  const auto steep = hn::Sqrt(plus(plus(times(slope[0], slope[0]), times(slope[1], slope[1])), times(slope[2], slope[2])));
  isSeen = hn::And(isSeen, hn::RebindMask(di, hn::Gt(steep, hn::Zero(d))));

  const auto line = hn::LoadU(di, met.line.data() + first), four = hn::ShiftLeft<2>(line);
  const auto wayX = hn::GatherIndex(d, &task.lines.data()->z, four), wayY = hn::GatherIndex(d, &task.lines.data()->w, four);
  const auto down = plus(times(slope[0], wayX), times(slope[1], wayY)), across = hn::Sub(times(slope[0], wayY), times(slope[1], wayX));
  const auto cosine = hn::Min(hn::Div(hn::Abs(down), hn::IfThenElse(hn::RebindMask(d, isSeen), steep, set(1.0F))), set(1.0F));
  const auto sine2 = hn::Sub(set(1.0F), times(cosine, cosine));
  const auto strengthOf = [&](const std::vector<float>& numbers) {
    return times(set(task.weight), hn::GatherIndex(d, numbers.data(), known));
  };
  const auto mirror = times(strengthOf(task.strengths.mirror), fallen(task.strengths.mirrorFall, known, sine2));
  const auto rough = times(strengthOf(task.strengths.rough), fallen(task.strengths.roughFall, known, sine2));
  const auto steepest = hn::CopySign(hn::Max(hn::Abs(down), set(0.2F)), down);
  const auto lean = hn::Div(hn::Neg(across), steepest), range_mm = hn::LoadU(d, met.range_mm.data() + first);
  auto side_mm = hn::Zero(d);
  if (task.sideSigmas > 0.0F) {
    const auto isMet = hn::RebindMask(d, isSeen);
    const auto sigma_mm = hn::GatherIndex(d, task.sigma_mm, hn::ConvertTo(di, hn::IfThenElseZero(isMet, range_mm)));
    side_mm = times(times(hn::Div(slope[2], steepest), sigma_mm), set(task.sideSigmas));
  }

  // What is rough is in quadrature and coherent along the surface too: of random signs it was a string of beads.
  Sheet sheet{range_mm, side_mm, hn::Min(hn::Max(lean, set(-3.0F)), set(3.0F)), mirror, rough};
  // What lies behind it, as the beam goes.
  const auto gap_mm = hn::Div(times(entering, hn::GatherIndex(d, task.strengths.sheetGap_mm.data(), known)), hn::Max(cosine, set(0.3F)));
  const auto sheets = hn::GatherIndex(di, task.strengths.sheets.data(), known);
  Places mm;
  for (std::size_t axis = 0; axis < 3; ++axis) mm[axis] = times(at[axis], set(task.spacing_mm[static_cast<int>(axis)]));
  auto fainter = set(1.0F);
  for (int number = 0; number < kMostSheets; ++number) {
    isSeen = hn::And(isSeen, hn::Gt(sheets, hn::Set(di, number)));
    if (hn::AllFalse(di, isSeen)) return;
    sheet.mirror = times(times(shareOf(mm), fainter), mirror);
    sheet.rough = times(fainter, rough);
    addSheet(task, line, isSeen, sheet, pending);
    fainter = times(fainter, set(kNextSheet));
    sheet.range_mm = plus(sheet.range_mm, gap_mm);
    for (F& each : mm) each = plus(each, set(kSheetsApart_mm));
  }
}

void addSurfaceEchoesOf(const SurfaceEchoTask& task, const SurfaceCrossings& met) {
  Pending pending;
  for (std::size_t first = 0; first < met.line.size(); first += hn::Lanes(D())) addCrossings(task, met, first, pending);
  pending.flush();
}

std::size_t lanesOf() { return hn::Lanes(D()); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(addSurfaceEchoesOf);
HWY_EXPORT(lanesOf);

void SurfaceStrengths::take(const std::vector<ReflectingSurface>& surfaces, double gain_db) {
  constexpr double kDecibelPerLevel = 60.0 / 255.0;
  for (auto* numbers : {&mirror, &rough, &mirrorFall, &roughFall, &sheetGap_mm}) numbers->clear();
  sheets.clear();
  frontOnly.clear();
  const auto fallOf = [](double fall_deg) {
    const double fall = std::sin(fall_deg * std::numbers::pi / 180.0);
    return static_cast<float>(0.5 * std::numbers::log2e / (fall * fall));
  };
  for (const ReflectingSurface& surface : surfaces) {
    const double amplitude = std::pow(10.0, 0.05 * ((surface.echoLevel - 255.0) * kDecibelPerLevel + gain_db));
    mirror.push_back(static_cast<float>(amplitude));
    rough.push_back(static_cast<float>(amplitude * std::pow(10.0, 0.05 * surface.rough_db)));
    mirrorFall.push_back(fallOf(surface.fall_deg));
    roughFall.push_back(fallOf(surface.roughFall_deg));
    sheetGap_mm.push_back(static_cast<float>(surface.sheetGap_mm));
    sheets.push_back(std::clamp(surface.sheets, 1, kMostSheets));
    frontOnly.push_back(surface.frontOnly ? 1 : 0);
  }
}

void SurfaceCrossings::resize(std::size_t count) {
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  const std::size_t lanes = HWY_DYNAMIC_DISPATCH(lanesOf)(), whole = (count + lanes - 1) / lanes * lanes;
  line.resize(whole);
  for (auto* numbers : {&range_mm, &entering, &at[0], &at[1], &at[2], &turned[0], &turned[1]}) numbers->resize(whole);
  std::fill(line.begin() + static_cast<std::ptrdiff_t>(count), line.end(), 0);
  for (auto* numbers : {&range_mm, &entering, &at[0], &at[1], &at[2], &turned[0], &turned[1]})
    std::fill(numbers->begin() + static_cast<std::ptrdiff_t>(count), numbers->end(), kNowhere);
}

void addSurfaceEchoes(const SurfaceEchoTask& task, const SurfaceCrossings& met) { HWY_DYNAMIC_DISPATCH(addSurfaceEchoesOf)(task, met); }

}  // namespace ew::detail
#endif
