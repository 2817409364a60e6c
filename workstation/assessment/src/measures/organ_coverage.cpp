#include "ew/assessment/organ_coverage.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ew/core/contract.h"
#include "measures/fan_slab.h"

namespace ew {
namespace {

constexpr float kGel_mm = 3.0F;  // gaps up to this are filled, as contactShare has it

bool hearsAt(const std::vector<float>& gaps_mm, double place, double reach) {
  if (gaps_mm.empty()) return true;
  if (gaps_mm.size() == 1) return gaps_mm.front() <= kGel_mm;
  const double perPoint = 2.0 / static_cast<double>(gaps_mm.size() - 1);
  const auto first = static_cast<std::ptrdiff_t>(std::ceil((place - reach + 1.0) / perPoint - 1e-9));
  const auto last = static_cast<std::ptrdiff_t>(std::floor((place + reach + 1.0) / perPoint + 1e-9));
  for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(first, 0); n <= std::min(last, static_cast<std::ptrdiff_t>(gaps_mm.size()) - 1); ++n)
    if (gaps_mm[static_cast<std::size_t>(n)] <= kGel_mm) return true;
  return false;
}

/// Where on the face hearsAt may say yes; nothing: nowhere.
std::optional<detail::FacePart> heardPartOf(const std::vector<float>& gaps_mm, double reach) {
  constexpr double kRounding = 1e-6;
  if (gaps_mm.empty()) return detail::FacePart{-1.0 - kRounding, 1.0 + kRounding};
  const auto touches = [](float gap_mm) { return gap_mm <= kGel_mm; };
  const auto first = std::find_if(gaps_mm.begin(), gaps_mm.end(), touches);
  if (first == gaps_mm.end()) return std::nullopt;
  if (gaps_mm.size() == 1) return detail::FacePart{-1.0 - kRounding, 1.0 + kRounding};
  const auto last = std::find_if(gaps_mm.rbegin(), gaps_mm.rend(), touches).base() - 1;
  const double perPoint = 2.0 / static_cast<double>(gaps_mm.size() - 1);
  const auto placeOf = [&](auto point) { return static_cast<double>(point - gaps_mm.begin()) * perPoint - 1.0; };
  return detail::FacePart{std::max(-1.0, placeOf(first) - reach) - kRounding, std::min(1.0, placeOf(last) + reach) + kRounding};
}

}  // namespace

struct OrganCoverage::Frame {
  const Fan& fan;
  const std::vector<float>& gaps_mm;
  Transform<frame::Probe, frame::World> worldToProbe;
};

OrganCoverage::OrganCoverage(std::shared_ptr<const OrganVoxels> organ, const CoverageOptions& options)
    : organ_(std::move(organ)), contactReach_(options.contactReach) {
  EW_EXPECTS(organ_ != nullptr && options.thickness_mm > 0.0);
  // Thinner, a frame would pass between the centres of the voxels that it cuts.
  halfThickness_mm_ = 0.5 * std::max(options.thickness_mm, glm::length(organ_->grid().spacing_mm));
  left_.reserve(organ_->blocks().size());
  layersLeft_.reserve(organ_->blocks().size());
  clear();
}

void OrganCoverage::clear() {
  bits_.assign((organ_->count() + 63) / 64, 0);
  left_.clear();
  layersLeft_.clear();
  for (const OrganVoxels::BlockMask& mask : organ_->masks()) layersLeft_.push_back(mask.layers);
  for (const OrganVoxels::Block& block : organ_->blocks()) left_.push_back(static_cast<std::uint32_t>(block.end - block.first));
  passed_ = 0;
}

std::size_t OrganCoverage::add(const Fan& fan, const Pose& pose, const std::vector<float>& gaps_mm) {
  if (pose.status != PoseStatus::ok || passed_ == of()) return 0;
  const auto heard = heardPartOf(gaps_mm, contactReach_);
  if (!heard) return 0;
  const Frame frame{fan, gaps_mm, rigidInverse(pose.probeToWorld)};
  const detail::FanSlab slab(fan, frame.worldToProbe, *organ_, halfThickness_mm_, *heard);
  const double reach_mm = fan.depth_mm + fan.probe.radius_mm + fan.probe.width_mm;
  const std::size_t before = passed_;
  detail::FanSlab::Layers found;
  for (std::size_t b = 0; b < left_.size(); ++b) {
    if (left_[b] == 0) continue;
    const OrganVoxels::Block& block = organ_->blocks()[b];
    const glm::dvec3 middle = carried(frame.worldToProbe, block.middle_mm);
    if (std::abs(middle.z) > block.radius_mm + halfThickness_mm_ || glm::length(middle) > reach_mm + block.radius_mm) continue;
    if (!slab.reachesFan(middle, block.radius_mm)) continue;
    if (!slab.find(carried(frame.worldToProbe, organ_->masks()[b].corner_mm), layersLeft_[b], found)) continue;
    passThrough(b, found, frame);
  }
  return passed_ - before;
}

void OrganCoverage::passThrough(std::size_t b, const std::array<std::uint64_t, 8>& voxels, const Frame& frame) {
  const OrganVoxels::BlockMask& mask = organ_->masks()[b];
  for (std::size_t layer = 0; layer < voxels.size(); ++layer)
    for (std::uint64_t rest = voxels[layer]; rest != 0; rest &= rest - 1) {
      const std::uint64_t voxel = rest & (~rest + 1);
      const std::size_t n =
          organ_->blocks()[b].first + mask.before[layer] + static_cast<std::size_t>(std::popcount(mask.layers[layer] & (voxel - 1)));
      const glm::dvec3 p_probe = carried(frame.worldToProbe, glm::dvec3(organ_->centres_mm()[n]));
      if (std::abs(p_probe.z) > halfThickness_mm_) continue;
      const auto place = placeInFan(frame.fan, glm::dvec2(p_probe));
      if (!place || !hearsAt(frame.gaps_mm, *place, contactReach_)) continue;
      bits_[n / 64] |= std::uint64_t{1} << (n % 64);
      layersLeft_[b][layer] &= ~voxel;
      --left_[b];
      ++passed_;
    }
}

double OrganCoverage::share() const { return organ_->empty() ? 1.0 : static_cast<double>(passed_) / static_cast<double>(organ_->count()); }

}  // namespace ew
