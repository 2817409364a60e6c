#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/imaging/probe.h"
#include "ew/library/preparation.h"
#include "ew/phantom/virtual_sweep.h"
#include "prepared_store.h"

namespace ew {

/// A sweep of a case and the places of what comes of it.
struct PlannedSweep {
  std::string name;  ///< file name without folder and ending: "subcostal"
  SweepRecipe recipe;
  Probe probe;
  std::string key;                    ///< of the recording
  std::filesystem::path recording;    ///< while it is not reconstructed yet
  std::filesystem::path calibration;  ///< the device set beside it, written first
  std::filesystem::path lock;         ///< of the recording, for as long as it is there
  PreparedStore store;                ///< the reconstructed volume
  double work = 0.0;                  ///< of recording: resolution cells, in millions
};

/// The steps of a preparation, what each depends on, and where its result is kept. Nothing is built for it.
struct CasePlan {
  std::filesystem::path patientFile;
  std::filesystem::path mannequins;
  std::vector<PlannedSweep> sweeps;  ///< none: the patient is voxelised
  PreparedStore volume;              ///< stitched, or voxelised with its labels
  PreparedStore labels;              ///< of a stitched volume
  std::filesystem::path truth;
  std::filesystem::path lock;
  [[nodiscard]] bool isDone() const { return volume.isThere() && (sweeps.empty() || labels.isThere()); }
};

/// Never throws: the window's own thread asks.
/// @error as fileOfCase, fingerprintOfPatient, readSweepRecipe, readProbe; internal for what nobody foresaw
[[nodiscard]] Result<CasePlan> planOf(const Case& opened);

/// What is still to be done, by the kept speed of this machine.
[[nodiscard]] PreparationEstimate estimateOf(const Case& opened, const CasePlan& plan);

/// Volume and labels of a case, from the cache or made now, each step kept as it is done.
/// @param notes what a user should know is appended
[[nodiscard]] Result<Prepared> makePrepared(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress,
                                            std::vector<std::string>& notes);

}  // namespace ew
