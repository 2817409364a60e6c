#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace ew {

/// All that lies within a distance of a straight piece of a line, which may be a point.
struct Capsule {
  glm::dvec3 from_mm{0.0};
  glm::dvec3 to_mm{0.0};
  double radius_mm = 0.0;
  bool operator==(const Capsule&) const = default;
};

/// From a point to the capsule's line, mm; within it where that is at most its radius.
[[nodiscard]] inline double distanceToLine_mm(const Capsule& capsule, const glm::dvec3& p_mm) {
  const glm::dvec3 along = capsule.to_mm - capsule.from_mm, from = p_mm - capsule.from_mm;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(from, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(from - t * along);
}

}  // namespace ew
