#pragma once

#include <nlohmann/json.hpp>

#include "ew/phantom/patient.h"

namespace ew {

/// What a patient knows about itself, for the cache: measurements, standard planes, organs with their labels.
/// @error as measurementsOf
[[nodiscard]] Result<nlohmann::json> truthOfPatient(const Patient& patient, Progress& progress);

}  // namespace ew
