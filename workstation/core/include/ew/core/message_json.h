#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ew/core/message.h"

namespace ew {

/// Messages in files that the program keeps for itself, so that a later start says them in its own language: what is verbatim as text, a
/// text with its arguments as {"text": "%1 is %2.", "with": ["a", {"number": "0.5"}]}, joined messages as {"between": " ", "with": [...]}.
/// Reports for people and other programs hold english() instead.
void to_json(nlohmann::json& json, const Message& message);
void to_json(nlohmann::ordered_json& json, const Message& message);

/// A text that this program does not have (an older one wrote it) becomes verbatim English. What is no message becomes nothing.
void from_json(const nlohmann::json& json, Message& message);
void from_json(const nlohmann::ordered_json& json, Message& message);

}  // namespace ew
