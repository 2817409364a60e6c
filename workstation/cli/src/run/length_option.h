#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew::cli {

/// What an option like --spacing was given, in mm: "0.5" or "0.5,0.5,1.2", one length for all or `count` with commas between them.
/// Errors: badUsage, when they are fewer, more, or not above 0.
[[nodiscard]] Result<std::vector<double>> lengthsGiven(const std::string& option, const std::string& text, std::size_t count);

}  // namespace ew::cli
