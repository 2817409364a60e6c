#include "ew/imaging/adaptive_quality.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

constexpr int kFewestPlanes = 3;

/// Steps down from `asked` to the least work.
int lowestLevel(const Knobs& asked, bool hasPlanes) {
  const int quality = asked.quality == Quality::cubic ? 2 : asked.quality == Quality::linear ? 1 : 0;
  return quality + (hasPlanes ? std::max(0, (asked.elevationPlanes - kFewestPlanes + 1) / 2) : 0);
}

Knobs lowered(Knobs knobs, int level, bool hasPlanes) {
  for (; level > 0; --level) {
    if (knobs.quality == Quality::cubic)
      knobs.quality = Quality::linear;
    else if (hasPlanes && knobs.elevationPlanes > kFewestPlanes)
      knobs.elevationPlanes = std::max(kFewestPlanes, knobs.elevationPlanes - 2);
    else
      knobs.quality = Quality::weave;
  }
  return knobs;
}

bool isUsable(const Pose& pose) {
  if (pose.status != PoseStatus::ok) return false;
  double sum = 0.0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) sum += pose.probeToWorld.matrix[column][row];
  return std::isfinite(sum);
}

/// Angle between two rotations: the Frobenius norm of their difference is 2 sqrt(2) sin(angle / 2). The quaternion's two signs never come
/// in, and half a turn is as good as any other.
double angleBetween_rad(const glm::dmat4& a, const glm::dmat4& b) {
  double squares = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) squares += (a[column][row] - b[column][row]) * (a[column][row] - b[column][row]);
  return 2.0 * std::asin(std::min(1.0, std::sqrt(squares / 8.0)));
}

}  // namespace

AdaptiveQuality::Speed AdaptiveQuality::speedTo(const Pose& pose, double time_s) {
  if (!isUsable(pose)) return Speed::resting;
  const double passed_s = time_s - lastPose_s_;
  const bool hasSpeed = hasLast_ && passed_s > 0.0;
  const double distance_mm = glm::length(glm::dvec3(pose.probeToWorld.matrix[3]) - glm::dvec3(last_.probeToWorld.matrix[3]));
  const double angle_rad = angleBetween_rad(pose.probeToWorld.matrix, last_.probeToWorld.matrix);
  hasLast_ = true;
  last_ = pose;
  lastPose_s_ = time_s;
  if (!hasSpeed) return Speed::resting;
  const double ofFast = std::max(distance_mm / passed_s / options_.fast_mmPerS, angle_rad / passed_s / options_.fast_radPerS);
  return ofFast > 1.0 ? Speed::fast : ofFast > 0.5 ? Speed::slowing : Speed::resting;
}

Knobs AdaptiveQuality::step(const Knobs& asked, const Pose& pose, double time_s, double lastFrame_ms, bool hasPlanes) {
  const int lowest = lowestLevel(asked, hasPlanes);
  if (std::isfinite(time_s)) {
    const double passed_s = hasLast_ ? std::max(0.0, time_s - lastTime_s_) : 0.0;
    const Speed speed = speedTo(pose, time_s);
    lastTime_s_ = time_s;
    rest_s_ = speed == Speed::resting ? rest_s_ + passed_s : 0.0;
    if (speed == Speed::fast) moving_ = true;
    if (rest_s_ >= options_.settle_s) moving_ = false;
  }
  if (!moving_)
    level_ = 0;
  else if (lastFrame_ms > options_.budget_ms)
    level_ += lastFrame_ms > 2.0 * options_.budget_ms ? 2 : 1;
  level_ = std::min(level_, lowest);
  return lowered(asked, level_, hasPlanes);
}

}  // namespace ew
