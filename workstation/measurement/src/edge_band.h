#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/measurement/tracing.h"

namespace ew::measurement {

/// A closed smooth line through points (Catmull & Rom 1974, chord lengths as parameter), the first one not repeated.
[[nodiscard]] std::vector<glm::dvec2> closedCurveThrough(std::span<const glm::dvec2> points, double spacing);

/// Points at even distances of about `spacing` along a closed line.
[[nodiscard]] std::vector<glm::dvec2> resampled(const std::vector<glm::dvec2>& line, double spacing);

/// A closed line under a Gaussian along itself. Half of the move is taken back once by a second pass of the other sign (Taubin's idea, one
/// step of it), without which a circle would shrink. @param deviation in points
[[nodiscard]] std::vector<glm::dvec2> smoothed(const std::vector<glm::dvec2>& line, double deviation);

/// A closed line moved along its normals onto the strongest edge around it that keeps one side: a bright wall has two, and an outline that
/// changes from one to the other is neither. The way through the band of the line is the best one under a penalty on its slope (dynamic
/// programming, as Amini, Weymouth & Jain, IEEE PAMI 12(9), 1990), so that where the edge fades the line goes on between what is seen.
/// Of both sides that one counts which is stronger and lies evenly about the line, for clicks err to both sides.
/// @param line points at options.spacing_mm, three at least
/// @return as many points; the line itself where there is no edge
[[nodiscard]] std::vector<glm::dvec2> broughtToEdge(ImageView<const std::uint8_t> image, const ImageGeometry& geometry,
                                                    const std::vector<glm::dvec2>& line, const TracingOptions& options);

}  // namespace ew::measurement
