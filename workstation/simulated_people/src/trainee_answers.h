#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ew/assessment/random_numbers.h"
#include "ew/library/step_answer.h"
#include "ew/simulated_people/trainee_case.h"
#include "ew/simulated_people/trainee_habits.h"

namespace ew::assessment {

/// What people hand in.
[[nodiscard]] StepAnswer answerBy(const TraineeHabits& habits, RandomNumbers& random, const AnswerTask& task);
/// Calipers in a frozen image, as near to the truth's points as its plane lets them.
[[nodiscard]] StepAnswer measuredBy(const TraineeHabits& habits, RandomNumbers& random, const ReferenceMeasurement& expected,
                                    const ScanState& image);
/// A click in a frozen image on a point or a structure. @param structure not 0: its label, else the point counts
[[nodiscard]] StepAnswer pointedBy(const TraineeHabits& habits, RandomNumbers& random, const TraineeCase& on, int structure,
                                   const glm::dvec3& point_mm, const ScanState& image);

}  // namespace ew::assessment
