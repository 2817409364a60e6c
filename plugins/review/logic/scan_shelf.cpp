#include "logic/scan_shelf.h"

#include <algorithm>
#include <map>

#include "ew/library/learning_progress.h"
#include "ew/library/lesson_links.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;

std::string scannedBy(const Lesson& lesson, const std::string& stepId, const std::string& home) {
  for (const LessonStep& step : lesson.steps)
    if (step.id == stepId) return step.caseId.empty() ? home : step.caseId;
  return home;
}

}  // namespace

Result<ScanExcerpt> openScan(const ScanChoice& choice, Progress& progress) {
  auto recording = readRecording(choice.file, progress);
  if (!recording) return passOn(recording.error());
  ScanExcerpt made{choice, std::move(*recording), {}};
  if (made.recording.log.frameCount() == 0)
    return failure(ErrorCode::badField, say<"%1 has no image; choose another recording.">(choice.file.filename()),
                   {{"file", choice.file.string()}});
  const ScanLog& log = made.recording.log;
  made.part = {log.begin_s(), log.end_s()};
  if (choice.watch) {
    made.part.begin_s = std::clamp(choice.watch->begin_s.value_or(made.part.begin_s), log.begin_s(), log.end_s());
    made.part.end_s = std::clamp(choice.watch->end_s.value_or(made.part.end_s), made.part.begin_s, log.end_s());
  }
  if (made.recording.caseId.empty()) made.recording.caseId = choice.caseId;
  return made;
}

std::vector<ScanChoice> expertScansOf(const Case& home, const Lesson& lesson) {
  std::vector<ScanChoice> scans;
  for (const LessonStep& step : lesson.steps) {
    const auto* watch = std::get_if<WatchTask>(&step.task);
    if (watch == nullptr || watch->recording.empty()) continue;
    const auto file = fileOfCase(home.folder / "parts" / std::string(kLessonsPart), watch->recording, "recording");
    if (!file) continue;
    scans.push_back({.who = Who::expert,
                     .title = step.title,
                     .file = *file,
                     .stepId = step.id,
                     .watch = *watch,
                     .caseId = step.caseId.empty() ? home.id : step.caseId});
  }
  return scans;
}

std::size_t usualExpertFor(const Lesson& lesson, const std::string& stepId, const std::vector<ScanChoice>& scans) {
  const auto placeOf = [&](const std::string& id) {
    return std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const LessonStep& step) { return step.id == id; }) -
           lesson.steps.begin();
  };
  const std::string scanned = scannedBy(lesson, stepId, {});
  const auto isSame = [&](const ScanChoice& scan) { return scannedBy(lesson, scan.stepId, {}) == scanned; };
  for (std::size_t n = scans.size(); n-- > 0;)
    if (isSame(scans[n]) && placeOf(scans[n].stepId) < placeOf(stepId)) return n;
  const auto same = std::find_if(scans.begin(), scans.end(), isSame);
  return same == scans.end() ? 0 : static_cast<std::size_t>(same - scans.begin());
}

std::optional<ScanChoice> scanOfStep(const fs::path& folder, const Attempt& attempt, const LessonStep& step) {
  const StepOutcome* outcome = attempt.outcomeOf(step.id);
  if (outcome == nullptr || outcome->recording.empty()) return std::nullopt;
  std::error_code ignored;
  const fs::path file = folder / outcome->recording;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  return ScanChoice{.who = Who::trainee,
                    .title = step.title,
                    .file = file,
                    .attempt = folder,
                    .stepId = step.id,
                    .outcome = *outcome,
                    .caseId = step.caseId.empty() ? attempt.caseId : step.caseId};
}

ScanLog logOfPart(const ScanLog& log, const Part& part) {
  ScanLog made;
  std::size_t frame = 0;
  for (const ScanEvent& event : log.events()) {
    const bool isFrame = std::holds_alternative<FrameMade>(event.what);
    const bool isWithin = event.time_s >= part.begin_s && event.time_s <= part.end_s;
    if (isFrame && isWithin) made.addFrame(log.frame(frame));  // with probe, settings and scene, whenever they were chosen
    if (isFrame) ++frame;
    if (isWithin && (std::holds_alternative<Note>(event.what) || std::holds_alternative<FreezeChanged>(event.what))) made.add(event);
  }
  return made;
}

ScanLog formedIn(const ScanLog& log, const Scene& scene) {
  ScanLog made;
  std::size_t frame = 0;
  for (const ScanEvent& event : log.events()) {
    if (std::holds_alternative<FrameMade>(event.what)) {
      ScanState state = log.frame(frame++);
      state.scene = scene;
      made.addFrame(state);
    } else if (std::holds_alternative<Note>(event.what) || std::holds_alternative<FreezeChanged>(event.what)) {
      made.add(event);
    }
  }
  return made;
}

Result<ScanShelf> readShelf(const fs::path& library, const fs::path& openCase, Progress& progress, const std::string& language) {
  progress.report(say<"Looking for attempts">(), 0.0);
  ScanShelf shelf;
  AttemptList list = listAttempts(attemptsFolder(library));
  shelf.problems = std::move(list.problems);
  std::map<std::string, std::map<std::string, std::vector<std::pair<fs::path, Attempt>>>> byLesson;
  for (auto& each : list.attempts) byLesson[each.second.caseId][each.second.lessonId].push_back(std::move(each));
  std::vector<Case> cases;
  if (!openCase.empty())
    if (auto opened = loadCase(openCase)) cases.push_back(std::move(*opened));
  const bool isOpen = !cases.empty();
  for (const auto& [id, lessons] : byLesson) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
    if (isOpen && cases.front().id == id) continue;
    const auto folder = findCase(id, library);
    if (!folder) continue;
    auto opened = loadCase(*folder);
    if (opened)
      cases.push_back(std::move(*opened));
    else
      shelf.problems.push_back(std::move(opened.error()));
  }
  std::stable_sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.title < b.title; });
  for (const Case& home : cases) {
    auto lessons = lessonsOf(home);
    if (!lessons) {
      shelf.problems.push_back(std::move(lessons.error()));
      continue;
    }
    const CaseWords words = language.empty() ? CaseWords() : wordsOf(home.folder, language);
    for (Lesson& lesson : *lessons) {
      auto tried = byLesson[home.id].extract(lesson.id);
      if (tried.empty() && !(isOpen && home.folder == openCase)) continue;
      shelf.lessons.push_back({home, std::move(lesson), {}, words});
      if (!tried.empty()) shelf.lessons.back().attempts = std::move(tried.mapped());
    }
  }
  for (const auto& [id, lessons] : byLesson)
    for (const auto& [lesson, attempts] : lessons) shelf.strayAttempts += attempts.size();
  return shelf;
}

Result<fs::path> caseOf(const ScanExcerpt& scan, const ScanShelf& shelf, const fs::path& library) {
  const std::string& id = scan.recording.caseId;
  for (const LessonAttempts& each : shelf.lessons)
    if (each.home.id == id) return each.home.folder;
  if (!id.empty())
    if (auto found = findCase(id, library)) return *found;
  return failure(ErrorCode::notFound,
                 say<"The case that %1 was recorded in is not in the library; import it, or open it, and choose the scan again.">(
                     scan.choice.file.filename()),
                 {{"case", id}, {"file", scan.choice.file.string()}});
}

}  // namespace ew::review
