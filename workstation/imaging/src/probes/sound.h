#pragma once

namespace ew::detail {

/// In soft tissue, as machines take it everywhere.
inline constexpr double kSpeedOfSound_mmPerS = 1.54e6;

}  // namespace ew::detail
