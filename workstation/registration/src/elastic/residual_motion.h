#pragma once

#include <vector>

#include "elastic/level_pair.h"
#include "ew/core/progress.h"

namespace ew::registration {

/// The images of a level are looked at in blocks of this size (four voxels at least), under shifts of this step (one voxel at least) and
/// reach along each axis.
inline constexpr double kLeftBlock_mm = 6.0;
inline constexpr double kLeftStep_mm = 2.0;
inline constexpr double kLeftReach_mm = 4.0;

/// What small blocks, each shifted on its own, say about motion that a warp did not follow.
struct ResidualMotion {
  double blocks = 0.0;           ///< that told: both halves of their voxels agree best under the same shift, more often than by chance
  double share = 0.0;            ///< of these: the shift is not none
  double deviation = 0.0;        ///< standard deviation of `share`
  double length_mm = 0.0;        ///< mean of the shifts that are not none
  std::vector<float> nodeShare;  ///< per node, `share` of the blocks around it (9 mm); 0 where fewer than two told
};

/// The images of `pair` as they were warped last, for which samples must not have been doubted. A block's voxels are halved like a
/// checkerboard of eight cubes; either half names the shift under which it correlates best. Where nothing moves any more both name none;
/// where nothing can be told they name different ones, or one under which the difference is no smaller than without. About a thousand
/// blocks are looked at, of larger volumes not all.
/// @return false when cancelled
[[nodiscard]] bool lookForResidualMotion(const LevelPair& pair, const NodeGrid& nodes, int threads, Progress& progress,
                                         ResidualMotion& left);

}  // namespace ew::registration
