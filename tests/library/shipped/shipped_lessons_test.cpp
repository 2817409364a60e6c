#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ew/library/case_words.h"
#include "ew/library/course.h"
#include "ew/library/lesson_links.h"
#include "ew/scanning/recording.h"
#include "places.h"

namespace ew::shipped_lessons_test {
namespace {

namespace fs = std::filesystem;

struct Shipped {
  Case opened;
  std::vector<Lesson> lessons;
  CaseWords german;
};

/// Every case below cases/ with its lessons, read once.
const std::vector<Shipped>& shipped() {
  static const std::vector<Shipped> all = [] {
    std::vector<Shipped> made;
    for (Case& each : listCases(fs::path(EW_SOURCE_DIR) / "cases").cases) {
      const auto lessons = lessonsOf(each);
      EXPECT_TRUE(lessons) << each.id << ": " << lessons.error().sentence();
      const auto words = readCaseWords(each.folder / "words" / "de.json");
      EXPECT_TRUE(words) << each.id << ": " << words.error().sentence();
      if (lessons && words) made.push_back({std::move(each), *lessons, *words});
    }
    return made;
  }();
  return all;
}

const Case* shippedCase(const std::string& id) {
  const auto found = std::find_if(shipped().begin(), shipped().end(), [&](const Shipped& each) { return each.opened.id == id; });
  return found == shipped().end() ? nullptr : &found->opened;
}

template <class See>
void eachStep(See see) {
  for (const Shipped& each : shipped())
    for (const Lesson& lesson : each.lessons)
      for (const LessonStep& step : lesson.steps) {
        SCOPED_TRACE(each.opened.id + ", " + lesson.id + ", " + step.id);
        see(each, step);
      }
}

TEST(ShippedLessons, AreTwoForEachCaseTheSecondHarderThanTheFirst) {
  ASSERT_GE(shipped().size(), 7u);
  for (const Shipped& each : shipped()) {
    SCOPED_TRACE(each.opened.id);
    ASSERT_GE(each.lessons.size(), 2u);
    EXPECT_LE(each.lessons[0].level, 2);
    EXPECT_GT(each.lessons[1].level, each.lessons[0].level);
    for (const Lesson& lesson : each.lessons) {
      EXPECT_GE(lesson.steps.size(), 6u);
      EXPECT_LE(lesson.steps.size(), 10u);
      EXPECT_FALSE(lesson.aim.empty());
      EXPECT_FALSE(lesson.sources.empty());
    }
  }
}

TEST(ShippedLessons, CanAllBeWorkedThrough) {
  for (const Shipped& each : shipped())
    for (const Lesson& lesson : each.lessons)
      for (const LessonProblem& problem : problemsOf(lesson, each.opened, shippedCase))
        ADD_FAILURE() << each.opened.id << ", " << lesson.id << ", " << problem.stepId << ": " << problem.text.english();
}

TEST(ShippedLessons, UseEveryKindOfStep) {
  std::set<std::string> kinds;
  eachStep([&](const Shipped&, const LessonStep& step) { kinds.insert(std::string(taskWord(step.task))); });
  EXPECT_EQ(kinds.size(), std::variant_size_v<LessonTask>);
}

TEST(ShippedLessons, SayWhatToDoAndAfterEveryAnswerWhy) {
  eachStep([](const Shipped&, const LessonStep& step) {
    EXPECT_FALSE(step.text.empty());
    const bool isWorkOfHands = std::holds_alternative<PlaneTask>(step.task) || std::holds_alternative<SweepTask>(step.task) ||
                               std::holds_alternative<MeasureTask>(step.task) || std::holds_alternative<PointTask>(step.task);
    if (isWorkOfHands) {
      EXPECT_FALSE(step.lookFor.empty());
      EXPECT_FALSE(step.hints.empty());
      EXPECT_FALSE(step.after.empty());
    }
    const auto* answer = std::get_if<AnswerTask>(&step.task);
    if (answer == nullptr) return;
    for (const AnswerOption& option : answer->options) {
      EXPECT_FALSE(option.why.empty()) << option.text;
    }
  });
}

TEST(ShippedLessons, HaveExpertScansOfTheirCaseWithMarksWithinThem) {
  std::size_t scans = 0;
  eachStep([&](const Shipped& each, const LessonStep& step) {
    const auto* watch = std::get_if<WatchTask>(&step.task);
    if (watch == nullptr) return;
    const fs::path file = each.opened.folder / "parts" / std::string(kLessonsPart) / watch->recording;
    const auto recording = readRecording(file);
    ASSERT_TRUE(recording) << recording.error().sentence();
    ++scans;
    EXPECT_EQ(recording->caseId, each.opened.id);
    EXPECT_TRUE(recording->notes.empty());
    EXPECT_LE(fs::file_size(file), 150u * 1024u);
    EXPECT_GE(watch->marks.size(), 3u);
    for (const ExpertMark& mark : watch->marks) {
      EXPECT_GE(mark.time_s, recording->log.begin_s());
      EXPECT_LE(mark.time_s, recording->log.end_s());
    }
  });
  EXPECT_GE(scans, 14u);
}

TEST(ShippedLessons, AndTheirCasesAreTranslatedTextForTextAndNothingElseIs) {
  for (const Shipped& each : shipped()) {
    const std::vector<std::string> texts = textsOf(each.opened, each.lessons);
    for (const std::string& text : texts) EXPECT_TRUE(each.german.has(text)) << each.opened.id << ": " << text;
    EXPECT_EQ(each.german.size(), texts.size()) << each.opened.id << " translates a text that is no longer there";
  }
}

/// Whether `text` holds a word of a diagnosis, in either language.
std::string wordGivenAway(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return c < 128 ? static_cast<char>(std::tolower(c)) : c; });
  for (const char* word : {"aneurysm", "stone", "stein", "nodule", "knoten", "plaque", "thromb", "fluid", "flüssigkeit", "bleed", "blutung",
                           "calc", "kalk", "chole", "normal", "stenos", "narrow"})
    if (text.find(word) != std::string::npos) return word;
  return {};
}

