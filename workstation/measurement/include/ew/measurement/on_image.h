#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/result.h"
#include "ew/imaging/display.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"
#include "ew/imaging/scene.h"
#include "ew/measurement/caliper.h"
#include "ew/measurement/tracing.h"

namespace ew::measurement {

/// How far the place of a point can be known in the image of a scan: its pixel, and the point spread of probe and settings there.
[[nodiscard]] UncertaintyAt uncertaintyOn(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry);

/// Options for an outline through clicks: the usual ones are for heads and abdomens of 60 mm and more; what is smaller is looked at closer,
/// down to a fifth, as the finer probes resolve it.
[[nodiscard]] TracingOptions tracingOptionsFor(std::span<const glm::dvec2> clicks_mm);

/// EdgeTracer::traceAround on the image of a scan, however it is turned. @param clicks_mm and the outline lie in mm of the probe frame
/// @error as EdgeTracer
[[nodiscard]] Result<std::vector<glm::dvec2>> traceOnImage(ImageView<const std::uint8_t> image, const DisplayGeometry& geometry,
                                                           std::span<const glm::dvec2> clicks_mm);

/// The ellipse of such an outline, as many points on it as there are clicks. @param clicks_mm at least 5 @error as EdgeTracer, fitEllipse
[[nodiscard]] Result<std::vector<glm::dvec2>> ellipseOnImage(ImageView<const std::uint8_t> image, const DisplayGeometry& geometry,
                                                             std::span<const glm::dvec2> clicks_mm);

}  // namespace ew::measurement
