#include "ew/tracking/hand.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "axes.h"
#include "ew/core/contract.h"

namespace ew {

Skin::~Skin() = default;

namespace tracking {

namespace {
/// Below this sine of the angle between hint and normal the projected hint is rounding noise.
constexpr double kAlongNormal = 1e-7;
}  // namespace

glm::dvec3 lateralOf(const glm::dvec3& outward, const glm::dvec3& hint) {
  const double length = glm::length(hint);
  EW_EXPECTS(length > 0.0);
  const glm::dvec3 tangential = hint - glm::dot(hint, outward) * outward;
  if (glm::length(tangential) > kAlongNormal * length) return glm::normalize(tangential);
  const glm::dvec3 around = glm::cross(outward, glm::dvec3(0.0, 0.0, 1.0));
  if (glm::length(around) > kAlongNormal) return glm::normalize(around);
  return {-1.0, 0.0, 0.0};
}

glm::dvec3 carried(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  // The usual closed form divides by 1 + cosine; near the opposite normal its axis is noise, and a person expects the probe to go
  // round the body, not over the head.
  if (cosine < -1.0 + 1e-9) {
    glm::dvec3 axis(0.0, 0.0, 1.0);
    axis -= glm::dot(axis, from) * from;
    if (glm::length(axis) < 1e-6) axis = glm::dvec3(0.0, 1.0, 0.0) - from.y * from;
    axis = glm::normalize(axis);
    return 2.0 * glm::dot(axis, v) * axis - v;
  }
  const glm::dvec3 axis = glm::cross(from, to);
  return v * cosine + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
}

}  // namespace tracking

namespace {

using tracking::carried;
using tracking::lateralOf;

struct Tip {
  double rock_rad = 0.0;
  double tilt_rad = 0.0;
};

/// The beam leaves the normal by acos(cos rock * cos tilt). Scaling both angles keeps the direction of the tip, and the limit is
/// reached without a jump.
Tip limited(Tip tip) {
  tip.rock_rad = std::clamp(tip.rock_rad, -kMaxTip_rad, kMaxTip_rad);
  tip.tilt_rad = std::clamp(tip.tilt_rad, -kMaxTip_rad, kMaxTip_rad);
  const double lowest = std::cos(kMaxTip_rad);
  const auto beam = [&](double scale) { return std::cos(scale * tip.rock_rad) * std::cos(scale * tip.tilt_rad); };
  // The slack keeps a tip that was limited once exactly as it is.
  if (beam(1.0) >= lowest - 1e-12) return tip;
  double inside = 0.0;
  double outside = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (inside + outside);
    (beam(middle) >= lowest ? inside : outside) = middle;
  }
  return {inside * tip.rock_rad, inside * tip.tilt_rad};
}

double wrapped(double angle_rad) { return std::remainder(angle_rad, glm::two_pi<double>()); }

/// Columns: lateral, into the body, elevational, before any angle.
glm::dmat3 baseAxes(const Skin::Contact& contact, const glm::dvec3& hint) {
  EW_EXPECTS(std::abs(glm::length(contact.outward) - 1.0) < 1e-6);
  const glm::dvec3 axial = -contact.outward;
  const glm::dvec3 lateral = lateralOf(contact.outward, hint);
  return {lateral, axial, glm::cross(lateral, axial)};
}

glm::dmat3 anglesMatrix(double rotation_rad, const Tip& tip) {
  const double cr = std::cos(rotation_rad);
  const double sr = std::sin(rotation_rad);
  const double ck = std::cos(tip.rock_rad);
  const double sk = std::sin(tip.rock_rad);
  const double ct = std::cos(tip.tilt_rad);
  const double st = std::sin(tip.tilt_rad);
  const glm::dmat3 aboutY(glm::dvec3(cr, 0.0, -sr), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(sr, 0.0, cr));
  const glm::dmat3 aboutX(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, ct, st), glm::dvec3(0.0, -st, ct));
  const glm::dmat3 aboutZ(glm::dvec3(ck, sk, 0.0), glm::dvec3(-sk, ck, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  return aboutY * aboutX * aboutZ;
}

Pose poseWith(const Hold& hold, const Tip& tip) {
  const glm::dmat3 axes = baseAxes(hold.contact, hold.lateralHint) * anglesMatrix(hold.rotation_rad, tip);
  Pose pose;
  for (int column = 0; column < 3; ++column) pose.probeToWorld.matrix[column] = glm::dvec4(axes[column], 0.0);
  EW_EXPECTS(std::isfinite(hold.press_mm));
  const double press_mm = std::clamp(hold.press_mm, 0.0, kMaxPress_mm);
  pose.probeToWorld.matrix[3] = glm::dvec4(hold.contact.point_mm - press_mm * hold.contact.outward, 1.0);
  return pose;
}

/// The contact whose normal passes through p. The nearest point alone is not it where the normals are smoothed: there the way back
/// from the point along its normal misses p by the press times the angle between the two normals.
Skin::Contact contactAbove(const Skin& skin, const glm::dvec3& p_mm) {
  constexpr int kRounds = 24;
  constexpr double kClose_mm = 1e-9;
  const auto missOf = [&](const Skin::Contact& c) {
    const glm::dvec3 below = p_mm - c.point_mm;
    return below - glm::dot(below, c.outward) * c.outward;
  };
  Skin::Contact best = skin.nearest(p_mm);
  // Above the skin the probe is put down at the nearest point, and from deep inside many normals meet.
  const double depth_mm = glm::dot(best.point_mm - p_mm, best.outward);
  if (depth_mm <= 0.0 || depth_mm > kMaxPress_mm) return best;
  glm::dvec3 miss_mm = missOf(best);
  glm::dvec3 asked_mm = best.point_mm;
  for (int round = 0; round < kRounds && glm::length(miss_mm) > kClose_mm; ++round) {
    asked_mm += miss_mm;
    const Skin::Contact next = skin.nearest(asked_mm);
    const glm::dvec3 nextMiss_mm = missOf(next);
    if (!(glm::length(nextMiss_mm) < glm::length(miss_mm))) break;
    best = next;
    miss_mm = nextMiss_mm;
  }
  return best;
}

}  // namespace

Pose poseOf(const Hold& hold) { return poseWith(hold, limited({hold.rock_rad, hold.tilt_rad})); }

Pose uprightPoseOf(const Hold& hold) { return poseWith(hold, {}); }

Hold movedTo(const Hold& hold, const Skin::Contact& contact) {
  Hold moved = hold;
  moved.lateralHint = carried(lateralOf(hold.contact.outward, hold.lateralHint), hold.contact.outward, contact.outward);
  moved.contact = contact;
  return moved;
}

Hold turned(const Hold& hold, double byRotation_rad, double byRock_rad, double byTilt_rad) {
  EW_EXPECTS(std::isfinite(byRotation_rad) && std::isfinite(byRock_rad) && std::isfinite(byTilt_rad));
  Hold result = hold;
  result.rotation_rad = wrapped(hold.rotation_rad + byRotation_rad);
  const Tip tip = limited({hold.rock_rad + byRock_rad, hold.tilt_rad + byTilt_rad});
  result.rock_rad = tip.rock_rad;
  result.tilt_rad = tip.tilt_rad;
  return result;
}

Hold holdFor(const Pose& pose, const Skin& skin) {
  EW_EXPECTS(pose.status == PoseStatus::ok && checkRigid(pose.probeToWorld.matrix).has_value());
  Hold hold;
  const glm::dvec3 origin_mm(pose.probeToWorld.matrix[3]);
  hold.contact = contactAbove(skin, origin_mm);
  hold.press_mm = std::clamp(glm::dot(hold.contact.point_mm - origin_mm, hold.contact.outward), 0.0, kMaxPress_mm);
  // Within about 6 degrees of the normal the patient's right is a poor hint: a little slide would turn the stated rotation a lot.
  if (std::abs(hold.contact.outward.x) > 0.995) hold.lateralHint = {0.0, 1.0, 0.0};
  // Entries of Ry(rotation) Rx(tilt) Rz(rock) that hold one angle each.
  const glm::dmat3 angles = glm::transpose(baseAxes(hold.contact, hold.lateralHint)) * glm::dmat3(pose.probeToWorld.matrix);
  Tip tip;
  tip.tilt_rad = std::asin(std::clamp(-angles[2].y, -1.0, 1.0));
  if (std::abs(angles[2].y) < 1.0 - 1e-12) {
    hold.rotation_rad = std::atan2(angles[2].x, angles[2].z);
    tip.rock_rad = std::atan2(angles[0].y, angles[1].y);
  } else {
    // The elevational axis is along the normal, so rotation and rock turn about the same line: all of it is called rotation.
    hold.rotation_rad = std::atan2(-angles[0].z, angles[0].x);
  }
  tip = limited(tip);
  hold.rock_rad = tip.rock_rad;
  hold.tilt_rad = tip.tilt_rad;
  return hold;
}

}  // namespace ew
