#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ew/phantom/patient.h"

namespace ew {

inline constexpr std::size_t kLargestTruthFile_bytes = 4u << 20;

/// What a patient knows about itself, as text for the cache: measurements, standard planes, organs with their labels.
/// @error as measurementsOf
[[nodiscard]] Result<std::string> truthOfPatient(const Patient& patient, Progress& progress);

}  // namespace ew
