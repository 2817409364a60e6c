#include "ew/assessment/attempt_result.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/judging.h"
#include "ew/assessment/step_work.h"
#include "ew/core/numbers.h"
#include "ew/library/lesson_links.h"
#include "ew/library/published.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool weighsAnything(const AttemptScore& score) {
  return std::any_of(score.steps.begin(), score.steps.end(), [](const StepScore& step) { return step.weight > 0.0; });
}

/// Of a step as the lesson judged it; by the plan's pass level where it has one.
StepScore asJudged(const LessonStep& step, const StepOutcome* outcome, const AssessmentPlan& plan) {
  StepScore made;
  made.stepId = step.id;
  made.title = step.title;
  made.kind = taskWord(step.task);
  made.weight = weightOf(step, plan);
  made.passLevel = passLevelOf(step, plan);
  made.verdict = StepVerdict::skipped;
  if (outcome == nullptr) return made;
  StepOutcome judged = *outcome;
  const StepPlan* decided = plan.of(step.id);
  const bool isJudged = judged.verdict != StepVerdict::skipped && judged.verdict != StepVerdict::handedIn;
  if (isJudged && decided != nullptr && decided->passLevel) conclude(step, made.passLevel, judged);
  made.result() = *outcome;
  made.verdict = judged.verdict;
  made.task = outcome->score;
  return made;
}

/// Of a lesson that nobody has any more.
StepScore asJudged(const StepOutcome& outcome) {
  StepScore made;
  made.stepId = outcome.stepId;
  made.result() = outcome;
  made.task = outcome.score;
  return made;
}

AttemptScore asJudged(const Attempt& attempt, const Lesson* lesson, const AssessmentPlan& plan) {
  AttemptScore made;
  made.attemptId = attempt.id;
  made.caseId = attempt.caseId;
  made.lessonId = attempt.lessonId;
  made.program = attempt.program;
  made.planRevision = plan.revision;
  if (lesson != nullptr)
    for (const LessonStep& step : lesson->steps) made.steps.push_back(asJudged(step, attempt.outcomeOf(step.id), plan));
  else
    for (const StepOutcome& outcome : attempt.outcomes)
      if (attempt.outcomeOf(outcome.stepId) == &outcome) made.steps.push_back(asJudged(outcome));
  concludeLesson(plan, attempt.finishedAt.has_value(), made);
  return made;
}

/// Whether a score was made of the attempt as it is now.
bool isOfNow(const AttemptScore& score, const Attempt& attempt) {
  if (score.outcomes) return *score.outcomes == attempt.outcomes.size() && score.wasFinished == attempt.finishedAt.has_value();
  // The first version did not say; then the clocks have to do.
  auto last = attempt.finishedAt.value_or(attempt.startedAt);
  for (const StepOutcome& outcome : attempt.outcomes) last = std::max(last, outcome.at);
  return score.madeAt == std::chrono::sys_seconds{} || score.madeAt >= last;
}

/// "70" of 0.7, "66.7" of two thirds: levels are set in points of 100.
Message points(double level) { return numeral(textOf(std::round(1000.0 * level) / 10.0)); }

/// The folders that may hold a case: the one that counts now, then every published revision, the latest first.
std::vector<fs::path> foldersOf(const std::string& caseId, const fs::path& library) {
  std::vector<fs::path> folders;
  if (auto found = findCase(caseId, library)) folders.push_back(std::move(*found));
  auto revisions = publishedRevisions(library, caseId);
  for (auto each = revisions.rbegin(); each != revisions.rend(); ++each) folders.push_back(each->folder);
  return folders;
}

}  // namespace

std::optional<double> AttemptResult::score() const { return isKnown && stepsHandedIn == 0 ? std::optional(counted.score) : std::nullopt; }

std::optional<bool> AttemptResult::passed() const { return score() ? std::optional(counted.passed) : std::nullopt; }

Message verdictWord(const AttemptResult& result) {
  if (!result.isKnown) return say<"not scored yet">();
  const auto passed = result.passed();
  return passed ? passedWord(*passed) : verdictWord(StepVerdict::handedIn);
}

bool passedForSystem(std::optional<double> score, bool passed, std::optional<double> masteryScore) {
  return score && masteryScore ? reachesLevel(*score, *masteryScore) : passed;
}

Message systemVerdictRemark(const AttemptResult& result, std::optional<double> masteryScore) {
  const auto passed = result.passed();
  if (!passed || !masteryScore) return {};
  const bool there = passedForSystem(result.score(), *passed, masteryScore);
  if (there == *passed) return {};
  if (result.passLevel)
    return say<"The learning system asks for %1 of 100 points: %2 there. The lesson asks for %3: %4.">(
        points(*masteryScore), passedWord(there), points(*result.passLevel), passedWord(*passed));
  return say<
      "The learning system asks for %1 of 100 points: %2 there. The lesson asks that it is finished and every step that "
      "counts is passed: %3.">(points(*masteryScore), passedWord(there), passedWord(*passed));
}

