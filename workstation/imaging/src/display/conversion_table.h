#pragma once

#include "ew/imaging/scan_conversion.h"
#include "probes/fan_shape.h"

namespace ew::detail {

/// makeScanConversion for lines of a fan that need not be the image's own, and for those of the image's pixels that are asked for.
[[nodiscard]] ScanConversionTable conversionOf(const FanShape& fan, Spans spans, const BeamGrid& grid, const DisplayGeometry& geometry);

}  // namespace ew::detail
