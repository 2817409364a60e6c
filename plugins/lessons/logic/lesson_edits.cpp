#include "logic/lesson_edits.h"

#include <algorithm>
#include <cmath>

namespace ew::lessons {
namespace {

template <class All>
auto placeOf(All& all, std::string_view id) {
  return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == id; });
}

template <class All>
std::vector<std::string> idsOf(const All& all) {
  std::vector<std::string> ids;
  for (const auto& one : all) ids.push_back(one.id);
  return ids;
}

template <class All>
void insertBehind(All& all, typename All::value_type added, std::string_view after, std::string_view otherwise) {
  added.id = idFor(added.title, idsOf(all), otherwise);
  auto at = placeOf(all, after);
  all.insert(at == all.end() ? at : at + 1, std::move(added));
}

template <class All>
void moveTo(All& all, std::string_view id, std::size_t place) {
  const auto at = placeOf(all, id);
  if (at == all.end()) return;
  const auto to = all.begin() + static_cast<std::ptrdiff_t>(std::min(place, all.size() - 1));
  if (to < at)
    std::rotate(to, at, at + 1);
  else
    std::rotate(at, at + 1, to + 1);
}

template <class All>
void copyBehind(All& all, std::string_view id, const std::string& title, std::string_view otherwise) {
  const auto at = placeOf(all, id);
  if (at == all.end()) return;
  auto copy = *at;
  copy.title = title;
  insertBehind(all, std::move(copy), id, otherwise);
}

/// How far a setting may be off when an author takes the present one: about what still gives a good image.
double marginOf(std::string_view setting) {
  if (setting == "gain_db") return 3.0;
  if (setting == "dynamic_range_db") return 10.0;
  return 15.0;  // depth and focus, mm
}

}  // namespace

nlohmann::json withLessons(nlohmann::json section, const Lessons& lessons) {
  if (!section.is_object()) section = nlohmann::json::object();
  section.update(jsonOf(lessons));
  return section;
}

LessonStep newStep(std::string_view taskWord, std::string title) {
  LessonStep step;
  step.title = std::move(title);
  step.task = taskOfWord(taskWord).value_or(ReadingTask{});
  return step;
}

Lesson newLesson(std::string title, std::string language, const std::vector<std::pair<std::string_view, std::string>>& steps) {
  Lesson lesson;
  lesson.title = std::move(title);
  lesson.language = std::move(language);
  for (const auto& [kind, name] : steps) lesson = withStep(std::move(lesson), newStep(kind, name));
  return lesson;
}

const Lesson* lessonIn(const Lessons& lessons, std::string_view id) {
  const auto at = placeOf(lessons, id);
  return at == lessons.end() ? nullptr : &*at;
}

const LessonStep* stepIn(const Lesson& lesson, std::string_view id) {
  const auto at = placeOf(lesson.steps, id);
  return at == lesson.steps.end() ? nullptr : &*at;
}

Lessons withLesson(Lessons lessons, Lesson added, std::string_view after) {
  insertBehind(lessons, std::move(added), after, "lesson");
  return lessons;
}

Lessons withCopyOf(Lessons lessons, std::string_view id, const std::string& title) {
  copyBehind(lessons, id, title, "lesson");
  return lessons;
}

Lessons without(Lessons lessons, std::string_view id) {
  std::erase_if(lessons, [&](const Lesson& one) { return one.id == id; });
  return lessons;
}

Lessons withMoved(Lessons lessons, std::string_view id, std::size_t place) {
  moveTo(lessons, id, place);
  return lessons;
}

Lessons withChanged(Lessons lessons, std::string_view id, const std::function<void(Lesson&)>& change) {
  const auto at = placeOf(lessons, id);
  if (at == lessons.end()) return lessons;
  change(*at);
  at->id = id;
  return lessons;
}

Lesson withStep(Lesson lesson, LessonStep added, std::string_view after) {
  insertBehind(lesson.steps, std::move(added), after, "step");
  return lesson;
}

Lesson withCopyOfStep(Lesson lesson, std::string_view id, const std::string& title) {
  copyBehind(lesson.steps, id, title, "step");
  return lesson;
}

Lesson withoutStep(Lesson lesson, std::string_view id) {
  std::erase_if(lesson.steps, [&](const LessonStep& one) { return one.id == id; });
  return lesson;
}

Lesson withStepMoved(Lesson lesson, std::string_view id, std::size_t place) {
  moveTo(lesson.steps, id, place);
  return lesson;
}

Lesson withStepChanged(Lesson lesson, std::string_view id, const std::function<void(LessonStep&)>& change) {
  const auto at = placeOf(lesson.steps, id);
  if (at == lesson.steps.end()) return lesson;
  change(*at);
  at->id = id;
  return lesson;
}

std::vector<std::string> listOfLines(std::string_view lines) {
  std::vector<std::string> list;
  while (!lines.empty()) {
    const auto end = std::min(lines.find('\n'), lines.size());
    std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) continue;
    const auto last = line.find_last_not_of(" \t\r");
    list.emplace_back(line.substr(first, last - first + 1));
  }
  return list;
}

std::string linesOfList(const std::vector<std::string>& list) {
  std::string lines;
  for (const std::string& each : list) lines += (lines.empty() ? "" : "\n") + each;
  return lines;
}

WatchTask withMark(WatchTask task, ExpertMark mark) {
  const auto at = std::upper_bound(task.marks.begin(), task.marks.end(), mark,
                                   [](const ExpertMark& a, const ExpertMark& b) { return a.time_s < b.time_s; });
  task.marks.insert(at, std::move(mark));
  return task;
}

WatchTask withoutMark(WatchTask task, std::size_t number) {
  if (number < task.marks.size()) task.marks.erase(task.marks.begin() + static_cast<std::ptrdiff_t>(number));
  return task;
}

WatchTask trimmed(WatchTask task, double begin_s, double end_s, double first_s, double last_s) {
  constexpr double kShortest_s = 0.1;
  const double latest_s = std::max(first_s, last_s - kShortest_s);
  begin_s = std::clamp(begin_s, first_s, latest_s);
  end_s = std::clamp(end_s, std::min(begin_s + kShortest_s, last_s), last_s);
  task.begin_s = begin_s > first_s ? std::optional(begin_s) : std::nullopt;
  task.end_s = end_s < last_s && end_s > begin_s ? std::optional(end_s) : std::nullopt;
  return task;
}

SettingBand bandAround(std::string_view setting, double value) {
  const double margin = marginOf(setting);
  const double lowest = setting.ends_with("_mm") || setting == "dynamic_range_db" ? std::max(0.0, value - margin) : value - margin;
  return {std::string(setting), std::round(lowest), std::round(value + margin)};
}

}  // namespace ew::lessons
