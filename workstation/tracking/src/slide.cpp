#include <algorithm>
#include <cmath>

#include "axes.h"
#include "ew/core/contract.h"
#include "ew/tracking/hand.h"

namespace ew {
namespace {

constexpr double kStep_mm = 1.0;  // well below the radius of any curve a probe's face can follow
constexpr double kLongest_mm = 2000.0;

/// Length of the way from a to b over the surface, taken as an arc whose ends have these normals: exact on spheres and across
/// cylinders, and at an edge at most pi/2 times the chord.
double arcBetween_mm(const Skin::Contact& a, const Skin::Contact& b) {
  const double chord_mm = glm::length(b.point_mm - a.point_mm);
  const double half_rad = std::asin(std::clamp(0.5 * glm::length(b.outward - a.outward), 0.0, 1.0));
  return half_rad < 1e-9 ? chord_mm : chord_mm * half_rad / std::sin(half_rad);
}

/// The contact about `step_mm` further along the unit tangent. Behind a sharp edge the nearest point of a tangent step is the edge
/// itself, over and over; then a step that also goes down (convex edge) or up (concave one) finds the next face.
Skin::Contact stepped(const Skin& skin, const Skin::Contact& at, const glm::dvec3& along, double step_mm) {
  const auto progress_mm = [&](const Skin::Contact& c) { return glm::length(c.point_mm - at.point_mm); };
  const auto acceptable = [&](const Skin::Contact& c) { return progress_mm(c) <= 3.0 * step_mm; };
  const glm::dvec3 ahead_mm = at.point_mm + step_mm * along;
  Skin::Contact best = skin.nearest(ahead_mm);
  if (!acceptable(best)) best = at;
  if (progress_mm(best) < 0.5 * step_mm) {
    for (const double side : {-1.0, 1.0}) {
      const Skin::Contact over = skin.nearest(ahead_mm + side * step_mm * at.outward);
      if (acceptable(over) && progress_mm(over) > progress_mm(best) + 1e-9) best = over;
    }
    return best;
  }
  double asked_mm = step_mm;
  for (int i = 0; i < 3; ++i) {
    const double gone_mm = arcBetween_mm(at, best);
    if (std::abs(gone_mm - step_mm) < 1e-10 * step_mm) break;
    asked_mm = std::clamp(asked_mm * step_mm / gone_mm, 0.5 * step_mm, 2.0 * step_mm);
    const Skin::Contact better = skin.nearest(at.point_mm + asked_mm * along);
    if (!acceptable(better)) break;
    best = better;
  }
  return best;
}

}  // namespace

Hold slid(const Hold& hold, const Skin& skin, double alongLateral_mm, double alongElevational_mm) {
  EW_EXPECTS(std::isfinite(alongLateral_mm) && std::isfinite(alongElevational_mm));
  double left_mm = std::min(std::hypot(alongLateral_mm, alongElevational_mm), kLongest_mm);
  if (left_mm <= 0.0) return hold;
  const glm::dmat4 upright = uprightPoseOf(hold).probeToWorld.matrix;
  glm::dvec3 along = glm::normalize(glm::dvec3(upright[0]) * alongLateral_mm + glm::dvec3(upright[2]) * alongElevational_mm);
  Hold moved = hold;
  while (left_mm > 1e-12) {
    const double step_mm = std::min(left_mm, kStep_mm);
    left_mm -= step_mm;
    const Skin::Contact next = stepped(skin, moved.contact, along, step_mm);
    if (next.point_mm == moved.contact.point_mm && next.outward == moved.contact.outward) break;
    along = tracking::carried(along, moved.contact.outward, next.outward);
    along = glm::normalize(along - glm::dot(along, next.outward) * next.outward);
    moved = movedTo(moved, next);
  }
  return moved;
}

}  // namespace ew
