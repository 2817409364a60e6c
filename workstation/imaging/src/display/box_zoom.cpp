#include "ew/imaging/box_zoom.h"

#include <algorithm>
#include <cmath>

#include "ew/core/contract.h"

namespace ew {
namespace {

glm::dvec2 pointOf(const DisplayGeometry& shown, glm::dvec2 at_px) {
  const glm::dvec2 from_mm = (at_px - shown.face_px) * shown.pixel_mm;
  return {shown.markerLeft ? -from_mm.x : from_mm.x, shown.upsideDown ? -from_mm.y : from_mm.y};
}

}  // namespace

Detail detailAround(const DisplayGeometry& shown, const Detail& as, glm::dvec2 p_mm) {
  const glm::dvec2 by_mm = p_mm - pointOf(shown, 0.5 * glm::dvec2(shown.width - 1, shown.height - 1));
  return {as.zoom, {as.pan.lateral_mm + by_mm.x, as.pan.axial_mm + by_mm.y}};
}

Detail detailOfBox(const DisplayGeometry& shown, const Detail& as, glm::dvec2 a_px, glm::dvec2 b_px) {
  const glm::dvec2 size_px = glm::abs(b_px - a_px);
  EW_EXPECTS(size_px.x > 0.0 && size_px.y > 0.0);
  Detail detail = detailAround(shown, as, pointOf(shown, 0.5 * (a_px + b_px)));
  const double magnified = std::min(shown.width / size_px.x, shown.height / size_px.y);
  detail.zoom = std::clamp(as.zoom * magnified, as.zoom, std::max(as.zoom, kLargestZoom));
  return detail;
}

}  // namespace ew
