#include "ew/library/lesson.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

#include "ew/library/case_words.h"
#include "ew/library/lesson_links.h"
#include "ew/library/schema.h"
#include "library/temporary_folder.h"

namespace ew::lesson_test {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using test::writeText;

LessonStep step(std::string id, LessonTask task) {
  LessonStep made;
  made.id = std::move(id);
  made.title = "Title of " + made.id;
  made.text = "Do it.";
  made.task = std::move(task);
  return made;
}

/// A lesson with a step of each kind, in which no field has the value it has by itself.
Lesson full() {
  Lesson lesson;
  lesson.id = "all-kinds";
  lesson.title = "All kinds";
  lesson.aim = "You know them all.";
  lesson.level = 3;
  lesson.minutes = 25;
  lesson.tags = {"liver", "first steps"};
  lesson.sources = {"Somebody, 2014"};
  lesson.language = "de";
  lesson.steps = {step("a", ReadingTask{"media/a.png"}),
                  step("b", WatchTask{"scans/b.seq.mha", 1.5, 9.25, {{2.0, "Here."}, {3.0, "There."}}}),
                  step("c", PlaneTask{"long", 4.0, 8.0}),
                  step("d", SweepTask{"liver", 0.75}),
                  step("e", MeasureTask{"width", 1.5}),
                  step("f", PointTask{"stone"}),
                  step("g", SettingsTask{{"convex-3.5"}, {{"depth_mm", 100.0, 150.0}, {"gain_db", -3.0, 3.0}}}),
                  step("h", AnswerTask{{{"Yes.", true, "Because."}, {"No.", false, ""}}, {}, 0.0, ""}),
                  step("i", AnswerTask{{}, 12.5, 0.5, "mm"}),
                  step("j", FreeTask{30.0, {"long", "liver"}})};
  LessonStep& first = lesson.steps.front();
  first.lookFor = "An image.";
  first.after = "Well read.";
  first.caseId = "another";
  first.hints = {"Look.", "Look again."};
  first.aids = {true, true, true, true, true, true, true};
  first.feedback = false;
  first.passLevel = 0.25;
  first.time_s = 90.0;
  first.otherFields = {{"colour", "blue"}};
  lesson.otherFields = {{"by", "A. Author"}};
  return lesson;
}

TEST(LessonsFromJson, ReadsWhatWasWritten) {
  const std::vector<Lesson> lessons = {full()};
  const auto read = lessonsFromJson(json::parse(jsonOf(lessons).dump()));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, lessons);
}

TEST(LessonsFromJson, TakesWhatTheSchemaTakes) {
  const auto schema = PartSchema::of(lessonsSchema(), verbatim("lessons"));
  ASSERT_TRUE(schema) << schema.error();
  EXPECT_TRUE(schema->problems(jsonOf({full()}), "parts.lessons", verbatim("case.json")).empty());
}

RC_GTEST_PROP(LessonsFromJson, KeepsStepsInAnyOrder, ()) {
  Lesson lesson = full();
  const auto order = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, lesson.steps.size()));
  Lesson mixed = lesson;
  mixed.steps.clear();
  for (std::size_t n = 0; n < order.size() && n < 200; ++n) {
    mixed.steps.push_back(lesson.steps[order[n]]);
    mixed.steps.back().id = "step-" + std::to_string(n);
  }
  const auto read = lessonsFromJson(jsonOf({mixed}));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == std::vector<Lesson>{mixed});
}

