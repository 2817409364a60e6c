#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/imaging/probe.h"
#include "ew/io/step_store.h"
#include "ew/library/case.h"
#include "ew/phantom/virtual_sweep.h"

namespace ew {

/// The folders of the cache, below steps, in which results of preparations lie: each with what was made in a step, under its key.
inline constexpr const char* kRecordings = "recordings";  ///< of sweeps, until those are reconstructed
inline constexpr const char* kSweeps = "sweeps";          ///< reconstructed
inline constexpr const char* kVolumes = "volumes";        ///< joined, or voxelised with their labels
inline constexpr const char* kLabels = "labels";          ///< of joined volumes
inline constexpr const char* kMaps = "maps";              ///< of tissue, beside volumes
inline constexpr const char* kMotions = "motions";        ///< of that tissue
inline constexpr const char* kTruths = "truths";
[[nodiscard]] const std::vector<std::string>& preparationSteps();

/// A sweep of a case and the keys of what comes of it.
struct CaseSweep {
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
  std::vector<CaseSweep> sweeps;  ///< none: the patient is voxelised
  std::string volume;             ///< key in kVolumes
  std::string labels;             ///< key in kLabels
  std::string maps;               ///< key in kMaps
  std::string motion;             ///< key in kMotions; empty: none is asked for
  std::string truth;              ///< key in kTruths
  [[nodiscard]] bool isDoneIn(const StepStore& store) const;
  [[nodiscard]] bool isDone() const;  ///< in the cache
  /// Whether something lies there as a part of it that cannot be used.
  [[nodiscard]] bool isDamagedIn(const StepStore& store) const;
};

/// Never throws: the window's own thread asks.
/// @error as fileOfCase, fingerprintOfPatient, readSweepRecipe, readProbe; internal for what nobody foresaw
[[nodiscard]] Result<CasePlan> planOf(const Case& opened);

/// Of stitching, which counts voxels: before there is a volume, what the sweeps see says how many there will be.
[[nodiscard]] double stitchWork(const CasePlan& plan, const CaseReconstruction& reconstruct);

/// Of building the patient: million voxels of its box. Reads the recipe; 0 where it has no box, which whoever makes the volume will say.
[[nodiscard]] double voxeliseWork(const CasePlan& plan, double spacing_mm);

}  // namespace ew
