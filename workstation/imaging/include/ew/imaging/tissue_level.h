#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/scene.h"
#include "ew/imaging/tissue_maps.h"

namespace ew {

/// Decibels that are taken off the level of a recorded volume when it is made, and that live echoes of it add again. Kept levels lie on
/// disks: this number never changes, whatever gain drawn tissue is shown with.
inline constexpr double kLevelGain_db = 6.5;

/// How the level of a recorded volume is made.
struct LevelOptions {
  double sigma_mm = 1.2;                  ///< of the Gaussian within which power is averaged in even tissue, 0.2..5
  GreyMap shownWith = GreyMap::clinical;  ///< the curve that made decibels grey when the volume was recorded; never automatic
  double recordedDynamicRange_db = 60.0;  ///< what grey 0..255 spans along that curve, 20..120
  double gain_db = kLevelGain_db;         ///< taken off, so that live echoes show the recording's brightness
  int threads = 0;                        ///< 0: one per processor; the level does not depend on it
  int block_voxels = 64;                  ///< edge of the blocks, 8..256; the level does not depend on it
  std::uint64_t maxBytes = 4ull << 30;    ///< that the threads may hold beside volume and level: fewer work when that is not enough for all
};

/// Grey 0..255 of a recording as the level (0..255, on the scale of its recorded dynamic range) that `shownWith` shows as this grey: the
/// inverse of shownLevel (effects/gain.h). 0 is the highest level that is shown black. Rising.
[[nodiscard]] std::array<float, 256> levelsShownAs(GreyMap shownWith);

/// Memory that levelInBlocks holds beside volume and level.
[[nodiscard]] std::uint64_t levelForecast_bytes(const Grid& grid, const LevelOptions& options);

/// Takes one block of the level, i fastest; one call at a time, in any order.
using LevelSink = std::function<void(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> level)>;

/// The level (TissueMaps::level) of recorded tissue: the mean echo around each voxel, without speckle.
///
/// Grey becomes decibels and power, and both are averaged by a Gaussian over the voxels with data. Speckle has its mean decibels 2.5 dB
/// below the decibels of its mean power; where averaging has left less speckle (compounded volumes), the mean decibels count. Edges show in
/// a second Gaussian of half the width: where its means vary more within the first than the scatter of voxels about them explains (a sixth:
/// there are six resolution cells), an edge runs, and the mean decibels of the narrow one count, with the weight 1 - variance of speckle /
/// variance found (J. S. Lee, IEEE Trans. Pattern Anal. Mach. Intell. 2(2), 1980; ours takes two scales in place of sample and mean). So an
/// edge stays where it is and is smeared by half of sigma_mm, while even tissue is averaged over all of it.
///
/// A voxel has data where coverage is not absent; where no coverage is known, where its grey is above 0. Voxels without data take no part:
/// the rim is not darkened. The level is 0 without coverage, or where no coverage is known and most of what is near is 0 too; elsewhere at
/// least 1.
/// Where voxels are finer than a sixth of sigma_mm, each so many of them count that six make a sigma, and the level in between is that of
/// the eight neighbours: memory and time depend on voxels, not on millimetres.
/// Equal to the bit for every number of threads, every size of block and, where every voxel counts, every cut of the volume that leaves
/// the neighbourhood whole.
/// @param coverage voxelCount() values of Coverage, or empty
/// @error cancelled (within a tenth of a second), tooLarge (one thread needs more than maxBytes, or there is no such memory), badField
/// (sigma_mm)
[[nodiscard]] Result<void> levelInBlocks(const VolumeView<const std::uint8_t>& echo, std::span<const std::uint8_t> coverage,
                                         const LevelOptions& options, const LevelSink& sink, Progress& progress = noProgress());

/// The same in memory: voxelCount() values.
[[nodiscard]] Result<std::vector<std::uint8_t>> levelOf(const Volume& volume, const LevelOptions& options = {},
                                                        Progress& progress = noProgress());

/// Maps from which live echoes of a recorded volume are formed: its level, no surfaces, and the volume's own grain to be kept.
[[nodiscard]] TissueMaps recordedMaps(const Grid& grid, std::vector<std::uint8_t> level);
/// Of a volume whose level is made now. @error as levelInBlocks
[[nodiscard]] Result<std::shared_ptr<const TissueMaps>> recordedMapsOf(const Volume& volume, Progress& progress,
                                                                       const LevelOptions& options = {});

}  // namespace ew
