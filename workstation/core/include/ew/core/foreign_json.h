#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/nesting.h"
#include "ew/core/result.h"

namespace ew {

// JSON of other programs, of which nothing is known: answers of servers, notes and states that somebody else may have written. Whatever it
// holds, nothing here throws. Files of a user are read with JsonFields, which says what is wrong with them (json_fields.h). tests/rules
// keeps json::parse() and the getters of the JSON library that throw out of everything else.

/// What a document may be at most.
struct JsonLimits {
  std::size_t bytes = std::size_t{64} << 20;  ///< of its text
  int depth = kDeepestNesting;                ///< of its objects and lists: writing out or destroying a value recurses
};

/// @param where how sentences name the document: verbatim("LMS.LaunchData")
/// @error tooLarge (longer than the limit), badHeader (nests too deeply, or is not valid, with line and column)
[[nodiscard]] Result<nlohmann::json> parseJson(std::string_view text, const Message& where, const JsonLimits& limits);

/// The document, or null when it cannot be read: for whoever then does as if nothing had been there.
[[nodiscard]] nlohmann::json jsonOrNull(std::string_view text, const JsonLimits& limits = {});

/// What stands at `key`; null when `of` is no object or has no such field. Valid as long as `of`.
[[nodiscard]] const nlohmann::json& memberOf(const nlohmann::json& of, std::string_view key);
/// The text at `key`; `fallback` when there is none or it is no text.
[[nodiscard]] std::string textAt(const nlohmann::json& of, std::string_view key, std::string fallback = {});
/// The text at `key`, or whatever stands there, written as JSON; empty when nothing does.
[[nodiscard]] std::string wordsAt(const nlohmann::json& of, std::string_view key);
/// A finite number.
[[nodiscard]] std::optional<double> numberAt(const nlohmann::json& of, std::string_view key);
/// A whole number that 64 bits hold, written as one.
[[nodiscard]] std::optional<long long> wholeAt(const nlohmann::json& of, std::string_view key);
[[nodiscard]] bool flagAt(const nlohmann::json& of, std::string_view key, bool fallback = false);
/// The texts in the list at `key`; what is none is left out.
[[nodiscard]] std::vector<std::string> textsAt(const nlohmann::json& of, std::string_view key);
/// The list at `key`; an empty one when there is none. Valid as long as `of`.
[[nodiscard]] const nlohmann::json& listAt(const nlohmann::json& of, std::string_view key);

}  // namespace ew
