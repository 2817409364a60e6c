#pragma once

#include <string>
#include <string_view>

#include "ew/core/json_fields.h"

namespace ew {

/// A text of a data file in the languages of the program.
struct Words {
  std::string english;
  std::string german;
  /// @param language "de" or "de_DE": German; else English
  [[nodiscard]] const std::string& in(std::string_view language) const { return language.starts_with("de") ? german : english; }
  bool operator==(const Words&) const = default;
};

/// {"en": "kidney", "de": "Niere"}: both have to be there, 1 to `longest` bytes each.
/// @param needed false: nothing when the field is not there
[[nodiscard]] Words wordsIn(const JsonFields& fields, std::string_view key, std::size_t longest = 600, bool needed = true);

/// The `format` of a document, a whole number from 1 to the one this program writes. @error newerFormat for a larger one
void requireFormat(const JsonFields& document, int known);

}  // namespace ew
