#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace ew {

/// A self-contained page (no network, light and dark) with a curve of accuracy against time for each volume of a slicing report, the
/// figures as a table, and the machine they were measured on.
/// @param report what benchSlicing returns
[[nodiscard]] std::string slicingPage(const nlohmann::json& report);

}  // namespace ew
