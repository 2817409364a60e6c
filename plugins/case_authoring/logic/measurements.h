#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"
#include "ew/sdk/scan.h"

namespace ew::case_authoring {

/// An expected measurement of case.json with value, kind, unit and points of a caliper that was drawn.
/// @param expected    its "kind" says which figure of the caliper is taken; without one the figure that the caliper is for
/// @param drawn       what is measured in the image; of several that have such a figure the latest counts
/// @param probeToFile of the image that was measured: points are kept before file_to_world
/// @error badUsage: nothing drawn has such a figure
[[nodiscard]] Result<nlohmann::json> withCaliper(nlohmann::json expected, const std::vector<sdk::ScanMeasurement>& drawn,
                                                 const Transform<frame::File, frame::Probe>& probeToFile);

/// Whether a trainee's figure is compared with a value of the case; else the virtual patient knows it.
[[nodiscard]] bool hasValue(const nlohmann::json& expected);

}  // namespace ew::case_authoring
