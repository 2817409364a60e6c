#include <chrono>
#include <map>
#include <tuple>

#include "ew/assessment/attempt_scoring.h"
#include "ew/core/parallel.h"
#include "ew/core/quiet_progress.h"
#include "ew/io/content_key.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using LessonName = std::tuple<std::string, std::string, std::string>;  ///< case, lesson, content
using Grounds = std::map<LessonName, Result<std::shared_ptr<const LessonGround>>>;

LessonName lessonOf(const Attempt& attempt) { return {attempt.caseId, attempt.lessonId, attempt.lessonContent}; }

Error stoppedBefore() { return {ErrorCode::cancelled, say<"Scoring was stopped before this attempt.">(), {}}; }

/// The name of everything that goes into a score. A recording that is not there has a name, too.
Result<std::string> keyOf(const AttemptAssessment& one, const LessonGround& ground, const Progress& progress) {
  ContentKey key;
  key.add("attempt score").add(kScoringVersion).add(ground.key).add(jsonOf(one.attempt).dump());
  for (const Metric& metric : metrics()) key.add(std::string_view(metric.id)).add(metric.version);
  for (const LessonStep& step : ground.lesson.steps) {
    const StepOutcome* outcome = one.attempt.outcomeOf(step.id);
    if (outcome == nullptr || outcome->recording.empty()) continue;
    const auto content = contentOf(one.folder / outcome->recording, progress);
    if (!content && content.error().code == ErrorCode::cancelled) return passOn(content.error());
    key.add(step.id).add(content && *content ? **content : std::string());
  }
  return key.text();
}

void scoreOne(AttemptAssessment& one, const Result<std::shared_ptr<const LessonGround>>& ground, const AssessOptions& options,
              Progress& progress) {
  if (!ground) {
    one.problem = ground.error();
    return;
  }
  const auto fail = [&](const Error& problem) { one.problem = problem; };
  const auto key = keyOf(one, **ground, progress);
  if (!key) return fail(key.error());
  auto latest = latestScore(one.folder);
  const bool isUpToDate = latest && latest->key == *key;
  if (isUpToDate && !options.again) {
    one.score = std::move(latest);
    one.wasUpToDate = true;
    return;
  }
  auto scored = scoreAttempt(one.folder, one.attempt, **ground, progress);
  if (!scored) return fail(scored.error());
  scored->key = *key;
  scored->madeAt = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  if (isUpToDate) {  // made again to look whether it comes out the same
    scored->madeAt = latest->madeAt;
    scored->number = latest->number;
    if (*scored == *latest) {
      one.score = std::move(latest);
      one.wasUpToDate = true;
      return;
    }
  }
  auto kept = keepScore(one.folder, std::move(*scored));
  if (!kept) return fail(kept.error());
  one.score = std::move(*kept);
}

}  // namespace

std::vector<AttemptAssessment> assess(const std::vector<fs::path>& folders, const fs::path& library, const AssessOptions& options,
                                      Progress& progress) {
  std::vector<AttemptAssessment> all;
  all.reserve(folders.size());
  Grounds grounds;
  PartOfProgress reading(progress, 0.0, 0.2), scoring(progress, 0.2, 1.0);
  for (const fs::path& folder : folders) {
    AttemptAssessment& one = all.emplace_back();
    one.folder = folder;
    if (reading.cancelRequested()) {
      one.problem = stoppedBefore();
      continue;
    }
    auto kept = AttemptFolder::open(folder);
    if (!kept) {
      one.problem = kept.error();
      continue;
    }
    one.attempt = kept->attempt();
    const LessonName name = lessonOf(one.attempt);
    if (!grounds.contains(name)) {
      reading.report(say<"Reading the lesson '%1'">(one.attempt.lessonId), 0.0);
      grounds.emplace(name, lessonGroundOf(one.attempt.caseId, one.attempt.lessonId, one.attempt.lessonContent, library, reading));
    }
  }
  QuietProgress quiet(scoring);
  forEachTask(static_cast<int>(all.size()), options.threads, scoring, say<"Scoring attempts">(), [&](int task) {
    AttemptAssessment& one = all[static_cast<std::size_t>(task)];
    if (!one.problem) scoreOne(one, grounds.at(lessonOf(one.attempt)), options, quiet);
  });
  for (AttemptAssessment& one : all)
    if (!one.problem && !one.score) one.problem = stoppedBefore();
  return all;
}

}  // namespace ew
