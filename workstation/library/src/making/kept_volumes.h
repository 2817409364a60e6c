#pragma once

#include <initializer_list>
#include <memory>
#include <string>

#include "case/case_plan.h"
#include "ew/core/volume.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/io/volume_file.h"

namespace ew {

/// What a preparation made. A part without voxels is one that it does not make.
struct Prepared {
  Volume volume;                                   ///< with coverage
  Volume labels;                                   ///< a label per voxel in its `echo`
  std::shared_ptr<TissueMaps> maps = nullptr;      ///< on the volume's grid: as drawn, or the level of what sweeps recorded
  std::shared_ptr<TissueMotion> motion = nullptr;  ///< of the maps' tissue; null where it does not move
};

// Files of a result.
inline constexpr const char* kVolumeFile = "volume.mha";
inline constexpr const char* kCoverageFile = "coverage.mha";
inline constexpr const char* kConfidenceFile = "confidence.mha";
inline constexpr const char* kLabelsFile = "labels.mha";
inline constexpr const char* kImagesFile = "images.igs.mha";
inline constexpr const char* kDeviceSetFile = "device-set.xml";

/// Speckle hardly compresses, and an uncompressed file opens several times faster.
inline constexpr WriteOptions kPlain{.compress = false};

/// Whether a result is there and its files hold what they held.
[[nodiscard]] bool isWhole(const StepStore& store, const char* step, const std::string& key, std::initializer_list<const char*> names);
[[nodiscard]] tl::unexpected<Error> damagedInCache(const StepStore& store, const char* step, const std::string& key);

/// With its coverage. @error as readVolume; badHeader (damaged)
[[nodiscard]] Result<Volume> readKeptVolume(const StepStore& store, const char* step, const std::string& key, Progress& progress);
/// @error as readLabelVolume; badHeader (damaged)
[[nodiscard]] Result<Volume> readKeptLabels(const StepStore& store, const char* step, const std::string& key, Progress& progress);
/// Volume and labels, those of them that have voxels. @error notWritable, cancelled
[[nodiscard]] Result<void> keepPrepared(const StepStore& store, const char* step, const std::string& key, const Prepared& made,
                                        Progress& progress);
/// Volume and labels that were made and kept are read from their files from now on, as those are that readPrepared reads (restInFile).
void restWhereKept(const StepStore& store, const char* step, const std::string& key, Prepared& made);
/// What a store holds in full. @error as readKeptVolume
[[nodiscard]] Result<Prepared> readPrepared(const CasePlan& plan, const StepStore& store, Progress& progress);

}  // namespace ew
