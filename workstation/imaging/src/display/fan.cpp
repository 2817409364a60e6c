#include <algorithm>
#include <cmath>

#include "ew/imaging/display.h"

#include "../probes/fan_shape.h"
#include "ew/core/contract.h"

namespace ew {
namespace {

/// Pixels x of a row of `width` whose centres lie in [low, high], lengths in mm from column `middle_px`.
RowSpan pixelsBetween(double low_mm, double high_mm, double middle_px, double pixel_mm, int width) {
  const auto nearest = [&](double at_mm) { return std::clamp(std::round(middle_px + at_mm / pixel_mm), -1.0, static_cast<double>(width)); };
  // The nearest pixels are only a guess: what counts is the comparison, which mirrored pixels pass or fail together.
  const auto at_mm = [&](int x) { return (x - middle_px) * pixel_mm; };
  int begin = static_cast<int>(nearest(low_mm));
  while (begin > 0 && at_mm(begin - 1) >= low_mm) --begin;
  while (begin < width && (begin < 0 || at_mm(begin) < low_mm)) ++begin;
  int end = std::max(begin, static_cast<int>(nearest(high_mm)));
  while (end < width && at_mm(end) <= high_mm) ++end;
  while (end > begin && at_mm(end - 1) > high_mm) --end;
  return {begin, end};
}

}  // namespace

Transform<frame::Probe, frame::Image> DisplayGeometry::imageToProbe() const {
  Transform<frame::Probe, frame::Image> result;
  const double lateral_mm = markerLeft ? -pixel_mm : pixel_mm;
  const double axial_mm = upsideDown ? -pixel_mm : pixel_mm;
  result.matrix[0][0] = lateral_mm;
  result.matrix[1][1] = axial_mm;
  result.matrix[2][2] = pixel_mm;
  result.matrix[3][0] = -face_px.x * lateral_mm;
  result.matrix[3][1] = -face_px.y * axial_mm;
  return result;
}

glm::dvec2 DisplayGeometry::probePoint_mm(int x_px, int y_px) const {
  const double x_mm = (x_px - face_px.x) * pixel_mm;
  const double y_mm = (y_px - face_px.y) * pixel_mm;
  return {markerLeft ? -x_mm : x_mm, upsideDown ? -y_mm : y_mm};
}

double resolvedDepth_mm(const Probe& probe, const Knobs& knobs) {
  if (!(knobs.depth_mm > 0.0)) return probe.defaultDepth_mm;
  return std::clamp(knobs.depth_mm, probe.minDepth_mm, probe.maxDepth_mm);
}

namespace {

double zoomOf(const Knobs& knobs) { return knobs.zoom > 1.0 ? std::min(knobs.zoom, 8.0) : 1.0; }  // NaN compares false

}  // namespace

Pan panWithinFan(const Probe& probe, const Knobs& knobs, const Pan& pan) {
  const detail::FanShape::Box box = detail::fanShapeOf(probe, knobs).box(resolvedDepth_mm(probe, knobs));
  const double free = 1.0 - 1.0 / zoomOf(knobs);
  const auto within = [](double asked_mm, double most_mm) {
    return std::isfinite(asked_mm) ? std::clamp(asked_mm, -most_mm, most_mm) : 0.0;
  };
  return {within(pan.lateral_mm, free * box.halfWidth_mm), within(pan.axial_mm, free * 0.5 * (box.bottom_mm - box.top_mm))};
}

DisplayGeometry fitDisplay(const Probe& probe, const Knobs& knobs, int width, int height, const Pan& pan) {
  EW_EXPECTS(width >= 1 && height >= 1);
  constexpr double kMargin = 0.02;  // of the image, on each side
  constexpr double kPixelSteps_perMm = 4294967296.0;
  DisplayGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  geometry.markerLeft = knobs.markerLeft;
  geometry.upsideDown = knobs.upsideDown;
  geometry.depth_mm = resolvedDepth_mm(probe, knobs);
  const detail::FanShape::Box box = detail::fanShapeOf(probe, knobs).box(geometry.depth_mm);
  const double usable = 1.0 - 2.0 * kMargin;
  geometry.pixel_mm = std::max(2.0 * box.halfWidth_mm / (usable * static_cast<double>(width)),
                               (box.bottom_mm - box.top_mm) / (usable * static_cast<double>(height)));
  const double zoom = zoomOf(knobs);
  // Of few binary digits, so that products with columns are exact and imageToProbe sends mirrored columns to mirrored places.
  geometry.pixel_mm = std::ceil(geometry.pixel_mm / zoom * kPixelSteps_perMm) / kPixelSteps_perMm;
  // The middle of the fan's box stays in the middle of the image at every zoom, but for what it is panned by: sideways in whole pixels,
  // for the same exactness.
  const Pan shown = panWithinFan(probe, knobs, pan);
  const double across = geometry.markerLeft ? -1.0 : 1.0;
  geometry.face_px.x = 0.5 * static_cast<double>(width - 1) - across * std::round(shown.lateral_mm / geometry.pixel_mm);
  const double middle_px = (0.5 * (box.top_mm + box.bottom_mm) + shown.axial_mm) / geometry.pixel_mm;
  geometry.face_px.y = 0.5 * static_cast<double>(height - 1) + (geometry.upsideDown ? middle_px : -middle_px);
  return geometry;
}

Spans fanSpans(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry) {
  const detail::FanShape fan = detail::fanShapeOf(probe, knobs);
  Spans spans(static_cast<std::size_t>(geometry.height));
  for (int y = 0; y < geometry.height; ++y) {
    const detail::FanShape::Row place = fan.rowAt(geometry.probePoint_mm(0, y).y, geometry.depth_mm);
    if (place.low_mm > place.high_mm) continue;
    const double low_mm = geometry.markerLeft ? -place.high_mm : place.low_mm;
    const double high_mm = geometry.markerLeft ? -place.low_mm : place.high_mm;
    auto& row = spans[static_cast<std::size_t>(y)];
    const auto between = [&](double from_mm, double to_mm) {
      return pixelsBetween(from_mm, to_mm, geometry.face_px.x, geometry.pixel_mm, geometry.width);
    };
    const auto add = [&row](RowSpan span) {
      if (span.begin < span.end) row.push_back(span);
    };
    if (place.gap_mm <= 0.0) {
      add(between(low_mm, high_mm));
      continue;
    }
    add(between(low_mm, -place.gap_mm));
    add(between(place.gap_mm, high_mm));
  }
  return spans;
}

std::vector<glm::dvec2> fanOutline_mm(const Probe& probe, const Knobs& knobs, double depth_mm, int pointsPerArc) {
  EW_EXPECTS(pointsPerArc >= 2);
  const detail::FanShape fan = detail::fanShapeOf(probe, knobs);
  const bool sector = fan.kind == detail::FanShape::Kind::sector;
  std::vector<glm::dvec2> outline;
  outline.reserve(2 * static_cast<std::size_t>(pointsPerArc) + 1);
  const auto add = [&](double at_mm, double towards, int points) {
    for (int n = 0; n < points; ++n) {
      const detail::FanShape::Line line = fan.lineAt(points == 1 ? 0.0 : towards * (2.0 * n / (points - 1) - 1.0));
      outline.push_back(line.origin_mm + at_mm * line.direction);
    }
  };
  add(0.0, 1.0, !sector ? 2 : fan.apexToFace_mm > 0.0 ? pointsPerArc : 1);
  add(depth_mm, -1.0, fan.kind == detail::FanShape::Kind::parallel ? 2 : pointsPerArc);
  outline.push_back(outline.front());
  return outline;
}

}  // namespace ew
