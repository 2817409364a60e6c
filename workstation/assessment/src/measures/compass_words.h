#pragma once

#include "ew/assessment/compass.h"

namespace ew::assessment {

/// The sentence of an advice whose other fields are set.
[[nodiscard]] Message sentenceOf(const CompassAdvice& advice);

}  // namespace ew::assessment