TEST(LessonsFromJson, RefusesWhatCannotBeALessonAndNamesTheField) {
  const json good = jsonOf({full()});
  const std::pair<const char*, json> wrong[] = {{"/lessons", 3},
                                                {"/lessons/0/id", ""},
                                                {"/lessons/0/level", 6},
                                                {"/lessons/0/steps/0/task", "dance"},
                                                {"/lessons/0/steps/0/picture", "../outside.png"},
                                                {"/lessons/0/steps/0/picture", "/etc/passwd"},
                                                {"/lessons/0/steps/1/id", "a"},
                                                {"/lessons/0/steps/1/end_s", 1.0},
                                                {"/lessons/0/steps/1/marks/0/time_s", "soon"},
                                                {"/lessons/0/steps/3/share", 1.5},
                                                {"/lessons/0/steps/6/bands/0/setting", "warp"},
                                                {"/lessons/0/steps/6/bands/0/highest", 1.0},
                                                {"/lessons/0/steps/6/bands/1/setting", "depth_mm"},
                                                {"/lessons/0/steps/7/number", 3},
                                                {"/lessons/0/steps/0/aids/magic", true},
                                                {"/lessons/0/steps/0/pass_level", 2},
                                                {"/lessons/0/steps/0/hints/0", 7},
                                                {"/lessons/0/steps/0/time_s", 1}};
  for (const auto& [pointer, value] : wrong) {
    json changed = good;
    changed[json::json_pointer(pointer)] = value;
    const auto read = lessonsFromJson(changed);
    ASSERT_FALSE(read) << pointer << " " << value;
    EXPECT_EQ(read.error().code, ErrorCode::badField) << read.error();
    EXPECT_TRUE(read.error().sentence().ends_with('.')) << read.error();
  }
}

TEST(LessonsFromJson, RefusesANewerFormatWithBothNumbers) {
  json newer = jsonOf({full()});
  newer["format"] = kLessonsFormat + 1;
  const auto read = lessonsFromJson(newer);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::newerFormat);
  EXPECT_NE(read.error().sentence().find(std::to_string(kLessonsFormat + 1)), std::string::npos);
}

TEST(IdFor, IsShortPlainAndFree) {
  EXPECT_EQ(idFor("Find the Portal Vein!", {}), "find-the-portal-vein");
  EXPECT_EQ(idFor("Find", {"find", "find-2"}), "find-3");
  EXPECT_EQ(idFor("\xc3\xa4\xc3\xb6", {}), "step");
}

Case home() {
  Case made;
  made.id = "home";
  made.targets.push_back({.kind = CaseTarget::Kind::plane, .name = "long"});
  made.targets.push_back({.kind = CaseTarget::Kind::structure, .name = "liver"});
  made.targets.push_back({.kind = CaseTarget::Kind::point, .name = "stone"});
  made.measurements.push_back({.name = "width"});
  return made;
}

TEST(ProblemsOfALesson, NamesTheStepThatCannotBeWorkedThrough) {
  const TemporaryFolder folder;
  Case scanned = home();
  scanned.folder = folder.path();
  Lesson lesson = full();
  lesson.steps.front().caseId.clear();
  auto problems = problemsOf(lesson, scanned, {});
  ASSERT_EQ(problems.size(), 2u) << "the image and the recording are not there";
  EXPECT_EQ(problems[0].stepId, "a");
  EXPECT_EQ(problems[1].stepId, "b");
  writeText(folder / "parts/lessons/media/a.png", "picture");
  writeText(folder / "parts/lessons/scans/b.seq.mha", "recording");
  EXPECT_TRUE(problemsOf(lesson, scanned, {}).empty());

  std::get<PlaneTask>(lesson.steps[2].task).target = "liver";
  std::get<MeasureTask>(lesson.steps[4].task).tolerance.reset();
  std::get<AnswerTask>(lesson.steps[7].task).options[0].right = false;
  lesson.steps[5].caseId = "nowhere";
  problems = problemsOf(lesson, scanned, [](const std::string&) { return nullptr; });
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].stepId, "c");
  EXPECT_EQ(problems[1].stepId, "e");
  EXPECT_EQ(problems[2].stepId, "f");
  EXPECT_EQ(problems[3].stepId, "h");
}

