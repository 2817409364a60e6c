#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_score.h"
#include "ew/library/attempt.h"
#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/lesson.h"

namespace ew {

/// What an attempt amounts to: the one answer that window, reports, tables, record stores, learning systems and archives give.
struct AttemptResult {
  /// The score that counts: the one that was kept, where it is of this attempt as it is now and of no earlier plan. Else (number 0, no key)
  /// what the lesson said of each step, weighted and passed by the plan: metrics do not count in it, for nobody has worked them out.
  AttemptScore counted;
  bool isScored = false;  ///< `counted` was kept
  bool isKnown = true;    ///< false: there is neither a score nor the lesson, so nobody knows which steps count, and nothing is judged
  bool areAlike = false;  ///< no step weighs anything (a lesson of reading alone), so that all count alike
  std::size_t stepsPassed = 0;
  std::size_t stepsJudged = 0;         ///< those that count in the score; reading and watching do not, unless the plan says so
  std::size_t stepsHandedIn = 0;       ///< that wait for somebody who can open the answers
  double worked_s = 0.0;               ///< on all tries of all steps, pauses left out
  std::optional<double> passLevel;     ///< of the lesson's plan, 0 to 1; empty: every step that counts has to be passed
  std::optional<double> masteryScore;  ///< of the launch that began the attempt, 0 to 1; empty: no learning system asks for one
  std::chrono::sys_seconds startedAt{};
  std::optional<std::chrono::sys_seconds> finishedAt;  ///< empty: it was stopped in the middle

  /// 0 to 1; empty: it waits to be judged, or nobody knows what counts.
  [[nodiscard]] std::optional<double> score() const;
  [[nodiscard]] std::optional<bool> passed() const;
};
/// "passed", "not passed", "handed in", "not scored yet".
[[nodiscard]] Message verdictWord(const AttemptResult& result);

/// Whether a learning system is told *passed*: by its own mastery score where it asks for one and there is a score to compare (cmi5, 9.3.4
/// and 9.3.5: nothing else may be told to it), else as the lesson says. Everybody else reads the lesson's verdict (decision 0077).
/// @param score 0 to 1 @param passed what the lesson says @param masteryScore 0 to 1
[[nodiscard]] bool passedForSystem(std::optional<double> score, bool passed, std::optional<double> masteryScore);
/// Where a learning system is told another verdict than the lesson's: both, with what each asks for, for whoever reads one of them. Nothing
/// where they agree, where the system asks for no score, and of what waits to be judged.
[[nodiscard]] Message systemVerdictRemark(const AttemptResult& result, std::optional<double> masteryScore);
/// What a step weighs in the score of its attempt: 1 where no step weighs anything, for all count alike then.
[[nodiscard]] double weightIn(const AttemptResult& result, const StepScore& step);

/// @param lesson as it was tried; null: it is not known @param kept the latest score
[[nodiscard]] AttemptResult attemptResultOf(const Attempt& attempt, const Lesson* lesson, const AssessmentPlan& plan,
                                            std::optional<AttemptScore> kept);

/// For LearningProgress: what trainees read of their attempts is what instructors read of them. Lessons and plans are read once.
[[nodiscard]] AttemptJudge attemptJudgeOf(const std::filesystem::path& library);

/// The score of the whole attempt and whether it is passed, of its steps: the weighted mean, or the plain one where no step weighs
/// anything; passed from the plan's level on, or, without one, when the attempt was finished and every step that counts was passed.
void concludeLesson(const AssessmentPlan& plan, bool isFinished, AttemptScore& score);

/// A lesson with the case that holds it, as it was when it was tried where the library still has that.
struct AttemptLesson {
  Case home;
  Lesson lesson;
  bool isAsTried = true;  ///< false: it has changed since, and this is how it is now
};
/// @param content of the lesson (Attempt::lessonContent); empty: as it is now
/// @error notFound (case, lesson), as loadCase
[[nodiscard]] Result<AttemptLesson> triedLessonOf(const std::string& caseId, const std::string& lessonId, const std::string& content,
                                                  const std::filesystem::path& library);

/// Results of the attempts of a library. Lessons and plans are read once, for an attempt at a lesson seldom comes alone. For one thread.
class AttemptResults {
 public:
  explicit AttemptResults(std::filesystem::path library) : library_(std::move(library)) {}
  /// By the plan of revision 0 where planOf has none. @param folder of the attempt
  [[nodiscard]] AttemptResult of(const std::filesystem::path& folder, const Attempt& attempt);
  /// The lesson as the library has it; null: not at all.
  [[nodiscard]] const AttemptLesson* lessonOf(const Attempt& attempt);
  /// The plan that counts; one of revision 0 where there is none. @error as readPlan
  [[nodiscard]] const Result<AssessmentPlan>& planOf(const Attempt& attempt);

 private:
  std::filesystem::path library_;
  std::map<std::tuple<std::string, std::string, std::string>, std::shared_ptr<const AttemptLesson>> lessons_;  ///< by case, id and content
  std::map<std::pair<std::string, std::string>, Result<AssessmentPlan>> plans_;                                ///< by case and lesson
};

}  // namespace ew
