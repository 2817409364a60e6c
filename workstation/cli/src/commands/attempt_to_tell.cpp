#include "commands/records_arguments.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_scoring.h"
#include "ew/library/case.h"
#include "ew/library/case_words.h"
#include "ew/library/learning_progress.h"
#include "ew/records/xapi.h"

namespace ew::cli {
namespace fs = std::filesystem;

void addLessonTo(XapiOptions& options, const Attempt& attempt, AttemptResults& results, const std::string& language) {
  const AttemptLesson* tried = results.lessonOf(attempt);
  if (tried == nullptr) return;
  const CaseWords words = wordsOf(tried->home.folder, language);
  options.caseTitle = words.of(titleForTrainees(tried->home));
  if (tried->isAsTried) options.lesson = translated(tried->lesson, words);
}

bool needsScore(const AttemptResult& result, const AssessmentPlan& plan) {
  return result.passed() && (result.isScored ? result.counted.scoring < kScoringVersion : plan.revision > 0);
}

Result<AttemptResult> resultToTell(const fs::path& folder, const Attempt& attempt, AttemptResults& results, const fs::path& library,
                                   bool keeps, Run& run) {
  const auto& plan = results.planOf(attempt);
  if (!plan) return passOn(plan.error());
  AttemptResult result = results.of(folder, attempt);
  if (!result.isKnown && attempt.finishedAt)
    run.remark(
        say<"The lesson of the attempt '%1' is not in the library, so it is told as completed, and neither as passed nor as failed.">(
            attempt.id));
  if (!needsScore(result, *plan)) return result;
  if (keeps && !assess({folder}, library, {.threads = 1}, run.progress).front().problem) return results.of(folder, attempt);
  // What is told under the statement's id is told for good: a score that cannot be kept counts all the same.
  const auto ground = lessonGroundOf(attempt.caseId, attempt.lessonId, attempt.lessonContent, library, run.progress);
  auto score = ground ? scoreAttempt(folder, attempt, **ground, run.progress) : passOn(ground.error());
  if (score) return attemptResultOf(attempt, &(*ground)->lesson, (*ground)->plan, std::move(*score));
  if (score.error().code == ErrorCode::cancelled) return passOn(score.error());
  run.remark(result.isScored
                 ? say<"The attempt '%1' cannot be scored anew and is told as it was scored before: %2">(attempt.id, score.error().message)
                 : say<"The attempt '%1' cannot be scored by its lesson's plan and is told as the lesson judged it: %2">(
                       attempt.id, score.error().message));
  return result;
}

}  // namespace ew::cli
