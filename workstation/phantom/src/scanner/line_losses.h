#pragma once

#include "scanner/frame_scratch.h"
#include "scanner/scanner_setup.h"

namespace ew::phantom {

/// Losses and delays along every line, in three planes across the slice: `work.gain` and `work.delay_mm`, (lines x steps). The blocks have
/// been found.
void walkLines(const ScannerSetup& setup, const ScattererField& field, const View& view, FrameScratch& work);

}  // namespace ew::phantom
