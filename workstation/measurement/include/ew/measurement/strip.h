#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ew/imaging/display.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/m_mode.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/measurement/caliper.h"

namespace ew::measurement {

/// How far moment and depth of a point of an M-mode strip can be known: in time its column and the interval of the beams that the column
/// was interpolated from, in depth its row and the axial resolution on the M line. As the strip is now: it goes on.
[[nodiscard]] UncertaintyAt uncertaintyInStrip(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry,
                                               const MModeStrip& strip);

/// Where the pixels of a strip lie in time and depth: rows go evenly from the face to the depth of the image, both included.
class StripPlane {
 public:
  /// @param strip outlives this and may go on @param depth_mm of its last row, > 0
  StripPlane(const MModeStrip& strip, double depth_mm) : strip_(&strip), depth_mm_(depth_mm) {}
  /// s and mm at the middle of the pixel (x, y), x to the nearest column, both kept within the strip; empty where nothing is drawn.
  [[nodiscard]] std::optional<glm::dvec2> pointAt(glm::dvec2 pixel) const;
  /// The pixel of a point; empty when its echoes are not in the strip.
  [[nodiscard]] std::optional<glm::dvec2> pixelOf(glm::dvec2 point) const;
  /// mm for each s, so that both count as many pixels.
  [[nodiscard]] double mmPerS() const;
  [[nodiscard]] double rowDepth_mm() const;

 private:
  const MModeStrip* strip_;
  double depth_mm_;
};

}  // namespace ew::measurement
