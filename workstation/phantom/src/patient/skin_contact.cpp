#include "patient/skin_contact.h"

#include <algorithm>
#include <cmath>

namespace ew::phantom {

glm::dvec3 skinNormal(const Shape& skin, const glm::dvec3& p_mm, double patch_mm) {
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = patch_mm;
    gradient[axis] = skin.distance_mm(p_mm + step) - skin.distance_mm(p_mm - step);
  }
  const double length = glm::length(gradient);
  return length > 0.0 ? gradient / length : glm::dvec3(0.0, -1.0, 0.0);
}

std::optional<glm::dvec3> skinPointNear(const Shape& skin, const glm::dvec3& near_mm) {
  constexpr double kClose_mm = 1e-3;
  glm::dvec3 at = near_mm;
  for (int step = 0; step < 100; ++step) {
    const double away_mm = skin.distance_mm(at);
    if (!std::isfinite(away_mm)) return std::nullopt;
    if (std::abs(away_mm) < kClose_mm) break;
    // Far off the distance is an estimate only: steps are bounded.
    at -= std::clamp(away_mm, -10.0, 10.0) * skinNormal(skin, at, 0.5);
  }
  const bool settled = std::abs(skin.distance_mm(at)) < kClose_mm && glm::distance(at, near_mm) <= kFarthestFromSkin_mm;
  return settled ? std::optional(at) : std::nullopt;
}

std::optional<double> drawnBack_mm(const Shape& skin, const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld,
                                   double most_mm) {
  constexpr double kClose_mm = 1e-3;
  constexpr int kPoints = 33;
  const auto face_probe_mm = facePoints_mm(probe, kPoints);
  const glm::dvec3 beam(probeToWorld.matrix[1]);
  double back_mm = 0.0;
  for (int step = 0; step < 200 && back_mm <= most_mm; ++step) {
    double deepest_mm = -1e9;
    for (const glm::dvec3& point : face_probe_mm)
      deepest_mm = std::max(deepest_mm, -skin.distance_mm((probeToWorld * Point<frame::Probe>{point}).at - back_mm * beam));
    if (deepest_mm < kClose_mm) return back_mm;
    back_mm += deepest_mm;
  }
  return std::nullopt;
}

std::vector<double> gapsToSkin_mm(const Shape& skin, const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld,
                                  int count, double most_mm) {
  constexpr double kClose_mm = 1e-3;
  constexpr double kReserve = 0.6;  // a first-order distance may be longer than the true one
  const glm::dvec3 beam(probeToWorld.matrix[1]);
  std::vector<double> gaps;
  for (const glm::dvec3& point : facePoints_mm(probe, count)) {
    const glm::dvec3 from = (probeToWorld * Point<frame::Probe>{point}).at;
    double gap_mm = 0.0;
    for (int step = 0; step < 200 && gap_mm < most_mm; ++step) {
      const double away_mm = skin.distance_mm(from + gap_mm * beam);
      if (away_mm < kClose_mm) break;
      gap_mm += kReserve * away_mm;
    }
    gaps.push_back(std::min(gap_mm, most_mm));
  }
  return gaps;
}

}  // namespace ew::phantom
