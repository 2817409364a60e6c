#include "surface_rows.h"

#include <limits>

#include "ew/imaging/tissue_maps.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/surface_rows.cpp"
#include "hwy/foreach_target.h"
//
#include "echoes/bytes-inl.h"
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // bytes-inl.h, powers-inl.h

constexpr float kCloseTo_mm = 0.35F;  // from here on steps are fine
constexpr float kTrusted = 0.85F;     // of a distance, which is first order, and between voxels
constexpr float kMostJump = 1.4F;     // of the way: beyond, two surfaces' distances meet and nothing is crossed

template <class D>
using Places = std::array<hn::Vec<D>, 3>;

/// Adds what rests where the lines are.
template <class D>
HWY_INLINE void addBack(D d, const EchoMotion::Rows& rows, hn::Vec<hn::RebindToSigned<D>> lines, hn::Vec<D> range, hn::Mask<D> active,
                        Places<D>& place) {
  const hn::RebindToSigned<D> di;
  const auto moving = hn::And(active, hn::Lt(range, hn::Set(d, rows.deepest_mm)));
  if (hn::AllFalse(d, moving)) return;
  const auto at = hn::Mul(hn::IfThenElseZero(moving, range), hn::Set(d, rows.perKnot));
  const auto knot = hn::Min(hn::ConvertTo(di, at), hn::Set(di, rows.knots - 2));
  const auto part = hn::Sub(at, hn::ConvertTo(d, knot));
  const auto cell = hn::Add(hn::Mul(knot, hn::Set(di, rows.lines)), lines);
  const auto near = hn::Add(hn::Add(cell, cell), cell), next = hn::Add(near, hn::Set(di, 3 * rows.lines));
  for (int axis = 0; axis < 3; ++axis) {
    const float* numbers = &rows.first->x + axis;
    const auto before = hn::GatherIndex(d, numbers, near), after = hn::GatherIndex(d, numbers, next);
    const auto back = hn::Add(before, hn::Mul(part, hn::Sub(after, before)));
    auto& own = place[static_cast<std::size_t>(axis)];
    own = hn::Add(own, hn::IfThenElseZero(moving, back));
  }
}

template <class D>
HWY_INLINE Places<D> placesAt(D d, const SurfaceWalk& walk, int line, hn::Vec<D> range, hn::Mask<D> active) {
  const hn::RebindToSigned<D> di;
  const auto sigma_mm = hn::GatherIndex(d, walk.sigma_mm, hn::ConvertTo(di, hn::IfThenElseZero(active, range)));
  const auto off = hn::Mul(hn::Set(d, walk.sigmas), sigma_mm);
  Places<D> place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto along =
        hn::Add(hn::LoadU(d, walk.ways.start[a].data() + line), hn::Mul(range, hn::LoadU(d, walk.ways.perMm[a].data() + line)));
    place[a] = hn::Add(along, hn::Mul(off, hn::Set(d, walk.aside_voxel[axis])));
  }
  if (walk.back.first != nullptr) addBack(d, walk.back, hn::Iota(di, line), range, active, place);
  return place;
}

/// mm, between the eight voxels around each place.
/// @return where it is known
template <class D>
HWY_INLINE hn::Mask<D> distancesAt(D d, const ByteMap& map, const Places<D>& place, hn::Mask<D> active, hn::Vec<D>& distance_mm) {
  const hn::RebindToSigned<D> di;
  const auto inside = hn::And(active, isInside(d, map, place));
  if (hn::AllFalse(d, inside)) return inside;
  std::array<hn::Vec<hn::RebindToSigned<D>>, 3> low;
  Places<D> t;
  for (std::size_t axis = 0; axis < low.size(); ++axis) {
    low[axis] = hn::ConvertTo(di, hn::IfThenElseZero(inside, place[axis]));
    t[axis] = hn::Sub(place[axis], hn::ConvertTo(d, low[axis]));
  }
  const auto pairs = pairsAround(di, map, low[0], low[1], low[2]);
  std::array<hn::Vec<D>, 4> along;
  auto isNone = hn::MaskFromVec(hn::Zero(di));
  for (std::size_t n = 0; n < along.size(); ++n) {
    const auto first = hn::And(pairs[n], hn::Set(di, 0xFF)), second = hn::And(hn::ShiftRight<8>(pairs[n]), hn::Set(di, 0xFF));
    isNone = hn::Or(isNone, hn::Or(hn::Eq(first, hn::Zero(di)), hn::Eq(second, hn::Zero(di))));
    along[n] = hn::Add(hn::ConvertTo(d, first), hn::Mul(t[0], hn::ConvertTo(d, hn::Sub(second, first))));
  }
  const auto near = hn::Add(along[0], hn::Mul(t[1], hn::Sub(along[1], along[0])));
  const auto far = hn::Add(along[2], hn::Mul(t[1], hn::Sub(along[3], along[2])));
  constexpr auto kMmPerStep = static_cast<float>(1.0 / TissueMaps::kDistanceStepsPerMm);
  const auto steps = hn::Sub(hn::Add(near, hn::Mul(t[2], hn::Sub(far, near))), hn::Set(d, 128.0F));
  distance_mm = hn::Mul(steps, hn::Set(d, kMmPerStep));
  return hn::AndNot(hn::RebindMask(d, isNone), inside);
}

