#pragma once

#include <vector>

#include "case/case_plan.h"

namespace ew {

/// Of the labels of a case that comes as a recipe, by rising label. @error as readLabelTissues
[[nodiscard]] Result<std::vector<TissueAcoustics>> acousticsOf(const CasePlan& plan);

/// Blood of a case that comes as a recipe, in the frame of its file; null where the recipe says nothing of it, and for what sweeps
/// recorded. Read at each load: it shapes no voxel, and nothing of it is kept.
/// @error as readPatientFlow
[[nodiscard]] Result<std::shared_ptr<const FlowField>> flowOf(const CasePlan& plan, Progress& progress);

/// Moves what was made of a case from the frame of its file to where the case lies, which is rigid.
void placeEcho(const Case& opened, CaseEcho& echo);

}  // namespace ew
