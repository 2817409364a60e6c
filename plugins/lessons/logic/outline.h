#pragma once

#include <vector>

#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"

namespace ew::lessons {

/// Where an image of a depth shows anything. @param p_mm of the image plane
[[nodiscard]] bool isInFan(const Probe& probe, double depth_mm, const glm::dvec2& p_mm);

/// The outline of a structure in an image, as short lines of the image plane's mm: where the share of its label, taken between voxels,
/// crosses a half on a grid of `step_mm` (marching squares). It ends at the border of the fan; nothing lies outside.
[[nodiscard]] std::vector<sdk::OverlayLine<frame::Probe>> outlineOf(const sdk::Scanned& scanned, int label, const ScanState& image,
                                                                    double step_mm);

}  // namespace ew::lessons
