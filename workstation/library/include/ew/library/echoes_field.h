#pragma once

#include "ew/library/case_values.h"

namespace ew {

/// Where Case::otherFields has what forms the echoes of the case's volume (case_echoes.h).
inline constexpr const char* kEchoesField = "echoes";
/// Without it: it is of no other volume.
[[nodiscard]] Case withoutEchoes(Case edited);

}  // namespace ew
