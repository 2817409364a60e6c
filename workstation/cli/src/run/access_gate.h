#pragma once

#include <optional>
#include <string_view>

#include "ew/core/result.h"
#include "ew/library/access.h"

namespace ew::cli {

/// What a command needs while the library is locked for trainees; nothing: it may be used by anybody. Commands that are not known to be
/// harmless, those of plugins among them, need to see answers.
/// @param command with its group: "lesson show"
[[nodiscard]] std::optional<Permission> permissionFor(std::string_view command);

/// Lets a command through, or not. @param unlockFrom of --unlock, empty: nobody gives a passphrase
/// @error as AccessPolicy::require, AccessPolicy::unlock, readPassphrase
[[nodiscard]] Result<void> passGate(std::string_view command, const std::string& unlockFrom, AccessPolicy& policy);

}  // namespace ew::cli
