#pragma once

#include "scanner/frame_scratch.h"
#include "scanner/scanner_setup.h"

namespace ew::phantom {

/// The blocks that the slice meets, into `work`; one that nobody met before is filled, which takes its time.
/// @return false when the work was stopped
[[nodiscard]] bool findBlocks(const ScannerSetup& setup, const ScattererField& field, const View& view, FrameScratch& work);

/// Number of the tissue at a place of the resting body; ScattererBlock::kOutside outside it and beyond the blocks that were found.
[[nodiscard]] std::uint8_t tissueAt(const ScattererField& field, const glm::dvec3& rest, const FrameScratch& work);

/// How a block's points come to lie in the probe frame. Shared corners of deformed blocks are kept in `work`.
[[nodiscard]] Trilinear motionOf(const ScattererField& field, const View& view, const glm::ivec3& index, FrameScratch& work);

}  // namespace ew::phantom
