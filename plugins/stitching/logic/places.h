#pragma once

#include <glm/glm.hpp>

namespace ew::stitching {

/// Inverse of a rotation and a translation, exact in the rotation.
[[nodiscard]] inline glm::dmat4 rigidInverse(const glm::dmat4& rigid) {
  const glm::dmat3 back = glm::transpose(glm::dmat3(rigid));
  glm::dmat4 inverse(back);
  inverse[3] = glm::dvec4(-(back * glm::dvec3(rigid[3])), 1.0);
  return inverse;
}

}  // namespace ew::stitching
