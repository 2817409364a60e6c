#include "ew/reports/csv.h"

#include <nlohmann/json.hpp>

#include "export/export_world.h"
#include "reports/reports_world.h"

namespace ew {
namespace {

using nlohmann::json;
using test::madeAttempt;
using test::someCodes;

/// What Python's csv reader makes of a table: a list of objects by the first line's names.
json readByPython(const std::string& table) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "a.csv", table);
  test::writeText(folder / "read.py",
                  "import csv, json, sys\n"
                  "with open(sys.argv[1], encoding='utf-8', newline='') as f: print(json.dumps(list(csv.DictReader(f, strict=True))))\n");
  const test::Said said = test::said("python3 " + (folder / "read.py").string() + " " + (folder / "a.csv").string());
  EXPECT_EQ(said.status, 0) << said.text;
  return json::parse(said.text, nullptr, false);
}

TEST(Table, HasALineForEachAttemptAndStepWithEveryMetric) {
  EW_NEEDS_PROGRAM("python3");
  auto attempts = std::vector{madeAttempt(1, 0.9, 0.25), madeAttempt(2, 0.5, 0.5)};
  attempts[1].score->steps[1].metrics = {{"path_length", 2, 1.0 / 3.0}, {"of_tomorrow", 1, -2.0}};
  const json lines = readByPython(csvOf(attempts, someCodes()));
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[1]["attempt"], attempts[0].attempt.id);
  EXPECT_EQ(lines[1]["person"], someCodes().ofPerson("Ana Gomez"));
  EXPECT_EQ(lines[1]["step"], "plane");
  EXPECT_EQ(lines[1]["verdict"], "passed");
  EXPECT_EQ(lines[1]["score"], "0.9");
  EXPECT_EQ(lines[1]["lesson_score"], "0.575");
  EXPECT_EQ(lines[1]["started"], "2026-11-01T10:01:00Z");
  EXPECT_EQ(lines[1]["seconds [s]"], "75");
  EXPECT_EQ(lines[1]["path_length v1 [mm]"], "201");
  EXPECT_EQ(lines[1]["path_length v2 [mm]"], "") << "what was not worked out is empty, never 0";
  EXPECT_EQ(lines[4]["path_length v1 [mm]"], "");
  EXPECT_EQ(std::stod(lines[4]["path_length v2 [mm]"].get<std::string>()), 1.0 / 3.0) << "every digit is there";
  EXPECT_EQ(lines[4]["of_tomorrow v1"], "-2") << "a number below 0 is no formula";
  EXPECT_EQ(lines[0]["hints v1"], "");
}

TEST(Table, SaysOnlyOfPosesThatScoringLookedAtHowManyAreValid) {
  EW_NEEDS_PROGRAM("python3");
  ReportAttempt scored = madeAttempt(1, 0.9, 0.25);
  scored.attempt.outcomes[1].recording = "plane.seq.mha";
  scored.score->steps[1].validShare = 0.5;
  ReportAttempt unscored = scored;
  unscored.lesson = test::triedLesson();
  unscored.score.reset();
  const json lines = readByPython(csvOf({scored, unscored}, someCodes()));
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0]["valid_poses [%]"], "") << "nothing was recorded in this step";
  EXPECT_EQ(lines[1]["valid_poses [%]"], "50");
  for (std::size_t n = 3; n < 6; ++n) {
    EXPECT_EQ(lines[n]["scored"], "no");
    EXPECT_EQ(lines[n]["valid_poses [%]"], "") << "nobody has worked it out";
  }
}

TEST(Table, HasNoColumnsOfAScoreThatNoLongerCounts) {
  EW_NEEDS_PROGRAM("python3");
  ReportAttempt one = madeAttempt(1, 0.9, 0.25);
  one.lesson = test::triedLesson();
  one.plan.revision = one.score->planRevision + 1;
  const json lines = readByPython(csvOf({one}, someCodes()));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1]["scored"], "no");
  EXPECT_EQ(lines[1]["plan_revision"], "");
  EXPECT_FALSE(lines[1].contains("path_length v1 [mm]")) << lines[1];
}

