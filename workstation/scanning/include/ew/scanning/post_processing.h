#pragma once

#include <optional>

#include "ew/imaging/box_zoom.h"
#include "ew/scanning/state.h"

namespace ew {

/// What may still be changed of an image whose echoes are there already: how it is shown. Whatever needs new echoes (depth, gain and TGC,
/// focus, frequency, probe, effects) is no part of it. Empty members stay as scanned, so that one value fits all images of a cine loop.
struct PostProcessing {
  std::optional<GreyMap> greyMap;
  std::optional<double> dynamicRange_db;
  std::optional<bool> markerLeft;
  std::optional<bool> upsideDown;
  std::optional<Detail> detail;  ///< which part is shown, and how large
  bool operator==(const PostProcessing&) const = default;
};

/// The state with these changes; without any, the state itself.
[[nodiscard]] ScanState processed(ScanState state, const PostProcessing& by);

/// Whether two settings differ in nothing but what can be changed afterwards.
[[nodiscard]] bool differInProcessingOnly(const Knobs& a, const Knobs& b);

/// `before`, and over it what leads from one setting to the other. Expects differInProcessingOnly(from, to).
[[nodiscard]] PostProcessing withChange(PostProcessing before, const ScanState& from, const Knobs& to, const Pan& toPan);

/// Whether images made with these knobs leave the same memory of themselves (FrameMemory) with and without `by`.
[[nodiscard]] bool leavesMemory(const PostProcessing& by, const Knobs& knobs);

}  // namespace ew
