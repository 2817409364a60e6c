#include "logic/class_attempts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/assessed_world.h"
#include "assessment/made_ratings.h"
#include "ew/reports/class_report.h"

namespace ew::review::class_attempts_test {
namespace {

namespace fs = std::filesystem;
using ew::test::ratingOf;
using ew::test::smallForm;

/// A class with everything that two statistics could see differently: steps that are only read, steps of weight 0, skipped, unreached and
/// handed-in ones, metrics of an older version, attempts that were never scored, raters who agree and do not, and standings that an
/// instructor has said.
class MixedClass : public ::testing::Test {
 protected:
  MixedClass() {
    AssessmentPlan plan = *readPlan(library(), "ball", "about-balls");
    plan.at("sweep").weight = 0.0;
    plan.at("plane").passLevel = 0.6;
    plan_ = *keepPlan(library(), std::move(plan));
    add(0.9, true, 2, 4);
    add(0.8, true, 2, 5);
    add(0.5, false, 2, 2);
    add(0.3, false, 1, 1);
    add(0.7, true, 0, 0);  // never scored
    const fs::path twoMinds = add(0.4, false, 2, 5);
    rate(twoMinds, "Ben", 1);
    // An instructor knows better than the rater, and knows somebody whom nobody rated.
    say(attempts_[2], Standing::shouldPass);
    say(attempts_[4], Standing::shouldFail);
    addSkipping();
    addExamined();
  }

  [[nodiscard]] fs::path library() const { return world_.library(); }
  void rate(const fs::path& attempt, const std::string& rater, int score) const {
    const auto kept = keepRating(attempt, smallForm(), ratingOf(smallForm(), rater, {score, score, score}));
    EXPECT_TRUE(kept) << kept.error();
  }
  void say(const fs::path& attempt, Standing standing) const {
    const auto kept = keepStanding(library(), attempt.filename().string(), standing);
    EXPECT_TRUE(kept) << kept.error();
  }

  /// The statistics as the window has them.
  [[nodiscard]] ClassFigures inWindow() const {
    const auto shelf = readShelf(library(), {});
    EXPECT_TRUE(shelf && shelf->lessons.size() == 1);
    const auto records = readClassRecords(*shelf, library());
    EXPECT_TRUE(records && !records->problem);
    AttemptResults results(library());
    return classFiguresOf(classOf(shelf->lessons.front(), plan_, *records, results));
  }
  struct Reported {
    ClassFigures figures;
    ReportDocument document;
  };
  /// As the report has them, which lists attempts in another order.
  [[nodiscard]] Reported inReport() const {
    AttemptResults results(library());
    std::vector<ReportAttempt> all;
    for (const fs::path& folder : attempts_) all.push_back(*readReportedAttempt(folder, &results));
    const ReportLesson lesson = readReportedLesson("ball", "about-balls", library(), {});
    EXPECT_FALSE(lesson.standingsProblem);
    return {classFiguresOf(all, lesson.standings), classReport(all, lesson, *Pseudonyms::ofLibrary(library()))};
  }

  ew::test::AssessedWorld world_;
  AssessmentPlan plan_;
  std::vector<fs::path> attempts_;

