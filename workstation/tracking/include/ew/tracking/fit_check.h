#pragma once

#include <deque>
#include <glm/glm.hpp>

#include "ew/core/message.h"
#include "ew/core/pose.h"
#include "ew/tracking/hand.h"

namespace ew {

struct FitCheckOptions {
  double gap_mm = 4.0;        ///< above the skin; a layer of gel and a mannequin of cloth are thinner
  double press_mm = 15.0;     ///< below the skin: deeper than a hand presses a training body
  double forAtLeast_s = 7.0;  ///< of claimed contact within the last 20 s
  double slid_mm = 25.0;      ///< way along the surface meanwhile
  bool operator==(const FitCheckOptions&) const = default;
};

/// Tells when a calibration no longer fits: a probe that scans, as its motion shows, while its face is measured off the skin.
///
/// Nobody tells a tracker that the probe touches. But a hand on skin goes along the surface and keeps its distance from it, whatever
/// distance that is said to be, where a hand that lifts the probe, carries it or lays it down moves away from it or stands still. So
/// contact is claimed by stretches of a second in which the face went along the surface while its distance changed by little of that way,
/// and the beam looked into the body; the distances of such stretches are then asked.
class FitCheck {
 public:
  explicit FitCheck(FitCheckOptions options = {}) : options_(options) {}

  /// @param pose probe in the world, at its time; one that is not ok interrupts
  /// @param skin the mannequin's
  /// @param isUsed the image is live and looked at: not frozen, nothing else covers it
  void add(const Pose& pose, const Skin& skin, bool isUsed);

  /// Empty while it fits or nothing can be said.
  [[nodiscard]] Message problem() const;
  /// Median distance above the skin (below: negative) of the stretches of the last 20 s in which contact was claimed.
  [[nodiscard]] double gap_mm() const { return gap_mm_; }
  void reset();

 private:
  struct Sample {
    double time_s = 0.0;
    glm::dvec3 face_mm{0.0};
    double distance_mm = 0.0;  ///< signed, above the skin
    glm::dvec3 foot_mm{0.0};
    bool looksIn = false;
  };
  struct Stretch {
    double begin_s = 0.0, end_s = 0.0;
    double distance_mm = 0.0, way_mm = 0.0;
  };
  void judgeSecond();
  void judgeStretches();

  FitCheckOptions options_;
  std::deque<Sample> second_;      ///< the samples of the running second
  std::deque<Stretch> stretches_;  ///< that claimed contact, of the last 20 s
  double gap_mm_ = 0.0;
  double claimed_s_ = 0.0;
  bool off_ = false;
};

}  // namespace ew
