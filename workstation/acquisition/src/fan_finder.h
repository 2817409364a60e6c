#pragma once

#include <optional>

#include "ew/acquisition/fan_outline.h"
#include "ew/acquisition/screen.h"

namespace ew::detail {

struct FanFit {
  FanOutline outline;
  double quality = 0.0;
};

/// The outline of what changes, see findScreen(); empty when nothing has the shape of a scan at all.
[[nodiscard]] std::optional<FanFit> findFan(const ScreenStatistics& statistics);

/// The level that most of an image's standing pixels have.
[[nodiscard]] float backgroundOf(const ScreenStatistics& statistics);

}  // namespace ew::detail
