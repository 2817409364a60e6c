#pragma once

#include <QString>

#include "ew/library/learning_progress.h"

namespace ew::ui {

/// "Passed", "3 of 9 steps passed", "Stopped in step 3 of 9", "Not begun yet".
[[nodiscard]] QString standingWords(const LessonStanding& standing, std::size_t steps);
/// "✓", "◐" or "○", which say the same without words.
[[nodiscard]] QString standingSign(const LessonStanding& standing, std::size_t steps);
/// What the button of a lesson says: "Start", "Go on", "Once more".
[[nodiscard]] QString startWords(const LessonStanding& standing, std::size_t steps);
/// The day of a moment, in the words of the language: "26 Nov 2026".
[[nodiscard]] QString dayWords(std::chrono::sys_seconds moment);

}  // namespace ew::ui
