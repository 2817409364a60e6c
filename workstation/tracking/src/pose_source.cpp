#include "ew/tracking/pose_source.h"

#include <algorithm>
#include <utility>

#include "ew/core/contract.h"

namespace ew {

PoseSource::~PoseSource() = default;

HandOnSkin::HandOnSkin() { hold_.contact = {{0.0, -105.0, 0.0}, {0.0, -1.0, 0.0}}; }

Pose HandOnSkin::poseAt(double /*time_s*/) const { return poseOf(hold_); }

bool HandOnSkin::movesAfter(double /*time_s*/) const { return false; }

PosePath::PosePath(std::vector<PoseSample> poses) : poses_(std::move(poses)) {
  EW_EXPECTS(!poses_.empty());
  EW_EXPECTS(std::is_sorted(poses_.begin(), poses_.end(), [](const PoseSample& a, const PoseSample& b) { return a.time_s < b.time_s; }));
}

Pose PosePath::poseAt(double time_s) const {
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), time_s, [](double time, const PoseSample& pose) { return time < pose.time_s; });
  return (after == poses_.begin() ? after : after - 1)->pose;
}

bool PosePath::movesAfter(double time_s) const { return time_s < poses_.back().time_s; }

}  // namespace ew
