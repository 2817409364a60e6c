#include "logic/lesson_edits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

namespace ew::lessons {
namespace {

constexpr std::string_view kKinds[] = {"read", "watch", "plane", "sweep", "measure", "point", "settings", "answer", "free"};

Lessons three() {
  Lessons lessons;
  for (const char* title : {"One", "Two", "Three"}) lessons = withLesson(lessons, newLesson(title, "en"));
  return lessons;
}

std::string idsIn(const Lessons& lessons) {
  std::string ids;
  for (const Lesson& one : lessons) ids += one.id + " ";
  return ids;
}

std::string stepsIn(const Lesson& lesson) {
  std::string ids;
  for (const LessonStep& one : lesson.steps) ids += one.id + " ";
  return ids;
}

TEST(LessonEdits, NewLessonsStandBehindTheChosenOneWithIdsOfTheirTitles) {
  Lessons lessons = three();
  EXPECT_EQ(idsIn(lessons), "one two three ");
  lessons = withLesson(lessons, newLesson("One", "de"), "one");
  EXPECT_EQ(idsIn(lessons), "one one-2 two three ");
  EXPECT_EQ(lessonIn(lessons, "one-2")->language, "de");
  EXPECT_EQ(lessonIn(lessons, "four"), nullptr);
}

TEST(LessonEdits, ACopyHasAnIdOfItsOwnAndTheSameSteps) {
  Lessons lessons = {newLesson("One", "en", {{"read", "Read this"}, {"plane", "Set it"}})};
  lessons.front().id = "one";
  const Lessons copied = withCopyOf(lessons, "one", "One again");
  EXPECT_EQ(idsIn(copied), "one one-again ");
  EXPECT_EQ(copied[1].steps, copied[0].steps);
  EXPECT_EQ(copied[0], lessons[0]);
}

TEST(LessonEdits, RenamingAndChangingKeepTheId) {
  const Lessons lessons = withChanged(three(), "two", [](Lesson& lesson) {
    lesson.title = "Another title";
    lesson.id = "another";
  });
  EXPECT_EQ(idsIn(lessons), "one two three ");
  EXPECT_EQ(lessons[1].title, "Another title");
}

TEST(LessonEdits, MovingPutsALessonWhereItIsWanted) {
  EXPECT_EQ(idsIn(withMoved(three(), "one", 2)), "two three one ");
  EXPECT_EQ(idsIn(withMoved(three(), "three", 0)), "three one two ");
  EXPECT_EQ(idsIn(withMoved(three(), "two", 1)), "one two three ");
  EXPECT_EQ(idsIn(withMoved(three(), "one", 99)), "two three one ");
  EXPECT_EQ(idsIn(withMoved(three(), "none", 0)), "one two three ");
}

TEST(LessonEdits, StepsAreAddedCopiedMovedAndTakenAway) {
  Lesson lesson = newLesson("L", "en", {{"read", "A"}, {"watch", "B"}, {"free", "C"}});
  EXPECT_EQ(stepsIn(lesson), "a b c ");
  lesson = withStep(lesson, newStep("answer", "D"), "a");
  EXPECT_EQ(stepsIn(lesson), "a d b c ");
  lesson = withCopyOfStep(lesson, "d", "D");
  EXPECT_EQ(stepsIn(lesson), "a d d-2 b c ");
  lesson = withStepMoved(lesson, "a", 4);
  EXPECT_EQ(stepsIn(lesson), "d d-2 b c a ");
  lesson = withoutStep(lesson, "d-2");
  EXPECT_EQ(stepsIn(lesson), "d b c a ");
  EXPECT_TRUE(std::holds_alternative<AnswerTask>(stepIn(lesson, "d")->task));
}

TEST(LessonEdits, TheSectionKeepsWhatItDoesNotKnow) {
  const nlohmann::json section = {{"format", 1}, {"lessons", nlohmann::json::array()}, {"course_of", "a school"}};
  const auto made = withLessons(section, three());
  EXPECT_EQ(made["course_of"], "a school");
  EXPECT_EQ(lessonsFromJson(made).value(), three());
  EXPECT_EQ(lessonsFromJson(withLessons(nullptr, three())).value(), three());
}

TEST(LessonEdits, LinesBecomeAListAndBack) {
  EXPECT_EQ(listOfLines(" one \n\n\t\ntwo\r\n"), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(linesOfList({"one", "two"}), "one\ntwo");
  EXPECT_TRUE(listOfLines("\n  \n").empty());
}

TEST(LessonEdits, ATrimIsWithinTheRecordingAndTheWholeIsNotWrittenDown) {
  EXPECT_EQ(trimmed({}, 1.0, 4.0, 0.0, 10.0).begin_s, 1.0);
  EXPECT_EQ(trimmed({}, 1.0, 4.0, 0.0, 10.0).end_s, 4.0);
  const WatchTask whole = trimmed({}, -5.0, 99.0, 0.0, 10.0);
  EXPECT_FALSE(whole.begin_s);
  EXPECT_FALSE(whole.end_s);
  const WatchTask crossed = trimmed({}, 8.0, 2.0, 0.0, 10.0);
  EXPECT_EQ(crossed.begin_s, 8.0);
  EXPECT_NEAR(*crossed.end_s, 8.1, 1e-12);
}

TEST(LessonEdits, MarksStayInTheOrderOfTheirTimes) {
  WatchTask task;
  for (const double at : {3.0, 1.0, 2.0}) task = withMark(task, {at, "Look."});
  ASSERT_EQ(task.marks.size(), 3u);
  EXPECT_EQ(task.marks[0].time_s, 1.0);
  EXPECT_EQ(task.marks[2].time_s, 3.0);
  task = withoutMark(withoutMark(task, 1), 7);
  ASSERT_EQ(task.marks.size(), 2u);
  EXPECT_EQ(task.marks[1].time_s, 3.0);
}

TEST(LessonEdits, ABandHoldsThePresentValueInItsMiddle) {
  const SettingBand depth = bandAround("depth_mm", 160.0);
  EXPECT_EQ(depth.lowest, 145.0);
  EXPECT_EQ(depth.highest, 175.0);
  EXPECT_EQ(bandAround("focus_mm", 5.0).lowest, 0.0);
  EXPECT_EQ(bandAround("gain_db", -2.0).lowest, -5.0);
}

/// One edit by chance; what it edits may be there or not.
Lessons edited(const Lessons& lessons) {
  const auto anyOf = [](const auto& all) {
    return all.empty() ? std::string("none") : all[*rc::gen::inRange<std::size_t>(0, all.size())].id;
  };
  const auto title = *rc::gen::element<std::string>("Leber", "Find the kidney", "???", "a", "a", "Übung");
  const std::string lesson = anyOf(lessons);
  const Lesson* chosen = lessonIn(lessons, lesson);
  const std::string step = chosen == nullptr ? "none" : anyOf(chosen->steps);
  const auto place = *rc::gen::inRange<std::size_t>(0, 8);
  const auto inLesson = [&](const std::function<Lesson(Lesson)>& edit) {
    return withChanged(lessons, lesson, [&](Lesson& one) { one = edit(one); });
  };
  switch (*rc::gen::inRange(0, 10)) {
    case 0:
      return withLesson(lessons, newLesson(title, "en"), lesson);
    case 1:
      return withCopyOf(lessons, lesson, title);
    case 2:
      return without(lessons, lesson);
    case 3:
      return withMoved(lessons, lesson, place);
    case 4:
      return withChanged(lessons, lesson, [&](Lesson& one) { one.title = title; });
    case 5:
      return inLesson([&](Lesson one) { return withStep(std::move(one), newStep(kKinds[place], title), step); });
    case 6:
      return inLesson([&](Lesson one) { return withCopyOfStep(std::move(one), step, title); });
    case 7:
      return inLesson([&](Lesson one) { return withStepMoved(std::move(one), step, place); });
    case 8:
      return inLesson([&](Lesson one) { return withStepChanged(std::move(one), step, [&](LessonStep& s) { s.title = title; }); });
    default:
      return *rc::gen::inRange(0, 3) == 0 ? inLesson([&](Lesson one) { return withoutStep(std::move(one), step); }) : lessons;
  }
}

RC_GTEST_PROP(LessonEdits, AnySequenceOfEditsLeavesASectionThatCanBeRead, ()) {
  Lessons lessons = three();
  const int edits = *rc::gen::inRange(1, 40);
  for (int n = 0; n < edits; ++n) {
    const Lessons before = lessons;
    lessons = edited(before);
    const auto read = lessonsFromJson(withLessons(nullptr, lessons));
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == lessons);
    // An edit adds at most one lesson or step, takes at most one away, and renames no id.
    std::set<std::string> earlier, later, gone, come;
    for (const Lesson& one : before) earlier.insert(one.id);
    for (const Lesson& one : lessons) later.insert(one.id);
    std::set_difference(earlier.begin(), earlier.end(), later.begin(), later.end(), std::inserter(gone, gone.end()));
    std::set_difference(later.begin(), later.end(), earlier.begin(), earlier.end(), std::inserter(come, come.end()));
    RC_ASSERT(gone.size() + come.size() <= 1u);
    for (const Lesson& one : before) {
      const Lesson* now = lessonIn(lessons, one.id);
      if (now == nullptr) continue;
      const auto kept = std::count_if(one.steps.begin(), one.steps.end(), [&](const LessonStep& step) {
        const LessonStep* same = stepIn(*now, step.id);
        return same != nullptr && same->task == step.task;
      });
      RC_ASSERT(static_cast<std::size_t>(kept) + 1 >= one.steps.size());
      RC_ASSERT(now->steps.size() <= one.steps.size() + 1);
    }
  }
}

RC_GTEST_PROP(LessonEdits, ATrimIsNeverEmptyNorOutside, ()) {
  const auto any = [] { return static_cast<double>(*rc::gen::inRange(-100, 400)) / 10.0; };
  const double last_s = static_cast<double>(*rc::gen::inRange(10, 300)) / 10.0;
  const WatchTask task = trimmed({}, any(), any(), 0.0, last_s);
  const double begin_s = task.begin_s.value_or(0.0), end_s = task.end_s.value_or(last_s);
  RC_ASSERT(begin_s >= 0.0);
  RC_ASSERT(end_s <= last_s);
  RC_ASSERT(end_s - begin_s >= 0.1 - 1e-9);
}

}  // namespace
}  // namespace ew::lessons
