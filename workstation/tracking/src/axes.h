#pragma once

#include <glm/glm.hpp>

namespace ew::tracking {

/// Lateral axis before rotation: the hint in the tangent plane of the unit vector `outward`, or a stated direction when the hint is
/// along the normal.
glm::dvec3 lateralOf(const glm::dvec3& outward, const glm::dvec3& hint);

/// `v` turned by the smallest rotation that takes the unit vector `from` to the unit vector `to`; about z when they are opposite and
/// not along z.
glm::dvec3 carried(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace ew::tracking
