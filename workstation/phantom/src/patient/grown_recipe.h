#pragma once

#include "patient/recipe.h"

namespace ew::phantom {

// Shapes that grow or are uneven by themselves. All: null after a problem.
[[nodiscard]] ShapePtr readVesselTree(const JsonFields& object, const ShapesByName& known, const DrawingFrame* frame);
[[nodiscard]] ShapePtr readVesselsBeside(const JsonFields& object, const ShapesByName& known);
[[nodiscard]] ShapePtr readRough(const JsonFields& object, const ShapesByName& known);
[[nodiscard]] ShapePtr readSheets(const JsonFields& object, const ShapesByName& known);
[[nodiscard]] ShapePtr readSepta(const JsonFields& object, const ShapesByName& known);
[[nodiscard]] ShapePtr readPatches(const JsonFields& object);

}  // namespace ew::phantom
