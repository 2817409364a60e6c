#pragma once

#include <nlohmann/json.hpp>

#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/scanning/events.h"

namespace ew {

/// An event as recordings keep it; of a frame, which a sequence file keeps in fields of its own, what the journal of a recording keeps.
[[nodiscard]] nlohmann::json jsonOf(const ScanEvent& event);
/// eventOf(jsonOf(e)) == e. @param where of the file, as sentences name it: say<"frame %1 of %2">(3, "scan.mha") @error badField
[[nodiscard]] Result<ScanEvent> eventOf(const nlohmann::json& object, const Message& where);

}  // namespace ew
