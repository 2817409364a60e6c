#include "logic/class_attempts.h"

#include <algorithm>
#include <utility>

namespace ew::review {
namespace {

namespace fs = std::filesystem;

/// Whether the lesson is as it was when it was tried.
bool isAsTried(const Lesson& lesson, const Attempt& tried) {
  return tried.lessonContent.empty() || tried.lessonContent == contentOf(lesson);
}

bool isOnlySeen(const ClassStep& step) { return step.kind == taskWord(ReadingTask{}) || step.kind == taskWord(WatchTask{}); }

}  // namespace

RatersWord ratersWordOf(const RatingRecords& ratings) {
  std::set<std::string> forms;
  std::map<std::string, std::set<std::string>> finished;  // by rater
  for (const RatingRecord& each : ratings.ratings) {
    if (!each.rating.finished) continue;
    forms.insert(each.rating.formId);
    finished[each.rating.rater].insert(each.rating.formId);
  }
  RatersWord made{standingBy(ratings), {}};
  for (const auto& [rater, with] : finished)
    if (with.size() == forms.size()) made.openTo.insert(rater);
  return made;
}

void ClassRecords::readRatings(const fs::path& attempt) {
  RatersWord word = ratersWordOf(everyRating(attempt));
  if (word.standing == Standing::unknown)
    ratersWords.erase(attempt);
  else
    ratersWords.insert_or_assign(attempt, std::move(word));
}

Result<ClassRecords> readClassRecords(const ScanShelf& shelf, const fs::path& library, Progress& progress) {
  ClassRecords made;
  for (const LessonAttempts& lesson : shelf.lessons)
    for (const auto& [folder, tried] : lesson.attempts) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
      if (auto score = latestScore(folder)) made.scores.insert_or_assign(folder, std::move(*score));
      made.readRatings(folder);
    }
  if (auto standings = readStandings(library))
    made.standings = std::move(*standings);
  else
    made.problem = std::move(standings.error());
  return made;
}

void readTriedLessons(const ScanShelf& shelf, AttemptResults& results) {
  for (const LessonAttempts& lesson : shelf.lessons)
    for (const auto& [folder, tried] : lesson.attempts)
      if (!isAsTried(lesson.lesson, tried)) static_cast<void>(results.lessonOf(tried));
}

AttemptResult resultOf(const LessonAttempts& lesson, std::size_t number, const AssessmentPlan& plan, const ClassRecords& records,
                       AttemptResults& results) {
  const auto& [folder, tried] = lesson.attempts.at(number);
  const auto kept = records.scores.find(folder);
  // As it was when it was tried: reports and records ask for that, too.
  const AttemptLesson* before = isAsTried(lesson.lesson, tried) ? nullptr : results.lessonOf(tried);
  return attemptResultOf(tried, before != nullptr ? &before->lesson : &lesson.lesson, plan,
                         kept == records.scores.end() ? std::nullopt : std::optional(kept->second));
}

std::vector<ClassAttempt> classOf(const LessonAttempts& lesson, const AssessmentPlan& plan, const ClassRecords& records,
                                  AttemptResults& results) {
  std::vector<ClassAttempt> all;
  for (std::size_t n = 0; n < lesson.attempts.size(); ++n) {
    const auto& [folder, tried] = lesson.attempts[n];
    const auto word = records.ratersWords.find(folder);
    all.push_back(classAttemptOf(tried, resultOf(lesson, n, plan, records, results), standingIn(records.standings, tried.id),
                                 word == records.ratersWords.end() ? Standing::unknown : word->second.standing));
  }
  return all;
}

std::vector<ClassStep> overviewSteps(const ClassFigures& figures, const Lesson& lesson, const AssessmentPlan& plan) {
  std::vector<ClassStep> rows = figures.steps;
  const AttemptResult untried = attemptResultOf(Attempt(), &lesson, plan, std::nullopt);
  for (const StepScore& step : untried.counted.steps) {
    if (std::any_of(rows.begin(), rows.end(), [&](const ClassStep& row) { return row.stepId == step.stepId; })) continue;
    ClassStep& made = rows.emplace_back();
    made.stepId = step.stepId;
    made.title = step.title;
    made.kind = step.kind;
    made.weight = weightIn(untried, step);
    made.passLevel = step.passLevel;
  }
  std::erase_if(rows, [](const ClassStep& row) { return row.weight <= 0.0 && isOnlySeen(row); });
  return rows;
}

}  // namespace ew::review
