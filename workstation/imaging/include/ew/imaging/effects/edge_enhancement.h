#pragma once

#include <span>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {

/// Unsharp masking of the picture: v + strength * kernel difference, clamped and rounded. Constants stay, ramps stay inside the fan.
/// @param in, out  the same size, not the same memory; rows [firstRow, firstRow + rows) of `out` are made
/// @param strength 0..1
void enhanceEdges(double strength, std::span<const std::vector<RowSpan>> spans, ImageView<const std::uint8_t> in, int firstRow, int rows,
                  ImageView<std::uint8_t> out);

}  // namespace ew
