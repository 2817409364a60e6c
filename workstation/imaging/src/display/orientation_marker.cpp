#include "ew/imaging/orientation_marker.h"

#include <algorithm>
namespace ew {
namespace {

constexpr double kAway_px = 12.0, kMarkerRadius_px = 5.0, kMarkerRim_px = 2.0;

template <class Pixel>
void burnDot(ImageView<Pixel> image, const glm::dvec2& centre_px) {
  const double outer_px = kMarkerRadius_px + kMarkerRim_px;
  for (int y = std::max(0, static_cast<int>(centre_px.y - outer_px));
       y < std::min(image.height, static_cast<int>(centre_px.y + outer_px) + 2); ++y)
    for (int x = std::max(0, static_cast<int>(centre_px.x - outer_px));
         x < std::min(image.width, static_cast<int>(centre_px.x + outer_px) + 2); ++x) {
      const double away_px = glm::distance(glm::dvec2(x, y), centre_px);
      if (away_px <= kMarkerRadius_px)
        image.at(x, y) = Pixel(std::uint8_t{255});
      else if (away_px <= outer_px)
        image.at(x, y) = Pixel(std::uint8_t{0});
    }
}

}  // namespace

glm::dvec2 markerPlace_px(const Probe& probe, const DisplayGeometry& geometry, double away_px, double margin_px) {
  const double side = geometry.markerLeft ? -1.0 : 1.0, down = geometry.upsideDown ? -1.0 : 1.0;
  const double x = geometry.face_px.x + side * faceHalfWidth_mm(probe) / geometry.pixel_mm;
  const double y = geometry.face_px.y - down * (faceSagitta_mm(probe) / geometry.pixel_mm + away_px);
  return {std::clamp(x, margin_px, std::max(margin_px, geometry.width - 1.0 - margin_px)),
          std::clamp(y, margin_px, std::max(margin_px, geometry.height - 1.0 - margin_px))};
}

void burnMarker(ImageView<std::uint8_t> image, const Probe& probe, const DisplayGeometry& geometry) {
  burnDot(image, markerPlace_px(probe, geometry, kAway_px, kMarkerRadius_px + kMarkerRim_px));
}

void burnMarker(ImageView<Rgb> image, const Probe& probe, const DisplayGeometry& geometry) {
  burnDot(image, markerPlace_px(probe, geometry, kAway_px, kMarkerRadius_px + kMarkerRim_px));
}

}  // namespace ew
