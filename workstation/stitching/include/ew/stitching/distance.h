#pragma once

#include <cstdint>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/volume.h"

namespace ew::stitching {

/// Distance of each covered voxel from the border of the covered region: to the centre of the nearest absent voxel, where everything
/// outside the grid counts as absent. mm along the grid's axes; 0 at absent voxels; never above `limit_mm`.
/// An empty volume.coverage means that every voxel is covered. Exact (Euclidean) for orthogonal axes.
/// Source: Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012: one lower envelope of parabolas per line and axis.
/// Cost: three passes, one float per voxel; threads 0 means all cores and does not change the result.
/// @error cancelled
[[nodiscard]] Result<std::vector<float>> distanceFromBorder_mm(const Volume& volume, double limit_mm, int threads, Progress& progress);

}  // namespace ew::stitching
