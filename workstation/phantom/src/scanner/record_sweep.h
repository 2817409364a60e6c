#pragma once

#include "ew/imaging/display.h"
#include "ew/phantom/virtual_sweep.h"

namespace ew::phantom {

/// The image that a sweep's frames are converted to: the whole fan, x towards the marker, y away from the probe, two pixels of margin.
[[nodiscard]] DisplayGeometry imageOf(const Probe& probe, double depth_mm, double pixel_mm);

/// As recordSweep, with the machine given. Its probe and depth must be the recipe's.
[[nodiscard]] Result<VirtualSweep> recordWith(const VirtualScanner& scanner, const Patient& patient, const SweepRecipe& recipe, int threads,
                                              Progress& progress, std::uint64_t maxBytes);

}  // namespace ew::phantom
