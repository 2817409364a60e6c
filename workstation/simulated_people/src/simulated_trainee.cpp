#include "ew/simulated_people/simulated_trainee.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/find_entry.h"
#include "ew/imaging/display.h"
#include "trainee_answers.h"
#include "trainee_hand.h"
#include "trainee_machine.h"

namespace ew {
namespace {

using assessment::HandNoise;
using assessment::HandPlan;
using assessment::Machine;
using assessment::RandomNumbers;
using assessment::TraineeHand;

constexpr double kLettersPerS = 18.0;    // that anybody reads
constexpr double kBetweenSteps_s = 3.0;  // to read what is said after a step
constexpr double kFreezes_s = 0.4;       // from the last image to the key
constexpr double kCaliper_s = 2.5, kClick_s = 2.0, kHint_s = 4.0;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// Half of an image's width at a depth.
double halfWidthAt_mm(const Fan& fan, double depth_mm) {
  constexpr double kStep_mm = 1.0, kWidest_mm = 300.0;
  const double within_mm = std::clamp(depth_mm, 1.0, 0.95 * fan.depth_mm);
  double half_mm = kStep_mm;
  while (half_mm < kWidest_mm && placeInFan(fan, {half_mm, within_mm})) half_mm += kStep_mm;
  return half_mm;
}

/// One person's way through one lesson.
class Working {
 public:
  Working(const TraineeCase& on, const TraineeHabits& habits, std::uint64_t seed, const SimulationOptions& options)
      : on_(on), habits_(habits), seed_(seed), options_(options), random_(seed), noise_(random_), now_(on.start()) {
    state_.probe = on.probes().front();
    state_.scene = on.teaching().opened.scene;
  }

  /// @param number of the step; @param isLastScan no step after it is scanned
  SimulatedStep work(const LessonStep& step, std::size_t number, bool isLastScan) {
    isLastScan_ = isLastScan;
    random_ = RandomNumbers(assessment::seedOf(seed_, number));
    SimulatedStep made;
    made.stepId = step.id;
    begin_s_ = time_s_;
    limit_s_ = step.time_s ? begin_s_ + *step.time_s : kNever_s;
    const auto hints = static_cast<double>(step.hints.size());
    made.hints = static_cast<int>(std::min(hints, std::floor(-habits_.hints * std::log(1.0 - 0.99 * random_.unit()) + 0.5)));
    reading_s_ = static_cast<double>(step.text.size() + step.lookFor.size()) / kLettersPerS * std::exp(0.2 * random_.normal());
    std::visit([&](const auto& task) { take(task, made); }, step.task);
    time_s_ = std::min(time_s_ + kHint_s * made.hints, limit_s_);
    made.seconds = time_s_ - begin_s_;
    time_s_ += kBetweenSteps_s;
    return made;
  }

 private:
  // Steps without a scan.
  void take(const ReadingTask&, SimulatedStep&) { time_s_ += reading_s_; }
  void take(const WatchTask& task, SimulatedStep& made) {
    time_s_ += reading_s_ + on_.lengthOf_s(task.recording);
    made.answer = WatchAnswer{true};
  }
  void take(const AnswerTask& task, SimulatedStep& made) {
    for (const AnswerOption& option : task.options) reading_s_ += static_cast<double>(option.text.size()) / kLettersPerS;
    time_s_ += reading_s_ + habits_.thinking_s * std::exp(0.3 * random_.normal());
    if (time_s_ <= limit_s_) made.answer = assessment::answerBy(habits_, random_, task);
  }

