#include "ew/core/beams.h"

namespace ew {

glm::dvec3 Beams::Fan::apexFor(const glm::dvec3& p_mm) const {
  const glm::dvec3 way = to_mm - from_mm;
  const double squared = glm::dot(way, way);
  return squared > 0.0 ? from_mm + glm::clamp(glm::dot(p_mm - from_mm, way) / squared, 0.0, 1.0) * way : from_mm;
}

glm::dvec3 Beams::at(const glm::dvec3& p_mm) const {
  if (fan) {
    const glm::dvec3 beam = p_mm - fan->apexFor(p_mm);
    if (const double length = glm::length(beam); length > 1e-6) return beam / length;
  }
  return glm::normalize(direction);
}

double Beams::depth_mm(const glm::dvec3& p_mm) const {
  return fan ? glm::distance(p_mm, fan->apexFor(p_mm)) : glm::dot(p_mm, glm::normalize(direction));
}

}  // namespace ew
