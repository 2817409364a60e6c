#include "ew/assessment/step_work.h"

#include <gtest/gtest.h>

#include "ew/core/figure.h"
#include "lessons/made_scene.h"

namespace ew::lessons {
namespace {

using test::held;
using test::image;
using test::scene;

StepOutcome judged(const LessonTask& task, const std::vector<ScanState>& images, const Handed& handed = {}) {
  auto work = workOf(test::step(task), scene().ground());
  EXPECT_TRUE(work) << work.error();
  for (const ScanState& each : images) (*work)->see(each);
  StepOutcome outcome;
  (*work)->hand(handed, outcome);
  return outcome;
}

double figure(const StepOutcome& outcome, const std::string& name) {
  for (const Figure& one : outcome.figures)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

TEST(PlaneStep, MeasuresTiltAndDistanceExactly) {
  const StepOutcome there = judged(PlaneTask{"middle", {}, {}}, {image(held())});
  EXPECT_DOUBLE_EQ(there.score, 1.0);
  const StepOutcome beside = judged(PlaneTask{"middle", {}, {}}, {image(held(4.0))});
  EXPECT_NEAR(figure(beside, "distance"), 4.0, 1e-9);
  EXPECT_NEAR(beside.score, 1.0 - 0.3 * 0.8, 1e-9);
  const StepOutcome tilted = judged(PlaneTask{"middle", {}, 5.0}, {image(held(0.0, 6.0))});
  EXPECT_NEAR(figure(tilted, "angle"), 6.0, 1e-9);
  EXPECT_LT(tilted.score, 0.7) << "the step's own tolerance of 5 degrees counts";
  EXPECT_FALSE(tilted.remarks.front().good);
}

TEST(PlaneStep, CountsTheImageThatIsShownLast) {
  EXPECT_LT(judged(PlaneTask{"middle", {}, {}}, {image(held()), image(held(30.0))}).score, 0.7);
}

TEST(SweepStep, SeesWhatImagesPassThrough) {
  std::vector<ScanState> half, all;
  for (double z_mm = -25.0; z_mm <= 25.0; z_mm += 1.0) {
    all.push_back(image(held(z_mm)));
    if (z_mm <= 0.0) half.push_back(image(held(z_mm)));
  }
  EXPECT_DOUBLE_EQ(judged(SweepTask{"ball", 0.9}, all).score, 1.0);
  const StepOutcome outcome = judged(SweepTask{"ball", 0.9}, half);
  EXPECT_LT(outcome.score, 0.7);
  EXPECT_TRUE(judged(SweepTask{"ball", 0.9}, {image(held(60.0))}).score == 0.0) << "beside the ball";
}

TEST(SweepStep, TakesNothingFromImagesWithoutAPose) {
  ScanState lost = image(held());
  lost.pose.status = PoseStatus::missing;
  EXPECT_DOUBLE_EQ(judged(SweepTask{"ball", 0.9}, {lost}).score, 0.0);
}

TEST(MeasureStep, ComparesTheLastFittingMeasurement) {
  const MeasureTask task{"ball, across", {}};
  EXPECT_DOUBLE_EQ(judged(task, {image(held())}, {.measurements = {test::length(90.0), test::length(40.0)}}).score, 1.0);
  const StepOutcome off = judged(task, {image(held())}, {.measurements = {test::length(43.0)}});
  EXPECT_LT(off.score, 0.7);
  auto work = workOf(test::step(task), scene().ground());
  MeasurementSubmission angle;
  angle.figures.push_back({"angle", 40.0, "deg"});
  EXPECT_TRUE((*work)->missing({.measurements = {angle}})) << "an angle is no length";
  EXPECT_FALSE((*work)->missing({.measurements = {test::length(1.0)}}));
}

TEST(HandedOf, TakesTheMeasurementsOfTheScan) {
  sdk::ScanMeasurement drawn;
  drawn.kind = "ellipse";
  drawn.points = {{{1.0, 2.0, 0.0}}};
  drawn.figures = {{"circumference", 31.4, "mm", 0.2}, {"area", 0.785, "cm2", 0.01}};
  const auto handed = handedOf({drawn});
  ASSERT_EQ(handed.size(), 1u);
  EXPECT_EQ(handed[0].kind, "ellipse");
  EXPECT_EQ(handed[0].points.size(), 1u);
  EXPECT_EQ(handed[0].figures, drawn.figures);
}

TEST(PointStep, KnowsStructuresAndPoints) {
  const auto at = [](double x, double y) { return Handed{.point = Point<frame::Probe>{{x, y, 0.0}}}; };
  EXPECT_DOUBLE_EQ(judged(PointTask{"ball"}, {image(held())}, at(0.0, 40.0)).score, 1.0);
  EXPECT_GE(judged(PointTask{"ball"}, {image(held())}, at(21.0, 40.0)).score, 0.7) << "a hand's width beside the border";
  EXPECT_LT(judged(PointTask{"ball"}, {image(held())}, at(26.0, 40.0)).score, 0.7);
  EXPECT_LT(judged(PointTask{"ball"}, {image(held())}, at(29.0, 5.0)).score, 0.3);
  EXPECT_DOUBLE_EQ(judged(PointTask{"middle of the ball"}, {image(held())}, at(0.0, 40.0)).score, 1.0);
  EXPECT_LT(judged(PointTask{"middle of the ball"}, {image(held())}, at(10.0, 40.0)).score, 0.7);
}

TEST(SettingsStep, CountsWhatIsRight) {
  const SettingsTask task{{"linear-7.5"}, {{"depth_mm", 60.0, 90.0}, {"gain_db", 5.0, 10.0}}};
  const StepOutcome outcome = judged(task, {image(held())});
  EXPECT_NEAR(outcome.score, 2.0 / 3.0, 1e-12);
  ASSERT_EQ(outcome.remarks.size(), 3u);
  EXPECT_TRUE(outcome.remarks[1].good);
  EXPECT_FALSE(outcome.remarks[2].good);
}

TEST(AnswerStep, GivesNothingForChoosingEverything) {
  const AnswerTask task{{{"a", true, ""}, {"b", true, ""}, {"c", false, "No."}, {"d", false, ""}}, {}, 0.0, ""};
  EXPECT_DOUBLE_EQ(judged(task, {}, {.chosen = {0, 1}}).score, 1.0);
  EXPECT_DOUBLE_EQ(judged(task, {}, {.chosen = {0}}).score, 0.5);
  EXPECT_DOUBLE_EQ(judged(task, {}, {.chosen = {0, 1, 2, 3}}).score, 0.0);
  EXPECT_DOUBLE_EQ(judged(AnswerTask{{}, 12.0, 0.5, "mm"}, {}, {.number = 12.4}).score, 1.0);
  EXPECT_DOUBLE_EQ(judged(AnswerTask{{}, 12.0, 0.5, "mm"}, {}, {.number = 12.6}).score, 0.0);
}

TEST(AnswerStep, TakesANumberAtItsToleranceForRight) {
  for (const auto& [expected, tolerance, answer] : {std::tuple(12.3, 0.2, 12.1), {0.3, 0.1, 0.4}, {0.3, 0.1, 0.2}, {5.0, 0.0, 5.0}}) {
    AnswerTask task;
    task.number = expected;
    task.tolerance = tolerance;
    const StepOutcome outcome = judged(task, {}, Handed{.number = answer});
    EXPECT_EQ(outcome.score, 1.0) << answer << " of " << expected << " +- " << tolerance;
  }
  AnswerTask task;
  task.number = 12.3;
  task.tolerance = 0.2;
  EXPECT_EQ(judged(task, {}, Handed{.number = 12.09}).score, 0.0);
}

TEST(FreeStep, TicksWhatWasShown) {
  const FreeTask task{10.0, {"middle", "ball"}};
  auto work = workOf(test::step(task), scene().ground());
  (*work)->see(image(held(60.0), 0.0));
  EXPECT_TRUE((*work)->missing({}));
  (*work)->see(image(held(1.0), 11.0));
  EXPECT_FALSE((*work)->missing({}));
  StepOutcome outcome;
  (*work)->hand({}, outcome);
  EXPECT_DOUBLE_EQ(outcome.score, 0.5) << "one image shows the plane, and little of the ball";
}

TEST(FreeStep, SaysWhyAndHowMuchIsNeeded) {
  const StepOutcome little = judged(FreeTask{0.0, {"ball", "middle"}}, {image(held(15.0)), image(held(8.0))});
  ASSERT_EQ(little.remarks.size(), 2u);
  EXPECT_TRUE(little.remarks[0].text.english().starts_with("Not shown: ball. The images passed through "));
  EXPECT_TRUE(little.remarks[0].text.english().ends_with(" % of it; 30 % are needed."));
  EXPECT_EQ(little.remarks[1].text.english(),
            "Not shown: middle. At best the plane was 0 degrees and 8 mm off; 10 degrees and 5 mm are allowed.");
}

TEST(WorkOf, SaysWhatTheCaseDoesNotHave) {
  for (const LessonTask& task : {LessonTask(PlaneTask{"none", {}, {}}), LessonTask(SweepTask{"none", 0.9}), LessonTask(PointTask{"none"}),
                                 LessonTask(MeasureTask{"none", {}})}) {
    const auto work = workOf(test::step(task), scene().ground());
    ASSERT_FALSE(work);
    EXPECT_NE(work.error().sentence().find("none"), std::string::npos);
  }
}

TEST(EveryStep, JudgesWithoutHavingSeenAnything) {
  for (const LessonTask& task :
       {LessonTask(ReadingTask{}), LessonTask(WatchTask{}), LessonTask(PlaneTask{"middle", {}, {}}), LessonTask(SweepTask{"ball", 0.9}),
        LessonTask(MeasureTask{"ball, across", {}}), LessonTask(PointTask{"ball"}), LessonTask(SettingsTask{{"x"}, {}}),
        LessonTask(AnswerTask{{{"a", true, ""}}, {}, 0.0, ""}), LessonTask(FreeTask{1.0, {"middle"}})}) {
    const double score = judged(task, {}).score;
    EXPECT_DOUBLE_EQ(score, std::holds_alternative<ReadingTask>(task) ? 1.0 : 0.0) << taskWord(task);
  }
}

}  // namespace
}  // namespace ew::lessons