  // Steps with one. What stands in front of them is read while the probe rests on the skin.
  void take(const PlaneTask& task, SimulatedStep& made) {
    const TargetView* view = on_.viewOf(TargetKind::plane, task.target);
    scan(view, made, [&](TraineeHand& hand, HandPlan&) {
      if (view != nullptr) hand.find(hand.pressed(view->hold));
    });
  }
  void take(const SweepTask& task, SimulatedStep& made) {
    const TargetView* view = on_.viewOf(TargetKind::place, task.target);
    scan(view, made, [&](TraineeHand& hand, HandPlan&) {
      if (view != nullptr) hand.sweep(*view, halfWidthAt_mm(fan(), view->depth_mm));
    });
  }
  void take(const FreeTask& task, SimulatedStep& made) {
    scan(nullptr, made, [&](TraineeHand& hand, HandPlan& plan) {
      for (const std::string& name : task.targets) visit(name, hand, plan);
      hand.wanderUntil(begin_s_ + task.shortest_s + 0.5);
    });
  }
  void take(const SettingsTask& task, SimulatedStep& made) {
    asked_ = &task;
    scan(nullptr, made, [&](TraineeHand&, HandPlan&) {});
    asked_ = nullptr;
  }
  void take(const PointTask& task, SimulatedStep& made) {
    const TargetView* view = on_.viewOf(TargetKind::place, task.target);
    const auto* point = entryNamed(on_.teaching().truth.points, task.target);
    const auto* structure = point == nullptr ? entryNamed(on_.teaching().truth.structures, task.target) : nullptr;
    const int label = structure != nullptr ? structure->label : 0;
    scan(view, made, [&](TraineeHand& hand, HandPlan& plan) {
      constexpr int kTries = 3;  // whoever does not see it looks again
      for (int n = 0; n < kTries && view != nullptr; ++n) {
        hand.find(hand.pressed(view->hold));
        if (label == 0 || !on_.teaching().labels) break;
        if (sectionOf(*on_.teaching().labels, label, fan(), poseOf(plan.now())).area_mm2 > 0.0) break;
      }
    });
    time_s_ += kClick_s * std::exp(0.3 * random_.normal());
    if (made.log.frameCount() == 0 || time_s_ > limit_s_ || (point == nullptr && structure == nullptr)) return;
    const glm::dvec3 at_mm = point != nullptr ? point->at_mm : on_.ground()->organ(label)->middle_mm();
    made.answer = assessment::pointedBy(habits_, random_, on_, label, at_mm, state_);
  }
  void take(const MeasureTask& task, SimulatedStep& made) {
    const TargetView* view = on_.viewOf(TargetKind::measurement, task.measurement);
    const auto* expected = entryNamed(on_.teaching().truth.measurements, task.measurement);
    scan(view, made, [&](TraineeHand& hand, HandPlan&) {
      if (view != nullptr) hand.find(hand.pressed(view->hold));
    });
    if (expected == nullptr) return;
    const auto calipers = static_cast<double>(std::max<std::size_t>(2, expected->points_mm.size()));
    time_s_ += calipers * kCaliper_s * std::exp(0.3 * random_.normal());
    if (made.log.frameCount() == 0 || time_s_ > limit_s_) return;
    made.answer = assessment::measuredBy(habits_, random_, *expected, state_);
  }

  void visit(const std::string& name, TraineeHand& hand, HandPlan& plan) {
    if (random_.unit() < habits_.missedTarget) return;
    if (const TargetView* plane = on_.viewOf(TargetKind::plane, name)) {
      hand.find(hand.pressed(plane->hold));
      plan.rest(1.0);
    }
    if (const TargetView* place = on_.viewOf(TargetKind::place, name)) {
      hand.find(hand.pressed(place->hold));
      hand.lookThrough(*place);
    }
  }

  [[nodiscard]] Fan fan() const { return {state_.probe, resolvedDepth_mm(state_.probe, state_.knobs)}; }

