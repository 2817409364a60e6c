#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ew/library/lesson.h"

namespace ew::lessons {

// What an author does to the lessons of a case, as functions of values: lessons in, lessons out. Ids are given once and stay, for attempts
// are kept by them; whatever is not there, or cannot move further, leaves the lessons as they are.
using Lessons = std::vector<Lesson>;

/// The section with these lessons; fields that this program does not know stay in it. @param section as it stands, or null
[[nodiscard]] nlohmann::json withLessons(nlohmann::json section, const Lessons& lessons);

/// A step of a kind ("plane") with its usual values, still without target.
[[nodiscard]] LessonStep newStep(std::string_view taskWord, std::string title);
/// A lesson with steps of these kinds and titles, in this order. @param steps kind and title
[[nodiscard]] Lesson newLesson(std::string title, std::string language,
                               const std::vector<std::pair<std::string_view, std::string>>& steps = {});

[[nodiscard]] const Lesson* lessonIn(const Lessons& lessons, std::string_view id);
[[nodiscard]] const LessonStep* stepIn(const Lesson& lesson, std::string_view id);

/// Puts it behind `after`, or at the end, with an id that no other has.
[[nodiscard]] Lessons withLesson(Lessons lessons, Lesson added, std::string_view after = {});
/// The copy comes behind what was copied. Its steps keep their ids: they are unique in their lesson alone.
[[nodiscard]] Lessons withCopyOf(Lessons lessons, std::string_view id, const std::string& title);
[[nodiscard]] Lessons without(Lessons lessons, std::string_view id);
/// @param place where it is to stand, from 0
[[nodiscard]] Lessons withMoved(Lessons lessons, std::string_view id, std::size_t place);
[[nodiscard]] Lessons withChanged(Lessons lessons, std::string_view id, const std::function<void(Lesson&)>& change);

[[nodiscard]] Lesson withStep(Lesson lesson, LessonStep added, std::string_view after = {});
[[nodiscard]] Lesson withCopyOfStep(Lesson lesson, std::string_view id, const std::string& title);
[[nodiscard]] Lesson withoutStep(Lesson lesson, std::string_view id);
[[nodiscard]] Lesson withStepMoved(Lesson lesson, std::string_view id, std::size_t place);
/// What `change` does to id is undone: it stays.
[[nodiscard]] Lesson withStepChanged(Lesson lesson, std::string_view id, const std::function<void(LessonStep&)>& change);

/// Lines of a text field as a list, and back: lines without words are left out.
[[nodiscard]] std::vector<std::string> listOfLines(std::string_view lines);
[[nodiscard]] std::string linesOfList(const std::vector<std::string>& list);

/// A mark added or taken away; they stay in the order of their times.
[[nodiscard]] WatchTask withMark(WatchTask task, ExpertMark mark);
[[nodiscard]] WatchTask withoutMark(WatchTask task, std::size_t number);
/// A part of a recording from begin to end (s, on its clock); what is the whole at one side is not written there.
/// @param first_s, last_s of the recording. The part is at least a tenth of a second long.
[[nodiscard]] WatchTask trimmed(WatchTask task, double begin_s, double end_s, double first_s, double last_s);

/// What is right when the present value is right: whole numbers about as far around it as still give a good image.
[[nodiscard]] SettingBand bandAround(std::string_view setting, double value);

}  // namespace ew::lessons
