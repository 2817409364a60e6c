#pragma once

#include "ew/io/sequence.h"

namespace ew::detail {

/// Whether a matrix can be part of a chain, whatever its status says: finite, affine, and neither flat nor zero.
[[nodiscard]] bool isUsable(const NamedTransform& transform);

}  // namespace ew::detail