double weightIn(const AttemptResult& result, const StepScore& step) { return result.areAlike ? 1.0 : step.weight; }

void concludeLesson(const AssessmentPlan& plan, bool isFinished, AttemptScore& score) {
  const bool areAlike = !weighsAnything(score);
  double sum = 0.0, weights = 0.0;
  bool allPassed = !score.steps.empty();
  for (const StepScore& step : score.steps) {
    const double weight = areAlike ? 1.0 : step.weight;
    if (weight <= 0.0) continue;
    sum += weight * step.score;
    weights += weight;
    allPassed = allPassed && step.verdict == StepVerdict::passed;
  }
  score.score = weights > 0.0 ? std::clamp(sum / weights, 0.0, 1.0) : 0.0;
  score.passed = plan.passLevel ? reachesLevel(score.score, *plan.passLevel) : allPassed && isFinished;
}

AttemptResult attemptResultOf(const Attempt& attempt, const Lesson* lesson, const AssessmentPlan& plan, std::optional<AttemptScore> kept) {
  AttemptResult result;
  result.startedAt = attempt.startedAt;
  result.finishedAt = attempt.finishedAt;
  result.passLevel = plan.passLevel;
  result.masteryScore = attempt.masteryScore;
  for (const StepOutcome& outcome : attempt.outcomes) result.worked_s += outcome.seconds;
  result.isScored = kept && kept->planRevision >= plan.revision && isOfNow(*kept, attempt);
  result.isKnown = result.isScored || lesson != nullptr;
  result.counted = result.isScored ? std::move(*kept) : asJudged(attempt, lesson, plan);
  result.areAlike = !weighsAnything(result.counted);
  for (const StepScore& step : result.counted.steps) {
    result.stepsHandedIn += step.verdict == StepVerdict::handedIn ? 1 : 0;
    if (!result.areAlike && step.weight <= 0.0) continue;
    ++result.stepsJudged;
    result.stepsPassed += step.verdict == StepVerdict::passed ? 1 : 0;
  }
  return result;
}

Result<AttemptLesson> triedLessonOf(const std::string& caseId, const std::string& lessonId, const std::string& content,
                                    const fs::path& library) {
  std::optional<AttemptLesson> now;
  std::optional<Error> problem;
  for (const fs::path& folder : foldersOf(caseId, library)) {
    auto opened = loadCase(folder);
    const auto lessons = opened ? lessonsOf(*opened) : passOn(opened.error());
    if (!lessons) {
      if (!problem) problem = lessons.error();
      continue;
    }
    for (const Lesson& each : *lessons) {
      if (each.id != lessonId) continue;
      const bool isAsTried = content.empty() || contentOf(each) == content;
      if (isAsTried || !now) now = AttemptLesson{*opened, each, isAsTried};
    }
    if (now && now->isAsTried) break;
  }
  if (now) return std::move(*now);
  if (problem) return passOn(*problem);
  return failure(ErrorCode::notFound, say<"The lesson '%1' of the case '%2' is not in the library; import the case.">(lessonId, caseId),
                 {{"case", caseId}, {"lesson", lessonId}});
}

AttemptJudge attemptJudgeOf(const fs::path& library) {
  return [results = std::make_shared<AttemptResults>(library)](const fs::path& folder, const Attempt& attempt) {
    const AttemptResult result = results->of(folder, attempt);
    return AttemptTally{result.stepsPassed, result.stepsJudged, result.passed().value_or(false)};
  };
}

const AttemptLesson* AttemptResults::lessonOf(const Attempt& attempt) {
  const auto [at, isNew] = lessons_.try_emplace({attempt.caseId, attempt.lessonId, attempt.lessonContent});
  if (isNew)
    if (auto tried = triedLessonOf(attempt.caseId, attempt.lessonId, attempt.lessonContent, library_))
      at->second = std::make_shared<const AttemptLesson>(std::move(*tried));
  return at->second.get();
}

const Result<AssessmentPlan>& AttemptResults::planOf(const Attempt& attempt) {
  const std::pair lesson(attempt.caseId, attempt.lessonId);
  auto at = plans_.find(lesson);
  if (at == plans_.end()) at = plans_.emplace(lesson, readPlan(library_, attempt.caseId, attempt.lessonId)).first;
  return at->second;
}

AttemptResult AttemptResults::of(const fs::path& folder, const Attempt& attempt) {
  const AttemptLesson* tried = lessonOf(attempt);
  const Result<AssessmentPlan>& plan = planOf(attempt);
  return attemptResultOf(attempt, tried != nullptr ? &tried->lesson : nullptr, plan ? *plan : AssessmentPlan(), latestScore(folder));
}

}  // namespace ew