TEST(ShippedLessons, GiveNoFindingAwayInTitlesAndTags) {
  for (const Shipped& each : shipped()) {
    std::vector<std::string> readBefore = each.opened.tags;
    readBefore.push_back(titleForTrainees(each.opened));
    for (const Lesson& lesson : each.lessons) {
      readBefore.push_back(lesson.title);
      readBefore.push_back(lesson.aim);
      readBefore.insert(readBefore.end(), lesson.tags.begin(), lesson.tags.end());
      for (const LessonStep& step : lesson.steps) readBefore.push_back(step.title);
    }
    for (const std::string& text : readBefore) {
      EXPECT_EQ(wordGivenAway(text), "") << each.opened.id << ": " << text;
      EXPECT_EQ(wordGivenAway(each.german.of(text)), "") << each.opened.id << ": " << each.german.of(text);
    }
  }
}

TEST(ShippedCourse, LeadsFromTheFirstMovementsThroughEveryLessonOnce) {
  const auto course = readCourse(fs::path(EW_SOURCE_DIR) / "cases" / "course.json");
  ASSERT_TRUE(course) << course.error().sentence();
  EXPECT_EQ(course->lessons.front(), (CourseLesson{"upper-abdomen-normal", "first-movements"}));
  std::set<std::pair<std::string, std::string>> there;
  std::set<std::pair<std::string, std::string>> named;
  for (const Shipped& each : shipped())
    for (const Lesson& lesson : each.lessons) there.emplace(each.opened.id, lesson.id);
  for (const CourseLesson& lesson : course->lessons) named.emplace(lesson.caseId, lesson.lessonId);
  EXPECT_EQ(named, there);
}

}  // namespace
}  // namespace ew::shipped_lessons_test
