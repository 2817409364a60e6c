#pragma once

#include <glm/glm.hpp>
#include <span>

namespace ew::labelling {

/// Even-odd rule: whether a point lies inside of a closed contour.
[[nodiscard]] bool isInside(std::span<const glm::dvec2> contour, const glm::dvec2& at);
[[nodiscard]] double toSegment_mm(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b);

}  // namespace ew::labelling
