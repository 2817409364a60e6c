#include "ew/assessment/organ_coverage.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

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

}  // namespace

OrganCoverage::OrganCoverage(std::shared_ptr<const OrganVoxels> organ, const CoverageOptions& options)
    : organ_(std::move(organ)), contactReach_(options.contactReach) {
  EW_EXPECTS(organ_ != nullptr && options.thickness_mm > 0.0);
  // Thinner, a frame would pass between the centres of the voxels that it cuts.
  halfThickness_mm_ = 0.5 * std::max(options.thickness_mm, glm::length(organ_->grid().spacing_mm));
  left_.reserve(organ_->blocks().size());
  clear();
}

void OrganCoverage::clear() {
  bits_.assign((organ_->count() + 63) / 64, 0);
  left_.clear();
  for (const OrganVoxels::Block& block : organ_->blocks()) left_.push_back(static_cast<std::uint32_t>(block.end - block.first));
  passed_ = 0;
}

std::size_t OrganCoverage::add(const Fan& fan, const Pose& pose, const std::vector<float>& gaps_mm) {
  if (pose.status != PoseStatus::ok) return 0;
  const auto worldToProbe = rigidInverse(pose.probeToWorld);
  const double reach_mm = fan.depth_mm + fan.probe.radius_mm + fan.probe.width_mm;
  const std::size_t before = passed_;
  for (std::size_t b = 0; b < left_.size(); ++b) {
    if (left_[b] == 0) continue;
    const OrganVoxels::Block& block = organ_->blocks()[b];
    const glm::dvec3 middle = carried(worldToProbe, block.middle_mm);
    if (std::abs(middle.z) > block.radius_mm + halfThickness_mm_ || glm::length(middle) > reach_mm + block.radius_mm) continue;
    for (std::size_t n = block.first; n < block.end; ++n) {
      if (isPassed(n)) continue;
      const glm::dvec3 p_probe = carried(worldToProbe, glm::dvec3(organ_->centres_mm()[n]));
      if (std::abs(p_probe.z) > halfThickness_mm_) continue;
      const auto place = placeInFan(fan, glm::dvec2(p_probe));
      if (!place || !hearsAt(gaps_mm, *place, contactReach_)) continue;
      bits_[n / 64] |= std::uint64_t{1} << (n % 64);
      --left_[b];
      ++passed_;
    }
  }
  return passed_ - before;
}

double OrganCoverage::share() const { return organ_->empty() ? 1.0 : static_cast<double>(passed_) / static_cast<double>(organ_->count()); }

}  // namespace ew
