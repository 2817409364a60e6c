#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ew/imaging/probe.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/io/step_store.h"
#include "ew/library/preparation.h"
#include "ew/phantom/virtual_sweep.h"

namespace ew {

/// What a preparation made. A part without voxels is one that it does not make.
struct Prepared {
  Volume volume;                                   ///< with coverage
  Volume labels;                                   ///< a label per voxel in its `echo`
  std::shared_ptr<TissueMaps> maps = nullptr;      ///< on the volume's grid; null where the case asks for none
  std::shared_ptr<TissueMotion> motion = nullptr;  ///< of the maps' tissue; null where it does not move
};

/// The folders of the cache, below steps, in which results of preparations lie: each with what was made in a step, under its key.
inline constexpr const char* kRecordings = "recordings";  ///< of sweeps, until those are reconstructed
inline constexpr const char* kSweeps = "sweeps";          ///< reconstructed
inline constexpr const char* kVolumes = "volumes";        ///< joined, or voxelised with their labels
inline constexpr const char* kLabels = "labels";          ///< of joined volumes
inline constexpr const char* kMaps = "maps";              ///< of tissue, beside voxelised volumes
inline constexpr const char* kMotions = "motions";        ///< of that tissue
inline constexpr const char* kTruths = "truths";
[[nodiscard]] const std::vector<std::string>& preparationSteps();

/// A sweep of a case and the keys of what comes of it.
struct PlannedSweep {
  std::string name;  ///< file name without folder and ending: "subcostal"
  SweepRecipe recipe;
  Probe probe;
  std::string recording;  ///< key in kRecordings
  std::string volume;     ///< key in kSweeps
  double work = 0.0;      ///< of recording: resolution cells, in millions
};

/// The steps of a preparation, and the key of everything that each depends on. Nothing is built for it.
struct CasePlan {
  std::filesystem::path patientFile;
  std::filesystem::path mannequins;
  std::vector<PlannedSweep> sweeps;  ///< none: the patient is voxelised
  std::string volume;                ///< key in kVolumes
  std::string labels;                ///< key in kLabels
  std::string maps;                  ///< key in kMaps; empty: none are made
  std::string motion;                ///< key in kMotions; empty: none is asked for
  std::string truth;                 ///< key in kTruths
  [[nodiscard]] bool isDoneIn(const StepStore& store) const;
  [[nodiscard]] bool isDone() const;  ///< in the cache
  /// Whether something lies there as a part of it that cannot be used.
  [[nodiscard]] bool isDamagedIn(const StepStore& store) const;
};

/// Never throws: the window's own thread asks.
/// @error as fileOfCase, fingerprintOfPatient, readSweepRecipe, readProbe; internal for what nobody foresaw
[[nodiscard]] Result<CasePlan> planOf(const Case& opened);

/// What is still to be done, by the kept speed of this machine.
[[nodiscard]] PreparationEstimate estimateOf(const Case& opened, const CasePlan& plan);

/// Volume and labels of a case, from the cache or made now, each step kept as it is done.
/// @param notes what a user should know is appended
[[nodiscard]] Result<Prepared> makePrepared(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress,
                                            std::vector<Message>& notes);

}  // namespace ew
