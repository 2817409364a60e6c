#pragma once

#include <cstdint>
#include <span>

namespace ew {

/// Piecewise linear stretch of `in` (m values) to `out` (n values), the first onto the first and the last onto the last, in fixed point.
/// Exact on constants, and on ramps within one rounding; m = 1 repeats the value; n = 1 gives the first; n < m undersamples.
/// Source: Aiger & Cohen-Or 1998, Eq. 2 and Fig. 5. Ours differs from the printed listing: its step is m / n and reads one value past
/// the input, its interval ends are swapped in the weighting, and 10 bits drift; we step (m - 1) / (n - 1) with 32 fraction bits.
void stretch(std::span<const std::uint8_t> in, std::span<std::uint8_t> out);

}  // namespace ew
