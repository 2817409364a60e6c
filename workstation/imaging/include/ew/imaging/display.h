#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/core/frames.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/slicing.h"

namespace ew {

/// Where the fan of a probe lies in the image.
struct DisplayGeometry {
  int width = 0;
  int height = 0;
  double pixel_mm = 0.0;    ///< size of a pixel, the same in both directions
  glm::dvec2 face_px{0.0};  ///< pixel coordinates of the probe frame's origin (may lie outside the image when zoomed in)
  bool markerLeft = true;   ///< the probe's +x points to the left of the image
  bool upsideDown = false;  ///< the probe's +y points to the top of the image
  double depth_mm = 0.0;    ///< resolved: never 0
  bool operator==(const DisplayGeometry&) const = default;
  [[nodiscard]] Transform<frame::Probe, frame::Image> imageToProbe() const;
  /// The same for one pixel centre, in the image plane. Pixels mirrored about face_px get mirrored points, to the bit.
  [[nodiscard]] glm::dvec2 probePoint_mm(int x_px, int y_px) const;
};

/// The knobs' depth brought into the probe's range, or the probe's own where they name none, mm.
[[nodiscard]] double resolvedDepth_mm(const Probe& probe, const Knobs& knobs);

/// Which part of the fan a zoomed image shows: its middle, from the middle of the whole fan, along the probe's +x and +y.
struct Pan {
  double lateral_mm = 0.0;
  double axial_mm = 0.0;
  bool operator==(const Pan&) const = default;
};

/// The same, no farther than the fan goes at the knobs' zoom; nowhere without a zoom, and where a number is none.
[[nodiscard]] Pan panWithinFan(const Probe& probe, const Knobs& knobs, const Pan& pan);

/// The largest scale at which the whole fan of `probe` down to the knobs' depth fits width x height with a small margin, then zoomed
/// about the image's middle and panned (as panWithinFan says). The middle of the face stays in the image's middle column, so a fan that
/// leans to one side is fitted as if it leant to both. A zoom outside 1..8 is brought to the nearer end.
/// @param width, height pixels, >= 1
[[nodiscard]] DisplayGeometry fitDisplay(const Probe& probe, const Knobs& knobs, int width, int height, const Pan& pan = {});

/// The pixels of each row whose centres lie inside the fan: none in a row the fan does not touch, two runs beside the face of a convex
/// probe.
[[nodiscard]] Spans fanSpans(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry);

/// Outline of the fan in the probe's x-y plane, mm: what the 3D view draws. Closed: the last point repeats the first. It runs along the
/// face from -x to +x, then back along the bottom; a curve has `pointsPerArc` points (>= 2), a straight edge its two ends, a face of
/// radius 0 its one point.
[[nodiscard]] std::vector<glm::dvec2> fanOutline_mm(const Probe& probe, const Knobs& knobs, double depth_mm, int pointsPerArc = 48);

}  // namespace ew
