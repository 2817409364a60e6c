#pragma once

namespace ew {

/// How probable a chi-square number of `freedoms` degrees of freedom is to be larger than x.
[[nodiscard]] double chanceAbove(double x, int freedoms);

}  // namespace ew
