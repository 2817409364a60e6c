#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ew/measurement/tracing.h"

namespace ew::measurement {

/// The grey profile of 2 `half` + 1 places through a point along a unit direction, averaged across it; not a number where the image ends.
[[nodiscard]] std::vector<double> profileThrough(ImageView<const std::uint8_t> image, const ImageGeometry& geometry, const glm::dvec2& p_mm,
                                                 const glm::dvec2& along, int half, double step_mm, double across_mm);
/// Derivative of a profile under a Gaussian, by mm; 0 where a part of it is missing.
[[nodiscard]] std::vector<double> slopesOf(const std::vector<double>& profile, double step_mm, double blur_mm);

}  // namespace ew::measurement
