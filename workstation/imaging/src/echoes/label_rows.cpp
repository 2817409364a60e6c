#include "label_rows.h"

// The instruction sets left out would only repeat the code of a neighbour.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "echoes/label_rows.cpp"
#include "hwy/foreach_target.h"
//
#include "echoes/bytes-inl.h"
#include "effects/powers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ew::detail {
namespace HWY_NAMESPACE {
namespace {

using namespace ew::HWY_NAMESPACE;  // bytes-inl.h, powers-inl.h

template <class D>
HWY_INLINE void placesOf(D d, const RowOfPlaces& places, int line, std::array<hn::Vec<D>, 3>& place) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto start = hn::Add(hn::LoadU(d, places.ways.start[a].data() + line), hn::Set(d, places.offset_voxel[axis]));
    place[a] = hn::Add(start, hn::Mul(hn::LoadU(d, places.ways.perMm[a].data() + line), hn::Set(d, places.range_mm)));
  }
  if (places.back.near == nullptr) return;
  std::array<hn::Vec<D>, 3> near, next;
  hn::LoadInterleaved3(d, &places.back.near[line].x, near[0], near[1], near[2]);
  hn::LoadInterleaved3(d, &places.back.next[line].x, next[0], next[1], next[2]);
  for (std::size_t a = 0; a < place.size(); ++a)
    place[a] = hn::Add(place[a], hn::Add(near[a], hn::Mul(hn::Set(d, places.back.part), hn::Sub(next[a], near[a]))));
}

/// Asks for the voxels that a depth farther down will read.
template <class D>
HWY_INLINE void announce(D d, const ByteMap& map, const RowOfPlaces& places, int line, std::array<hn::Vec<D>, 3> p) {
  const hn::RebindToSigned<D> di;
  for (std::size_t a = 0; a < p.size(); ++a)
    p[a] = hn::Add(p[a], hn::Mul(hn::LoadU(d, places.ways.perMm[a].data() + line), hn::Set(d, places.ahead_mm)));
  const auto inside = isInside(d, map, p);
  const auto wholeOf = [&](std::size_t axis) HWY_ATTR { return hn::ConvertTo(di, hn::IfThenElseZero(inside, p[axis])); };
  HWY_ALIGN std::int32_t at[3][hn::MaxLanes(di)];
  for (std::size_t axis = 0; axis < p.size(); ++axis) hn::Store(wholeOf(axis), di, at[axis]);
  for (std::size_t n = 0; n < hn::Lanes(d); ++n) {
    const std::uint8_t* first = map.first + at[0][n] + map.row * at[1][n] + map.plane * at[2][n];
    __builtin_prefetch(first);
    __builtin_prefetch(first + map.row);
    __builtin_prefetch(first + map.plane);
    __builtin_prefetch(first + map.row + map.plane);
  }
}

/// Where all eight voxels are of one label, as most are, its numbers; elsewhere each lane asks for itself.
template <class D>
HWY_INLINE void blendLanes(D d, const LabelBlend& blend, const ByteMap& map, const RowOfPlaces& places, int line, float* ownAt,
                           float* reflectionAt) {
  const hn::RebindToSigned<D> di;
  std::array<hn::Vec<D>, 3> p;
  placesOf(d, places, line, p);
  const auto inside = isInside(d, map, p);
  if (hn::AllFalse(d, inside)) {
    hn::StoreU(hn::Set(d, blend.own[0]), d, ownAt);
    hn::StoreU(hn::Set(d, blend.reflection[0]), d, reflectionAt);
    return;
  }
  announce(d, map, places, line, p);
  const auto wholeOf = [&](std::size_t axis) HWY_ATTR { return hn::ConvertTo(di, hn::IfThenElseZero(inside, p[axis])); };
  const auto pairs = pairsAround(di, map, wholeOf(0), wholeOf(1), wholeOf(2));
  const auto label = hn::And(pairs[0], hn::Set(di, 0xFF)), even = hn::Or(label, hn::ShiftLeft<8>(label));
  const auto others = hn::Or(hn::Xor(pairs[1], even), hn::Or(hn::Xor(pairs[2], even), hn::Xor(pairs[3], even)));
  const auto mixed = hn::And(hn::Or(hn::Xor(pairs[0], even), others), hn::Set(di, 0xFFFF));
  const auto known = hn::IfThenElseZero(hn::RebindMask(di, inside), label);
  hn::StoreU(hn::GatherIndex(d, blend.own.data(), known), d, ownAt);
  hn::StoreU(hn::GatherIndex(d, blend.reflection.data(), known), d, reflectionAt);

  std::uint64_t left = bitsOf(d, hn::And(inside, hn::RebindMask(d, hn::Ne(mixed, hn::Zero(di)))));
  if (left == 0) return;
  HWY_ALIGN float lanes[3][hn::MaxLanes(d)];
  for (std::size_t axis = 0; axis < p.size(); ++axis) hn::Store(p[axis], d, lanes[axis]);
  for (; left != 0; left &= left - 1) {
    const int n = __builtin_ctzll(left);
    blend.at({lanes[0][n], lanes[1][n], lanes[2][n]}, ownAt[n], reflectionAt[n]);
  }
}

void blendRowOf(const LabelBlend& blend, const RowOfPlaces& places, int first, int count, float* ownAt, float* reflectionAt) {
  const ByteMap map(blend.labels.voxels, blend.labels.grid.dims);
  forColumns(count, [&](auto d, int x) HWY_ATTR { blendLanes(d, blend, map, places, first + x, ownAt + x, reflectionAt + x); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace ew::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {

HWY_EXPORT(blendRowOf);

void LineWays::resize(std::size_t lines) {
  for (auto* each : {&start, &perMm})
    for (std::vector<float>& numbers : *each) numbers.resize(lines);
}

void LineWays::lay(const BeamGrid& grid, const glm::dmat4& probeToVoxel) {
  resize(grid.lines.size());
  for (std::size_t line = 0; line < grid.lines.size(); ++line) {
    const BeamGrid::Line& way = grid.lines[line];
    set(line, glm::vec3(probeToVoxel * glm::dvec4(way.origin_mm, 0.0, 1.0)), glm::vec3(probeToVoxel * glm::dvec4(way.direction, 0.0, 0.0)));
  }
}

void blendRow(const LabelBlend& blend, const RowOfPlaces& places, int first, int count, float* ownAt, float* reflectionAt) {
  HWY_DYNAMIC_DISPATCH(blendRowOf)(blend, places, first, count, ownAt, reflectionAt);
}

}  // namespace ew::detail
#endif