TEST(Table, WeighsAllStepsAlikeWhereNoneWeighsAnything) {
  EW_NEEDS_PROGRAM("python3");
  const json lines = readByPython(csvOf({test::readingAttempt()}, someCodes()));
  ASSERT_EQ(lines.size(), 2u);
  for (const json& line : lines) {
    EXPECT_EQ(line["weight"], "1");
    EXPECT_EQ(line["steps_judged"], "2");
    EXPECT_EQ(line["lesson_score"], "0.9");
  }
}

TEST(Table, GuardsSpreadsheetsAgainstTextsThatAreFormulas) {
  EXPECT_EQ(csvText("=HYPERLINK(\"http://x\")"), "\"'=HYPERLINK(\"\"http://x\"\")\"");
  for (const std::string text : {"+1", "-1", "@x", "\tx", "=1"}) EXPECT_EQ(csvText(text), "'" + text);
  EXPECT_EQ(csvText("\rx"), "\"'\rx\"");
  EXPECT_EQ(csvText("a-b=c"), "a-b=c");
  EXPECT_EQ(csvText(""), "");
}

TEST(Table, SurvivesCommasQuotesAndLinesInNames) {
  EW_NEEDS_PROGRAM("python3");
  const std::string name = "Åsa \"the hand\", Öst\nline two";
  ReportAttempt one = madeAttempt(1, 0.9, 0.9, name);
  one.score->steps[0].title = "=cmd|' /C calc'!A0";
  const json lines = readByPython(csvOf({one}, someCodes(), true));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["person"], name);
  EXPECT_EQ(lines[0]["step_title"], "'=cmd|' /C calc'!A0");
}

TEST(Table, NamesNobodyUnlessAsked) { EXPECT_EQ(csvOf({madeAttempt(1, 0.9, 0.9)}, someCodes()).find("Ana"), std::string::npos); }

TEST(Table, HasWhatTheLessonSaidOfAttemptsWithoutAScore) {
  EW_NEEDS_PROGRAM("python3");
  ReportAttempt one = madeAttempt(1, 0.9, 0.25);
  one.score.reset();
  one.attempt.outcomes.push_back(one.attempt.outcomes[2]);
  const json lines = readByPython(csvOf({one, madeAttempt(2, 0.9, 0.9)}, someCodes()));
  ASSERT_EQ(lines.size(), 6u) << "of a step that was repeated the last try alone";
  EXPECT_EQ(lines[1]["scored"], "no");
  EXPECT_EQ(lines[1]["verdict"], "passed");
  EXPECT_EQ(lines[1]["hints"], "0");
  EXPECT_EQ(lines[1]["lesson_score"], "");
}

TEST(Table, SaysOfAnExaminationThatItIsHandedIn) {
  EW_NEEDS_PROGRAM("python3");
  ReportAttempt one = madeAttempt(1, 0.9, 0.25);
  one.score.reset();
  one.attempt.outcomes[1].verdict = StepVerdict::handedIn;
  for (const bool isKnown : {true, false}) {
    if (isKnown) {
      one.lesson.emplace();
      for (const StepOutcome& outcome : one.attempt.outcomes) {
        one.lesson->steps.emplace_back().id = outcome.stepId;
        one.lesson->steps.back().task = PlaneTask{};
      }
    } else {
      one.lesson.reset();
    }
    const json lines = readByPython(csvOf({one}, someCodes()));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0]["lesson_verdict"], isKnown ? "handed in" : "");
    EXPECT_EQ(lines[1]["verdict"], "handed in");
    EXPECT_EQ(lines[1]["score"], "");
    EXPECT_EQ(lines[2]["verdict"], "not passed");
    EXPECT_EQ(lines[2]["lesson_score"], "");
  }
}

TEST(Table, OfNobodyHasItsNamesAlone) {
  const std::string table = csvOf({}, someCodes());
  EXPECT_TRUE(table.starts_with("attempt,person,case,"));
  EXPECT_EQ(table.find("\r\n"), table.size() - 2);
}

}  // namespace
}  // namespace ew
