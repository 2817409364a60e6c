#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/library/attempt.h"
#include "ew/library/case_words.h"
#include "ew/library/course.h"
#include "ew/library/lesson.h"

namespace ew {

// How far somebody has got: worked out from the attempts that are kept, whenever it is asked for, so that it cannot say anything else than
// they do.

[[nodiscard]] std::filesystem::path attemptsFolder(const std::filesystem::path& library);

/// What a finished attempt amounts to, step by step.
struct AttemptTally {
  std::size_t passed = 0;
  std::size_t judged = 0;  ///< steps that count
  bool isPassed = false;   ///< the lesson
};
/// Who says so: the scores stand above this library (AttemptResults of assessment).
using AttemptJudge = std::function<AttemptTally(const std::filesystem::path& folder, const Attempt& attempt)>;

/// Of one lesson.
struct LessonStanding {
  std::size_t attempts = 0;                          ///< finished
  std::size_t bestPassed = 0;                        ///< steps, of the best attempt that was finished
  std::size_t judged = 0;                            ///< steps that count in that attempt; 0: nobody judged it, and all of them do
  bool passed = false;                               ///< that attempt, where it was judged
  std::optional<std::filesystem::path> interrupted;  ///< the latest attempt, when it was stopped in the middle
  std::size_t interruptedAt = 0;                     ///< steps ended in it, each counted once
  std::optional<std::chrono::sys_seconds> last;      ///< when it was worked on last
  bool operator==(const LessonStanding&) const = default;

  [[nodiscard]] bool isPassed(std::size_t steps) const { return attempts > 0 && (judged > 0 ? passed : bestPassed >= steps); }
  /// Of how many steps `bestPassed` are. @param steps of the lesson
  [[nodiscard]] std::size_t counting(std::size_t steps) const { return judged > 0 ? judged : steps; }
};

/// A lesson that was stopped in the middle.
struct LessonInterruption {
  std::string caseId;
  std::string lessonId;
  std::string lessonTitle;  ///< as it was when it began
  std::size_t endedSteps = 0;
  std::filesystem::path folder;  ///< of the attempt
  bool operator==(const LessonInterruption&) const = default;
};

/// Whether an attempt counts for a person: it bears their name or none, for a workstation where nobody gives a name has one trainee.
[[nodiscard]] bool countsFor(const Attempt& attempt, const std::string& person);

/// What one person's attempts say of all lessons.
class LearningProgress {
 public:
  LearningProgress() = default;
  /// @param judge asked once for each finished attempt of the person; none: a step is passed by the verdict that the lesson gave, and a
  /// lesson when all its steps are
  LearningProgress(const AttemptList& attempts, const std::string& person, const AttemptJudge& judge = {});

  /// @param steps ids of those that count, as a lesson has them now; empty: any
  [[nodiscard]] LessonStanding of(const std::string& caseId, const std::string& lessonId, const std::vector<std::string>& steps = {}) const;
  [[nodiscard]] LessonStanding of(const std::string& caseId, const Lesson& lesson) const;
  /// Those whose latest attempt was stopped, the latest first.
  [[nodiscard]] std::vector<LessonInterruption> interrupted() const;
  [[nodiscard]] bool empty() const { return attempts_.empty(); }

 private:
  struct Judged {
    std::filesystem::path folder;
    Attempt attempt;
    std::optional<AttemptTally> tally;  ///< empty: nobody judged it
  };
  using Key = std::pair<std::string, std::string>;  // case and lesson
  std::map<Key, std::vector<Judged>> attempts_;     ///< the latest first
};

/// A lesson of a course with what is needed to show and to open it.
struct CourseStep {
  CourseLesson lesson;
  std::filesystem::path caseFolder;  ///< empty: the library does not have it
  std::string title;
  std::string caseTitle;  ///< for trainees
  int minutes = 0;
  std::size_t steps = 0;
  LessonStanding standing;

  [[nodiscard]] bool isThere() const { return !caseFolder.empty(); }
  [[nodiscard]] bool isPassed() const { return isThere() && standing.isPassed(steps); }
};

/// A course as one person stands in it.
struct CourseProgress {
  Course course;
  std::vector<CourseStep> steps;
  [[nodiscard]] std::size_t passed() const;
  /// The first that is there and not passed; as many as there are: none.
  [[nodiscard]] std::size_t next() const;
};
/// Reads the cases of the course. @param language of the titles, as in a locale
[[nodiscard]] CourseProgress standingIn(Course course, const LearningProgress& standings, const std::filesystem::path& library,
                                        const std::string& language);

/// The author's own cases with this id, the one that findCase takes first; after them a folder of that name whose case cannot be opened,
/// so that nobody knows its id.
[[nodiscard]] std::vector<std::filesystem::path> ownCases(const std::string& id, const std::filesystem::path& library);
/// The folder of a case by its id: the author's own, else the latest published revision, else the shipped one.
[[nodiscard]] std::optional<std::filesystem::path> findCase(const std::string& id, const std::filesystem::path& library);

}  // namespace ew