  /// Sets the machine as the expert had it near the target, or as the step asks.
  double setMachine(const TargetView* view, double from_s, HandPlan& plan) {
    ScanState set = state_;
    double time_s = from_s;
    if (asked_ != nullptr && !asked_->probes.empty()) {
      set.probe = assessment::chosenProbe(habits_, random_, on_.probes(), asked_->probes, state_.probe);
      if (!(set.probe == state_.probe)) plan.set(time_s, set.probe, set.knobs);
      time_s += 2.0;
    }
    ScanState expert = set;
    expert.knobs = on_.expertKnobsAt(poseOf(view != nullptr ? view->hold : now_));
    Machine wanted = assessment::machineOf(expert);
    if (asked_ != nullptr) wanted = assessment::withBands(wanted, *asked_);
    return assessment::turnKnobs(set, assessment::setBy(habits_, random_, set, wanted, asked_ != nullptr), time_s, plan);
  }

  template <class Plan>
  void scan(const TargetView* view, SimulatedStep& made, const Plan& planned) {
    HandPlan plan(now_, time_s_);
    TraineeHand hand(habits_, *on_.teaching().skin, state_.probe, random_, plan);
    plan.rest(reading_s_);
    hand.think();
    const double set_s = setMachine(view, plan.end_s(), plan);
    if (asked_ != nullptr) plan.rest(std::max(0.5, set_s + 0.5 - plan.end_s()));
    planned(hand, plan);
    plan.rest(kFreezes_s);
    lookOn(hand, plan);
    const double until_s = std::min(plan.end_s(), limit_s_);
    const assessment::Liftings liftings(habits_.contactLoss, plan.begin_s(), until_s, random_);
    assessment::Filming(*on_.teaching().skin, on_.skinDistance(), options_.rate_hz, noise_)
        .film(plan, habits_, liftings, until_s, state_, made.log, options_.stopped);
    if (made.log.frameCount() > 0) now_ = plan.end_s() <= limit_s_ ? plan.now() : holdFor(state_.pose, *on_.teaching().skin);
    time_s_ = until_s;
    scanned_s_ += until_s - plan.begin_s();
    if (asked_ == nullptr && made.log.frameCount() > 0) made.log.setFrozen(time_s_, true);
  }

  /// In the lesson's last scan, until there has been enough of it.
  void lookOn(TraineeHand& hand, HandPlan& plan) {
    if (!isLastScan_) return;
    const double missing_s = options_.shortest_s - scanned_s_ - (plan.end_s() - plan.begin_s());
    if (missing_s > 0.0 && !(options_.stopped && options_.stopped())) hand.wanderUntil(plan.end_s() + missing_s);
  }

  const TraineeCase& on_;
  const TraineeHabits& habits_;
  std::uint64_t seed_;
  const SimulationOptions& options_;
  RandomNumbers random_;
  HandNoise noise_;
  Hold now_;
  ScanState state_;
  const SettingsTask* asked_ = nullptr;
  bool isLastScan_ = false;
  double time_s_ = 0.0, begin_s_ = 0.0, limit_s_ = kNever_s, reading_s_ = 0.0, scanned_s_ = 0.0;
};

bool needsImage(const LessonTask& task) {
  return !std::holds_alternative<ReadingTask>(task) && !std::holds_alternative<WatchTask>(task) &&
         !std::holds_alternative<AnswerTask>(task);
}

}  // namespace

std::vector<SimulatedStep> simulateAttempt(const Lesson& lesson, const TraineeCase& on, const TraineeHabits& habits, std::uint64_t seed,
                                           const SimulationOptions& options) {
  std::vector<SimulatedStep> steps;
  Working working(on, habits, seed, options);
  const auto lastScan = std::find_if(lesson.steps.rbegin(), lesson.steps.rend(), [](const LessonStep& s) { return needsImage(s.task); });
  for (std::size_t n = 0; n < lesson.steps.size(); ++n) {
    if (options.stopped && options.stopped()) break;
    const LessonStep& step = lesson.steps[n];
    steps.push_back(working.work(step, n, lastScan != lesson.steps.rend() && &step == &*lastScan));
  }
  return steps;
}

}  // namespace ew
