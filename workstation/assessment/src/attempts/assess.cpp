#include <algorithm>
#include <chrono>
#include <map>
#include <span>
#include <tuple>
#include <utility>

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

/// Attempts of any lessons, which are read once each.
class Assessing {
 public:
  Assessing(const fs::path& library, const AssessOptions& options) : library_(library), options_(options) {}

  std::vector<AttemptAssessment> of(std::span<const fs::path> folders, Progress& progress) {
    PartOfProgress reading(progress, 0.0, 0.2), scoring(progress, 0.2, 1.0);
    std::vector<AttemptAssessment> all;
    all.reserve(folders.size());
    for (const fs::path& folder : folders) all.push_back(read(folder, reading));
    QuietProgress quiet(scoring);
    forEachTask(static_cast<int>(all.size()), options_.threads, scoring, say<"Scoring attempts">(), [&](int task) {
      AttemptAssessment& one = all[static_cast<std::size_t>(task)];
      if (!one.problem) scoreOne(one, grounds_.at(lessonOf(one.attempt)), options_, quiet);
    });
    for (AttemptAssessment& one : all)
      if (!one.problem && !one.score) one.problem = stoppedBefore();
    return all;
  }

 private:
  AttemptAssessment read(const fs::path& folder, Progress& progress) {
    AttemptAssessment one;
    one.folder = folder;
    if (progress.cancelRequested()) {
      one.problem = stoppedBefore();
      return one;
    }
    auto kept = AttemptFolder::open(folder);
    if (!kept) {
      one.problem = kept.error();
      return one;
    }
    one.attempt = kept->attempt();
    const LessonName name = lessonOf(one.attempt);
    if (!grounds_.contains(name)) {
      progress.report(say<"Reading the lesson '%1'">(one.attempt.lessonId), 0.0);
      grounds_.emplace(name, lessonGroundOf(one.attempt.caseId, one.attempt.lessonId, one.attempt.lessonContent, library_, progress));
    }
    return one;
  }

  const fs::path& library_;
  const AssessOptions& options_;
  Grounds grounds_;
};

}  // namespace

void assess(const std::vector<fs::path>& folders, const fs::path& library, const AssessOptions& options, Progress& progress,
            const std::function<void(AttemptAssessment)>& take) {
  // A thread that is done with a batch waits for the others: of this many each, seldom for long.
  const std::size_t batch = 32 * static_cast<std::size_t>(threadCount(options.threads));
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(folders.size()); };
  Assessing assessing(library, options);
  for (std::size_t first = 0; first < folders.size(); first += batch) {
    const std::span some = std::span(folders).subspan(first, std::min(batch, folders.size() - first));
    PartOfProgress part(progress, share(first), share(first + some.size()));
    for (AttemptAssessment& one : assessing.of(some, part)) take(std::move(one));
  }
}

std::vector<AttemptAssessment> assess(const std::vector<fs::path>& folders, const fs::path& library, const AssessOptions& options,
                                      Progress& progress) {
  std::vector<AttemptAssessment> all;
  all.reserve(folders.size());
  assess(folders, library, options, progress, [&](AttemptAssessment one) { all.push_back(std::move(one)); });
  return all;
}

}  // namespace ew
