#pragma once

#include <string>

#include "ew/core/message.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

/// One or two words for a list or a status line: "live", "out of view".
[[nodiscard]] Message stateWord(TrackingState state);

/// The state in a sentence that says what to do.
/// @param tool as the tracker names it; empty: none is known yet
[[nodiscard]] Message stateSentence(TrackingState state, const std::string& tool);

}  // namespace ew
