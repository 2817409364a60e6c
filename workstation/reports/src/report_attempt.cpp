#include "ew/reports/report_attempt.h"

#include <algorithm>

#include "ew/assessment/metric_defaults.h"
#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/recording.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
constexpr double kStep_mm = 0.5;

/// Of the attempt that others are compared with.
void readExpert(ReportLesson& lesson, const fs::path& library, const ReportOptions& options) {
  if (lesson.plan.expertAttempt.empty()) return;
  const auto kept = AttemptFolder::open(attemptsFolder(library) / lesson.plan.expertAttempt);
  if (!kept) return;
  lesson.expert = latestScore(kept->folder());
  if (!options.images) return;
  for (const StepOutcome& outcome : kept->attempt().outcomes) {
    if (outcome.recording.empty()) continue;
    const auto recording = readRecording(kept->folder() / outcome.recording);
    if (recording) lesson.expertPaths[outcome.stepId] = pathOf(recording->log);
  }
}

void readCase(ReportLesson& lesson, const fs::path& library, const ReportOptions& options) {
  const auto folder = findCase(lesson.caseId, library);
  if (!folder) return;
  const auto opened = loadCase(*folder);
  if (!opened) return;
  lesson.words = wordsOf(*folder, options.language);
  lesson.caseTitle = lesson.words.of(titleForTrainees(*opened));
  const auto lessons = lessonsOf(*opened);
  if (!lessons) return;
  const auto found = std::find_if(lessons->begin(), lessons->end(), [&](const Lesson& each) { return each.id == lesson.lessonId; });
  if (found == lessons->end()) return;
  lesson.lesson = *found;
  lesson.lessonTitle = lesson.words.of(found->title);
}

/// Those that the study found wanting; none where it cannot be read.
std::set<std::pair<std::string, std::string>> metricsOff() {
  const auto resources = resourceFolder();
  const auto defaults = resources ? MetricDefaults::read(*resources) : passOn(resources.error());
  std::set<std::pair<std::string, std::string>> off;
  if (!defaults) return off;
  for (const Metric& metric : metrics())
    for (const std::string_view kind : metric.stepKinds)
      if (!defaults->isOn(metric.id, kind)) off.emplace(kind, metric.id);
  return off;
}

}  // namespace

AttemptResult ReportAttempt::result() const { return attemptResultOf(attempt, lesson ? &*lesson : nullptr, plan, score); }

Result<ReportAttempt> readReportedAttempt(const fs::path& folder, AttemptResults* results) {
  auto kept = AttemptFolder::open(folder);
  if (!kept) return passOn(kept.error());
  ReportAttempt made;
  made.folder = folder;
  made.attempt = kept->attempt();
  if (results != nullptr) {
    if (const AttemptLesson* tried = results->lessonOf(made.attempt)) made.lesson = tried->lesson;
    if (const auto& plan = results->planOf(made.attempt)) made.plan = *plan;
  }
  made.earlier = scoresOf(folder);
  if (!made.earlier.empty()) {
    made.score = std::move(made.earlier.back());
    made.earlier.pop_back();
  }
  made.ratings = everyRating(folder);
  std::erase_if(made.ratings.ratings, [](const RatingRecord& each) { return !each.rating.finished; });
  made.comments = listComments(folder);
  return made;
}

ReportLesson readReportedLesson(const std::string& caseId, const std::string& lessonId, const fs::path& library,
                                const ReportOptions& options) {
  ReportLesson made;
  made.caseId = made.caseTitle = caseId;
  made.lessonId = made.lessonTitle = lessonId;
  readCase(made, library, options);
  if (auto plan = readPlan(library, caseId, lessonId)) made.plan = std::move(*plan);
  readExpert(made, library, options);
  made.offByDefault = metricsOff();
  if (auto standings = readStandings(library))
    made.standings = std::move(*standings);
  else
    made.standingsProblem = std::move(standings.error());
  return made;
}

std::vector<std::vector<glm::dvec2>> pathOf(const ScanLog& log) {
  std::vector<std::vector<glm::dvec2>> pieces(1);
  for (const ScanEvent& event : log.events()) {
    const auto* made = std::get_if<FrameMade>(&event.what);
    if (made == nullptr) continue;
    const Pose& pose = made->pose;
    if (pose.status != PoseStatus::ok) {
      if (!pieces.back().empty()) pieces.emplace_back();
      continue;
    }
    const glm::dvec4& face_mm = pose.probeToWorld.matrix[3];
    const glm::dvec2 seen_mm(face_mm.x, face_mm.z);
    if (pieces.back().empty() || glm::distance(pieces.back().back(), seen_mm) >= kStep_mm) pieces.back().push_back(seen_mm);
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.size() < 2; });
  return pieces;
}

}  // namespace ew
