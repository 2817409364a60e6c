#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/attempt_result.h"
#include "ew/scanning/events.h"
#include "logic/step_scene.h"

namespace ew::lessons {

/// One trainee's way through one lesson: which step it stands at, what has been seen in it, and an attempt on disk that loses at most the
/// step that runs. Times are on the scan's clock. A run without an attempt (an author's preview) keeps nothing.
class LessonRun {
 public:
  /// @param attempt empty: nothing is kept
  LessonRun(Lesson lesson, std::optional<AttemptFolder> attempt);

  /// An attempt of this lesson, begun now. @error as AttemptFolder::begin
  /// @param sealedAnswers of an examination: SHA-256 of the answers it is to be judged by (Case::sealed); empty: judged at once
  [[nodiscard]] static Result<LessonRun> begin(Lesson lesson, const std::string& caseId, const std::string& person,
                                               const std::filesystem::path& attempts, const std::string& sealedAnswers = {});

  /// An attempt that was stopped, at the first step that nobody has ended. One whose steps have all ended is finished now, as of its last
  /// outcome: its window was closed before anybody went on. @error as AttemptFolder::finish
  [[nodiscard]] static Result<LessonRun> goOnWith(Lesson lesson, AttemptFolder attempt);

  [[nodiscard]] const Lesson& lesson() const { return lesson_; }
  /// Which step is next or runs; as many as there are steps: the lesson is over.
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] bool isOver() const { return at_ >= lesson_.steps.size(); }
  [[nodiscard]] const LessonStep& step() const { return lesson_.steps[at_]; }
  [[nodiscard]] bool isRunning() const { return work_ != nullptr; }
  [[nodiscard]] bool isPaused() const { return isRunning() && !runningSince_s_; }
  /// The latest outcome of a step; null while there is none.
  [[nodiscard]] const StepOutcome* outcomeOf(const std::string& stepId) const;
  /// What it amounts to by now, as everybody else says it. @param plan of the lesson
  [[nodiscard]] AttemptResult result(const AssessmentPlan& plan) const;
  /// The step that a crash or a kill took, and that begins anew; empty: none.
  [[nodiscard]] const std::string& lostStep() const { return lostStep_; }
  [[nodiscard]] const std::optional<AttemptFolder>& attempt() const { return attempt_; }

  /// Begins the step it stands at. @error as workOf, as AttemptFolder::beginStep
  [[nodiscard]] Result<void> startStep(const StepScene& scene, double now_s);
  /// Begins it with work that is judged in another way than the step's own. @error as AttemptFolder::beginStep
  [[nodiscard]] Result<void> startStep(std::unique_ptr<StepWork> work, double now_s);
  /// What was seen of the step that runs before the program ended, as if it had been seen in one piece up to now.
  /// @param seen on a clock of its own @param used_s of the step by then
  void resume(const ScanLog& seen, double used_s, int hints, double now_s);
  /// What was scanned in the step that runs.
  [[nodiscard]] const ScanLog& log() const { return log_; }
  void pause(double now_s);
  void goOn(double now_s);
  /// Every image of the scan and what happens in it, while a step runs. Nothing is taken while it is paused.
  void see(const ScanEvent& event, const std::optional<ScanState>& image);
  [[nodiscard]] double used_s(double now_s) const;
  /// Of the time that the step may take; empty: as long as one likes.
  [[nodiscard]] std::optional<double> left_s(double now_s) const;
  /// The next hint, or none; each is counted.
  [[nodiscard]] std::optional<std::string> nextHint();
  [[nodiscard]] int hintsGiven() const { return hints_; }
  [[nodiscard]] std::vector<LiveFigure> live() const { return work_ ? work_->live() : std::vector<LiveFigure>{}; }
  /// What is missing before the step can be handed in; empty: nothing. A step that is scanned cannot be handed in before anything was done
  /// in it.
  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const;
  /// Whether the time of the step has run out: true once. Who cannot end it then pauses it, so that its time stands.
  [[nodiscard]] bool takeTimeUp(double now_s);

  /// Ends the step, judges it, or hands it in when its answers are sealed, and keeps its outcome, with a recording of the scan when there
  /// was one. With the last step that was open the attempt is finished. The run stands at the same step until next() or again(). @param
  /// keepFiles writes images into the attempt's folder and returns their names
  /// @error as AttemptFolder::endStep, as writeRecording: then the step goes on
  using KeepFiles = std::function<std::vector<std::string>(const AttemptFolder&)>;
  [[nodiscard]] Result<StepOutcome> endStep(const Handed& handed, double now_s, const KeepFiles& keepFiles = {});
  /// Leaves the step without judging it: it counts as skipped. @error as endStep
  [[nodiscard]] Result<StepOutcome> skipStep(double now_s);
  /// Goes to the step after this one; after the last the attempt is finished, should a step have been lost meanwhile. @error as
  /// AttemptFolder::finish
  [[nodiscard]] Result<void> next();
  /// Back to a step that was ended, to try it once more; next() then leads to the end again. Expects that none runs.
  void goBackTo(std::size_t step);
  /// Back to the step that a crash took while it was tried once more; next() then leads on from there. Expects that none runs.
  /// @return whether that was so
  bool goBackToLost();
  /// Gives up the running step, as if it had not begun. @error as AttemptFolder::leaveStep
  [[nodiscard]] Result<void> leave();

 private:
  [[nodiscard]] Result<StepOutcome> keep(StepOutcome outcome, const KeepFiles& keepFiles);
  /// Whether all other steps of the lesson have an outcome.
  [[nodiscard]] bool isLastOpen() const;
  /// A moment of the scan that its recording keeps, once there is an image: whoever measures motion has to know when nobody scanned.
  void note(const char* kind, double now_s);
  void stop();
  /// Whether anything was done since the step's first image.
  void follow(const ScanState& image);

  Lesson lesson_;
  std::optional<AttemptFolder> attempt_;
  std::vector<StepOutcome> unkept_;  ///< of a run without an attempt
  std::string lostStep_;
  std::size_t at_ = 0;
  std::unique_ptr<StepWork> work_;
  bool isHandedIn_ = false;  ///< the step that runs is judged later, by somebody else
  ScanLog log_;
  std::optional<double> runningSince_s_;
  double usedBefore_s_ = 0.0;
  int hints_ = 0;
  std::optional<ScanState> first_;  ///< image of the step that runs
  bool isActed_ = false;            ///< something was done since
  bool isTimeUpTold_ = false;
  bool isRepeated_ = false;  ///< the step was gone back to
};

}  // namespace ew::lessons
