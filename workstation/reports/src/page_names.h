#pragma once

#include <string>
#include <string_view>

namespace ew::reports {

/// A name for a file: letters, digits, '-' and '_' stay, everything else becomes '-'; at most 100 characters, never empty.
[[nodiscard]] std::string plainName(std::string_view name);

}  // namespace ew::reports
