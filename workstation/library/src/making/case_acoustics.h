#pragma once

#include <vector>

#include "case/case_plan.h"

namespace ew {

/// Of the labels of a case that comes as a recipe, by rising label. @error as readLabelTissues
[[nodiscard]] Result<std::vector<TissueAcoustics>> acousticsOf(const CasePlan& plan);

/// Moves what was made of a case from the frame of its file to where the case lies, which is rigid.
void placeEcho(const Case& opened, CaseEcho& echo);

}  // namespace ew
