#pragma once

#include "ew/core/pose.h"
#include "ew/imaging/knobs.h"

namespace ew {

/// Chooses how much work the next frame may be, from how fast the probe moves and what frames took; a value that is stepped, no clock.
/// While the probe moves fast, each frame that takes longer than the budget lowers the quality by a step, one that takes more than twice
/// the budget by two: cubic to linear, then two elevation planes fewer at a time down to 3, then linear to weave. It never rises while the
/// probe moves, so it cannot flicker; at rest it returns at once to what the console asks for, however long frames take then.
/// Live echoes have no planes: their quality (echo_quality.h) falls from step to step.
class AdaptiveQuality {
 public:
  struct Options {
    double budget_ms = 12.0;    ///< a frame may take this long while the probe moves
    double fast_mmPerS = 25.0;  ///< of the face; faster than one of these two counts as moving, until both stay below half of them
    double fast_radPerS = 0.35;
    double settle_s = 0.15;  ///< at rest this long before refining
  };
  AdaptiveQuality() = default;
  explicit AdaptiveQuality(Options options) : options_(options) {}
  /// @param asked   the console
  /// @param pose    of the frame to be made; one that is not PoseStatus::ok or not finite counts as rest
  /// @param time_s  of the frame to be made; one that stands still, runs backwards or is not finite counts as rest that lasts no time
  /// @param lastFrame_ms what the last frame took, 0 when there was none; not a number counts as 0
  /// @param hasPlanes whether fewer elevation planes are less work: not for live echoes
  /// @return `asked`, or the same with lower quality
  [[nodiscard]] Knobs step(const Knobs& asked, const Pose& pose, double time_s, double lastFrame_ms, bool hasPlanes = true);
  /// Whether the last step lowered the quality: then one more frame is due at rest.
  [[nodiscard]] bool isLowered() const { return level_ > 0; }
  void reset() { *this = AdaptiveQuality(options_); }

 private:
  enum class Speed { resting, slowing, fast };
  [[nodiscard]] Speed speedTo(const Pose& pose, double time_s);

  Options options_;
  int level_ = 0;
  bool moving_ = false;
  bool hasLast_ = false;
  Pose last_;  ///< the last usable one
  double lastPose_s_ = 0.0;
  double lastTime_s_ = 0.0;
  double rest_s_ = 0.0;  ///< how long it rests by now
};

}  // namespace ew
