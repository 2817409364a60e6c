#include "logic/step_autosave.h"

#include <cstdlib>

#include "ew/core/json_fields.h"
#include "ew/scanning/recording_journal.h"

namespace ew::lessons {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kStepItem = "step.jsonl";
constexpr const char* kKindOfStep = "lesson_step";
constexpr const char* kStandNote = "stand";  ///< how the step stands, in the journal alone

/// How the step stands, as the journal's last word says it; the log without such words.
ScanLog withoutStand(const ScanLog& log, double& used_s, int& hints) {
  ScanLog seen;
  for (const ScanEvent& event : log.events()) {
    const auto* note = std::get_if<Note>(&event.what);
    if (note == nullptr || note->kind != kStandNote) {
      seen.add(event);
      continue;
    }
    JsonReading reading(verbatim(kStepItem));
    const JsonFields fields(note->what, reading);
    used_s = fields.number("used_s", 0.0, 1e6, used_s);
    hints = static_cast<int>(fields.whole("hints", 0, 1000, hints));
  }
  return seen;
}

}  // namespace

fs::path autosaveFolder() {
  // As QStandardPaths::GenericDataLocation has it, without Qt.
  const char* const data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && fs::path(data).is_absolute()) return fs::path(data) / "echoweave" / "unsaved-work";
  const char* const home = std::getenv("HOME");
  return (home != nullptr ? fs::path(home) : fs::temp_directory_path()) / ".local" / "share" / "echoweave" / "unsaved-work";
}

void StepAutosave::begin(const LessonRun& run, const fs::path& caseFolder, const std::string& title) {
  isKept_ = run.attempt().has_value();
  events_ = 0;
  if (!isKept_) return;  // an author tries the lesson
  kept_.remove(kStepItem);
  kept_.describe(
      {{"kind", kKindOfStep},
       {"path", caseFolder.string()},
       {"title", title},
       {"attempt", run.attempt()->folder().string()},
       {"step_id", run.step().id},
       {"step",
        {{"lesson", run.lesson().id}, {"title", run.lesson().title}, {"number", run.at() + 1}, {"count", run.lesson().steps.size()}}}});
}

void StepAutosave::grow(const LessonRun& run, double now_s) {
  const ScanLog& log = run.log();
  if (!isKept_ || log.frameCount() == 0 || log.events().size() == events_) return;
  std::string lines;
  if (events_ == 0) {
    ScanRecording head;
    head.caseId = run.step().caseId.empty() ? run.attempt()->attempt().caseId : run.step().caseId;
    head.title = run.step().title;
    lines = journalHead(head);
  }
  lines += journalLines(log, events_);
  ScanLog stand;
  stand.addNote(log.end_s(), kStandNote, {{"used_s", run.used_s(now_s)}, {"hints", run.hintsGiven()}});
  kept_.append(kStepItem, lines + journalLines(stand, 0));
  events_ = log.events().size();
}

void StepAutosave::endStep(const LessonRun& run) {
  if (run.attempt() && run.attempt()->attempt().finishedAt) return forget();
  kept_.remove(kStepItem);
  events_ = 0;
}

void StepAutosave::forget() {
  isKept_ = false;
  events_ = 0;
  kept_.forget();
}

std::optional<StepAutosave::Left> StepAutosave::takeLeft(const fs::path& attempt) const {
  auto found = kept_.takeLeft([&](const json& about) {
    JsonReading reading(verbatim("about"));
    const JsonFields fields(about, reading);
    return fields.text("kind", "", 0) == kKindOfStep && fields.text("attempt", "", 0, 10000) == attempt.string();
  });
  std::optional<Left> left;
  for (Autosave::Left& each : found) {
    JsonReading reading(verbatim("about"));
    const std::string stepId = JsonFields(each.about(), reading).text("step_id", "", 0);
    const auto read = each.has(kStepItem) ? readJournal(each.fileOf(kStepItem)) : Result<ScanRecording>(ScanRecording());
    if (!read && read.error().code != ErrorCode::truncated) continue;  // a newer program may read it
    // A program that took up a step and could not keep it has left less of it than the one before.
    Left seen{attempt, stepId, {}, 0.0, 0, nullptr};
    if (read) seen.log = withoutStand(read->log, seen.used_s, seen.hints);
    if (left && (left->stepId != stepId || left->log.frameCount() >= seen.log.frameCount())) continue;
    seen.kept = std::make_shared<Autosave::Left>(std::move(each));
    left = std::move(seen);
  }
  return left;
}

std::optional<StepAutosave::Left> StepAutosave::takeLeftOfAny(const std::vector<fs::path>& attempts) const {
  for (const fs::path& each : attempts)
    if (auto left = takeLeft(each)) return left;
  return std::nullopt;
}

void StepAutosave::discardOnceKept(const std::shared_ptr<Autosave::Left>& left) {
  if (left) kept_.discardOnceKept(left);
}

}  // namespace ew::lessons
