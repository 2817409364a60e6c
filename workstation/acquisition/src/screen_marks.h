#pragma once

#include <optional>
#include <vector>

#include "ew/acquisition/screen.h"

namespace ew::detail {

/// Text over the scan, and across its edge: boxes that do not overlap.
[[nodiscard]] std::vector<PixelRect> findText(const ScreenStatistics& statistics, const FanOutline& outline);

/// Tick marks beside the scan.
[[nodiscard]] std::optional<DepthTicks> findTicks(const ScreenStatistics& statistics, const FanOutline& outline, float background);

/// What stands beside the scan.
[[nodiscard]] std::vector<ScreenPart> findBeside(const ScreenStatistics& statistics, const FanOutline& outline, float background,
                                                 const std::optional<DepthTicks>& ticks);

/// Boxes that overlap become the box that holds them.
[[nodiscard]] std::vector<PixelRect> withoutOverlap(std::vector<PixelRect> boxes);

}  // namespace ew::detail
