#include "making/preparation_clock.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

double secondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// A step and how long all will take, no finer than can be known: a console that prints each change would be full of them.
Message withTimeLeft(const Message& step, double left_s) {
  constexpr double kCoarse_min = 10.0;
  const double left_min = left_s / 60.0;
  if (left_min > kCoarse_min) return say<"%1, %2 min left">(step, 5 * static_cast<int>(std::ceil(left_min / 5.0)));
  if (left_min > 1.0) return say<"%1, %2 min left">(step, static_cast<int>(std::ceil(left_min)));
  return say<"%1, %2 s left">(step, 10 * std::max(1, static_cast<int>(std::ceil(left_s / 10.0))));
}

}  // namespace

double PreparationClock::total_s(double expected_s, double passed_s, double fraction) {
  const double done = std::clamp(fraction, 0.0, 1.0);
  const double atLeast_s = std::max(expected_s, passed_s);
  if (done <= 0.0) return atLeast_s;
  const double trust = std::min(1.0, 3.0 * done);
  return (1.0 - trust) * atLeast_s + trust * passed_s / done;
}

double PreparationClock::steadied_s(double shown_s, double since_s, double estimate_s) {
  constexpr double kNears_s = 20.0;
  if (shown_s < 0.0) return estimate_s;
  const double expected_s = std::max(0.0, shown_s - since_s);
  return expected_s + (estimate_s - expected_s) * (1.0 - std::exp(-since_s / kNears_s));
}

void PreparationClock::goOn(double share) {
  const std::lock_guard lock(guard_);
  if (at_ >= steps_.size() || !(share > 0.0)) return;
  double all_s = 0.0;
  for (const Step& each : steps_) all_s += each.expected_s;
  const double done_s = share * steps_[at_].expected_s;
  if (all_s > 0.0) before_ = std::clamp(before_ + (1.0 - before_) * done_s / all_s, 0.0, 0.99);
  steps_[at_].expected_s -= done_s;
  shownLeft_s_ = -1.0;
}

double PreparationClock::correctionOf(int kind) const {
  double expected_s = 0.0;
  double took_s = 0.0;
  for (const Finished& each : finished_) {
    if (each.kind != kind) continue;
    expected_s += each.expected_s;
    took_s += each.took_s;
  }
  return expected_s > 0.0 ? took_s / expected_s : 1.0;
}

void PreparationClock::finishStep() {
  if (!begun_ || at_ >= steps_.size()) return;
  finished_.push_back({steps_[at_].kind, steps_[at_].expected_s, sinceBegin_s()});
  ++at_;
}

void PreparationClock::begin(int kind, Message what) {
  {
    const std::lock_guard lock(guard_);
    finishStep();
    const auto next =
        std::find_if(steps_.begin() + static_cast<std::ptrdiff_t>(at_), steps_.end(), [&](const Step& s) { return s.kind == kind; });
    if (next == steps_.end())
      steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(at_), Step{kind, 0.0});
    else
      at_ = static_cast<std::size_t>(next - steps_.begin());
    begun_ = true;
    what_ = std::move(what);
    stepStarted_ = Clock::now();
  }
  report({}, 0.0);
}

double PreparationClock::sinceBegin_s() const { return secondsBetween(stepStarted_, Clock::now()); }

void PreparationClock::report(const Message&, double fraction) {
  const std::lock_guard lock(guard_);
  const Step now = at_ < steps_.size() ? steps_[at_] : Step{};
  const double inStep_s = sinceBegin_s();
  const double expected_s = total_s(now.expected_s * correctionOf(now.kind), inStep_s, fraction);
  // The step in work corrects those of its kind at once: the first recording tells how long the others will take.
  finished_.push_back({now.kind, now.expected_s, expected_s});
  double rest_s = std::max(0.0, expected_s - inStep_s);
  for (std::size_t n = at_ + 1; n < steps_.size(); ++n) rest_s += steps_[n].expected_s * correctionOf(steps_[n].kind);
  finished_.pop_back();
  const double passed_s = secondsBetween(started_, Clock::now());
  const double part = passed_s + rest_s > 0.0 ? passed_s / (passed_s + rest_s) : 0.0;
  furthest_ = std::max(furthest_, before_ + (1.0 - before_) * part);
  shownLeft_s_ = steadied_s(shownLeft_s_, passed_s - shownAt_s_, rest_s);
  shownAt_s_ = passed_s;
  whole_.report(withTimeLeft(what_, shownLeft_s_), furthest_);
}

}  // namespace ew
