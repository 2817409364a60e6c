#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "comparable.h"

/// What runs along a view's beams: shadows and enhancement. It turns with the probe and not with the tissue. Private to this library.
namespace ew::registration {

constexpr double kAlongBeam_mm = 6.0;  ///< standard deviation of the mean along the beam that is taken out

/// Where the rows of an image lie in its values: row (j, k) begins at first + (k * dims.y + j) * stride.
struct RowLayout {
  std::size_t stride = 0;
  std::size_t first = 0;
};

/// Takes the weighted mean along the beams out of an echo image. Of a fan, each voxel's own beam is followed straight on, its direction
/// rounded to about 2 degrees.
/// @param weight    empty: 1 everywhere
/// @param sum       echo times weight; on return (echo - mean along the beam) times weight
/// @return false when cancelled
bool takeOutAlong(const Grid& grid, const RowLayout& rows, const Beams& beams, double sigma_mm, const std::vector<float>& weight,
                  std::vector<float>& sum, int threads, Progress& progress);

/// The direction (mm) along which the image is most alike to itself 18 to 36 mm further on, which tissue hardly is; empty when it is not
/// alike in any, or when cancelled. Straight layers and vessels count too: a hint, no proof.
/// @param image voxels of 1 to 5 mm
/// A second is named when it is nearly as good and more than 30 degrees off, for a ridge of tissue may look the same.
[[nodiscard]] std::vector<glm::dvec3> findStreaks(const ComparableImage& image, int threads, Progress& progress);

}  // namespace ew::registration
