#include "ew/assessment/class_figures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/made_ratings.h"

namespace ew::class_figures_test {
namespace {

struct Did {
  std::string step;
  StepVerdict verdict = StepVerdict::passed;
  double score = 0.0;
  double weight = 1.0;
  bool hasEnded = true;
};

/// A scored attempt. @param number attempts in the order of their time
ClassAttempt tried(int number, const std::vector<Did>& all, Standing said = Standing::unknown) {
  ClassAttempt made;
  made.id = "attempt-" + std::to_string(100 + number);
  made.said = said;
  made.result.isScored = true;
  made.result.startedAt = std::chrono::sys_seconds(std::chrono::minutes(number));
  for (const Did& each : all) {
    StepScore score;
    score.stepId = each.step;
    score.title = "Step " + each.step;
    score.kind = "plane";
    score.verdict = each.verdict;
    score.score = score.task = each.score;
    score.weight = each.weight;
    made.result.counted.score += each.score / static_cast<double>(all.size());
    made.result.stepsHandedIn += each.verdict == StepVerdict::handedIn ? 1 : 0;
    made.result.counted.steps.push_back(score);
    if (each.hasEnded) made.ended.insert(each.step);
  }
  return made;
}

std::string hardestOf(const ClassFigures& figures) { return figures.hardest ? figures.steps[*figures.hardest].stepId : std::string(); }

TEST(ClassFigures, NameTheStepThatTheLargestShareOfThoseWhoReachedItDidNotPass) {
  const Did never{"third", StepVerdict::skipped, 0.0, 1.0, false};
  const ClassFigures made =
      classFiguresOf({tried(1, {{"first", StepVerdict::passed, 0.9}, {"second", StepVerdict::skipped}, never}),
                      tried(2, {{"first", StepVerdict::failed, 0.5}, {"second", StepVerdict::skipped}, never}),
                      tried(3, {{"first", StepVerdict::passed, 0.8}, {"second", StepVerdict::skipped, 0.0, 1.0, false}, never})});
  EXPECT_EQ(made.scored, 3u);
  ASSERT_EQ(made.steps.size(), 3u);
  EXPECT_EQ(made.steps[0].reached(), 3u);
  EXPECT_EQ(made.steps[0].passed, 2u);
  EXPECT_EQ(made.steps[0].scores, (std::vector<double>{0.9, 0.5, 0.8}));
  EXPECT_EQ(made.steps[1].skipped, 2u);
  EXPECT_EQ(made.steps[1].notReached, 1u);
  EXPECT_TRUE(made.steps[1].scores.empty()) << "skipped steps have no score";
  EXPECT_EQ(made.steps[2].reached(), 0u);
  EXPECT_EQ(made.steps[2].notReached, 3u);
  EXPECT_EQ(hardestOf(made), "second") << "skipped is not passed";
}

TEST(ClassFigures, NameNoStepWhenNobodyFailsOneThatCounts) {
  const ClassFigures made = classFiguresOf({tried(1, {{"first", StepVerdict::passed, 0.9}, {"read", StepVerdict::failed, 0.0, 0.0}})});
  EXPECT_FALSE(made.hardest) << "a step of no weight does not count";
  EXPECT_EQ(made.steps[1].failed, 1u) << "but is counted";
  EXPECT_FALSE(classFiguresOf(std::vector<ClassAttempt>{}).hardest);
}

TEST(ClassFigures, CountAllStepsAlikeWhereNothingWeighs) {
  ClassAttempt one = tried(1, {{"read", StepVerdict::passed, 1.0, 0.0}, {"watch", StepVerdict::failed, 0.2, 0.0}});
  one.result.areAlike = true;
  const ClassFigures made = classFiguresOf({one});
  for (const ClassStep& step : made.steps) EXPECT_EQ(step.weight, 1.0) << step.stepId;
  EXPECT_EQ(hardestOf(made), "watch");
}

TEST(ClassFigures, HearNothingFromAStepThatWaitsAndAllFromThoseThatWereJudged) {
  const ClassFigures made = classFiguresOf({tried(1, {{"first", StepVerdict::failed, 0.4}, {"second", StepVerdict::handedIn}})});
  EXPECT_EQ(made.scored, 0u);
  EXPECT_EQ(made.unscored, 1u) << "the whole attempt waits";
  EXPECT_EQ(made.steps[0].failed, 1u);
  EXPECT_EQ(made.steps[1].reached(), 0u);
  EXPECT_EQ(made.steps[1].notReached, 0u);
  EXPECT_EQ(hardestOf(made), "first");
}

TEST(ClassFigures, LeaveOutAttemptsOfWhichNobodyKnowsWhatCounts) {
  ClassAttempt one = tried(1, {{"first", StepVerdict::failed, 0.4}}, Standing::shouldFail);
  one.result.isScored = one.result.isKnown = false;
  const ClassFigures made = classFiguresOf({one});
  EXPECT_EQ(made.unscored, 1u);
  EXPECT_TRUE(made.steps.empty());
  EXPECT_EQ(made.shouldFail, 0u);
  EXPECT_EQ(made.standing.at(one.id), Standing::shouldFail);
  EXPECT_EQ(one.judged("first"), nullptr);
}

TEST(ClassFigures, TakeMetricsOfTheNewestVersionAndFiguresOfTheTaskWhereNothingWasScored) {
  std::vector<ClassAttempt> all;
  for (int n = 0; n < 4; ++n) {
    all.push_back(tried(n, {{"first", StepVerdict::passed, 0.9}}));
    StepScore& score = all.back().result.counted.steps.front();
    score.figures = {{"angle", 10.0 * n, "deg"}};
    if (n < 3) score.metrics = {{"path_length", n == 0 ? 1 : 2, 100.0 * n}};
  }
  all[3].result.isScored = false;
  const ClassFigures made = classFiguresOf(all);
  ASSERT_EQ(made.steps.front().metrics.size(), 2u);
  const ClassMetric &path = made.steps.front().metrics[0], &angle = made.steps.front().metrics[1];
  EXPECT_EQ(path.id, "path_length");
  EXPECT_EQ(path.version, 2);
  EXPECT_EQ(path.unit, "mm");
  EXPECT_TRUE(path.isMetric);
  EXPECT_EQ(path.values, (std::vector<double>{100.0, 200.0}));
  EXPECT_EQ(angle.id, "angle");
  EXPECT_EQ(angle.unit, "deg");
  EXPECT_FALSE(angle.isMetric);
  EXPECT_EQ(angle.values, std::vector<double>{30.0}) << "of the attempt that was never scored alone";
}

TEST(ClassFigures, SuggestAPassLevelBetweenTwoGroups) {
  const auto did = [](double score) { return std::vector<Did>{{"first", StepVerdict::passed, score}}; };
  std::vector<ClassAttempt> all = {tried(1, did(0.3), Standing::shouldFail),
                                   tried(2, did(0.5), Standing::shouldFail),
                                   tried(3, did(0.7), Standing::shouldPass),
                                   tried(4, did(0.9), Standing::shouldPass),
                                   tried(5, did(0.0)),
                                   tried(6, did(0.2))};
  const ClassFigures made = classFiguresOf(all);
  ASSERT_TRUE(made.steps[0].suggested);
  EXPECT_NEAR(made.steps[0].suggested->value, 0.6, 1e-9) << "both vary alike, so it lies half way between the means";
  EXPECT_EQ(made.suggested, made.steps[0].suggested) << "the lesson has this step alone";
  EXPECT_EQ(made.steps[0].shouldPass, 2u);
  EXPECT_EQ(made.steps[0].shouldFail, 2u);
  all[0].said = Standing::unknown;
  EXPECT_FALSE(classFiguresOf(all).steps[0].suggested) << "one is no group";
  all[0].said = Standing::shouldFail;
  all[0].result.counted.steps[0].score = 0.5;
  EXPECT_FALSE(classFiguresOf(all).steps[0].suggested) << "a group of one and the same score suggests nothing";
  all[0].result.counted.steps[0].score = 0.3;
  for (ClassAttempt& one : all) one.result.counted.steps[0].weight = 0.0;
  EXPECT_FALSE(classFiguresOf(all).steps[0].suggested) << "what weighs nothing needs no level";
  all[1].result.counted.steps[0].verdict = StepVerdict::skipped;
  EXPECT_EQ(classFiguresOf(all).steps[0].shouldFail, 1u) << "who skips a step has no score of it";
}

TEST(ClassFigures, DoNotDependOnTheOrderOfTheAttempts) {
  std::vector<ClassAttempt> all;
  for (int n = 0; n < 9; ++n)
    all.push_back(tried(n, {{"first", n % 3 == 0 ? StepVerdict::failed : StepVerdict::passed, 0.1 * n, 1.0 + n}},
                        n % 2 == 0 ? Standing::shouldPass : Standing::shouldFail));
  const ClassFigures made = classFiguresOf(all);
  EXPECT_EQ(made.steps[0].weight, 9.0) << "by the latest attempt";
  std::reverse(all.begin(), all.end());
  EXPECT_TRUE(classFiguresOf(all) == made);
}

TEST(Standing, OfAnAttemptIsWhatAnInstructorHasSaidElseWhatItsRatersAgreeOn) {
  ClassAttempt one;
  EXPECT_EQ(one.standing(), Standing::unknown);
  one.byRaters = Standing::shouldPass;
  EXPECT_EQ(one.standing(), Standing::shouldPass);
  one.said = Standing::shouldFail;
  EXPECT_EQ(one.standing(), Standing::shouldFail);
  EXPECT_EQ(classFiguresOf({one}).standing.at(""), Standing::shouldFail);
}

TEST(Standing, ByRatersIsKnownWhereAllOfThemSayTheSame) {
  const auto form = std::make_shared<const RatingForm>(test::smallForm());
  const auto rated = [&](const std::string& rater, int score) {
    return RatingRecord{test::ratingOf(*form, rater, {score, score, score}), form};
  };
  RatingRecords ratings;
  EXPECT_EQ(standingBy(ratings), Standing::unknown);
  ratings.ratings = {rated("Ada", 4), rated("Ben", 3)};
  EXPECT_EQ(standingBy(ratings), Standing::shouldPass);
  ratings.ratings.push_back(rated("Cleo", 2));
  EXPECT_EQ(standingBy(ratings), Standing::unknown);
  ratings.ratings.back().rating.sawOthers = true;
  EXPECT_EQ(standingBy(ratings), Standing::shouldPass) << "who saw others' ratings is not asked";
  ratings.ratings = {rated("Ada", 1)};
  EXPECT_EQ(standingBy(ratings), Standing::shouldFail);
  ratings.ratings.front().rating.finished = false;
  EXPECT_EQ(standingBy(ratings), Standing::unknown) << "a draft says nothing";
}

}  // namespace
}  // namespace ew::class_figures_test
