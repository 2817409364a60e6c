#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "ew/core/json_fields.h"

namespace ew {

// Moments as files have them: "2026-11-26T09:30:00Z".

[[nodiscard]] std::string timestampText(std::chrono::sys_seconds moment);
/// Empty: no such moment.
[[nodiscard]] std::optional<std::chrono::sys_seconds> timestampOf(const std::string& text);
/// A field that holds one; refused when it holds anything else, or is missing though `needed`.
std::optional<std::chrono::sys_seconds> readTimestamp(const JsonFields& fields, std::string_view key, bool needed);

}  // namespace ew
