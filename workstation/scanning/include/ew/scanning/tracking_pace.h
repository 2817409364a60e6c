#pragma once

#include <algorithm>

namespace ew {

/// When the next image of a tracked probe is made: at once of a reading that arrives from `earliest_s` on, and at `latest_s` without one,
/// so that what changes by itself goes on and a loss is seen. One that arrives sooner is left to the next: an image at `earliest_s` would
/// show it when it is old, and delay the newer one behind.
struct TrackingPace {
  double earliest_s = 0.0;
  double latest_s = 0.0;
  bool operator==(const TrackingPace&) const = default;
};

/// An image takes 25 ms at least, so that a reading may come 8 ms early: every frame of a camera of 30 a second makes one, every second
/// one of 60, every third one of 100. At least half of the time is left to the hand and the window, as long as frames take less than 0.2 s.
/// @param begin_s when the last image was begun  @param spent_s what it took, with all who show it
[[nodiscard]] inline TrackingPace trackedPace(double begin_s, double spent_s) {
  constexpr double kPeriod_s = 0.025;
  constexpr double kWithoutNews_s = 0.045;  // longer than a camera's period: an image of no news would delay the reading behind
  constexpr double kLongestRest_s = 0.2;
  const double rested_s = begin_s + spent_s + std::min(spent_s, kLongestRest_s);
  return {std::max(begin_s + kPeriod_s, rested_s), std::max(begin_s + kWithoutNews_s, rested_s)};
}

}  // namespace ew
