#pragma once

#include <vector>

#include "ew/phantom/flow.h"
#include "patient/recipe.h"

namespace ew::phantom {

struct Flow {
  FlowField field;
  std::vector<TrueStenosis> stenoses;
};

/// Reads "flow" of a recipe; nothing usable after a problem.
[[nodiscard]] Flow readFlow(const JsonFields& flow, const ShapesByName& shapes, const BodyRhythms& rhythms);

}  // namespace ew::phantom
