#pragma once

#include <optional>

#include "ew/core/progress.h"
#include "ew/imaging/tissue_maps.h"

namespace ew {

/// Maps of a coarser grid on a finer one of the same axes, for images until the finer ones are made: levels lie smoothly between the
/// voxels that send anything back, and the rest sends nothing back where it is nearer; distances to a surface lie smoothly between voxels
/// that know the same surface, so that it stays a line and does not become stairs.
/// @return empty when cancelled
[[nodiscard]] std::optional<TissueMaps> spreadOn(const TissueMaps& coarse, const Grid& fine, int threads, Progress& progress);

}  // namespace ew
