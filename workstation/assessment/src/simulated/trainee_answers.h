#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "ew/assessment/trainee_case.h"
#include "ew/assessment/trainee_habits.h"
#include "measures/random_numbers.h"

namespace ew::assessment {

/// What people hand in, in the form of StepWork::answerOf.
[[nodiscard]] nlohmann::json answerBy(const TraineeHabits& habits, RandomNumbers& random, const AnswerTask& task);
/// Calipers in a frozen image, as near to the truth's points as its plane lets them.
[[nodiscard]] nlohmann::json measuredBy(const TraineeHabits& habits, RandomNumbers& random, const ExpectedMeasurement& expected,
                                        const ScanState& image);
/// A click in a frozen image on a point or a structure. @param structure not 0: its label, else the point counts
[[nodiscard]] nlohmann::json pointedBy(const TraineeHabits& habits, RandomNumbers& random, const TraineeCase& on, int structure,
                                       const glm::dvec3& point_mm, const ScanState& image);

}  // namespace ew::assessment
