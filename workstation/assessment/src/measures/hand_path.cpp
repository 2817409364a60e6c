#include "ew/assessment/hand_path.h"

#include <algorithm>
#include <cmath>

#include "ew/scanning/contact.h"

namespace ew {
namespace {

constexpr int kWayPoints = 96;           // of a way between two holds, before it is walked evenly
constexpr double kFarthestJump_mm = 25;  // between two of them: more, and the nearest skin has changed sides

glm::dquat attitudeOf(const Pose& pose) { return glm::normalize(glm::quat_cast(glm::dmat3(pose.probeToWorld.matrix))); }

}  // namespace

Hold pressedOn(const Pose& plane, const Skin& skin, const Probe& probe) {
  Hold hold = holdFor(plane, skin);
  hold.press_mm = std::max(hold.press_mm, usualPress_mm(probe));
  const glm::dmat4& wanted = plane.probeToWorld.matrix;
  const glm::dvec3 away_mm(wanted[3] - poseOf(hold).probeToWorld.matrix[3]);
  const glm::dmat4 upright = uprightPoseOf(hold).probeToWorld.matrix;
  const glm::dvec3 across_mm = away_mm - glm::dot(away_mm, glm::dvec3(wanted[1])) * glm::dvec3(wanted[1]);
  return slid(hold, skin, glm::dot(across_mm, glm::dvec3(upright[0])), glm::dot(across_mm, glm::dvec3(upright[2])));
}

std::optional<HandPath> HandPath::between(const Hold& from, const Hold& to, const Skin& skin) {
  HandPath path;
  Hold carried = from;
  carried.rotation_rad = carried.rock_rad = carried.tilt_rad = 0.0;
  for (int n = 0; n <= kWayPoints; ++n) {
    const double share = static_cast<double>(n) / kWayPoints;
    const Skin::Contact contact = n == 0            ? from.contact
                                  : n == kWayPoints ? to.contact
                                                    : skin.nearest(glm::mix(from.contact.point_mm, to.contact.point_mm, share));
    const double step_mm = glm::distance(contact.point_mm, carried.contact.point_mm);
    if (step_mm > kFarthestJump_mm) return std::nullopt;
    carried = movedTo(carried, contact);
    path.length_mm_.push_back(n == 0 ? 0.0 : path.length_mm_.back() + step_mm);
    path.holds_.push_back(carried);
  }
  path.press_mm_ = {from.press_mm, to.press_mm};
  path.turn_ = {glm::inverse(attitudeOf(poseOf(path.holds_.front()))) * attitudeOf(poseOf(from)),
                glm::inverse(attitudeOf(poseOf(path.holds_.back()))) * attitudeOf(poseOf(to))};
  return path;
}

Pose HandPath::at(double share, const Skin& skin) const {
  const double wanted_mm = share * length_mm_.back();
  const auto next =
      std::clamp<std::ptrdiff_t>(std::upper_bound(length_mm_.begin(), length_mm_.end(), wanted_mm) - length_mm_.begin(), 1, kWayPoints);
  const auto before = static_cast<std::size_t>(next - 1);
  const double step_mm = length_mm_[before + 1] - length_mm_[before];
  const double within = step_mm > 0.0 ? std::clamp((wanted_mm - length_mm_[before]) / step_mm, 0.0, 1.0) : 0.0;
  Hold here = holds_[before];
  if (within > 0.0) here = movedTo(here, skin.nearest(glm::mix(here.contact.point_mm, holds_[before + 1].contact.point_mm, within)));
  here.press_mm = glm::mix(press_mm_[0], press_mm_[1], share);
  Pose pose = poseOf(here);
  const glm::dmat3 turn = glm::mat3_cast(glm::normalize(attitudeOf(pose) * glm::slerp(turn_[0], turn_[1], share)));
  for (int column = 0; column < 3; ++column) pose.probeToWorld.matrix[column] = glm::dvec4(turn[column], 0.0);
  return pose;
}

glm::dvec3 HandPath::turn_rad() const {
  glm::dquat turn = glm::inverse(turn_[0]) * turn_[1];
  if (turn.w < 0.0) turn = -turn;
  const glm::dvec3 axis(turn.x, turn.y, turn.z);
  const double sine = glm::length(axis);
  return sine > 0.0 ? 2.0 * std::atan2(sine, turn.w) / sine * axis : glm::dvec3(0.0);
}

std::vector<float> shortened(std::vector<float> gaps_mm) {
  for (float& gap_mm : gaps_mm) gap_mm = std::round(16.0F * gap_mm) / 16.0F;
  return gaps_mm;
}

}  // namespace ew
