#include "measures/fan_slab.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "ew/core/volume.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measures/fan_slab.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ew::detail::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using VecF = hn::Vec<Floats>;

constexpr int kVoxels = 64;

template <class Mask>
HWY_INLINE std::uint64_t bitsOf(Mask mask, int lane) {
  const Floats d;
  HWY_ALIGN std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint16_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  return (bits & ((std::uint64_t{1} << hn::Lanes(d)) - 1)) << lane;
}

HWY_INLINE std::uint64_t outsideOfSlab(const FanSlab::Terms& terms, float z_mm) {
  const Floats d;
  const VecF layer = hn::Set(d, z_mm), half = hn::Set(d, terms.halfThickness_mm);
  std::uint64_t outside = 0;
  for (int lane = 0; lane < kVoxels; lane += static_cast<int>(hn::Lanes(d)))
    outside |= bitsOf(hn::Gt(hn::Abs(hn::Add(layer, hn::Load(d, terms.z_mm.data() + lane))), half), lane);
  return outside;
}

HWY_INLINE std::uint64_t outsideOfFan(const FanSlab::Terms& terms, float x_mm, float y_mm) {
  const Floats d;
  const VecF left = hn::Set(d, x_mm), below = hn::Set(d, y_mm);
  const VecF least = hn::Set(d, terms.least), most = hn::Set(d, terms.most);
  const VecF lowX = hn::Set(d, terms.low.x), lowY = hn::Set(d, terms.low.y), highX = hn::Set(d, terms.high.x),
             highY = hn::Set(d, terms.high.y);
  const VecF beyondLow = hn::Set(d, terms.beyondLow_mm), beyondHigh = hn::Set(d, terms.beyondHigh_mm);
  std::uint64_t outside = 0;
  for (int lane = 0; lane < kVoxels; lane += static_cast<int>(hn::Lanes(d))) {
    const VecF x = hn::Add(left, hn::Load(d, terms.x_mm.data() + lane)), y = hn::Add(below, hn::Load(d, terms.y_mm.data() + lane));
    const VecF depth = terms.isSector ? hn::MulAdd(x, x, hn::Mul(y, y)) : y;
    const auto across =
        hn::Or(hn::Gt(hn::MulAdd(x, lowX, hn::Mul(y, lowY)), beyondLow), hn::Gt(hn::MulAdd(x, highX, hn::Mul(y, highY)), beyondHigh));
    outside |= bitsOf(hn::Or(across, hn::Or(hn::Lt(depth, least), hn::Gt(depth, most))), lane);
  }
  return outside;
}

bool findInBlock(const FanSlab::Terms& terms, const glm::dvec3& corner_mm, const std::uint64_t* asked, std::uint64_t* found) {
  std::uint64_t any = 0;
  for (int k = 0; k < 8; ++k) {
    found[k] = 0;
    if (asked[k] == 0) continue;
    const glm::vec3 first_mm(corner_mm + static_cast<double>(k) * terms.layer_mm);
    if (std::abs(first_mm.z + terms.middleZ_mm) > terms.halfThickness_mm + terms.spreadZ_mm) continue;
    std::uint64_t voxels = asked[k] & ~outsideOfSlab(terms, first_mm.z);
    if (voxels != 0) voxels &= ~outsideOfFan(terms, first_mm.x, first_mm.y);
    found[k] = voxels;
    any |= voxels;
  }
  return any != 0;
}

}  // namespace
}  // namespace ew::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ew::detail {
namespace {

HWY_EXPORT(findInBlock);

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// No coordinate of the organ's blocks in the probe's frame is larger.
double largest_mm(const Transform<frame::Probe, frame::World>& worldToProbe, const OrganVoxels& organ) {
  constexpr double kBlock = 8.0;  // blocks reach beyond the last voxel
  const Bounds bounds = boundsOf(organ.grid());
  const glm::dvec3 spacing_mm = organ.grid().spacing_mm;
  const glm::dvec3 world_mm =
      glm::max(glm::abs(bounds.lowest_mm), glm::abs(bounds.highest_mm)) + kBlock * (spacing_mm.x + spacing_mm.y + spacing_mm.z);
  const glm::dmat4& m = worldToProbe.matrix;
  const glm::dvec3 probe_mm = glm::abs(glm::dvec3(m[0])) * world_mm.x + glm::abs(glm::dvec3(m[1])) * world_mm.y +
                              glm::abs(glm::dvec3(m[2])) * world_mm.z + glm::abs(glm::dvec3(m[3]));
  return std::max({probe_mm.x, probe_mm.y, probe_mm.z});
}

void setSector(FanSlab::Terms& terms, const Fan& fan, const FacePart& heard, double margin_mm) {
  terms.isSector = true;
  const double nearest_mm = std::max(0.0, fan.probe.radius_mm - margin_mm), farthest_mm = fan.probe.radius_mm + fan.depth_mm + margin_mm;
  terms.least = static_cast<float>(nearest_mm * nearest_mm);
  terms.most = static_cast<float>(farthest_mm * farthest_mm);
  terms.beyondLow_mm = terms.beyondHigh_mm = static_cast<float>(margin_mm);
  // Beyond a right angle a line has fan on both of its sides.
  if (!(fan.probe.halfAngle_rad <= 1.5707)) return;
  const double low_rad = heard.from * fan.probe.halfAngle_rad, high_rad = heard.to * fan.probe.halfAngle_rad;
  terms.low = {-std::cos(low_rad), std::sin(low_rad)};
  terms.high = {std::cos(high_rad), -std::sin(high_rad)};
}

void setStraight(FanSlab::Terms& terms, const Fan& fan, const FacePart& heard, double margin_mm) {
  terms.least = static_cast<float>(-margin_mm);
  terms.most = static_cast<float>(fan.depth_mm + margin_mm);
  terms.low = {-1.0F, 0.0F};
  terms.high = {1.0F, 0.0F};
  terms.beyondLow_mm = static_cast<float>(-0.5 * heard.from * fan.probe.width_mm + margin_mm);
  terms.beyondHigh_mm = static_cast<float>(0.5 * heard.to * fan.probe.width_mm + margin_mm);
}

}  // namespace

