#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "ew/core/image.h"
#include "ew/core/volume.h"
#include "ew/library/placing.h"

namespace ew {

/// Into the volume from one of its six sides, of length 1. @param side 0 and 1: where i is least and greatest; 2, 3: j; 4, 5: k
[[nodiscard]] glm::dvec3 inwardOf(const Grid& own, std::size_t side);

/// The directions a volume would have, had the probe stood on each of its six sides, numbered as by inwardOf.
/// @param lateral where the marker points, roughly; the axis of the grid that lies nearest is taken
[[nodiscard]] std::array<SweepAxes, 6> axesOfFaces(const Grid& own, const glm::dvec3& lateral);

/// The side of a patient in LPS: front is where y is least, left where x is greatest, upper where z is greatest.
enum class VolumeSide { front, back, left, right, upper, lower };
[[nodiscard]] const char* nameOf(VolumeSide side);                            ///< "front"
[[nodiscard]] std::optional<VolumeSide> volumeSideOf(std::string_view name);  ///< nothing for any other word
[[nodiscard]] VolumeSide volumeSideOf(const SweepAxes& axes);                 ///< from which its beams come, roughly
[[nodiscard]] SweepAxes axesFrom(const Grid& own, VolumeSide side);           ///< the axis of the grid that looks in from there

/// Where the probe was, as far as the voxels tell. It is a proposal and no finding: a volume that is equally bright and wide on all sides
/// says nothing, and then it is the front.
struct ProbeSide {
  SweepAxes axes;
  double certainty = 0.0;  ///< 0: nothing speaks for this side; 1: the sides differ clearly
};

/// Of the six sides that from which echoes grow fainter and images wider (a fan): the mean grey and the number of voxels with data of the
/// nearest quarter of the slabs against those of the farthest, as logarithms, of which the larger sum counts. A voxel has data as by
/// placingShapeOf. Cost: one pass over the voxels.
[[nodiscard]] ProbeSide proposedProbeSide(const Volume& volume);

/// The middle plane as a machine would show it, had the probe stood where `axes` say: its face at the top, the marker to the right.
/// @param axes along axes of the grid @param longest_px of the longer edge, > 0
[[nodiscard]] GreyImage middleImage(const Volume& volume, const SweepAxes& axes, int longest_px);

/// Every n-th voxel, so that no edge has more than `most` voxels; echo alone.
[[nodiscard]] Volume thinned(const Volume& volume, int most);

}  // namespace ew
