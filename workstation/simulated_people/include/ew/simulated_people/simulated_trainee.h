#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ew/library/attempt.h"
#include "ew/library/step_answer.h"
#include "ew/simulated_people/trainee_case.h"
#include "ew/simulated_people/trainee_habits.h"

namespace ew {

/// What the window keeps of one step of a person's attempt.
struct SimulatedStep {
  std::string stepId;
  ScanLog log;  ///< empty: nothing was scanned in it
  StepAnswer answer;
  double seconds = 0.0;  ///< spent on the step
  int hints = 0;
};

struct SimulationOptions {
  double rate_hz = 20.0;    ///< of images, > 0; the motion does not depend on it
  double shortest_s = 0.0;  ///< of all scanning together: whoever is done sooner looks about; 0: nobody does
  /// Asked for every image; once it is true, what there is of the attempt is returned at once and is of no use. Empty: nobody stops it.
  std::function<bool()> stopped = {};
};

/// A person works through a lesson from its first step to its last. The same steps for the same habits, seed and options on every machine.
/// What it leaves out of life is listed in resources/docs/science/simulated-trainees.md.
/// @param on the case that holds the lesson and that all of its steps scan
/// @param habits of the day
[[nodiscard]] std::vector<SimulatedStep> simulateAttempt(const Lesson& lesson, const TraineeCase& on, const TraineeHabits& habits,
                                                         std::uint64_t seed, const SimulationOptions& options = {});

/// Who is said to have made an attempt.
struct SimulatedPerson {
  SkillLevel level = SkillLevel::novice;
  int number = 1;          ///< "novice 07"
  std::uint64_t seed = 1;  ///< of the attempt; said in the attempt, which says as well that it is simulated
  [[nodiscard]] std::string name() const;
};

/// Writes an attempt as the window keeps it, judged by the rules of its steps: ROOT/ID/attempt.json and a recording of each step that was
/// scanned in. Times stand as if it had begun at `begun`; the id is made of that and the seed.
/// @return the attempt's folder
/// @error as AttemptFolder, writeRecording, workOf; cancelled, within 0.1 s
[[nodiscard]] Result<std::filesystem::path> keepSimulatedAttempt(const Lesson& lesson, const TraineeCase& on,
                                                                 const std::vector<SimulatedStep>& steps, const SimulatedPerson& person,
                                                                 std::chrono::sys_seconds begun, const std::filesystem::path& root,
                                                                 Progress& progress = noProgress());

}  // namespace ew
