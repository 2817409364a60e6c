#include "ew/library/learning_progress.h"

#include <algorithm>
#include <set>

#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "ew/library/published.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

std::size_t passedSteps(const Attempt& attempt, const std::vector<std::string>& steps) {
  std::set<std::string> passed;
  for (const StepOutcome& each : attempt.outcomes)  // the latest of a step counts
    if (each.verdict == StepVerdict::passed)
      passed.insert(each.stepId);
    else
      passed.erase(each.stepId);
  if (steps.empty()) return passed.size();
  return static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [&](const auto& id) { return passed.contains(id); }));
}

std::size_t endedSteps(const Attempt& attempt) {
  std::set<std::string> ended;
  for (const StepOutcome& each : attempt.outcomes) ended.insert(each.stepId);
  return ended.size();
}

std::chrono::sys_seconds lastMoment(const Attempt& attempt) {
  auto last = attempt.finishedAt.value_or(attempt.startedAt);
  for (const StepOutcome& each : attempt.outcomes) last = std::max(last, each.at);
  return last;
}

/// Whether it is no more than a name, which leads out of no folder.
bool isName(const std::string& id) { return !id.empty() && id.find('/') == std::string::npos && id != "." && id != ".."; }

fs::path ownCasesOf(const fs::path& library) { return library == libraryFolder() ? ownCasesFolder() : library / "cases"; }

/// The case of a folder of cases: by the folder's name, as nearly all are named, or by looking into each.
std::optional<fs::path> caseIn(const fs::path& cases, const std::string& id) {
  if (const auto named = loadCase(cases / id); named && named->id == id) return named->folder;
  for (const Case& each : listCases(cases).cases)
    if (each.id == id) return each.folder;
  return std::nullopt;
}

/// What the course shows of its lessons in one case.
void fillFrom(const fs::path& folder, const std::string& language, const std::string& caseId, const LearningProgress& standings,
              std::vector<CourseStep>& steps) {
  const auto opened = loadCase(folder);
  if (!opened) return;
  const auto lessons = lessonsOf(*opened);
  if (!lessons) return;
  const CaseWords words = wordsOf(folder, language);
  for (CourseStep& step : steps)
    for (const Lesson& lesson : *lessons) {
      if (step.lesson.caseId != caseId || step.lesson.lessonId != lesson.id) continue;
      step.caseFolder = folder;
      step.title = words.of(lesson.title);
      step.caseTitle = words.of(titleForTrainees(*opened));
      step.minutes = lesson.minutes;
      step.steps = lesson.steps.size();
      step.standing = standings.of(caseId, lesson);
    }
}

}  // namespace

fs::path attemptsFolder(const fs::path& library) { return library / "attempts"; }

bool countsFor(const Attempt& attempt, const std::string& person) { return attempt.person.empty() || attempt.person == person; }

LearningProgress::LearningProgress(const AttemptList& attempts, const std::string& person, const AttemptJudge& judge) {
  for (const auto& [folder, attempt] : attempts.attempts) {
    if (!countsFor(attempt, person)) continue;
    Judged& one = attempts_[{attempt.caseId, attempt.lessonId}].emplace_back(Judged{folder, attempt, {}});
    if (judge && attempt.finishedAt) one.tally = judge(folder, attempt);
  }
}

LessonStanding LearningProgress::of(const std::string& caseId, const std::string& lessonId, const std::vector<std::string>& steps) const {
  LessonStanding standing;
  const auto found = attempts_.find({caseId, lessonId});
  if (found == attempts_.end()) return standing;
  for (const auto& [folder, attempt, tally] : found->second) {
    standing.last = std::max(standing.last.value_or(std::chrono::sys_seconds{}), lastMoment(attempt));
    if (attempt.finishedAt) {
      ++standing.attempts;
      const AttemptTally made = tally.value_or(AttemptTally{passedSteps(attempt, steps), 0, false});
      if (standing.attempts > 1 && std::pair(standing.passed, standing.bestPassed) >= std::pair(made.isPassed, made.passed)) continue;
      standing.passed = made.isPassed;
      standing.bestPassed = made.passed;
      standing.judged = made.judged;
    } else if (&attempt == &found->second.front().attempt) {
      standing.interrupted = folder;
      standing.interruptedAt = endedSteps(attempt);
    }
  }
  return standing;
}

LessonStanding LearningProgress::of(const std::string& caseId, const Lesson& lesson) const {
  std::vector<std::string> steps;
  for (const LessonStep& each : lesson.steps) steps.push_back(each.id);
  return of(caseId, lesson.id, steps);
}

std::vector<LessonInterruption> LearningProgress::interrupted() const {
  std::vector<std::pair<std::string, LessonInterruption>> found;
  for (const auto& [key, attempts] : attempts_) {
    const auto& [folder, attempt, tally] = attempts.front();
    if (!attempt.finishedAt)
      found.push_back({attempt.id, {attempt.caseId, attempt.lessonId, attempt.lessonTitle, endedSteps(attempt), folder}});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<LessonInterruption> lessons;
  for (auto& each : found) lessons.push_back(std::move(each.second));
  return lessons;
}

std::size_t CourseProgress::passed() const {
  return static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [](const CourseStep& each) { return each.isPassed(); }));
}

std::size_t CourseProgress::next() const {
  const auto open = std::find_if(steps.begin(), steps.end(), [](const CourseStep& each) { return each.isThere() && !each.isPassed(); });
  return static_cast<std::size_t>(open - steps.begin());
}

CourseProgress standingIn(Course course, const LearningProgress& standings, const fs::path& library, const std::string& language) {
  CourseProgress made;
  std::set<std::string> cases;
  for (const CourseLesson& each : course.lessons) {
    CourseStep step;
    step.lesson = each;
    made.steps.push_back(std::move(step));
    cases.insert(each.caseId);
  }
  for (const std::string& id : cases)
    if (const auto folder = findCase(id, library)) fillFrom(*folder, language, id, standings, made.steps);
  made.course = std::move(course);
  return made;
}

std::vector<fs::path> ownCases(const std::string& id, const fs::path& library) {
  std::vector<fs::path> found;
  if (!isName(id)) return found;
  const fs::path own = ownCasesOf(library);
  const auto named = loadCase(own / id);
  if (named && named->id == id) found.push_back(named->folder);
  for (const Case& each : listCases(own).cases)
    if (each.id == id && each.folder.filename() != id) found.push_back(each.folder);
  std::error_code ignored;
  if (!named && fs::exists(own / id / "case.json", ignored)) found.push_back(own / id);
  return found;
}

std::optional<fs::path> findCase(const std::string& id, const fs::path& library) {
  if (!isName(id)) return std::nullopt;
  if (auto found = caseIn(ownCasesOf(library), id)) return found;
  if (const auto published = latestPublished(library, id)) return published->folder;
  if (const auto shipped = shippedCasesFolder()) return caseIn(*shipped, id);
  return std::nullopt;
}

}  // namespace ew
