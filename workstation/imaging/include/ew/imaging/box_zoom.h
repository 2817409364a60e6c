#pragma once

#include <glm/glm.hpp>

#include "ew/imaging/display.h"

namespace ew {

inline constexpr double kLargestZoom = 8.0;

/// How large an image is shown, and which part.
struct Detail {
  double zoom = 1.0;
  Pan pan;
  bool operator==(const Detail&) const = default;
};

/// The zoom and the part at which an image of the same size just shows all of a box, in the middle; not larger than kLargestZoom, and
/// never smaller than it is.
/// @param shown the image in which the box was drawn
/// @param as    how it is shown, with the pan that acts (panWithinFan)
/// @param a_px, b_px opposite corners of the box, pixels of the image; expects them apart in both directions
[[nodiscard]] Detail detailOfBox(const DisplayGeometry& shown, const Detail& as, glm::dvec2 a_px, glm::dvec2 b_px);

/// The same zoom, and the part whose middle lies at a point of the image plane.
[[nodiscard]] Detail detailAround(const DisplayGeometry& shown, const Detail& as, glm::dvec2 p_mm);

}  // namespace ew
