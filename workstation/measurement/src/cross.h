#pragma once

#include <glm/glm.hpp>

namespace ew::measurement {

/// The third component of a x b: twice the area of the triangle of both, > 0 when b lies from x towards y of a.
[[nodiscard]] inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace ew::measurement
