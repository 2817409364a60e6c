#pragma once

#include "ew/core/pose.h"
#include "ew/imaging/knobs.h"

namespace ew {

/// Chooses how much work the next frame may be, from how fast the probe moves and what frames took; a value that is stepped, no clock.
/// While the probe moves fast and frames take longer than the budget, quality falls (cubic -> linear -> weave, fewer elevation planes); at
/// rest it returns to what the console asks for.
class AdaptiveQuality {
 public:
  struct Options {
    double budget_ms = 12.0;    ///< a frame may take this long while the probe moves
    double fast_mmPerS = 25.0;  ///< slower counts as resting
    double fast_radPerS = 0.35;
    double settle_s = 0.15;  ///< at rest this long before refining
  };
  AdaptiveQuality() = default;
  explicit AdaptiveQuality(Options options) : options_(options) {}
  /// @param asked   the console
  /// @param pose, time_s of the frame to be made; times that stand still or run backwards count as rest
  /// @param lastFrame_ms what the last frame took, 0 when there was none
  /// @return `asked`, or the same with lower quality
  [[nodiscard]] Knobs step(const Knobs& asked, const Pose& pose, double time_s, double lastFrame_ms);
  /// Whether the last step lowered the quality: then one more frame is due at rest.
  [[nodiscard]] bool isLowered() const { return level_ > 0; }
  void reset() { *this = AdaptiveQuality(options_); }

 private:
  Options options_;
  int level_ = 0;
  bool hasLast_ = false;
  Pose last_;
  double lastTime_s_ = 0.0;
  double restingSince_s_ = 0.0;
};

}  // namespace ew
