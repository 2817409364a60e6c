#pragma once

#include <filesystem>
#include <string>

namespace ew {

/// A name below `parent` that nothing has: the moment, then `ending` ("-knee"), then a number where that is taken. `parent` is made, the
/// place itself is not.
[[nodiscard]] std::filesystem::path stampedPlace(const std::filesystem::path& parent, const std::string& ending);

}  // namespace ew
