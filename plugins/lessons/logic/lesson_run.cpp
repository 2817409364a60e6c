#include "logic/lesson_run.h"

#include <algorithm>
#include <cmath>

#include "ew/core/version.h"
#include "ew/library/sealed_answers.h"
#include "ew/scanning/recording.h"

namespace ew::lessons {
namespace {

/// Whether a hand has moved the probe or set something: more than a tracker trembles, and not the quality that moving changes by itself.
bool isOther(const ScanState& before, const ScanState& now) {
  constexpr double kMoved_mm = 1.0;
  const double kTurned = std::cos(glm::radians(1.0));
  Knobs were = before.knobs;
  were.quality = now.knobs.quality;
  const glm::dmat4 &a = before.pose.probeToWorld.matrix, &b = now.pose.probeToWorld.matrix;
  return were != now.knobs || before.probe.id != now.probe.id || glm::distance(glm::dvec3(a[3]), glm::dvec3(b[3])) > kMoved_mm ||
         glm::dot(glm::dvec3(a[0]), glm::dvec3(b[0])) < kTurned || glm::dot(glm::dvec3(a[1]), glm::dvec3(b[1])) < kTurned;
}

std::chrono::sys_seconds now() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

}  // namespace

LessonRun::LessonRun(Lesson lesson, std::optional<AttemptFolder> attempt) : lesson_(std::move(lesson)), attempt_(std::move(attempt)) {
  if (!attempt_) return;
  lostStep_ = attempt_->attempt().runningStep;
  // It goes on at the first step that nobody has ended: the steps before it were judged, or skipped.
  const auto isOpen = [&](const LessonStep& step) { return attempt_->attempt().outcomeOf(step.id) == nullptr; };
  at_ = static_cast<std::size_t>(std::find_if(lesson_.steps.begin(), lesson_.steps.end(), isOpen) - lesson_.steps.begin());
}

Result<LessonRun> LessonRun::begin(Lesson lesson, const std::string& caseId, const std::string& person,
                                   const std::filesystem::path& attempts, const std::string& sealedAnswers) {
  Attempt attempt;
  attempt.startedAt = now();
  attempt.id = idOfAttempt(attempt.startedAt);
  attempt.caseId = caseId;
  attempt.lessonId = lesson.id;
  attempt.lessonTitle = lesson.title;
  attempt.lessonContent = contentOf(lesson);
  attempt.person = person;
  attempt.program = kVersion;
  attempt.launch = launchOfEnvironment();
  attempt.masteryScore = masteryScoreOfEnvironment();
  if (!sealedAnswers.empty()) attempt = withSealedAnswers(std::move(attempt), sealedAnswers);
  auto kept = AttemptFolder::begin(attempts, std::move(attempt));
  if (!kept) return passOn(kept.error());
  return LessonRun(std::move(lesson), std::move(*kept));
}

Result<LessonRun> LessonRun::goOnWith(Lesson lesson, AttemptFolder attempt) {
  if (auto moved = attempt.goOnAt(lesson); !moved) return passOn(moved.error());
  LessonRun run(std::move(lesson), std::move(attempt));
  const Attempt& tried = run.attempt_->attempt();
  if (run.isOver() && !tried.finishedAt && !tried.outcomes.empty())
    if (auto finished = run.attempt_->finish(tried.outcomes.back().at); !finished) return passOn(finished.error());
  return run;
}

AttemptResult LessonRun::result(const AssessmentPlan& plan) const {
  Attempt tried = attempt_ ? attempt_->attempt() : Attempt();
  if (!attempt_) {
    tried.outcomes = unkept_;
    if (isOver()) tried.finishedAt = now();
  }
  return attemptResultOf(tried, &lesson_, plan, attempt_ ? latestScore(attempt_->folder()) : std::nullopt);
}

const StepOutcome* LessonRun::outcomeOf(const std::string& stepId) const {
  if (attempt_) return attempt_->attempt().outcomeOf(stepId);
  const auto last = std::find_if(unkept_.rbegin(), unkept_.rend(), [&](const StepOutcome& one) { return one.stepId == stepId; });
  return last == unkept_.rend() ? nullptr : &*last;
}

Result<void> LessonRun::startStep(const StepScene& scene, double now_s) {
  EW_EXPECTS(!isOver());
  auto work = scene.isSealed ? Result<std::unique_ptr<StepWork>>(handedInWork(step())) : workOf(step(), scene.ground());
  if (!work) return passOn(work.error());
  if (auto started = startStep(std::move(*work), now_s); !started) return started;
  isHandedIn_ = scene.isSealed && !std::holds_alternative<ReadingTask>(step().task);
  return {};
}

Result<void> LessonRun::startStep(std::unique_ptr<StepWork> work, double now_s) {
  EW_EXPECTS(!isOver() && !isRunning());
  if (attempt_)
    if (auto begun = attempt_->beginStep(step().id); !begun) return begun;
  work_ = std::move(work);
  isHandedIn_ = false;
  log_ = {};
  usedBefore_s_ = 0.0;
  runningSince_s_ = now_s;
  hints_ = 0;
  first_.reset();
  isActed_ = isTimeUpTold_ = false;
  lostStep_.clear();
  return {};
}

void LessonRun::resume(const ScanLog& seen, double used_s, int hints, double now_s) {
  EW_EXPECTS(isRunning());
  const double later_s = now_s - seen.end_s();
  std::size_t frame = 0;
  log_ = {};
  for (ScanEvent event : seen.events()) {
    event.time_s += later_s;
    if (std::holds_alternative<FrameMade>(event.what)) {
      ScanState image = seen.frame(frame++);
      image.time_s = event.time_s;
      work_->see(image);
      follow(image);
    }
    log_.add(std::move(event));
  }
  // Nobody scanned in between: whoever measures motion has to know.
  note("pause", now_s);
  note("resume", now_s);
  usedBefore_s_ = std::max(0.0, used_s);
  runningSince_s_ = now_s;
  hints_ = std::clamp(hints, 0, static_cast<int>(step().hints.size()));
}

void LessonRun::pause(double now_s) {
  if (!isRunning() || isPaused()) return;
  usedBefore_s_ = used_s(now_s);
  runningSince_s_.reset();
  note("pause", now_s);
}

void LessonRun::goOn(double now_s) {
  if (!isPaused()) return;
  runningSince_s_ = now_s;
  note("resume", now_s);
}

void LessonRun::note(const char* kind, double now_s) {
  if (log_.frameCount() > 0) log_.addNote(now_s, kind, {});
}

void LessonRun::follow(const ScanState& image) {
  if (!first_) first_ = image;
  isActed_ = isActed_ || isOther(*first_, image);
}

void LessonRun::see(const ScanEvent& event, const std::optional<ScanState>& image) {
  if (!isRunning() || isPaused()) return;
  if (std::holds_alternative<FrameMade>(event.what)) {
    if (!image) return;
    log_.addFrame(*image);  // with probe and settings before the first one, which were told before the step began
    work_->see(*image);
    follow(*image);
  } else if (const auto* freeze = std::get_if<FreezeChanged>(&event.what)) {
    isActed_ = isActed_ || freeze->isFrozen;
    log_.setFrozen(event.time_s, freeze->isFrozen);
  } else if (std::holds_alternative<Note>(event.what)) {
    log_.add(event);
  }
}

double LessonRun::used_s(double now_s) const { return usedBefore_s_ + (runningSince_s_ ? std::max(0.0, now_s - *runningSince_s_) : 0.0); }

std::optional<double> LessonRun::left_s(double now_s) const {
  if (!isRunning() || !step().time_s) return std::nullopt;
  return std::max(0.0, *step().time_s - used_s(now_s));
}

std::optional<Message> LessonRun::missing(const Handed& handed) const {
  if (!work_) return std::nullopt;
  if (auto lacks = work_->missing(handed)) return lacks;
  if (isActed_ || !isScanned(step().task)) return std::nullopt;
  return say<"Nothing was done in this step yet: move the probe, set the machine, or freeze the image.">();
}

bool LessonRun::takeTimeUp(double now_s) {
  const auto left = left_s(now_s);
  if (!left || *left > 0.0 || isTimeUpTold_) return false;
  isTimeUpTold_ = true;
  return true;
}

std::optional<std::string> LessonRun::nextHint() {
  const auto& hints = step().hints;
  if (!isRunning() || hints_ >= static_cast<int>(hints.size())) return std::nullopt;
  return hints[static_cast<std::size_t>(hints_++)];
}

void LessonRun::stop() {
  work_.reset();
  runningSince_s_.reset();
}

Result<StepOutcome> LessonRun::keep(StepOutcome outcome, const KeepFiles& keepFiles) {
  outcome.stepId = step().id;
  outcome.hints = hints_;
  outcome.at = now();
  if (attempt_) {
    if (log_.frameCount() > 0) {
      const std::string name = attempt_->nameForFile(outcome.stepId, ".seq.mha");
      ScanRecording recording;
      recording.caseId = step().caseId.empty() ? attempt_->attempt().caseId : step().caseId;
      recording.title = step().title;
      recording.log = log_;
      if (auto written = writeRecording(recording, attempt_->folder() / name); !written) return passOn(written.error());
      outcome.recording = name;
    }
    if (keepFiles) outcome.images = keepFiles(*attempt_);
    // Finished with the last outcome, whatever becomes of the window then.
    if (auto ended = attempt_->endStep(outcome, isLastOpen() ? std::optional(outcome.at) : std::nullopt); !ended)
      return passOn(ended.error());
  } else {
    unkept_.push_back(outcome);
  }
  stop();
  return outcome;
}

Result<StepOutcome> LessonRun::endStep(const Handed& handed, double now_s, const KeepFiles& keepFiles) {
  EW_EXPECTS(isRunning());
  StepOutcome outcome;
  outcome.seconds = used_s(now_s);
  work_->hand(handed, outcome);
  if (!isPaused()) note("handed in", now_s);
  if (isHandedIn_)
    outcome.verdict = StepVerdict::handedIn;
  else
    conclude(step(), step().passLevel, outcome);
  return keep(std::move(outcome), keepFiles);
}

Result<StepOutcome> LessonRun::skipStep(double now_s) {
  StepOutcome outcome;
  outcome.seconds = isRunning() ? used_s(now_s) : 0.0;
  outcome.verdict = StepVerdict::skipped;
  return keep(std::move(outcome), {});
}

bool LessonRun::isLastOpen() const {
  return std::all_of(lesson_.steps.begin(), lesson_.steps.end(),
                     [&](const LessonStep& each) { return each.id == step().id || outcomeOf(each.id) != nullptr; });
}

Result<void> LessonRun::next() {
  EW_EXPECTS(!isRunning() && !isOver());
  if (isRepeated_) {
    isRepeated_ = false;
    at_ = lesson_.steps.size();
    return {};
  }
  if (at_ + 1 == lesson_.steps.size() && attempt_ && !attempt_->attempt().finishedAt)
    if (auto finished = attempt_->finish(now()); !finished) return finished;
  ++at_;
  return {};
}

void LessonRun::goBackTo(std::size_t step) {
  EW_EXPECTS(!isRunning() && isOver() && step < lesson_.steps.size());
  at_ = step;
  isRepeated_ = true;
}

bool LessonRun::goBackToLost() {
  EW_EXPECTS(!isRunning());
  const auto ended = lesson_.steps.begin() + static_cast<std::ptrdiff_t>(at_);  // those before it have an outcome
  const auto lost = std::find_if(lesson_.steps.begin(), ended, [&](const LessonStep& step) { return step.id == lostStep_; });
  if (lost == ended) return false;
  isRepeated_ = isOver();
  at_ = static_cast<std::size_t>(lost - lesson_.steps.begin());
  return true;
}

Result<void> LessonRun::leave() {
  if (attempt_)
    if (auto left = attempt_->leaveStep(); !left) return left;
  stop();
  return {};
}

}  // namespace ew::lessons
