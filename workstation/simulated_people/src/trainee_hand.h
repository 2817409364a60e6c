#pragma once

#include <algorithm>

#include "ew/simulated_people/trainee_case.h"
#include "ew/simulated_people/trainee_habits.h"
#include "trainee_motion.h"

namespace ew::assessment {

/// A person's hand as it plans a step: it searches, reaches, corrects and sweeps as the person's habits have it.
class TraineeHand {
 public:
  TraineeHand(const TraineeHabits& habits, const Skin& skin, const Probe& probe, RandomNumbers& random, HandPlan& plan)
      : habits_(habits), skin_(skin), probe_(probe), random_(random), plan_(plan) {}

  /// Looks for a hold, and ends near it.
  void find(const Hold& target);
  /// The hold as this person presses it on.
  [[nodiscard]] Hold pressed(const Hold& target);
  /// Sweeps a structure from the view of it, in as many passes as it is wide, then once more across.
  /// @param halfWidth_mm of the image at the structure's depth
  void sweep(const TargetView& view, double halfWidth_mm);
  /// One pass through the middle.
  void lookThrough(const TargetView& view);
  /// Looks about until a moment of the plan.
  void wanderUntil(double time_s);
  void think();
  void pause(double factor = 1.0);

 private:
  [[nodiscard]] bool happens(double probability) { return random_.unit() < probability; }
  [[nodiscard]] int countAbout(double mean);
  /// Within two and a half standard deviations.
  [[nodiscard]] double error(double deviation) { return deviation * std::clamp(random_.normal(), -2.5, 2.5); }
  [[nodiscard]] Hold beside(const Hold& target, double deviation_mm, double deviation_deg);
  [[nodiscard]] Hold missed(const Hold& target, const Route& way, bool isFirst);
  void reach(const Hold& target);
  void move(const Hold& to, double slowest_mmPerS = 0.0);
  void setOutWrongly(const Hold& target);
  void pass(const Hold& from, const Hold& to);
  void sweepAlong(const Hold& middle, const TargetView& view, double halfWidth_mm);

  const TraineeHabits& habits_;
  const Skin& skin_;
  const Probe& probe_;
  RandomNumbers& random_;
  HandPlan& plan_;
};

}  // namespace ew::assessment