/// Each lane goes on as far as its own surface is away, until the last is through.
template <class D>
HWY_INLINE void walkLanes(D d, const SurfaceWalk& walk, int line, std::vector<SurfaceCrossing>& found) {
  const auto none = hn::Set(d, std::numeric_limits<float>::quiet_NaN()), end = hn::Set(d, walk.depth_mm);
  auto range = hn::Zero(d), step = hn::Zero(d), before = none;
  for (auto active = hn::Lt(range, end); !hn::AllFalse(d, active); active = hn::Lt(range, end)) {
    auto distance = none;
    const auto known = distancesAt(d, walk.distances, placesAt(d, walk, line, range, active), active, distance);
    const auto here = hn::IfThenElse(known, distance, none);
    const auto last = before, lastStep = step;
    before = here;
    const auto away = hn::Abs(here), fine = hn::Set(d, kFineStep_mm);
    const auto wide = hn::IfThenElse(hn::Gt(away, hn::Set(d, kCloseTo_mm)), hn::Max(hn::Mul(hn::Set(d, kTrusted), away), fine), fine);
    step = hn::IfThenElse(known, wide, hn::Set(d, walk.blind_mm));
    // Not a number compares false.
    const auto apart = hn::Sub(here, last);
    const auto changes =
        hn::And(hn::Le(hn::Mul(here, last), hn::Zero(d)), hn::Lt(hn::Abs(apart), hn::Mul(hn::Set(d, kMostJump), lastStep)));
    std::uint64_t left = bitsOf(d, hn::And(hn::And(active, changes), hn::Ne(here, last)));
    if (HWY_UNLIKELY(left != 0)) {
      HWY_ALIGN float met[hn::MaxLanes(d)];
      hn::Store(hn::Sub(range, hn::Div(hn::Mul(lastStep, here), apart)), d, met);
      const std::uint64_t entering = bitsOf(d, hn::Lt(here, last));
      for (; left != 0; left &= left - 1) {
        const int n = __builtin_ctzll(left);
        found.push_back({line + n, met[n], ((entering >> n) & 1U) != 0});
      }
    }
    range = hn::Add(range, step);
  }
}

void findCrossingsOf(const SurfaceWalk& walk, int first, int count, std::vector<SurfaceCrossing>& found) {
  forColumns(count, [&](auto d, int x) HWY_ATTR { walkLanes(d, walk, first + x, found); });
}

void distancesOfAll(const SurfaceWalk& walk, const glm::mat4& m, const std::vector<glm::vec4>& lines,
                    const std::vector<SurfaceProbe>& probes, std::vector<float>& distance_mm) {
  static_assert(sizeof(SurfaceProbe) == 12 && sizeof(glm::vec4) == 16);
  forColumns(static_cast<int>(probes.size()), [&](auto d, int first) HWY_ATTR {
    using D = decltype(d);
    const hn::RebindToSigned<D> di;
    hn::Vec<D> number, range, off;
    hn::LoadInterleaved3(d, reinterpret_cast<const float*>(probes.data() + first), number, range, off);
    const auto line = hn::BitCast(di, number), four = hn::ShiftLeft<2>(line);
    const auto ofLine = [&](int part) HWY_ATTR { return hn::GatherIndex(d, &lines.data()->x + part, four); };
    const auto x = hn::Add(ofLine(0), hn::Mul(range, ofLine(2))), y = hn::Add(ofLine(1), hn::Mul(range, ofLine(3)));
    Places<D> place;
    for (int axis = 0; axis < 3; ++axis) {  // as the product of a matrix and a point is added up elsewhere
      const auto inSlice = hn::Add(hn::Mul(hn::Set(d, m[0][axis]), x), hn::Mul(hn::Set(d, m[1][axis]), y));
      const auto beside = hn::Add(hn::Mul(hn::Set(d, m[2][axis]), off), hn::Set(d, m[3][axis]));
      place[static_cast<std::size_t>(axis)] = hn::Add(inSlice, beside);
    }
    const auto all = hn::Eq(range, range);
    if (walk.back.first != nullptr) addBack(d, walk.back, line, range, all, place);
    auto distance = hn::Zero(d);
    const auto known = distancesAt(d, walk.distances, place, all, distance);
    hn::StoreU(hn::IfThenElse(known, distance, hn::Set(d, std::numeric_limits<float>::quiet_NaN())), d, distance_mm.data() + first);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(findCrossingsOf);
HWY_EXPORT(distancesOfAll);

void findCrossings(const SurfaceWalk& walk, int first, int count, std::vector<SurfaceCrossing>& found) {
  HWY_DYNAMIC_DISPATCH(findCrossingsOf)(walk, first, count, found);
}

void distancesOf(const SurfaceWalk& walk, const glm::mat4& probeToVoxel, const std::vector<glm::vec4>& lines,
                 const std::vector<SurfaceProbe>& probes, std::vector<float>& distance_mm) {
  distance_mm.resize(probes.size());
  HWY_DYNAMIC_DISPATCH(distancesOfAll)(walk, probeToVoxel, lines, probes, distance_mm);
}

}  // namespace ew::detail
#endif
