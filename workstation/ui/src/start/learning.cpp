#include "start/learning.h"

#include <spdlog/spdlog.h>
#include <QLocale>
#include <algorithm>

#include "ew/assessment/attempt_result.h"
#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "ew/sdk/person.h"

namespace ew::ui {
namespace {

constexpr std::size_t kMostLookedAt = 8;  // of the lessons that were stopped; an older one is hardly gone on with

/// Empty: its case or its lesson is not there any more.
std::optional<ResumableLesson> stoppedOf(const LessonInterruption& interrupted, const std::filesystem::path& library,
                                         const std::string& language) {
  const auto folder = findCase(interrupted.caseId, library);
  if (!folder) return std::nullopt;
  const auto opened = loadCase(*folder);
  if (!opened) return std::nullopt;
  const auto lessons = lessonsOf(*opened);
  if (!lessons) return std::nullopt;
  for (const Lesson& lesson : *lessons) {
    if (lesson.id != interrupted.lessonId || lesson.steps.empty()) continue;
    return ResumableLesson{*folder, lesson.id, ew::wordsOf(*folder, language).of(lesson.title),
                           std::min(interrupted.endedSteps + 1, lesson.steps.size()), lesson.steps.size()};
  }
  return std::nullopt;
}

Learning::Known knownBy(const AttemptList& attempts, const std::filesystem::path& library, const std::string& person,
                        const std::string& language) {
  Learning::Known known;
  known.standings = LearningProgress(attempts, person, attemptJudgeOf(library));
  if (const auto file = shippedCourseFile()) {
    if (auto course = readCourse(*file))
      known.course = standingIn(std::move(*course), known.standings, library, language);
    else
      spdlog::warn("{}", course.error().sentence());
  }
  const auto interrupted = known.standings.interrupted();
  for (std::size_t n = 0; n < std::min(interrupted.size(), kMostLookedAt) && !known.stopped; ++n)
    known.stopped = stoppedOf(interrupted[n], library, language);
  return known;
}

}  // namespace

Learning::Learning(QObject* parent) : QObject(parent) {}
Learning::~Learning() = default;

void Learning::refresh() {
  if (waiting_ > 1) return;  // one that has not begun reads what there is by then
  ++waiting_;
  worker_.add([this, library = libraryFolder(), person = sdk::personWhoLearns(), language = QLocale().name().toStdString()] {
    const AttemptList attempts = listAttempts(attemptsFolder(library));
    auto known = std::make_shared<const Known>(knownBy(attempts, library, person, language));
    QMetaObject::invokeMethod(
        this, [this, known = std::move(known), problems = attempts.problems] { take(known, problems); }, Qt::QueuedConnection);
  });
}

void Learning::take(std::shared_ptr<const Known> known, const std::vector<Error>& problems) {
  --waiting_;
  known_ = std::move(known);
  Q_EMIT changed();
  for (const Error& problem : problems)
    if (told_.insert(problem.sentence()).second) Q_EMIT failed(problem);
}

}  // namespace ew::ui
