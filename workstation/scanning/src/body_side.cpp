#include "ew/scanning/body_side.h"

#include <cmath>

namespace ew {

std::optional<BodySide> bodySideOf(const Pose& pose, double depth_mm, double near_mm) {
  if (pose.status != PoseStatus::ok) return std::nullopt;
  const double x_mm = (pose.probeToWorld * Point<frame::Probe>{{0.0, 0.5 * depth_mm, 0.0}}).at.x;
  if (!std::isfinite(x_mm) || std::abs(x_mm) <= near_mm) return std::nullopt;
  return x_mm < 0.0 ? BodySide::right : BodySide::left;
}

}  // namespace ew