TEST(ProblemsOfALesson, SaysWhatNobodyHasPutIntoWords) {
  const auto problemsIn = [](LessonStep made) {
    Lesson lesson;
    lesson.steps = {std::move(made)};
    std::vector<std::string> texts;
    for (const LessonProblem& each : problemsOf(lesson, home(), {})) texts.push_back(each.text.english());
    return texts;
  };
  LessonStep point = step("point", PointTask{"stone"});
  EXPECT_TRUE(problemsIn(point).empty());
  point.text.clear();
  EXPECT_EQ(problemsIn(point), std::vector<std::string>{"Nothing says what is to be done; write it."});
  LessonStep question =
      step("question", AnswerTask{{{"Answer 1", true, ""}, {"A stone", false, ""}, {"Antwort 3", false, ""}}, {}, 0.0, ""});
  EXPECT_EQ(problemsIn(question).size(), 2u);
  EXPECT_TRUE(isGivenName("Structure") && isGivenName("Struktur 2") && !isGivenName("Structure of the liver") && !isGivenName("12"));

  Lesson twice;
  twice.steps = {step("one", PointTask{"stone"}), step("two", PointTask{"stone"})};
  twice.steps[1].title = "Another name";
  ASSERT_EQ(problemsOf(twice, home(), {}).size(), 1u);
  EXPECT_EQ(problemsOf(twice, home(), {})[0].stepId, "two");
  twice.steps[1].feedback = false;
  EXPECT_TRUE(problemsOf(twice, home(), {}).empty()) << "without help is another step";
}

TEST(ProblemsOfALesson, LooksAtTheCaseThatAStepScans) {
  Lesson lesson;
  lesson.steps = {step("elsewhere", PointTask{"stone"})};
  lesson.steps.front().caseId = "other";
  Case other;
  other.id = "other";
  const CaseById byId = [&](const std::string& id) { return id == "other" ? &other : nullptr; };
  EXPECT_EQ(problemsOf(lesson, home(), byId).size(), 1u);
  other.targets = home().targets;
  EXPECT_TRUE(problemsOf(lesson, home(), byId).empty());
}

TEST(LessonsOf, ReadsTheSectionOfACase) {
  Case made = home();
  EXPECT_TRUE(lessonsOf(made)->empty());
  made.otherFields["parts"]["lessons"] = jsonOf({full()});
  ASSERT_TRUE(lessonsOf(made));
  EXPECT_EQ(lessonsOf(made)->front(), full());
}

TEST(CaseWordsOfACase, StandInPlaceOfTheTextsAndNamesStay) {
  const TemporaryFolder folder;
  writeText(folder / "words/de.json", R"({"format": 1, "words": {"Do it.": "Tu es.", "Yes.": "Ja.", "long": "laengs"}})");
  const CaseWords words = wordsOf(folder.path(), "de_AT");
  const Lesson shown = translated(full(), words);
  EXPECT_EQ(shown.steps[0].text, "Tu es.");
  EXPECT_EQ(shown.steps[0].title, "Title of a") << "what has no translation is shown as it is";
  EXPECT_EQ(std::get<AnswerTask>(shown.steps[7].task).options[0].text, "Ja.");
  EXPECT_EQ(std::get<PlaneTask>(shown.steps[2].task).target, "long") << "a name that something refers to";
  EXPECT_EQ(words.of("long"), "laengs");
  EXPECT_TRUE(wordsOf(folder.path(), "fr").empty());
}

TEST(CaseWordsOfACase, SayWhatIsWrongWithTheirFile) {
  const TemporaryFolder folder;
  writeText(folder / "de.json", R"({"format": 1, "words": {"a": 3}})");
  EXPECT_EQ(readCaseWords(folder / "de.json").error().code, ErrorCode::badField);
  writeText(folder / "de.json", R"({"format": 9, "words": {}})");
  EXPECT_EQ(readCaseWords(folder / "de.json").error().code, ErrorCode::newerFormat);
  writeText(folder / "de.json", R"({"format": 1, "words": )");
  EXPECT_EQ(readCaseWords(folder / "de.json").error().code, ErrorCode::badHeader);
  EXPECT_TRUE(wordsOf(folder.path() / "..", "de").empty());
}

TEST(TextsOfACase, AreAllThatATraineeReadsOnce) {
  Case shown = home();
  shown.title = "Do it.";
  const auto texts = textsOf(shown, {full()});
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "Do it."), 1);
  for (const char* text : {"long", "width", "Look again.", "There.", "Because.", "first steps"})
    EXPECT_EQ(std::count(texts.begin(), texts.end(), text), 1) << text;
}

}  // namespace
}  // namespace ew::lesson_test
