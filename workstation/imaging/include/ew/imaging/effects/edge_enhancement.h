#pragma once

#include <span>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {

/// Unsharp masking of the image: out = v + 2 strength (v - b), rounded and clamped, where b is the mean of the 5 x 5 pixels around v
/// with binomial weights (1 4 6 4 1) / 16 along rows and columns. Constants stay and ramps stay. A straight step of height h along the
/// rows or columns overshoots by 5/8 strength h in the pixels beside it and by 1/8 strength h in the next ones, on both sides; elsewhere
/// nothing changes. Within 0.6 grey levels of this formula (16-bit arithmetic), the same on every vector unit.
/// A pixel whose 5 x 5 surroundings are not all inside the fan is left as it is, so that the black around the fan draws no line.
/// @param in, out  the same size, not the same memory; of `out` the pixels of `spans` in rows firstRow .. firstRow + rows - 1 are
///                 written, the others stay as they are. Threads share an image by bands of rows.
/// @param strength 0..1, brought into this range; not a number counts as 0, which copies
void enhanceEdges(double strength, std::span<const std::vector<RowSpan>> spans, ImageView<const std::uint8_t> in, int firstRow, int rows,
                  ImageView<std::uint8_t> out);

}  // namespace ew
