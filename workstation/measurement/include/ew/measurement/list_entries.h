#pragma once

#include <optional>
#include <vector>

#include "ew/core/result.h"
#include "ew/measurement/caliper.h"
#include "ew/measurement/measurement_list.h"
#include "ew/measurement/package.h"
#include "ew/measurement/worksheet.h"

namespace ew::measurement {

/// What a caliper gives to an item of a kind, in the order of preference; null when it gives nothing of that kind.
[[nodiscard]] const CaliperFigure* figureFor(ItemMeasure measure, const Measured& measured);

/// What a measurement gives to the item it was made for; empty when it was made for none of this package, or cannot be measured yet.
/// @error badField (a caliper that gives nothing its item needs: a distance for a circumference)
[[nodiscard]] Result<std::optional<WorksheetEntry>> entryOf(const Measurement& measurement, const Package& package,
                                                            const UncertaintyAt& at = {});

}  // namespace ew::measurement
