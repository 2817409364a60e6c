#pragma once

#include <glm/glm.hpp>

#include "ew/core/image.h"
#include "ew/imaging/display.h"
#include "ew/imaging/display_image.h"
#include "ew/imaging/probe.h"

namespace ew {

/// Where the orientation marker of an image stands, in its pixels: at the side to which the probe's +x (its marker) points, `away_px` off
/// the end of the face, and no nearer than `margin_px` to an edge.
[[nodiscard]] glm::dvec2 markerPlace_px(const Probe& probe, const DisplayGeometry& geometry, double away_px, double margin_px);

/// A white dot with a dark rim there: what tells, of an image that is handed on, which side is which.
void burnMarker(ImageView<std::uint8_t> image, const Probe& probe, const DisplayGeometry& geometry);
void burnMarker(ImageView<Rgb> image, const Probe& probe, const DisplayGeometry& geometry);

}  // namespace ew
