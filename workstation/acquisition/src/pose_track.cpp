#include "pose_track.h"

#include <algorithm>

#include "body_signal.h"

namespace ew {

PoseTrack::PoseTrack(std::span<const double> time_s, const FramePoses& poses, const glm::dvec2& centre, double longestGap_s)
    : centre_(centre, 0.0) {
  for (std::size_t n = 0; n < time_s.size(); ++n) {
    if (!time_s_.empty() && time_s[n] <= time_s_.back()) continue;
    time_s_.push_back(time_s[n]);
    poses_.push_back(poses[n]);
  }
  turns_.resize(poses_.size());
  for (std::size_t n = 0; n + 1 < poses_.size(); ++n) {
    if (!poses_[n] || !poses_[n + 1] || time_s_[n + 1] - time_s_[n] > longestGap_s) continue;
    const glm::dmat4 step = poses_[n + 1]->matrix * glm::inverse(poses_[n]->matrix);
    // Between poses of different calibrations there is no rigid way.
    if (checkRigid(step)) turns_[n] = glm::normalize(glm::quat_cast(glm::dmat3(step)));
  }
}

std::optional<Transform<frame::World, frame::Image>> PoseTrack::at(double t_s) const {
  const auto after = std::upper_bound(time_s_.begin(), time_s_.end(), t_s);
  if (after == time_s_.begin()) return std::nullopt;
  const auto n = static_cast<std::size_t>(after - time_s_.begin()) - 1;
  if (t_s == time_s_[n]) return poses_[n];
  if (n + 1 >= poses_.size() || !turns_[n]) return std::nullopt;
  const double share = (t_s - time_s_[n]) / (time_s_[n + 1] - time_s_[n]);
  const glm::dmat3 turned = glm::mat3_cast(glm::slerp(glm::dquat(1.0, 0.0, 0.0, 0.0), *turns_[n], share)) * glm::dmat3(poses_[n]->matrix);
  const glm::dvec3 from_mm = (*poses_[n] * Point<frame::Image>{centre_}).at, to_mm = (*poses_[n + 1] * Point<frame::Image>{centre_}).at;
  glm::dmat4 matrix(turned);
  matrix[3] = glm::dvec4(glm::mix(from_mm, to_mm, share) - turned * centre_, 1.0);
  return Transform<frame::World, frame::Image>{matrix};
}

double longestGapOf(double asked_s, std::span<const double> time_s) {
  if (asked_s > 0.0) return asked_s;
  std::vector<double> steps_s;
  for (std::size_t n = 1; n < time_s.size(); ++n)
    if (time_s[n] > time_s[n - 1]) steps_s.push_back(time_s[n] - time_s[n - 1]);
  return 3.0 * medianOrZero(std::move(steps_s));
}

}  // namespace ew
