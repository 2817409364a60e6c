#pragma once

#include <string>

#include "ew/core/frames.h"

namespace ew {

namespace frame {
struct Tracker {};  ///< what a tracker measures in: its own origin and axes, or those of a reference tool where one is chosen; mm
struct Tool {};     ///< a marker body or sensor as the tracker reports it; mm
}  // namespace frame

/// How it stands with the pose of a tool. Never encoded in a matrix: trackers report a loss with identity, zeros or the last good pose.
enum class TrackingState {
  live,        ///< measured just now
  outOfRange,  ///< seen, but where it cannot be measured well enough to be shown
  outOfView,   ///< the tracker runs and does not see the tool
  invalid,     ///< the tracker sends something that is no pose: not finite, not rigid, or marked as bad
  duplicate,   ///< the tracker sends one and the same reading again and again
  stale,       ///< connected, but nothing has come for longer than half a second
  lost,        ///< the tracker itself is gone: connection closed, camera unplugged, file at its end
  off,         ///< not started
};

/// What a tracker tells of one tool at one moment.
struct ToolReading {
  std::string tool;  ///< as the tracker names it
  /// Rigid where the state is live or outOfRange; without meaning otherwise.
  Transform<frame::Tracker, frame::Tool> toolToTracker;
  TrackingState state = TrackingState::live;
  double device_s = 0.0;    ///< when it was measured, on the tracker's own clock; not a number: the tracker stamps nothing
  double arrival_s = 0.0;   ///< when it came here, on steadyNow_s()
  double spread_mm = 0.0;   ///< standard deviation of the origin's position as the tracker judges it; 0: it does not say
  double spread_rad = 0.0;  ///< the same of the turn
  bool operator==(const ToolReading&) const = default;
};

/// Seconds on the clock of this computer that never jumps and is the same in all threads.
[[nodiscard]] double steadyNow_s();

}  // namespace ew
