#pragma once

#include <vector>

#include "ew/core/pose.h"
#include "ew/tracking/hand.h"

namespace ew {

/// Where the poses of a probe come from: a hand that slides it on skin, a recording, later a tracker. Whoever scans asks for the pose of a
/// moment and does not change it: a free pose stays free.
class PoseSource {
 public:
  virtual ~PoseSource();
  /// Probe in the world at a moment of the scan's clock, in seconds.
  [[nodiscard]] virtual Pose poseAt(double time_s) const = 0;
  /// Whether the pose may change after that moment without anybody moving anything here: then images are made as time goes on.
  [[nodiscard]] virtual bool movesAfter(double time_s) const = 0;
};

/// A hand that holds the probe on the skin, at every moment as it was held last.
class HandOnSkin final : public PoseSource {
 public:
  HandOnSkin();
  [[nodiscard]] Pose poseAt(double time_s) const override;
  [[nodiscard]] bool movesAfter(double time_s) const override;

  void setHold(const Hold& hold) { hold_ = hold; }
  [[nodiscard]] const Hold& hold() const { return hold_; }

 private:
  Hold hold_;  ///< at first in front of the middle of the trunk, so that there is one before there is a skin
};

struct PoseSample {
  double time_s = 0.0;
  Pose pose;
  bool operator==(const PoseSample&) const = default;
};

/// Poses along a path, one after another: each holds until the next one's time, the first also before its own, the last for ever.
class PosePath final : public PoseSource {
 public:
  /// Expects at least one pose, and times that never fall.
  explicit PosePath(std::vector<PoseSample> poses);
  [[nodiscard]] Pose poseAt(double time_s) const override;
  [[nodiscard]] bool movesAfter(double time_s) const override;

 private:
  std::vector<PoseSample> poses_;
};

}  // namespace ew
