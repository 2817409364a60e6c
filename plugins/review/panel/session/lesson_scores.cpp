#include "panel/session/lesson_scores.h"

#include <chrono>
#include <utility>

#include "ew/assessment/attempt_scoring.h"
#include "ew/core/progress.h"
#include "ew/sdk/window.h"
#include "ew/widgets/words.h"

namespace ew::review {

void LessonScores::readPlan() {
  plan_ = {};
  const LessonAttempts* of = selection_.lesson();
  if (of == nullptr) return;
  auto read = ew::readPlan(libraryFolder(), of->home.id, of->lesson.id);
  if (!read) return host_.window().error(words(read.error()).toStdString(), "review plan");
  plan_ = std::move(*read);
  plan_.caseId = of->home.id;
  plan_.lessonId = of->lesson.id;
}

void LessonScores::takeRecords(ClassRecords records, AttemptResults results) {
  records_ = std::move(records);
  results_ = std::move(results);
  if (records_.problem) host_.window().error(words(*records_.problem).toStdString(), "review standings");
}

AttemptResult LessonScores::resultOf(std::size_t number) const {
  return review::resultOf(*selection_.lesson(), number, plan_, records_, results_);
}

std::vector<ClassAttempt> LessonScores::classAttempts() const {
  const LessonAttempts* of = selection_.lesson();
  return of != nullptr ? classOf(*of, plan_, records_, results_) : std::vector<ClassAttempt>();
}

bool LessonScores::mayReadRaters(const std::filesystem::path& attempt) const {
  const auto word = records_.ratersWords.find(attempt);
  return word != records_.ratersWords.end() && word->second.openTo.contains(reviewer_.name().toStdString());
}

bool LessonScores::keepStanding(const std::string& attemptId, Standing standing) {
  auto kept = ew::keepStanding(libraryFolder(), attemptId, standing, reviewer_.name().toStdString());
  if (!kept) {
    host_.window().error(words(kept.error()).toStdString(), "review standings");
    return false;
  }
  records_.standings = std::move(*kept);
  records_.problem.reset();
  return true;
}

void LessonScores::takeRating(const std::filesystem::path& attempt) {
  records_.readRatings(attempt);
  Q_EMIT changed();
}

const AttemptScore* LessonScores::scoreOf(std::size_t number) const {
  const LessonAttempts* of = selection_.lesson();
  if (of == nullptr || number >= of->attempts.size()) return nullptr;
  const auto score = records_.scores.find(of->attempts[number].first);
  return score == records_.scores.end() ? nullptr : &score->second;
}

std::vector<MetricValue> LessonScores::metricsOf(const ReviewScan* scan) const {
  if (scan == nullptr) return {};
  const auto& folder = scan->scan->choice.attempt;
  const LessonAttempts* of = selection_.lesson();
  for (std::size_t n = 0; of != nullptr && !folder.empty() && n < of->attempts.size(); ++n)
    if (const AttemptScore* score = scoreOf(n); score != nullptr && of->attempts[n].first == folder)
      if (const StepScore* scored = score->of(selection_.stepId()); scored != nullptr && score->planRevision == plan_.revision)
        return scored->metrics;
  return scan->metrics;
}

void LessonScores::keepPlan(AssessmentPlan plan) {
  plan.changedBy = reviewer_.name().toStdString();
  plan.changedAt = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  auto kept = ew::keepPlan(libraryFolder(), std::move(plan));
  if (!kept) return host_.window().error(words(kept.error()).toStdString(), "review plan");
  plan_ = std::move(*kept);
  Q_EMIT changed();
  scoreAll();
}

void LessonScores::scoreAll() {
  if (scoring_ || selection_.lesson() == nullptr) return;
  std::vector<std::filesystem::path> folders;
  for (const auto& [folder, tried] : selection_.lesson()->attempts) folders.push_back(folder);
  if (folders.empty()) return;
  scoring_ = true;
  Q_EMIT changed();
  auto scored = std::make_shared<std::vector<AttemptAssessment>>();
  host_.jobs().start(
      tr("Scoring the attempts").toStdString(),
      [scored, folders](Progress& progress) -> Result<void> {
        *scored = assess(folders, libraryFolder(), {.threads = 1}, progress);
        for (const AttemptAssessment& each : *scored)
          if (each.problem) return passOn(*each.problem);
        return {};
      },
      [this, scored, alive = std::weak_ptr(alive_)](const Result<void>& done) {
        if (alive.expired()) return;
        scoring_ = false;
        for (AttemptAssessment& each : *scored)
          if (each.score) records_.scores.insert_or_assign(each.folder, std::move(*each.score));
        if (!done && done.error().code != ErrorCode::cancelled) host_.window().warn(words(done.error()).toStdString(), "review scores");
        Q_EMIT changed();
      });
}

}  // namespace ew::review
