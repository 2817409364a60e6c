#include "editor/lesson_document.h"

#include <QPointer>
#include <algorithm>
#include <memory>
#include <utility>

#include "ew/library/published.h"
#include "ew/sdk/case_parts.h"
#include "ew/widgets/words.h"

namespace ew::lessons {
namespace {

const std::string kPart(kLessonsPart);

/// The user's own cases, the program's and those that are published, each id once and without `home`. In a job.
std::vector<Case> casesBeside(const std::string& home, Progress& progress) {
  std::vector<Case> all;
  const auto add = [&](Case found) {
    const bool isKnown = found.id == home || std::any_of(all.begin(), all.end(), [&](const Case& one) { return one.id == found.id; });
    if (!isKnown) all.push_back(std::move(found));
  };
  std::vector<std::filesystem::path> roots = {ownCasesFolder()};
  if (auto shipped = shippedCasesFolder()) roots.push_back(*shipped);
  for (const auto& root : roots)
    for (Case& each : listCases(root).cases) add(std::move(each));
  for (const CaseRevision& each : listPublished(libraryFolder())) {
    if (progress.cancelRequested()) break;
    if (auto opened = loadCase(each.folder)) add(std::move(*opened));
  }
  return all;
}

}  // namespace

LessonDocument::LessonDocument(sdk::Host& host, QObject* parent) : QObject(parent), host_(host) {
  tickets_ = {host_.cases().onChanged([this] {
                read();
                Q_EMIT changed();
              }),
              host_.caseParts().onOpened([this](const std::filesystem::path&) {
                library_.reset();
                isReadingLibrary_ = false;
                ++opened_;
                typedIn_.clear();
                read();
                Q_EMIT opened();
              })};
  read();
}

void LessonDocument::read() {
  lessons_.clear();
  problem_.reset();
  if (!editing_) typedIn_.clear();
  home_ = host_.cases().current();
  if (!home_) return;
  auto lessons = lessonsOf(*home_);
  if (lessons)
    lessons_ = std::move(*lessons);
  else
    problem_ = lessons.error();
}

std::filesystem::path LessonDocument::folder() const { return host_.caseParts().folderOf(kPart); }

Result<void> LessonDocument::edit(const QString& what, const std::string& mergeKey, const Edit& edit) {
  if (problem_) return passOn(*problem_);
  if (!home_) return failure(ErrorCode::notFound, say<"No case is open; open one first.">());
  if (mergeKey.empty() || mergeKey != typedIn_) beforeTyping_ = lessons_;
  typedIn_ = mergeKey;
  const Lessons next = edit(lessons_);
  if (next == lessons_) return {};
  const nlohmann::json section = host_.caseParts().read(kPart).value_or(nullptr);
  const nlohmann::json changedSection = withLessons(section, next);
  // The section's schema says less than its reader: a trim that ends before it begins, for instance.
  const auto readable = lessonsFromJson(changedSection);
  editing_ = true;
  auto done = readable ? host_.caseParts().edit(kPart, changedSection, what.toStdString(), mergeKey)
                       : Result<void>(tl::unexpected(readable.error()));
  // What is fit to be used only on the way to something that is not must not stay in the case: nobody meant it.
  if (!done && !mergeKey.empty() && lessons_ != beforeTyping_)
    static_cast<void>(host_.caseParts().edit(kPart, withLessons(section, beforeTyping_), what.toStdString(), mergeKey));
  editing_ = false;
  return done;
}

const std::vector<Case>& LessonDocument::library() {
  if (!library_) readLibrary();
  return library_ ? *library_ : noCases_;
}

void LessonDocument::readLibrary() {
  if (std::exchange(isReadingLibrary_, true)) return;
  const int of = opened_;
  auto found = std::make_shared<std::vector<Case>>();
  host_.jobs().start(
      tr("Looking for cases that a step may scan").toStdString(),
      [found, home = home_ ? home_->id : std::string()](Progress& progress) -> Result<void> {
        *found = casesBeside(home, progress);
        // Of half a library it would be said that a step's case is not in it.
        if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
        return {};
      },
      [document = QPointer<LessonDocument>(this), found, of](const Result<void>& done) {
        if (!document || document->opened_ != of) return;
        document->isReadingLibrary_ = false;
        if (!done) return;  // asked for again by whoever looks next
        document->library_ = std::move(*found);
        Q_EMIT document->changed();
      });
}

const Case* LessonDocument::caseById(const std::string& id) {
  for (const Case& each : library())
    if (each.id == id) return &each;
  return nullptr;
}

const Case* LessonDocument::scannedBy(const LessonStep& step) {
  if (!home_) return nullptr;
  return step.caseId.empty() || step.caseId == home_->id ? &*home_ : caseById(step.caseId);
}

std::vector<LessonProblem> LessonDocument::problemsOf(const Lesson& lesson) {
  if (!home_) return {};
  auto problems = ew::problemsOf(lesson, *home_, [this](const std::string& id) { return caseById(id); });
  // Until the library was read nobody knows what is in it.
  if (!library_)
    std::erase_if(problems, [&](const LessonProblem& problem) {
      const LessonStep* step = stepIn(lesson, problem.stepId);
      return step != nullptr && !step->caseId.empty() && step->caseId != home_->id;
    });
  return problems;
}

Result<void> LessonDocument::makeOwn() { return host_.cases().makeOwn(); }

const LessonStep* StepEdit::step() const {
  const Lesson* in = lesson();
  return in == nullptr ? nullptr : stepIn(*in, stepId);
}

Result<void> StepEdit::change(const QString& what, const std::string& field, const std::function<void(LessonStep&)>& change) const {
  const std::string key = field.empty() ? std::string() : lessonId + "/" + stepId + "/" + field;
  return document.edit(what, key, [&](Lessons lessons) {
    return withChanged(std::move(lessons), lessonId, [&](Lesson& one) { one = withStepChanged(std::move(one), stepId, change); });
  });
}

}  // namespace ew::lessons
