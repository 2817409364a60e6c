#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ew/library/lesson.h"
#include "ew/scanning/state.h"
#include "ew/simulated_people/trainee_habits.h"
#include "trainee_motion.h"

namespace ew::assessment {

/// A machine's settings as they act, in the order of kLessonSettings: depth_mm, gain_db, dynamic_range_db, focus_mm.
using Machine = std::array<double, std::size(kLessonSettings)>;
[[nodiscard]] Machine machineOf(const ScanState& state);

/// What a person changes who means `wanted`: some settings are left as they are (nothing), some changed too far, all a little beside.
using MachineChange = std::array<std::optional<double>, std::size(kLessonSettings)>;
/// @param insists sets even what is nearly right
[[nodiscard]] MachineChange setBy(const TraineeHabits& habits, RandomNumbers& random, const ScanState& now, const Machine& wanted,
                                  bool insists);

/// Turns the knobs one after the other in the plan, from a moment on, each in a few steps.
/// @return when the last one is turned
double turnKnobs(const ScanState& now, const MachineChange& to, double from_s, HandPlan& plan);

/// What a step asks for, where it does: the middle of each band.
[[nodiscard]] Machine withBands(Machine wanted, const SettingsTask& task);

/// The probe that a person takes for a step that asks for one of `asked`.
[[nodiscard]] const Probe& chosenProbe(const TraineeHabits& habits, RandomNumbers& random, const std::vector<Probe>& offered,
                                       const std::vector<std::string>& asked, const Probe& now);

}  // namespace ew::assessment
