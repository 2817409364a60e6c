#pragma once

namespace ew {

/// What twice the power adds on a scale of `greyPerDb` grey levels a decibel: 10 log10(2) dB.
inline float levelsPerDoubling(double greyPerDb) { return static_cast<float>(3.010299956639812 * greyPerDb); }

}  // namespace ew