 private:
  fs::path keep(const std::vector<ew::test::AssessedWorld::Tried>& steps) {
    attempts_.push_back(world_.keep("20261101-10000" + std::to_string(attempts_.size()) + "-aaaaaaaa", steps));
    return attempts_.back();
  }
  /// Keeps a score of what the lesson said, with a metric of the plane.
  void score(const fs::path& folder, int metricVersion) {
    const Attempt attempt = AttemptFolder::open(folder)->attempt();
    AttemptScore made = attemptResultOf(attempt, &world_.lesson(), plan_, std::nullopt).counted;
    made.key = "0123456789abcdef";
    made.outcomes = attempt.outcomes.size();
    made.wasFinished = attempt.finishedAt.has_value();
    for (StepScore& step : made.steps)
      if (step.stepId == "plane") step.metrics = {{"path_length", metricVersion, 100.0 + static_cast<double>(attempts_.size())}};
    const auto kept = keepScore(folder, made);
    EXPECT_TRUE(kept) << kept.error();
  }
  /// @param metricVersion 0: it is not scored @param rating 0: nobody rates it
  fs::path add(double plane, bool isRight, int metricVersion, int rating) {
    const StepVerdict verdict = isRight ? StepVerdict::passed : StepVerdict::failed;
    const fs::path folder = keep({{.step = "read", .verdict = StepVerdict::passed, .score = 1.0},
                                  {.step = "plane", .verdict = plane >= 0.7 ? StepVerdict::passed : StepVerdict::failed, .score = plane},
                                  {.step = "sweep", .verdict = StepVerdict::failed, .score = 0.1},
                                  {.step = "answer", .verdict = verdict, .score = isRight ? 1.0 : 0.0}});
    if (metricVersion > 0)
      score(folder, metricVersion);
    else
      addFigure(folder);
    if (rating > 0) rate(folder, "Ada", rating);
    return folder;
  }
  /// The lesson judged its plane by an angle.
  static void addFigure(const fs::path& folder) {
    Attempt attempt = AttemptFolder::open(folder)->attempt();
    for (StepOutcome& outcome : attempt.outcomes)
      if (outcome.stepId == "plane") outcome.figures = {{"angle", 12.5, "deg"}};
    ew::test::writeText(folder / "attempt.json", jsonOf(attempt).dump());
  }
  void addSkipping() {
    for (int n = 0; n < 2; ++n)
      score(keep({{.step = "read", .verdict = StepVerdict::failed}, {.step = "plane", .verdict = StepVerdict::skipped}}), 2);
  }
  void addExamined() {
    score(keep({{.step = "plane", .verdict = StepVerdict::failed, .score = 0.2}, {.step = "answer", .verdict = StepVerdict::handedIn}}), 2);
  }
};

const ClassStep* stepIn(const std::vector<ClassStep>& steps, const std::string& id) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const ClassStep& step) { return step.stepId == id; });
  return found == steps.end() ? nullptr : &*found;
}

TEST_F(MixedClass, HasTheSameFiguresInTheWindowInTheReportAndInItsPage) {
  const ClassFigures window = inWindow();
  const Reported report = inReport();
  EXPECT_TRUE(window == report.figures);
  EXPECT_EQ(window.scored, 8u);
  EXPECT_EQ(window.unscored, 1u) << "one was handed in";
  const ClassStep &plane = *stepIn(window.steps, "plane"), &sweep = *stepIn(window.steps, "sweep"),
                  &answer = *stepIn(window.steps, "answer");
  EXPECT_EQ(plane.reached(), 9u);
  EXPECT_EQ(plane.passed, 3u) << "by the plan's level";
  EXPECT_EQ(plane.failed, 4u);
  EXPECT_EQ(plane.skipped, 2u);
  EXPECT_EQ(sweep.weight, 0.0);
  EXPECT_EQ(sweep.failed, 6u);
  EXPECT_EQ(answer.reached(), 6u) << "two never reached it, and one waits";
  EXPECT_EQ(answer.notReached, 2u);
  ASSERT_TRUE(window.hardest);
  EXPECT_EQ(window.steps[*window.hardest].stepId, "plane") << "all fail at the sweep, which does not count";
  ASSERT_EQ(plane.metrics.size(), 2u);
  EXPECT_EQ(plane.metrics[0].version, 2);
  EXPECT_EQ(plane.metrics[0].values.size(), 5u) << "one has an older version, one was never scored, two skipped the step";
  EXPECT_EQ(plane.metrics[1].id, "angle");
  EXPECT_EQ(plane.metrics[1].unit, "deg");
  EXPECT_EQ(plane.shouldPass, 3u) << "two by raters, one by the instructor against them";
  EXPECT_EQ(plane.shouldFail, 2u) << "one by raters, one by the instructor alone";
  bool isSaid = false;
  for (const ReportBlock& block : report.document.blocks)
    if (const auto* paragraph = std::get_if<ReportParagraph>(&block))
      isSaid = isSaid || paragraph->text.english() == "Hardest step: 'Step plane', which 6 of 9 did not pass.";
  EXPECT_TRUE(isSaid);
}

