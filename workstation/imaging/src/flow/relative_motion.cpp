#include "flow/relative_motion.h"

#include <algorithm>

namespace ew::detail {
namespace {

constexpr double kLongestAgo_s = 0.5;  // a frame before that long ago says nothing of how fast the probe moves
constexpr double kShortestAgo_s = 0.005;

}  // namespace

void RelativeMotion::take(const FrameInput& input, const Scene& scene, const EchoMotion* motion, const FrameBefore& before,
                          const Transform<frame::Probe, frame::World>& ownToProbe) {
  const double ago_s = input.time_s - before.time_s;
  const bool knowsBefore = before.isKnown && ago_s > 0.0 && ago_s < kLongestAgo_s;
  motion_ = motion != nullptr && motion->moves() ? motion : nullptr;
  body_.rest();
  bodyBefore_.rest();
  bodyMoves_ = knowsBefore && motion != nullptr && input.motion != nullptr && scene.motion && !(before.body == input.body);
  if (bodyMoves_) {
    body_.take(*input.motion, input.body, scene.motion->strength, ownToProbe);
    bodyBefore_.take(*input.motion, before.body, scene.motion->strength, ownToProbe);
  }
  toBefore_ = knowsBefore ? (inverse(before.pose.probeToWorld) * input.pose.probeToWorld).matrix : glm::dmat4(1.0);
  probeMoves_ = knowsBefore && before.pose.probeToWorld.matrix != input.pose.probeToWorld.matrix;
  moves_ = motion_ != nullptr || bodyMoves_ || probeMoves_;
  perS_ = static_cast<float>(1.0 / std::max(ago_s, kShortestAgo_s));
}

RelativeMotion::At RelativeMotion::at(const glm::dvec3& now_mm, const glm::vec3& guess) const {
  At found;
  if (!moves_) return found;
  if (motion_ != nullptr) found.back_mm = motion_->backAt(glm::vec3(now_mm), guess);
  const glm::vec3 rest_mm = glm::vec3(now_mm) + found.back_mm;
  glm::vec3 gone_mm(0.0F);
  if (bodyMoves_) gone_mm = body_.shiftAt(rest_mm) - bodyBefore_.shiftAt(rest_mm);
  // A place that stands still in the world was elsewhere before the face.
  if (probeMoves_) gone_mm += glm::vec3(now_mm - glm::dvec3(toBefore_ * glm::dvec4(now_mm, 1.0)));
  found.velocity_mmPerS = gone_mm * perS_;
  return found;
}

}  // namespace ew::detail
