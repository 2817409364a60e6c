#pragma once

#include <chrono>
#include <mutex>
#include <vector>

#include "ew/core/progress.h"

namespace ew {

/// Turns the progress of steps of very different length into one of time: the fraction is the time that passed over the time it will take,
/// and the step's words end with the time left. What finished steps of a kind took corrects what is expected of the others.
class PreparationClock final : public Progress {
 public:
  struct Step {
    int kind = 0;
    double expected_s = 0.0;
  };
  PreparationClock(Progress& whole, std::vector<Step> steps) : whole_(whole), steps_(std::move(steps)) {}

  /// Begins the next step of that kind, ending the one before; one that nobody expected (damage in the cache) counts as taking no time.
  void begin(int kind, Message what);
  /// A part of the step that is under way was done by an earlier run: what is shown begins there, and only the rest takes time.
  void goOn(double share);
  /// Seconds the step that is under way has taken.
  [[nodiscard]] double sinceBegin_s() const;
  void report(const Message& what, double fraction) override;
  [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

  /// Seconds that a step will take of which `fraction` is done after `passed_s`. The further it is, the more its own speed counts and the
  /// less what was expected of it; from a third on nothing else counts.
  [[nodiscard]] static double total_s(double expected_s, double passed_s, double fraction);
  /// The time left as it is told: a new estimate is not jumped to but neared, so that a person can believe what is shown.
  /// @param shown_s as it was told `since_s` ago; negative: never
  [[nodiscard]] static double steadied_s(double shown_s, double since_s, double estimate_s);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double correctionOf(int kind) const;
  void finishStep();

  Progress& whole_;
  std::vector<Step> steps_;
  std::mutex guard_;  // of what follows: steps report from their worker threads
  std::size_t at_ = 0;
  bool begun_ = false;
  Message what_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point stepStarted_ = started_;
  double furthest_ = 0.0;
  double before_ = 0.0;  ///< the part of all that earlier runs have done
  double shownLeft_s_ = -1.0;
  double shownAt_s_ = 0.0;
  struct Finished {
    int kind = 0;
    double expected_s = 0.0;
    double took_s = 0.0;
  };
  std::vector<Finished> finished_;
};

}  // namespace ew
