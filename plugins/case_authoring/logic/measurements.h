#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/library/case_values.h"
#include "ew/sdk/scan.h"

namespace ew::case_authoring {

/// A kind of measurement of a case: what calipers call the figure, what a case calls it, and the unit in which a case keeps it.
struct MeasurementKind {
  std::string_view figure;
  std::string_view kind;
  std::string_view unit;
};
inline constexpr std::array<MeasurementKind, 4> kMeasurementKinds = {
    MeasurementKind{"length", "distance", "mm"},
    {"circumference", "circumference", "mm"},
    {"area", "area", "cm2"},
    {"angle", "angle", "deg"},
};

/// An expected measurement with value, kind, unit and points of a caliper that was drawn.
/// @param expected    its kind says which figure of the caliper is taken; without one the figure that the caliper is for
/// @param drawn       what is measured in the image; of several that have such a figure the latest counts
/// @param probeToFile of the image that was measured: points are kept before file_to_world
/// @error badUsage: nothing drawn has such a figure
[[nodiscard]] Result<CaseMeasurement> withCaliper(CaseMeasurement expected, const std::vector<sdk::ScanMeasurement>& drawn,
                                                  const Transform<frame::File, frame::Probe>& probeToFile);

}  // namespace ew::case_authoring
