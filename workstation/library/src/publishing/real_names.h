#pragma once

#include <string_view>

namespace ew {

/// Whether a word is among the commonest given names, or family names, of English and German speaking countries.
[[nodiscard]] bool isCommonGivenName(std::string_view word);
[[nodiscard]] bool isCommonFamilyName(std::string_view word);

}  // namespace ew
