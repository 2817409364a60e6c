#include "ew/measurement/snap_target.h"

#include <cmath>
#include <optional>

#include "ew/measurement/tracing.h"

namespace ew::measurement {
namespace {

constexpr double kAligned = 0.4;  // of the reach: how far off a level or a plumb line

std::optional<SnapTarget> crossNear(glm::dvec2 at, const Measurements& shown, const SnapSearch& search) {
  std::optional<SnapTarget> nearest;
  double least_mm = search.reach_mm;
  for (const Measurement& each : shown.all) {
    if (each.number == search.except) continue;
    for (const CaliperPart& part : each.caliper.parts) {
      if (part.image != search.image) continue;
      for (const glm::dvec2& point : part.points) {
        const double apart_mm = glm::length(search.scale * (point - at));
        if (apart_mm > least_mm) continue;
        least_mm = apart_mm;
        nearest = SnapTarget{SnapKind::point, point, each.number};
      }
    }
  }
  return nearest;
}

/// @param direction in the plane, any length above 0
std::optional<SnapTarget> edgeNear(glm::dvec2 at, glm::dvec2 direction, const SnapSearch& search, ImageView<const std::uint8_t> image,
                                   const DisplayGeometry& geometry) {
  SnapOptions options;  // closer than an outline looks: the pointer is there already
  options.reach_mm = search.reach_mm;
  options.blur_mm = 0.5;
  options.across_mm = 1.0;
  options.weakest = 10.0;
  const glm::dvec2 side(geometry.markerLeft ? -1.0 : 1.0, geometry.upsideDown ? -1.0 : 1.0);
  const ImageGeometry pixels{glm::dvec2(geometry.pixel_mm), -geometry.face_px * geometry.pixel_mm};
  const Snapped snapped = snapToEdge(image, pixels, side * at, side * direction, options);
  if (!snapped.isFound) return std::nullopt;
  return SnapTarget{SnapKind::edge, side * snapped.at_mm, 0};
}

}  // namespace

SnapTarget snapTarget(glm::dvec2 at, const Measurements& shown, std::span<const glm::dvec2> before, const SnapSearch& search,
                      ImageView<const std::uint8_t> image, const DisplayGeometry& geometry) {
  if (const auto cross = crossNear(at, shown, search)) return *cross;
  const glm::dvec2 line = before.empty() ? glm::dvec2(std::sin(search.beam_rad), std::cos(search.beam_rad)) : at - before.back();
  const glm::dvec2 off_mm = glm::abs(search.scale * (before.empty() ? glm::dvec2(0.0) : line));
  const bool isFar = off_mm.x + off_mm.y > 2.0 * search.reach_mm;
  if (image.width > 1 && image.height > 1 && geometry.pixel_mm > 0.0 && (before.empty() || isFar))
    if (const auto edge = edgeNear(at, line, search, image, geometry)) return *edge;
  if (before.empty() || !isFar) return {SnapKind::none, at, 0};
  if (off_mm.y <= kAligned * search.reach_mm) return {SnapKind::horizontal, {at.x, before.back().y}, 0};
  if (off_mm.x <= kAligned * search.reach_mm) return {SnapKind::vertical, {before.back().x, at.y}, 0};
  return {SnapKind::none, at, 0};
}

}  // namespace ew::measurement
