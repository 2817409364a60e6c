#include <algorithm>
#include <cmath>
#include <numbers>

#include "colour/colour_lines.h"
#include "ew/core/contract.h"
#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/display.h"
#include "ew/imaging/doppler.h"
#include "flow/echo_powers.h"
#include "plan/planning.h"
#include "probes/fan_shape.h"
#include "probes/sound.h"

namespace ew {
namespace {

constexpr double kMiddle = 0.5, kHeight = 0.4;  // of the depth
constexpr double kThinnest_mm = 5.0;
constexpr double kNarrowest = 0.1;  // of the face
constexpr int kFewestLines = 8;

/// Of a box where the settings ask for it, brought into the depth.
struct Extent {
  double middle_mm, height_mm;
};
Extent extentOf(const ColourDoppler& colour, double depth_mm) {
  const double asked_mm = colour.boxHeight_mm > 0.0 ? colour.boxHeight_mm : kHeight * depth_mm;
  const double height_mm = std::clamp(asked_mm, std::min(kThinnest_mm, depth_mm), depth_mm);
  const double middle_mm = colour.boxMiddle_mm > 0.0 ? colour.boxMiddle_mm : kMiddle * depth_mm;
  return {std::clamp(middle_mm, 0.5 * height_mm, depth_mm - 0.5 * height_mm), height_mm};
}

}  // namespace

namespace detail {

int filterOrderOf(const ColourDoppler& colour) {
  // Two degrees of freedom must be left: of one, the phase from sample to sample is the same whatever moves.
  return std::min(static_cast<int>(colour.wallFilter), colour.packet - 3);
}

Probe colourProbeOf(const Probe& probe, const ColourDoppler& colour) {
  Probe result = probe;
  result.lines = std::max(kFewestLines, (probe.lines - 1) / colour.everyLine + 1);
  return result;
}

Knobs steeredKnobs(const Probe& probe, const Knobs& knobs, double steering_rad) {
  Knobs result = knobs;
  const bool isParallel = probe.kind == ProbeKind::linear && !knobs.trapezoid;
  const double most_rad = std::min(kMostColourSteering_rad, probe.maxSteering_rad);
  result.steering_rad = isParallel ? std::clamp(steering_rad, -most_rad, most_rad) : 0.0;
  return result;
}

Knobs colourKnobsOf(const Probe& probe, const Knobs& knobs) { return steeredKnobs(probe, knobs, knobs.colour->steering_rad); }

}  // namespace detail

ColourBox colourBoxOf(const Probe& probe, const Knobs& asked) {
  EW_EXPECTS(asked.colour.has_value());
  const Knobs knobs = limited(asked);
  const ColourDoppler& colour = *knobs.colour;
  const double depth_mm = resolvedDepth_mm(probe, knobs);
  const Extent extent = extentOf(colour, depth_mm);
  ColourBox box;
  const double half = std::clamp(colour.boxWidth, kNarrowest, 1.0);
  const double middle = std::clamp(colour.boxMiddle, half - 1.0, 1.0 - half);
  box.left = middle - half;
  box.right = middle + half;
  box.top_mm = extent.middle_mm - 0.5 * extent.height_mm;
  box.bottom_mm = extent.middle_mm + 0.5 * extent.height_mm;
  box.steering_rad = detail::colourKnobsOf(probe, knobs).steering_rad;
  box.carrier_hz = colour.carrier_hz > 0.0 ? colour.carrier_hz : detail::kCarrierShare * detail::withCarrierOf(probe, knobs).carrier_hz;
  // The next pulse is sent once the echo of the lower edge is back.
  box.prf_hz = std::min(colour.prf_hz, 0.5 * detail::kSpeedOfSound_mmPerS / box.bottom_mm);
  box.nyquist_mmPerS = nyquist_mmPerS(box.prf_hz, box.carrier_hz);
  box.packet = colour.packet;
  box.filterOrder = detail::filterOrderOf(colour);
  box.wallEdge_mmPerS = WallFilter(box.packet, box.filterOrder).edge() * box.nyquist_mmPerS;
  const int lines = detail::colourProbeOf(probe, colour).lines;
  box.lines = static_cast<int>(std::lround(half * (lines - 1))) + 1;
  box.frame_s = box.lines * box.packet / box.prf_hz;
  box.shown_mmPerS = {(-1.0 + colour.baseline) * box.nyquist_mmPerS, (1.0 + colour.baseline) * box.nyquist_mmPerS};
  return box;
}

std::vector<glm::dvec2> colourBoxOutline_mm(const Probe& probe, const Knobs& knobs) {
  constexpr int kPoints = 25;  // of an arc
  const ColourBox box = colourBoxOf(probe, knobs);
  const detail::FanShape fan = detail::fanShapeOf(probe, detail::colourKnobsOf(probe, limited(knobs)));
  const auto at = [&](double across, double depth_mm) {
    const detail::FanShape::Line line = fan.lineAt(across);
    return line.origin_mm + depth_mm * line.direction;
  };
  const auto across = [&](int n) { return std::lerp(box.left, box.right, static_cast<double>(n) / (kPoints - 1)); };
  std::vector<glm::dvec2> outline;
  for (int n = 0; n < kPoints; ++n) outline.push_back(at(across(n), box.bottom_mm));
  for (int n = kPoints - 1; n >= 0; --n) outline.push_back(at(across(n), box.top_mm));
  std::rotate(outline.begin(), outline.end() - 1, outline.end());
  outline.push_back(outline.front());
  return outline;
}

ColourPlace colourPlaceOf(const Probe& probe, const Knobs& asked, const glm::dvec2& p_mm) {
  EW_EXPECTS(asked.colour.has_value());
  const detail::FanShape::Place place = detail::fanShapeOf(probe, detail::colourKnobsOf(probe, limited(asked))).placeOf(p_mm);
  return {place.across, place.depth_mm};
}

Knobs withColourBoxMiddle(const Probe& probe, const Knobs& knobs, const ColourPlace& middle) {
  Knobs moved = limited(knobs);
  const ColourBox box = colourBoxOf(probe, moved);
  const double half = 0.5 * (box.right - box.left), halfHeight_mm = 0.5 * (box.bottom_mm - box.top_mm);
  const double depth_mm = resolvedDepth_mm(probe, moved);
  moved.colour->boxMiddle = std::clamp(middle.across, std::min(half - 1.0, 0.0), std::max(1.0 - half, 0.0));
  moved.colour->boxMiddle_mm = std::clamp(middle.depth_mm, halfHeight_mm, std::max(depth_mm - halfHeight_mm, halfHeight_mm));
  moved.colour->boxHeight_mm = 2.0 * halfHeight_mm;
  return moved;
}

Knobs withColourBoxAt(const Probe& probe, const Knobs& knobs, const glm::dvec2& p_mm) {
  return withColourBoxMiddle(probe, knobs, colourPlaceOf(probe, knobs, p_mm));
}

Knobs withColourEdgesAt(const Probe& probe, const Knobs& asked, const ColourEdges& edges, const ColourPlace& place) {
  Knobs moved = limited(asked);
  ColourBox box = colourBoxOf(probe, moved);
  const double depth_mm = resolvedDepth_mm(probe, moved);
  const double thinnest_mm = std::min(kThinnest_mm, depth_mm);
  if (edges.left) box.left = std::min(std::max(place.across, -1.0), box.right - 2.0 * kNarrowest);
  if (edges.right) box.right = std::max(std::min(place.across, 1.0), box.left + 2.0 * kNarrowest);
  if (edges.top) box.top_mm = std::min(std::max(place.depth_mm, 0.0), box.bottom_mm - thinnest_mm);
  if (edges.bottom) box.bottom_mm = std::max(std::min(place.depth_mm, depth_mm), box.top_mm + thinnest_mm);
  moved.colour->boxMiddle = 0.5 * (box.left + box.right);
  moved.colour->boxWidth = 0.5 * (box.right - box.left);
  moved.colour->boxMiddle_mm = 0.5 * (box.top_mm + box.bottom_mm);
  moved.colour->boxHeight_mm = box.bottom_mm - box.top_mm;
  return moved;
}

}  // namespace ew
