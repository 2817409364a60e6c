#pragma once

#include <vector>

#include "case/case_plan.h"
#include "ew/library/preparation.h"
#include "making/kept_volumes.h"

namespace ew {

/// What is still to be done, by the kept speed of this machine.
[[nodiscard]] PreparationEstimate estimateOf(const Case& opened, const CasePlan& plan);

/// Volume and labels of a case, from the cache or made now, each step kept as it is done.
/// @param notes what a user should know is appended
[[nodiscard]] Result<Prepared> makePrepared(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress,
                                            std::vector<Message>& notes);

/// Whether a draft comes sooner than the volume itself.
[[nodiscard]] bool isWorthDrafting(const Case& opened, const CasePlan& plan);
/// A case of a recipe without sweeps at once, from coarser voxels; nothing is kept.
/// @error as makePrepared
[[nodiscard]] Result<Prepared> makeDraft(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress);

/// The labels alone: those that are kept, else made now; of sweeps only with the volume. On the labels' own grid, not placed.
/// @error as makePrepared
[[nodiscard]] Result<Volume> makeLabels(const Case& opened, const CasePlan& plan, const PreparationOptions& options, Progress& progress);

}  // namespace ew