TEST_F(MixedClass, SaysTheSameOfAPassLevelInTheWindowAndInTheReport) {
  say(attempts_[2], Standing::shouldFail);
  say(attempts_[4], Standing::unknown);
  const ClassFigures window = inWindow();
  EXPECT_TRUE(window == inReport().figures);
  const ClassStep& plane = *stepIn(window.steps, "plane");
  EXPECT_EQ(window.standing.at(attempts_[5].filename().string()), Standing::unknown) << "its raters differ";
  EXPECT_EQ(plane.shouldPass, 2u);
  EXPECT_EQ(plane.shouldFail, 2u);
  EXPECT_EQ(plane.suggested, contrastingGroups(std::vector<double>{0.5, 0.3}, std::vector<double>{0.9, 0.8}));
  EXPECT_TRUE(plane.suggested);
  EXPECT_FALSE(stepIn(window.steps, "sweep")->suggested) << "a step that does not count";
}

TEST_F(MixedClass, IsShownWithoutWhatIsOnlyReadAndWithStepsThatNobodyTried) {
  const ClassFigures figures = inWindow();
  const auto rows = overviewSteps(figures, world_.lesson(), plan_);
  EXPECT_EQ(stepIn(rows, "read"), nullptr);
  EXPECT_NE(stepIn(rows, "sweep"), nullptr) << "of weight 0, but somebody did it";
  EXPECT_EQ(rows.size(), figures.steps.size() - 1);
  const auto untried = overviewSteps({}, world_.lesson(), plan_);
  EXPECT_EQ(untried.size(), rows.size());
  EXPECT_EQ(stepIn(untried, "plane")->passLevel, 0.6);
  EXPECT_EQ(stepIn(untried, "sweep")->weight, 0.0);
}

TEST_F(MixedClass, IsShownWithoutStandingsThatCannotBeRead) {
  ew::test::writeText(standingsFile(library()), "{");
  const auto shelf = readShelf(library(), {});
  ASSERT_TRUE(shelf) << shelf.error();
  const auto records = readClassRecords(*shelf, library());
  ASSERT_TRUE(records) << records.error();
  ASSERT_TRUE(records->problem);
  EXPECT_NE(records->problem->sentence().find("standings.json is not valid JSON"), std::string::npos) << *records->problem;
  EXPECT_TRUE(records->standings.empty());
  EXPECT_EQ(records->scores.size(), 8u);
  const ReportLesson lesson = readReportedLesson("ball", "about-balls", library(), {});
  ASSERT_TRUE(lesson.standingsProblem);
  EXPECT_EQ(*lesson.standingsProblem, *records->problem);
}

TEST(RatersWord, IsOpenToThoseWhoHaveFinishedARatingWithEveryForm) {
  const auto form = std::make_shared<const RatingForm>(smallForm());
  RatingRecords ratings;
  EXPECT_EQ(ratersWordOf(ratings).standing, Standing::unknown);
  for (const std::string rater : {"Ada", "Ben"}) {
    Rating rating = ratingOf(*form, rater, {4, 4, 4});
    rating.formId = form->id;
    ratings.ratings.push_back({rating, form});
  }
  EXPECT_EQ(ratersWordOf(ratings).standing, Standing::shouldPass);
  EXPECT_EQ(ratersWordOf(ratings).openTo, (std::set<std::string>{"Ada", "Ben"}));
  Rating other = ratings.ratings.front().rating;
  other.formId = "another";
  ratings.ratings.push_back({other, form});
  EXPECT_EQ(ratersWordOf(ratings).openTo, std::set<std::string>{"Ada"}) << "Ben has not rated with the other form";
  ratings.ratings[1].rating.finished = false;
  ratings.ratings.pop_back();
  EXPECT_EQ(ratersWordOf(ratings).openTo, std::set<std::string>{"Ada"}) << "Ben's is a draft";
}

}  // namespace
}  // namespace ew::review::class_attempts_test