FanSlab::FanSlab(const Fan& fan, const Transform<frame::Probe, frame::World>& worldToProbe, const OrganVoxels& organ,
                 double halfThickness_mm, const FacePart& heard) {
  const auto voxelToProbe = worldToProbe * organ.grid().voxelToWorld();
  const glm::dvec3 i_mm(voxelToProbe.matrix[0]), j_mm(voxelToProbe.matrix[1]);
  terms_.layer_mm = glm::dvec3(voxelToProbe.matrix[2]);
  for (std::size_t n = 0; n < terms_.x_mm.size(); ++n) {
    const std::size_t i = n % 8, j = n / 8;
    const glm::vec3 from_mm(static_cast<double>(i) * i_mm + static_cast<double>(j) * j_mm);
    terms_.x_mm[n] = from_mm.x;
    terms_.y_mm[n] = from_mm.y;
    terms_.z_mm[n] = from_mm.z;
  }
  apex_mm_ = isSector(fan.probe.kind) ? fan.probe.radius_mm : 0.0;
  // Centres are rounded to float, and so are a corner, a step within a layer and their sum: four times 2^-24 of the largest coordinate, and
  // as much for the products of the outer lines.
  const double margin_mm = 0x1p-19 * (largest_mm(worldToProbe, organ) + fan.probe.radius_mm + fan.depth_mm);
  if (!std::isfinite(margin_mm)) {  // the exact test is asked about everything
    terms_.halfThickness_mm = terms_.most = terms_.beyondLow_mm = terms_.beyondHigh_mm = static_cast<float>(kInfinite);
    terms_.least = static_cast<float>(-kInfinite);
    return;
  }
  terms_.middleZ_mm = static_cast<float>(3.5 * (i_mm.z + j_mm.z));
  terms_.spreadZ_mm = static_cast<float>(3.5 * (std::abs(i_mm.z) + std::abs(j_mm.z)) + margin_mm);
  terms_.halfThickness_mm = static_cast<float>(halfThickness_mm + margin_mm);
  if (isSector(fan.probe.kind))
    setSector(terms_, fan, heard, margin_mm);
  else
    setStraight(terms_, fan, heard, margin_mm);
}

bool FanSlab::reachesFan(const glm::dvec3& middle_mm, double radius_mm) const {
  const double x = middle_mm.x, y = middle_mm.y + apex_mm_;
  const auto isBeyond = [&](const glm::vec2& away, float by_mm) {
    return x * static_cast<double>(away.x) + y * static_cast<double>(away.y) > radius_mm + static_cast<double>(by_mm);
  };
  if (isBeyond(terms_.low, terms_.beyondLow_mm) || isBeyond(terms_.high, terms_.beyondHigh_mm)) return false;
  const double least = static_cast<double>(terms_.least), most = static_cast<double>(terms_.most);
  if (!terms_.isSector) return !(y + radius_mm < least || y - radius_mm > most);
  const double away_mm = std::hypot(x, y);
  return !((away_mm + radius_mm) * (away_mm + radius_mm) < least ||
           (away_mm > radius_mm && (away_mm - radius_mm) * (away_mm - radius_mm) > most));
}

bool FanSlab::find(const glm::dvec3& corner_mm, const Layers& asked, Layers& found) const {
  return HWY_DYNAMIC_DISPATCH(findInBlock)(terms_, corner_mm + glm::dvec3(0.0, apex_mm_, 0.0), asked.data(), found.data());
}

}  // namespace ew::detail
#endif
