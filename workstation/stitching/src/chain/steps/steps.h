#pragma once

#include "chain/chain_run.h"

/// The steps of the chain, one file each. A step takes its forecast, looks in the store for its result under its key, makes and keeps it
/// where it is not there, and leaves it in the run for the steps after it.
namespace ew::stitching {

/// Names the inputs, reconstructs sweeps, reads everything once where it was never read, and finds the keys of all steps.
[[nodiscard]] Result<void> reconstructStep(ChainRun& run, Progress& progress);
/// Registers each pair by itself, rigidly, as many beside each other as there are threads and room; each is kept by itself.
[[nodiscard]] Result<void> rigidStep(ChainRun& run, Progress& progress);
/// All poses together; names pairs that cannot be right and volumes that nothing holds to the others.
[[nodiscard]] Result<void> graphStep(ChainRun& run, Progress& progress);
/// The grey levels of each view.
[[nodiscard]] Result<void> equaliseStep(ChainRun& run, Progress& progress);
/// Warps each pair by itself, each kept by itself, then brings all warps together.
[[nodiscard]] Result<void> elasticStep(ChainRun& run, Progress& progress);
/// Which view each cell of the result takes, and how levels pass over.
[[nodiscard]] Result<void> seamStep(ChainRun& run, Progress& progress);
/// The result and its provenance: made under waiting names, then moved to the folder.
[[nodiscard]] Result<void> volumeStep(ChainRun& run, Progress& progress);
/// Whether the files in the folder, or waiting to be moved there, are those of this key.
[[nodiscard]] bool resultIsThere(const ChainRun& run, const std::string& key);

}  // namespace ew::stitching
