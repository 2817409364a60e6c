#pragma once

#include "scanner/frame_scratch.h"
#include "scanner/scanner_setup.h"

namespace ew::phantom {

/// Adds what a block sends back, its points and its facets, to the fine grid of `work`. Delays along the lines are known, where they count.
void addBlock(const ScannerSetup& setup, const ScattererField& field, const View& view, const FrameScratch::Block& block,
              FrameScratch& work);

}  // namespace ew::phantom
