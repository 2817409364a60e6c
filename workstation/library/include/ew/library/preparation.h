#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/library/case.h"

namespace ew {

/// The volumes of cases that come as recipes are made once and kept in the cache, by what shaped them: recipe, mannequin, sweeps, probes,
/// options and the program's way of making them. A case with sweeps is made in steps, each kept as soon as it is done:
///   for each sweep: record it from the virtual patient, write and open it as a user's recording is opened, reconstruct;
///   then stitch, and label the voxels from the patient's truth.
/// So a preparation that was cancelled or killed goes on where it was, a changed sweep is made again alone, and whatever is damaged in the
/// cache is noticed by its hash and made again. Two programs at once wait for each other.

/// What is still to be done, before it begins.
struct PreparationEstimate {
  double seconds = 0.0;   ///< 0 when there is nothing left to do
  bool measured = false;  ///< from the speed of earlier preparations on this machine; false: from that of the machine it was written on
};

/// @error as loadCase for what the case names, readSweepRecipe, readProbe
[[nodiscard]] Result<PreparationEstimate> estimatePreparation(const Case& opened);

/// Makes what the cache does not have yet; returns what a user should know, in sentences. Reports the step and the seconds left; fractions
/// are of time.
/// @error as loadCaseVolume
[[nodiscard]] Result<std::vector<Message>> prepareCase(const Case& opened, const PreparationOptions& options, Progress& progress);

/// The order in which to prepare: first the one that is scannable soonest. Cases that need no preparation are left out.
[[nodiscard]] std::vector<Case> preparationOrder(const std::vector<Case>& cases);

}  // namespace ew
