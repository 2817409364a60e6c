#include "ew/assessment/attempt_scoring.h"

#include <algorithm>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/step_metrics.h"
#include "ew/core/version.h"
#include "ew/io/content_key.h"
#include "ew/library/sealed_answers.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Judging a watched step takes its answer, which older attempts do not hold.
bool hasAnswer(const LessonStep& step, const StepOutcome& outcome) {
  return !std::holds_alternative<WatchTask>(step.task) || !outcome.answerJson().is_null();
}

/// One attempt's way through all that counts.
class Scoring {
 public:
  Scoring(const fs::path& folder, const Attempt& attempt, const LessonGround& ground, Progress& progress)
      : folder_(folder), attempt_(attempt), ground_(ground), progress_(progress) {}

  Result<AttemptScore> run() {
    score_.attemptId = attempt_.id;
    score_.caseId = attempt_.caseId;
    score_.lessonId = attempt_.lessonId;
    score_.program = kVersion;
    score_.planRevision = ground_.plan.revision;
    score_.expertAttempt = ground_.plan.expertAttempt;
    score_.notes = ground_.notes;
    for (const LessonStep& step : ground_.lesson.steps) {
      if (progress_.cancelRequested()) return failure(ErrorCode::cancelled, say<"Scoring was stopped.">());
      auto scored = scoreStep(step);
      if (!scored) return passOn(scored.error());
      score_.steps.push_back(std::move(*scored));
    }
    score_.outcomes = attempt_.outcomes.size();
    score_.wasFinished = attempt_.finishedAt.has_value();
    concludeLesson(ground_.plan, score_.wasFinished, score_);
    return std::move(score_);
  }

 private:
  Result<StepScore> scoreStep(const LessonStep& step) {
    StepScore made;
    made.stepId = step.id;
    made.title = step.title;
    made.kind = taskWord(step.task);
    made.weight = weightOf(step, ground_.plan);
    made.passLevel = passLevelOf(step, ground_.plan);
    made.verdict = StepVerdict::skipped;
    const StepOutcome* kept = attempt_.outcomeOf(step.id);
    if (kept == nullptr) return made;
    const auto scan = scanOf(step, *kept);
    if (!scan) return passOn(scan.error());
    StepOutcome outcome = *kept;
    const ScanLog* log = *scan ? &(*scan)->log : nullptr;
    std::optional<VoxelPass> passed;
    made.isJudgedAnew = kept->verdict != StepVerdict::skipped && judgeAnew(step, log, outcome, passed);
    made.task = outcome.score;
    made.figures = outcome.figures;
    const auto ground = ground_.caseOf(step);
    if (ground) {
      if (log != nullptr) made.validShare = validShareOf(*log);
      auto metrics = metricsOf({step, outcome, log, passed}, *ground, expertOf(step), progress_);
      if (!metrics) return passOn(metrics.error());
      made.metrics = std::move(*metrics);
    }
    made.score = weighted(step, made);
    if (outcome.verdict != StepVerdict::skipped) {
      outcome.score = made.score;
      ew::conclude(step, made.passLevel, outcome);
    }
    made.verdict = outcome.verdict;
    made.remarks = std::move(outcome.remarks);
    return made;
  }

  Result<std::optional<ScanRecording>> scanOf(const LessonStep& step, const StepOutcome& outcome) {
    if (outcome.recording.empty()) return std::optional<ScanRecording>();
    auto read = readRecording(folder_ / outcome.recording, progress_);
    if (read) return std::optional<ScanRecording>(std::move(*read));
    if (read.error().code == ErrorCode::cancelled) return passOn(read.error());
    score_.notes.push_back(say<"The recording of the step '%1' cannot be read: %2">(step.id, read.error().message));
    return std::optional<ScanRecording>();
  }

  /// @param passed as the work says; @return false: as it was judged in the lesson
  bool judgeAnew(const LessonStep& step, const ScanLog* scan, StepOutcome& outcome, std::optional<VoxelPass>& passed) {
    const auto ground = ground_.caseOf(step);
    if (!ground || !hasAnswer(step, outcome) || (scan == nullptr && isScanned(step.task))) return false;
    const auto work = workOf(step, ground);
    if (!work) {
      score_.notes.push_back(say<"The step '%1' keeps the verdict it had: %2">(step.id, work.error().message));
      return false;
    }
    ScanState image;
    for (std::size_t n = 0; scan != nullptr && n < scan->frameCount(); ++n) {
      scan->frame(n, image);
      (*work)->see(image);
    }
    outcome.result() = (*work)->judge(outcome.answer);
    if (scan != nullptr) passed = (*work)->passedVoxels();
    return true;
  }

  [[nodiscard]] ExpertStep expertOf(const LessonStep& step) const {
    ExpertStep expert;
    if (attempt_.id == ground_.plan.expertAttempt) return expert;  // nobody is compared with themselves
    if (const auto scan = ground_.expertScans.find(step.id); scan != ground_.expertScans.end()) expert.scan = &scan->second->log;
    if (const auto image = ground_.expertImages.find(step.id); image != ground_.expertImages.end()) expert.image = image->second;
    return expert;
  }

  /// The task's score and the metrics that the plan weighs; a metric that could not be worked out does not count.
  [[nodiscard]] double weighted(const LessonStep& step, const StepScore& scored) const {
    const StepPlan* plan = ground_.plan.of(step.id);
    if (plan == nullptr || plan->metrics.empty()) return scored.task;
    double sum = plan->taskWeight * scored.task, weights = plan->taskWeight;
    for (const MetricWeight& each : plan->metrics)
      if (const auto value = valueOf(scored.metrics, each.metric)) {
        sum += each.weight * shareOf(each, *value);
        weights += each.weight;
      }
    return weights > 0.0 ? std::clamp(sum / weights, 0.0, 1.0) : scored.task;
  }

  const fs::path& folder_;
  const Attempt& attempt_;
  const LessonGround& ground_;
  Progress& progress_;
  AttemptScore score_;
};

}  // namespace

Result<AttemptScore> scoreAttempt(const fs::path& folder, const Attempt& attempt, const LessonGround& ground, Progress& progress) {
  if (!sealedAnswersOf(attempt).empty())
    return failure(
        ErrorCode::badUsage,
        say<"The attempt '%1' is at an examination, whose answers are sealed; open them with 'echoweave case unseal' and your key, "
            "and score what that makes.">(attempt.id),
        {{"attempt", attempt.id}});
  return Scoring(folder, attempt, ground, progress).run();
}

}  // namespace ew
