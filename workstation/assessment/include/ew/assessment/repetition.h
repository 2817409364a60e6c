#pragma once

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/exercise.h"
#include "ew/core/result.h"
#include "ew/library/attempt.h"

namespace ew {

inline constexpr int kRepetitionFormat = 1;  ///< `format` of the file; a larger one is refused with newerFormat
inline constexpr double kLeastEase = 1.3;
inline constexpr std::chrono::seconds kBackAfter{300};  ///< a failed exercise comes back within the session

/// What is known of one person and one exercise.
struct RepetitionState {
  std::string exerciseId;
  double ease = 2.5;           ///< by which intervals grow, kLeastEase and more
  int repetitions = 0;         ///< passed in a row since the last failure
  double interval_days = 0.0;  ///< until it is due, as it was planned last; 0 after a failure
  std::chrono::sys_seconds due{};
  std::chrono::sys_seconds last{};
  int tries = 0;
  int lapses = 0;  ///< failures
  int level = 1;   ///< at which it comes next, 1 to kExerciseLevels
  bool operator==(const RepetitionState&) const = default;
};

/// 0 (nothing) to 5 (with ease), 3 and more for passing, as SM-2 takes them. A hint costs a grade, but not the pass.
[[nodiscard]] int gradeOf(const StepResult& result, int hints = 0);

/// The state after a try. Source: P. A. Wozniak, "Optimization of learning", 1990, algorithm SM-2: the ease grows by
/// 0.1 - (5 - q) (0.08 + (5 - q) 0.02), never below 1.3; intervals are 1 day, 6 days, then the last one times the ease; below grade 3
/// they begin anew and the ease stays. Ours differs: a failure is due again after kBackAfter (SM-2 repeats the same day); an exercise
/// passed before it was due, and after its last try, grows from the time that really passed where that is shorter than its interval; grades
/// 4 and 5 raise the level, failures lower it.
/// @param grade 0..5, brought to the nearer end
[[nodiscard]] RepetitionState afterwards(const RepetitionState& state, int grade, std::chrono::sys_seconds when);

/// What to do next, and how hard.
struct NextExercise {
  std::string exerciseId;
  int level = 1;
  bool operator==(const NextExercise&) const = default;
};

/// Of four tries two go to what is most overdue in terms of its own interval (failures first), one to what has waited longest, one to
/// something new; when there is none of the kind, to the next kind, and when nothing is due, to what is due soonest. So nothing is left out
/// for ever. The exercise tried last comes again only when there is no other.
/// @param states of exercises that are no more are left alone
/// @param seed   the order of new exercises
/// @return nothing when there are no exercises
[[nodiscard]] std::optional<NextExercise> nextExercise(const std::vector<RepetitionState>& states, const std::vector<Exercise>& exercises,
                                                       std::chrono::sys_seconds now, std::uint64_t seed);

/// @error badField (also an exercise twice), newerFormat (with both format numbers)
[[nodiscard]] Result<std::vector<RepetitionState>> repetitionFromJson(const nlohmann::json& document);
/// repetitionFromJson(jsonOf(states)) == states.
[[nodiscard]] nlohmann::json jsonOf(const std::vector<RepetitionState>& states);

}  // namespace ew
