#pragma once

#include <optional>

#include "ew/library/case.h"
#include "ew/sdk/host.h"

namespace ew::lessons {

/// The open case with everything that a lesson of it is judged by; empty: none is open. While the library is locked for trainees the door
/// gives no plugin an answer; practice goes on all the same, so this plugin, which is a part of the program, reads the case's folder.
[[nodiscard]] std::optional<Case> caseAtHand(sdk::Host& host);

}  // namespace ew::lessons
