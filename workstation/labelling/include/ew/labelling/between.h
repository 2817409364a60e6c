#pragma once

#include "ew/labelling/labels.h"

namespace ew::labelling {

/// A closed contour as it was traced in an image plane.
struct ContourTrace {
  Transform<frame::File, frame::Probe> planeToFile;  ///< rigid
  std::vector<glm::dvec2> points;                    ///< of the plane, mm; the last is joined to the first
};

/// Signed distance of a point of the plane to a closed contour, mm: below 0 inside (even-odd rule).
[[nodiscard]] double signedDistance_mm(std::span<const glm::dvec2> contour, const glm::dvec2& at_mm);

/// The shape between traced contours: for each two that follow one another along the structure, a voxel between their planes takes the
/// distances d1 and d2 of its projections to the contours, weighted by its distances z1 and z2 to the planes,
///   d = (z2 d1 + z1 d2) / (z1 + z2),
/// and belongs to the shape when d <= 0. Beyond the first and the last plane nothing is filled.
/// Source: Raya and Udupa, Shape-based interpolation of multidimensional objects, IEEE Trans. Med. Imaging 9(1), 1990, which interpolates
/// signed distances between parallel slices. Ours takes exact distances to the traced lines, and planes of any direction that do not cross
/// within the shape (a fan of tilted planes).
/// The order is found: along the direction in which the contours' middles lie farthest apart.
/// @error badUsage (fewer than two contours of at least three points; two planes cross within their contours), cancelled; then nothing
///        changed
[[nodiscard]] Result<VoxelBox> fillBetween(Volume& labels, std::span<const ContourTrace> contours, const Brush& brush, Progress& progress);

}  // namespace ew::labelling
