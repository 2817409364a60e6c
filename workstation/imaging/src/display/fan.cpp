#include <algorithm>
#include <cmath>

#include "ew/imaging/display.h"

#include "ew/core/contract.h"

namespace ew {
namespace {

/// Smallest box around the fan in the probe's x-y plane.
struct FanBox {
  double halfWidth_mm = 0.0;
  double top_mm = 0.0;
  double bottom_mm = 0.0;
};

FanBox boxOf(const Probe& probe, double depth_mm) {
  if (probe.kind == ProbeKind::linear) return {0.5 * probe.width_mm, 0.0, depth_mm};
  // The ends of the face lie behind its foremost point.
  return {(probe.radius_mm + depth_mm) * std::sin(probe.halfAngle_rad), probe.radius_mm * (std::cos(probe.halfAngle_rad) - 1.0), depth_mm};
}

double resolvedDepth_mm(const Probe& probe, const Knobs& knobs) {
  if (!(knobs.depth_mm > 0.0)) return probe.defaultDepth_mm;
  return std::clamp(knobs.depth_mm, probe.minDepth_mm, probe.maxDepth_mm);
}

/// Half of the fan's width at axial position y, and half of the gap that the face of a convex probe leaves there; halfWidth < 0 where
/// the fan has no point.
struct HalfRow {
  double halfWidth_mm = -1.0;
  double halfGap_mm = -1.0;
};

HalfRow halfRowAt(const Probe& probe, double depth_mm, double y_mm) {
  if (probe.kind == ProbeKind::linear) return {y_mm >= 0.0 && y_mm <= depth_mm ? 0.5 * probe.width_mm : -1.0, -1.0};
  const double fromCentre_mm = y_mm + probe.radius_mm;
  const double far_mm = probe.radius_mm + depth_mm;
  if (fromCentre_mm <= 0.0 || fromCentre_mm > far_mm) return {};
  HalfRow half;
  half.halfWidth_mm =
      std::min(fromCentre_mm * std::tan(probe.halfAngle_rad), std::sqrt(std::max(0.0, far_mm * far_mm - fromCentre_mm * fromCentre_mm)));
  if (fromCentre_mm < probe.radius_mm) half.halfGap_mm = std::sqrt(probe.radius_mm * probe.radius_mm - fromCentre_mm * fromCentre_mm);
  if (half.halfGap_mm > half.halfWidth_mm) return {};
  return half;
}

/// Pixels whose centres lie in [low, high], kept inside the picture.
RowSpan pixelsBetween(double low_px, double high_px, int width) {
  const double end = static_cast<double>(width);
  const double first = std::clamp(std::ceil(low_px), 0.0, end);
  const double afterLast = std::clamp(std::floor(high_px) + 1.0, 0.0, end);
  if (!(first < afterLast)) return {};
  return {static_cast<int>(first), static_cast<int>(afterLast)};
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

DisplayGeometry fitDisplay(const Probe& probe, const Knobs& knobs, int width, int height) {
  EW_EXPECTS(width >= 1 && height >= 1);
  constexpr double kMargin = 0.02;  // of the picture, on each side
  DisplayGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  geometry.markerLeft = knobs.markerLeft;
  geometry.upsideDown = knobs.upsideDown;
  geometry.depth_mm = resolvedDepth_mm(probe, knobs);
  const FanBox box = boxOf(probe, geometry.depth_mm);
  const double usable = 1.0 - 2.0 * kMargin;
  geometry.pixel_mm = std::max(2.0 * box.halfWidth_mm / (usable * static_cast<double>(width)),
                               (box.bottom_mm - box.top_mm) / (usable * static_cast<double>(height)));
  const double zoom = knobs.zoom > 1.0 ? std::min(knobs.zoom, 8.0) : 1.0;  // NaN compares false
  geometry.pixel_mm /= zoom;
  // The middle of the fan's box stays in the middle of the picture at every zoom.
  geometry.face_px.x = 0.5 * static_cast<double>(width - 1);
  geometry.face_px.y = 0.5 * static_cast<double>(height - 1) - 0.5 * (box.top_mm + box.bottom_mm) / geometry.pixel_mm;
  return geometry;
}

Spans fanSpans(const Probe& probe, const Knobs&, const DisplayGeometry& geometry) {
  Spans spans(static_cast<std::size_t>(geometry.height));
  for (int y = 0; y < geometry.height; ++y) {
    const HalfRow half = halfRowAt(probe, geometry.depth_mm, (static_cast<double>(y) - geometry.face_px.y) * geometry.pixel_mm);
    if (half.halfWidth_mm < 0.0) continue;
    const double outer_px = half.halfWidth_mm / geometry.pixel_mm;
    const double centre_px = geometry.face_px.x;
    auto& row = spans[static_cast<std::size_t>(y)];
    const auto add = [&row](RowSpan span) {
      if (span.begin < span.end) row.push_back(span);
    };
    if (half.halfGap_mm < 0.0) {
      add(pixelsBetween(centre_px - outer_px, centre_px + outer_px, geometry.width));
      continue;
    }
    const double gap_px = half.halfGap_mm / geometry.pixel_mm;
    const RowSpan left = pixelsBetween(centre_px - outer_px, centre_px - gap_px, geometry.width);
    RowSpan right = pixelsBetween(centre_px + gap_px, centre_px + outer_px, geometry.width);
    if (left.begin < left.end) right.begin = std::max(right.begin, left.end);  // a gap of no width: the middle pixel belongs to one side
    add(left);
    add(right);
  }
  return spans;
}

std::vector<glm::dvec2> fanOutline_mm(const Probe& probe, const Knobs&, double depth_mm, int pointsPerArc) {
  EW_EXPECTS(pointsPerArc >= 2);
  if (probe.kind == ProbeKind::linear) {
    const double half_mm = 0.5 * probe.width_mm;
    return {{-half_mm, 0.0}, {half_mm, 0.0}, {half_mm, depth_mm}, {-half_mm, depth_mm}, {-half_mm, 0.0}};
  }
  std::vector<glm::dvec2> outline;
  outline.reserve(2 * static_cast<std::size_t>(pointsPerArc) + 1);
  const auto addArc = [&](double radius_mm, double direction) {
    for (int n = 0; n < pointsPerArc; ++n) {
      const double angle_rad = direction * probe.halfAngle_rad * (2.0 * n / (pointsPerArc - 1) - 1.0);
      outline.emplace_back(radius_mm * std::sin(angle_rad), radius_mm * std::cos(angle_rad) - probe.radius_mm);
    }
  };
  addArc(probe.radius_mm, 1.0);
  addArc(probe.radius_mm + depth_mm, -1.0);
  outline.push_back(outline.front());
  return outline;
}

}  // namespace ew
