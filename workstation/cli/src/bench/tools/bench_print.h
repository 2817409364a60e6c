#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>

namespace ew::cli {

/// What a bench measured, a line for each row: whatever of "results", "peers", "threads_measured", "confidence", "ratios", "promises" and
/// "must_show" there is.
void printResults(std::ostream& out, const nlohmann::json& measured);

}  // namespace ew::cli
