#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "ew/phantom/patient.h"
#include "run/command.h"

namespace ew::cli {

/// What `phantom` is asked about blood.
struct FlowArguments {
  std::optional<std::vector<double>> at_mm;  ///< of --blood: x y z in the world
  double time_s = 0.0;
};

/// For TRUTH.json: streams, what Doppler finds half way along each (of a tree: along its first root), and its narrow places.
/// All of it for the body at rest.
[[nodiscard]] nlohmann::json flowTruthOf(const Patient& patient);

/// Tells what blood does at the place and time that were asked for, on the screen and in the report's details.
/// @error notFound (no vessel is there), unsupported (the recipe has no flow)
[[nodiscard]] Result<void> tellBlood(const FlowArguments& arguments, const Patient& patient, Run& run);

}  // namespace ew::cli
