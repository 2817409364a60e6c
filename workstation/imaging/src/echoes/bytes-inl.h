// Bytes of maps at places of their own for every lane, included once for every instruction set (Highway's foreach_target.h).
#if defined(EW_IMAGING_BYTES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EW_IMAGING_BYTES_INL_H_
#undef EW_IMAGING_BYTES_INL_H_
#else
#define EW_IMAGING_BYTES_INL_H_
#endif

#include <array>
#include <cstdint>
#include <cstring>

#include "echoes/byte_map.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ew {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Four bytes from each place; lanes beyond `last` take the bytes that end there and shift them.
template <class DI>
HWY_INLINE hn::Vec<DI> bytesAt(DI di, const std::uint8_t* from, hn::Vec<DI> offset, std::int32_t last) {
  const auto safe = hn::Min(offset, hn::Set(di, last));
#if HWY_TARGET <= HWY_AVX2
  const auto word = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(from), safe);
#else
  HWY_ALIGN std::int32_t offsets[hn::MaxLanes(di)], words[hn::MaxLanes(di)];
  hn::Store(safe, di, offsets);
  for (std::size_t n = 0; n < hn::Lanes(di); ++n) std::memcpy(&words[n], from + offsets[n], sizeof(words[n]));
  const auto word = hn::Load(di, words);
#endif
  const auto beyond = hn::Sub(offset, safe);
  if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(beyond, hn::Zero(di))))) return word;
  const hn::RebindToUnsigned<DI> du;
  return hn::BitCast(di, hn::Shr(hn::BitCast(du, word), hn::BitCast(du, hn::ShiftLeft<3>(hn::Min(beyond, hn::Set(di, 3))))));
}

/// One bit for each lane, the first lowest.
template <class D, class M>
HWY_INLINE std::uint64_t bitsOf(D d, M mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  std::uint64_t result = 0;
  std::memcpy(&result, bits, sizeof(result));
  return result;
}

/// Places that have eight voxels around them; not a number has none.
template <class D>
HWY_INLINE hn::Mask<D> isInside(D d, const detail::ByteMap& map, const std::array<hn::Vec<D>, 3>& place) {
  const auto within = [&](std::size_t axis, float end)
                          HWY_ATTR { return hn::And(hn::Ge(place[axis], hn::Zero(d)), hn::Lt(place[axis], hn::Set(d, end))); };
  return hn::And(hn::And(within(0, map.last.x), within(1, map.last.y)), within(2, map.last.z));
}

/// The eight bytes around places that lie inside the map, as the first two bytes of four words: at (j, k), (j + 1, k), (j, k + 1) and
/// (j + 1, k + 1).
/// @param i, j, k whole parts of the places
template <class DI>
HWY_INLINE std::array<hn::Vec<DI>, 4> pairsAround(DI di, const detail::ByteMap& map, hn::Vec<DI> i, hn::Vec<DI> j, hn::Vec<DI> k) {
  const std::array<std::ptrdiff_t, 4> more{0, map.row, map.plane, map.row + map.plane};
  std::array<hn::Vec<DI>, 4> pairs;
  if (HWY_LIKELY(map.isSmall())) {
    const auto row = static_cast<std::int32_t>(map.row), plane = static_cast<std::int32_t>(map.plane);
    const auto last = static_cast<std::int32_t>(map.count - 4);
    const auto at = hn::Add(i, hn::Add(hn::Mul(j, hn::Set(di, row)), hn::Mul(k, hn::Set(di, plane))));
    for (std::size_t n = 0; n < pairs.size(); ++n)
      pairs[n] = bytesAt(di, map.first, hn::Add(at, hn::Set(di, static_cast<std::int32_t>(more[n]))), last);
    return pairs;
  }
  HWY_ALIGN std::int32_t places[3][hn::MaxLanes(di)], words[hn::MaxLanes(di)] = {};
  hn::Store(i, di, places[0]);
  hn::Store(j, di, places[1]);
  hn::Store(k, di, places[2]);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    for (std::size_t lane = 0; lane < hn::Lanes(di); ++lane)
      std::memcpy(&words[lane], map.first + places[0][lane] + map.row * places[1][lane] + map.plane * places[2][lane] + more[n], 2);
    pairs[n] = hn::Load(di, words);
  }
  return pairs;
}

}  // namespace HWY_NAMESPACE
}  // namespace ew
HWY_AFTER_NAMESPACE();

#endif
