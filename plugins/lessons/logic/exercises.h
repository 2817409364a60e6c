#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/exercise.h"
#include "ew/assessment/repetition.h"
#include "ew/core/progress.h"
#include "logic/step_scene.h"

namespace ew::lessons {

// Exercises that the program makes of a case, as steps of a lesson that nobody wrote.

/// What the exercises of a case stand on, and which there are.
struct ExercisePlan {
  ExerciseGround ground;
  ExerciseList list;
};

/// Takes seconds on a case with organs: for a job.
/// @param image  that is shown: its probe and depth are those of the exercises
/// @error as loadCaseTruth; badUsage (the body is not there yet), cancelled
[[nodiscard]] Result<ExercisePlan> planExercises(const Case& opened, const sdk::Scanned& scanned, const ScanState& image,
                                                 Progress& progress);

/// Those that a trainee may be asked: without those that give a finding away, unless `withFindings`.
[[nodiscard]] std::vector<Exercise> offered(const ExerciseList& list, bool withFindings);

/// An exercise by its id alone. Empty: it is no id of an exercise.
[[nodiscard]] std::optional<Exercise> exerciseOfId(const std::string& id);

/// An exercise as a step: target, tolerances, aids and time of its level. Its texts are English, by the target's own name.
/// @error badField: the case does not know the target any more
[[nodiscard]] Result<LessonStep> stepOf(const Exercise& exercise, const ExerciseGround& ground, int level);
/// "Find the plane “%1”", and what to do then. @param name as the trainee reads it
[[nodiscard]] Message titleOf(const Exercise& exercise, const std::string& name);
[[nodiscard]] Message taskOf(const Exercise& exercise);

/// The work of an exercise: it sees and asks for what the step of its kind does, and is judged by judgeExercise.
/// @error as workOf
[[nodiscard]] Result<std::unique_ptr<StepWork>> exerciseWork(const Exercise& exercise, std::shared_ptr<const ExercisePlan> plan, int level,
                                                             const LessonStep& step, const StepScene& scene);

/// How one person stands with the exercises of a case.
struct ExerciseOverview {
  std::size_t tried = 0;
  std::size_t due = 0;                              ///< of the tried
  std::optional<std::chrono::sys_seconds> nextDue;  ///< the soonest that is not due yet
  std::optional<Exercise> strongest;                ///< known for the longest; only what was passed at least twice in a row
  std::optional<Exercise> weakest;                  ///< failed most often; only what was failed the last time
};
[[nodiscard]] ExerciseOverview overviewOf(const std::vector<RepetitionState>& states, const std::string& caseId,
                                          std::chrono::sys_seconds now);

}  // namespace ew::lessons
