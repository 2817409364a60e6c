#include "ew/reports/class_report.h"

#include "reports/reports_world.h"

namespace ew {
namespace {

using test::holds;
using test::madeAttempt;
using test::madeLesson;
using test::plainTextOf;
using test::ratedBy;
using test::someCodes;

std::vector<ReportAttempt> someClass() {
  return {madeAttempt(1, 0.9, 0.2, "A"), madeAttempt(2, 0.8, 0.9, "B"), madeAttempt(3, 0.6, 0.3, "C"), madeAttempt(4, 0.7, 0.1, "D")};
}

TEST(FiguresOfAClass, CountVerdictsScoresAndMetricsOfEachStep) {
  const ClassFigures figures = classFiguresOf(someClass());
  EXPECT_EQ(figures.scored, 4u);
  EXPECT_EQ(figures.passed, 1u);
  ASSERT_EQ(figures.steps.size(), 3u);
  EXPECT_EQ(figures.steps[1].passed, 3u);
  EXPECT_EQ(figures.steps[1].failed, 1u);
  EXPECT_EQ(figures.steps[1].scores, (std::vector<double>{0.9, 0.8, 0.6, 0.7}));
  EXPECT_DOUBLE_EQ(figures.steps[2].notPassedShare(), 0.75);
  ASSERT_TRUE(figures.hardest);
  EXPECT_EQ(figures.steps[*figures.hardest].stepId, "answer");
  ASSERT_EQ(figures.steps[1].metrics.size(), 2u);
  EXPECT_EQ(figures.steps[1].metrics[0].values, (std::vector<double>{201.0, 202.0, 203.0, 204.0}));
}

TEST(FiguresOfAClass, TellSkippedFromNotReachedAndCountNeitherAsAScore) {
  auto attempts = someClass();
  attempts[0].score->steps[1].verdict = StepVerdict::skipped;
  attempts[1].score->steps[1].verdict = StepVerdict::skipped;
  std::erase_if(attempts[1].attempt.outcomes, [](const StepOutcome& one) { return one.stepId == "plane"; });
  const ClassStep step = classFiguresOf(attempts).steps[1];
  EXPECT_EQ(step.skipped, 1u);
  EXPECT_EQ(step.notReached, 1u);
  EXPECT_EQ(step.scores.size(), 2u);
  EXPECT_DOUBLE_EQ(step.notPassedShare(), 2.0 / 3.0);
}

TEST(FiguresOfAClass, LeaveOutMetricsOfAnOlderVersion) {
  auto attempts = someClass();
  attempts[2].score->steps[1].metrics[0] = {"path_length", 2, 33.0};
  const ClassMetric metric = classFiguresOf(attempts).steps[1].metrics[0];
  EXPECT_EQ(metric.version, 2);
  EXPECT_EQ(metric.values, std::vector<double>{33.0});
}

TEST(FiguresOfAClass, TakeTheStandingOfAnAttemptFromRatersWhoAgree) {
  auto attempts = someClass();
  attempts[0].ratings.ratings = {ratedBy("R", 4, 4), ratedBy("S", 3, 3)};
  attempts[1].ratings.ratings = {ratedBy("R", 4, 4), ratedBy("S", 1, 3)};
  attempts[2].ratings.ratings = {ratedBy("R", 2, 2)};
  attempts[3].ratings.ratings = {ratedBy("R", 2, 2)};
  attempts[3].ratings.ratings[0].rating.sawOthers = true;
  const ClassFigures figures = classFiguresOf(attempts);
  EXPECT_EQ(figures.standing.at(attempts[0].attempt.id), Standing::shouldPass);
  EXPECT_EQ(figures.standing.at(attempts[1].attempt.id), Standing::unknown);
  EXPECT_EQ(figures.standing.at(attempts[2].attempt.id), Standing::shouldFail);
  EXPECT_EQ(figures.standing.at(attempts[3].attempt.id), Standing::unknown);
  EXPECT_FALSE(figures.suggested) << "two groups of one are none";
}

TEST(FiguresOfAClass, SuggestThePassLevelWhereTheGroupsCross) {
  std::vector<ReportAttempt> attempts;
  std::vector<double> failing, passing;
  for (int n = 0; n < 12; ++n) {
    const bool isGood = n % 2 == 0;
    const double score = (isGood ? 0.8 : 0.4) + 0.01 * (n % 5);
    attempts.push_back(madeAttempt(n, score, score));
    attempts.back().ratings.ratings = {ratedBy("R", isGood ? 5 : 1, isGood ? 4 : 2)};
    (isGood ? passing : failing).push_back(score);
  }
  const ClassFigures figures = classFiguresOf(attempts);
  EXPECT_EQ(figures.shouldPass, 6u);
  EXPECT_EQ(figures.suggested, contrastingGroups(failing, passing));
  EXPECT_EQ(figures.steps[1].suggested, figures.suggested);
  EXPECT_FALSE(figures.steps[0].suggested) << "what is only read does not count";
  EXPECT_TRUE(holds(plainTextOf(classReport(attempts, madeLesson(), someCodes())), "6 attempts should pass, 6 should not"));
}

TEST(FiguresOfAClass, SuggestNothingFromAGroupOfOneAndTheSameScore) {
  std::vector<ReportAttempt> attempts;
  for (int n = 0; n < 8; ++n) {
    const double score = n < 4 ? 0.0 : 0.8 + 0.01 * n;
    attempts.push_back(madeAttempt(n, score, score));
    attempts.back().ratings.ratings = {n < 4 ? ratedBy("R", 1, 2) : ratedBy("R", 4, 5)};
  }
  const ClassFigures figures = classFiguresOf(attempts);
  EXPECT_EQ(figures.shouldFail, 4u);
  EXPECT_FALSE(figures.suggested);
  EXPECT_FALSE(figures.steps[1].suggested);
}

TEST(FiguresOfAClass, TakeWhatAnInstructorHasSaidBeforeWhatRatersSay) {
  auto attempts = someClass();
  attempts[0].ratings.ratings = {ratedBy("R", 4, 4)};
  const StandingsByAttempt said = {{attempts[0].attempt.id, Standing::shouldFail}, {attempts[1].attempt.id, Standing::shouldPass}};
  const ClassFigures figures = classFiguresOf(attempts, said);
  EXPECT_EQ(figures.standing.at(attempts[0].attempt.id), Standing::shouldFail);
  EXPECT_EQ(figures.standing.at(attempts[1].attempt.id), Standing::shouldPass);
  EXPECT_EQ(figures.standing.at(attempts[2].attempt.id), Standing::unknown);
}

/// Both groups are as good on the whole, and not at each step.
TEST(ReportOfAClass, HasTheLevelsOfStepsThoughTheLessonHasNone) {
  const std::vector<ReportAttempt> attempts = {madeAttempt(1, 0.3, 0.9), madeAttempt(2, 0.4, 0.8), madeAttempt(3, 0.9, 0.3),
                                               madeAttempt(4, 0.8, 0.4)};
  ReportLesson lesson = madeLesson();
  for (std::size_t n = 0; n < attempts.size(); ++n)
    lesson.standings[attempts[n].attempt.id] = n < 2 ? Standing::shouldFail : Standing::shouldPass;
  const ClassFigures figures = classFiguresOf(attempts, lesson.standings);
  EXPECT_FALSE(figures.suggested);
  ASSERT_TRUE(figures.steps[1].suggested);
  const std::string text = plainTextOf(classReport(attempts, lesson, someCodes()));
  EXPECT_TRUE(holds(text, "2 attempts should pass, 2 should not")) << text;
  EXPECT_TRUE(holds(text, "Step plane | 70 % | 60 %")) << text;
  EXPECT_FALSE(holds(text, "No level can be suggested")) << text;
}

TEST(ReportOfAClass, SaysThatStandingsCannotBeReadAndGoesOnWithRaters) {
  auto attempts = someClass();
  attempts[0].ratings.ratings = {ratedBy("R", 4, 4)};
  ReportLesson lesson = madeLesson();
  lesson.standingsProblem = Error{ErrorCode::badHeader, verbatim("\"/home/ana/standings.json\" is torn."), {}};
  const std::string text = plainTextOf(classReport(attempts, lesson, someCodes()));
  EXPECT_TRUE(holds(text, "so raters' word alone counts: \"standings.json\" is torn.")) << text;
  EXPECT_TRUE(holds(text, "1 attempts should pass and 0 should not")) << text;
}

TEST(ReportOfAClass, HasTheFiguresThatTheTaskWasJudgedByWhereNothingWasScored) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.attempt.outcomes[1].figures = {{"angle", 4.25, "deg"}};
  EXPECT_FALSE(holds(plainTextOf(classReport({one}, madeLesson(), someCodes())), "through the task")) << "a scored one has metrics";
  one.score.reset();
  one.lesson = test::triedLesson();
  const std::string text = plainTextOf(classReport({one}, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Angle | 1 | ")) << text;
  EXPECT_TRUE(holds(text, "through the task")) << text;
}

TEST(ReportOfAClass, HasEveryAttemptTheHardestStepAndMarksWhatIsOff) {
  ReportLesson lesson = madeLesson();
  lesson.offByDefault = {{"plane", "hints"}};
  const std::vector<std::string> pages = {"a.html", "b.html", "c.html", "d.html"};
  const ReportDocument document = classReport(someClass(), lesson, someCodes(), pages);
  const std::string text = plainTextOf(document);
  EXPECT_TRUE(holds(text, "Hardest step: 'Step answer', which 3 of 4 did not pass.")) << text;
  EXPECT_TRUE(holds(text, "Passed: 1 of 4"));
  EXPECT_TRUE(holds(text, "Step answer (most fail here) | Answer a question | 1 | 3 | 0 | 0"));
  EXPECT_TRUE(holds(text, "Hints | 4 | 2 | 2 | 2 | 2 | 2 | – | no; off by default"));
  EXPECT_TRUE(holds(text, "Path length | 4 | 201 mm | 202 mm | 202 mm | 203 mm | 204 mm"));
  for (const std::string person : {"A", "B", "C", "D"}) EXPECT_TRUE(holds(text, someCodes().ofPerson(person)));
  for (const std::string& page : pages) EXPECT_TRUE(holds(htmlOf(document, {}), "href='./" + page + "'"));
}

TEST(ReportOfAClass, AtALessonOfReadingAloneCountsAllStepsAlike) {
  ReportAttempt failed = test::readingAttempt();
  failed.attempt.outcomes[1].verdict = StepVerdict::failed;
  const std::vector<ReportAttempt> attempts = {test::readingAttempt(), failed};
  const ClassFigures figures = classFiguresOf(attempts);
  ASSERT_EQ(figures.steps.size(), 2u);
  for (const ClassStep& step : figures.steps) EXPECT_EQ(step.weight, 1.0) << step.stepId;
  const std::string text = plainTextOf(classReport(attempts, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Hardest step: 'Step watch', which 1 of 2 did not pass.")) << text;
  EXPECT_FALSE(holds(text, "does not count")) << text;
}

TEST(ReportOfAClass, OfNobodySaysSo) {
  const std::string text = plainTextOf(classReport({}, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Attempts: 0"));
  EXPECT_TRUE(holds(text, "Nobody has tried this lesson yet."));
}

TEST(ReportOfAClass, OfOneAttemptIsWhole) {
  const std::string text = plainTextOf(classReport({madeAttempt(1, 0.9, 0.9)}, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Passed: 1 of 1"));
  EXPECT_TRUE(holds(text, "Nobody failed a step that counts."));
}

TEST(ReportOfAClass, OfAttemptsWithoutScoresSaysWhatToDo) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.score.reset();
  const std::string text = plainTextOf(classReport({one}, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "No attempt has a score yet"));
  EXPECT_TRUE(holds(text, "Not scored yet: 1"));
}

TEST(ReportOfAClass, WarnsOfScoresThatCannotBeCompared) {
  auto attempts = someClass();
  EXPECT_FALSE(holds(plainTextOf(classReport(attempts, madeLesson(), someCodes())), "different plans"));
  attempts[1].score->planRevision = 3;
  EXPECT_TRUE(holds(plainTextOf(classReport(attempts, madeLesson(), someCodes())), "different plans"));
}

TEST(ReportOfAClass, HasTheAgreementOfItsRatersWithoutTheirNames) {
  auto attempts = someClass();
  for (std::size_t n = 0; n < attempts.size(); ++n) {
    const int score = static_cast<int>(n) + 1;
    attempts[n].ratings.ratings = {ratedBy("Rita Rater", score, score), ratedBy("Sven Rater", score, 5 - score)};
  }
  const std::string text = plainTextOf(classReport(attempts, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "How far raters agree"));
  EXPECT_TRUE(holds(text, "Item plan | " + someCodes().ofReviewer("Rita Rater") + ", " + someCodes().ofReviewer("Sven Rater") +
                              " | 4 | 1 (95 % interval"))
      << text;
  EXPECT_FALSE(holds(text, "Rita"));
}

TEST(ReportOfAClass, OfAThousandAttemptsIsAPageBelowFiveMegabytes) {
  std::vector<ReportAttempt> attempts;
  std::vector<std::string> pages;
  for (int n = 0; n < 1000; ++n) {
    attempts.push_back(madeAttempt(n, 0.001 * (n * 7919 % 1000), 0.001 * (n * 104729 % 1000), "Person " + std::to_string(n % 200)));
    auto& step = attempts.back().score->steps[1];
    for (const Metric& metric : metrics())
      if (isFor(metric, "plane") && !valueOf(step.metrics, metric.id))
        step.metrics.push_back({std::string(metric.id), metric.version, 0.37 * n});
    pages.push_back("attempt-" + std::to_string(n) + ".html");
  }
  const std::string page = htmlOf(classReport(attempts, madeLesson(), someCodes(), pages), {});
  EXPECT_LT(page.size(), 5u << 20);
  EXPECT_EQ(test::countOf(page, "href='./attempt-"), 1000u);
  RecordProperty("page_bytes", static_cast<int>(page.size()));
}

}  // namespace
}  // namespace ew
