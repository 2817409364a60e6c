#pragma once

#include <glm/glm.hpp>

namespace ew {

enum class PaperSize { a4, letter };

/// Width and height upright, mm.
[[nodiscard]] inline glm::dvec2 sizeOf(PaperSize paper) {
  return paper == PaperSize::a4 ? glm::dvec2(210.0, 297.0) : glm::dvec2(215.9, 279.4);
}

inline constexpr double kPointsPerMm = 72.0 / 25.4;

}  // namespace ew
