#pragma once

#include "ew/imaging/slice_source.h"

namespace ew {

/// What slices of a volume cost from rows and from bricks, on the machine, with the instruction set and beside the neighbours it was timed
/// with. Pictures are the same from both.
struct LayoutTimes {
  double rows_us = 0.0;  ///< geometric mean over directions and over weave, linear and cubic sampling; one thread, 200 x 200 pixels
  double bricks_us = 0.0;
  [[nodiscard]] bool bricksAreFaster() const { return bricks_us < rows_us; }
};

/// Times both in turns, for about a tenth of a second of the calling thread.
/// @param bricks made of `volume`
[[nodiscard]] LayoutTimes timeLayouts(const VolumeView<const std::uint8_t>& volume, const BrickedVolume& bricks);

}  // namespace ew
