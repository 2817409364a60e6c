#pragma once

#include <QString>
#include <string_view>
#include <vector>

namespace ew::lessons {

/// What a kind of step is called, and what it is in a sentence. @param taskWord as taskWord() has it
[[nodiscard]] QString kindTitle(std::string_view taskWord);
[[nodiscard]] QString kindTip(std::string_view taskWord);
/// The kinds in the order of LessonTask.
[[nodiscard]] const std::vector<std::string_view>& kindWords();

}  // namespace ew::lessons
