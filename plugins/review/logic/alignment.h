#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/scanning/events.h"
#include "logic/review_clock.h"

namespace ew::review {

struct AlignmentOptions {
  double step_s = 0.1;           ///< poses that are nearer to each other than this are not all compared
  std::size_t mostPoses = 6000;  ///< of each scan; a longer one is compared in larger steps
  std::uint64_t mostBytes = 256u << 20;
};

/// Which moment of one scan shows the probe where the other one has it at a moment: two scans of the same way at different paces.
class Alignment {
 public:
  /// By dynamic time warping (ew/assessment/time_warping.h) over the poses that are valid; what happens between two of them goes on evenly.
  /// @error noValidPose (in one of the parts), cancelled, tooLarge
  [[nodiscard]] static Result<Alignment> of(const ScanLog& first, const Part& firstPart, const ScanLog& second, const Part& secondPart,
                                            Progress& progress = noProgress(), const AlignmentOptions& options = {});

  /// On the second's clock; never falls with `first_s`, and stays within both parts.
  [[nodiscard]] double inSecond_s(double first_s) const;
  /// The earliest moment of the first that goes with a moment of the second.
  [[nodiscard]] double inFirst_s(double second_s) const;
  /// How far apart both probes are on the way, on the average of the pairs (poseDistance_mm).
  [[nodiscard]] double mean_mm() const { return mean_mm_; }

 private:
  std::vector<double> first_s_, second_s_;  ///< knots, rising
  double mean_mm_ = 0.0;
};

/// Where both scans stand when the review's clock shows a moment. The clock's 0 is where the first one's part begins.
class TwoScans {
 public:
  TwoScans() = default;
  TwoScans(const Part& first, const Part& second) : first_(first), second_(second) {}

  /// Same seconds from each beginning; the second begins `offset_s` later.
  void setOneClock(double offset_s);
  /// The clock is the first one's; the second follows it where its probe was. Null: one clock again.
  void setAligned(std::shared_ptr<const Alignment> alignment) { alignment_ = std::move(alignment); }
  [[nodiscard]] bool isAligned() const { return alignment_ != nullptr; }
  [[nodiscard]] const std::shared_ptr<const Alignment>& alignment() const { return alignment_; }
  [[nodiscard]] double offset_s() const { return offset_s_; }
  [[nodiscard]] const Part& first() const { return first_; }
  [[nodiscard]] const Part& second() const { return second_; }

  /// What the clock runs over: both of them on one clock, the first when they are aligned.
  [[nodiscard]] Part range() const;
  /// On each recording's own clock; before its beginning and after its end it shows its first and its last moment.
  [[nodiscard]] double inFirst_s(double clock_s) const;
  [[nodiscard]] double inSecond_s(double clock_s) const;
  /// On the review's clock.
  [[nodiscard]] double fromFirst_s(double time_s) const;
  [[nodiscard]] double fromSecond_s(double time_s) const;

 private:
  Part first_, second_;
  double offset_s_ = 0.0;
  std::shared_ptr<const Alignment> alignment_;
};

}  // namespace ew::review
