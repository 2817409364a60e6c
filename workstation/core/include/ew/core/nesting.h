#pragma once

#include <string_view>

namespace ew {

/// Deeper than any JSON file of the program; writing out or destroying a value recurses once a level, so a text from outside that nests
/// without bound would end the program.
inline constexpr int kDeepestNesting = 200;

/// Whether braces and brackets of a JSON text, outside of its strings, nest deeper than `limit`. The text need not be valid.
[[nodiscard]] bool nestsDeeperThan(std::string_view jsonText, int limit = kDeepestNesting);

}  // namespace ew
