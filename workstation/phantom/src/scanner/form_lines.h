#pragma once

#include "scanner/frame_scratch.h"
#include "scanner/scanner_setup.h"

namespace ew::phantom {

/// From the fine grid of `work` to envelopes: lateral beam, losses, electronic noise, pulse, gains.
/// @param pitch_mm of the scatterers
/// @param frame    changes the noise alone
/// @param envelope resized to (samples x lines)
void formLines(const ScannerSetup& setup, double pitch_mm, std::uint64_t frame, FrameScratch& work, Image<float>& envelope);

}  // namespace ew::phantom
