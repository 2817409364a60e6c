#include "logic/exercises.h"

#include <gtest/gtest.h>

#include "../tracking/skins.h"
#include "ew/scanning/contact.h"
#include "lessons/made_scene.h"
#include "logic/lesson_run.h"

namespace ew::lessons {
namespace {

using std::chrono::sys_seconds;

constexpr sys_seconds kNow{std::chrono::seconds(1'790'000'000)};

Exercise exercise(ExerciseKind kind, const std::string& target) {
  return {"home/" + std::string(wordOf(kind)) + "/" + target, "home", kind, target, false};
}

std::shared_ptr<ExercisePlan> planOfTheBall() {
  const StepScene scene = test::scene();
  auto plan = std::make_shared<ExercisePlan>();
  plan->ground.truth = *scene.truth;
  auto labels = std::make_shared<Volume>(*scene.scanned.labels);
  labels->grid = scene.scanned.placedLabels;
  plan->ground.labels = labels;
  return plan;
}

/// The exercise as its player works through it. @return whether it passed
bool passes(const Exercise& asked, int level, const ScanState& image, const Handed& handed) {
  const auto plan = planOfTheBall();
  const auto step = stepOf(asked, plan->ground, level);
  EXPECT_TRUE(step);
  auto work = exerciseWork(asked, plan, level, *step, test::scene());
  EXPECT_TRUE(work);
  Lesson lesson;
  lesson.steps = {*step};
  LessonRun run(lesson, std::nullopt);
  EXPECT_TRUE(run.startStep(std::move(*work), 0.0));
  run.see({0.0, FrameMade{image.pose, image.gaps_mm, 1, image.body}}, image);
  run.see({0.5, FreezeChanged{true}}, image);
  EXPECT_FALSE(run.missing(handed)) << *run.missing(handed);
  const auto outcome = run.endStep(handed, 1.0);
  EXPECT_TRUE(outcome);
  EXPECT_FALSE(outcome->remarks.empty()) << "a person is told why";
  return outcome->verdict == StepVerdict::passed;
}

TEST(Exercises, AreNamedByTheirIds) {
  for (const ExerciseKind kind : {ExerciseKind::findPlane, ExerciseKind::pointAtOrgan, ExerciseKind::measure}) {
    const Exercise made = exercise(kind, "right kidney/upper pole");
    EXPECT_EQ(exerciseOfId(made.id), made);
  }
  for (const char* none : {"", "home", "home/plane", "home/plane/", "/plane/x", "home/else/x"}) EXPECT_FALSE(exerciseOfId(none)) << none;
}

TEST(Exercises, AreStepsWithTheTolerancesAidsAndTimeOfTheirLevel) {
  const auto ground = planOfTheBall()->ground;
  for (int level = 1; level <= kExerciseLevels; ++level) {
    const ExerciseDifficulty difficulty = difficultyOf(level);
    const auto plane = stepOf(exercise(ExerciseKind::findPlane, "middle"), ground, level);
    ASSERT_TRUE(plane);
    EXPECT_EQ(std::get<PlaneTask>(plane->task), (PlaneTask{"middle", 5.0 * difficulty.toleranceFactor, 10.0 * difficulty.toleranceFactor}));
    EXPECT_EQ(plane->aids.compass, difficulty.aids.compass);
    EXPECT_EQ(plane->aids.expertProbe, difficulty.aids.expertProbe);
    EXPECT_FALSE(plane->aids.outline) << "of a plane there is none";
    const auto point = stepOf(exercise(ExerciseKind::pointAtOrgan, "ball"), ground, level);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->aids.outline, difficulty.aids.outline);
    EXPECT_FALSE(point->aids.compass);
    EXPECT_EQ(plane->time_s, difficulty.time_s);
    const auto measure = stepOf(exercise(ExerciseKind::measure, "ball, across"), ground, level);
    ASSERT_TRUE(measure);
    EXPECT_EQ(std::get<MeasureTask>(measure->task), (MeasureTask{"ball, across", 2.0 * difficulty.toleranceFactor}));
  }
  EXPECT_TRUE(stepOf(exercise(ExerciseKind::findPlane, "middle"), ground, 1)->feedback);
  EXPECT_FALSE(stepOf(exercise(ExerciseKind::findPlane, "middle"), ground, 5)->feedback);
  const auto lost = stepOf(exercise(ExerciseKind::findPlane, "gone"), ground, 1);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, ErrorCode::badField);
}

TEST(Exercises, ArePlanesJudgedMoreStrictlyOnHigherLevels) {
  const Exercise plane = exercise(ExerciseKind::findPlane, "middle");
  EXPECT_TRUE(passes(plane, 1, test::image(test::held(6.5)), {})) << "6.5 mm of 7.5";
  EXPECT_FALSE(passes(plane, 3, test::image(test::held(6.5)), {})) << "of 5";
  EXPECT_TRUE(passes(plane, 3, test::image(test::held(4.5)), {}));
  EXPECT_FALSE(passes(plane, 5, test::image(test::held(4.5)), {})) << "of 3.75";
}

TEST(Exercises, ArePointsJudgedWithTheMarginOfTheirLevel) {
  const Exercise point = exercise(ExerciseKind::pointAtOrgan, "ball");
  Handed beside;
  beside.point = Point<frame::Probe>{{22.5, 40.0, 0.0}};  // 2.5 mm beside a ball of 20 mm
  EXPECT_TRUE(passes(point, 1, test::image(test::held()), beside));
  EXPECT_FALSE(passes(point, 4, test::image(test::held()), beside));
  Handed inside;
  inside.point = Point<frame::Probe>{{5.0, 40.0, 0.0}};
  EXPECT_TRUE(passes(point, 5, test::image(test::held()), inside));
}

TEST(Exercises, AreMeasurementsReadFromCalipers) {
  const Exercise measure = exercise(ExerciseKind::measure, "ball, across");
  Handed handed;
  handed.measurements = {test::length(42.5)};
  EXPECT_TRUE(passes(measure, 1, test::image(test::held()), handed)) << "2.5 mm of 3";
  EXPECT_FALSE(passes(measure, 3, test::image(test::held()), handed)) << "of 2";
}

TEST(Exercises, FindingsAreAskedForOnlyWhenTheyMayBe) {
  ExerciseList list;
  list.offered = {exercise(ExerciseKind::findPlane, "a"), exercise(ExerciseKind::pointAtOrgan, "stone")};
  list.offered[1].revealsFinding = true;
  EXPECT_EQ(offered(list, false), (std::vector<Exercise>{list.offered[0]}));
  EXPECT_EQ(offered(list, true), list.offered);
}

TEST(Exercises, ArePlannedFromWhatIsScannedAndNothingBefore) {
  Case opened;
  opened.id = "home";
  CaseTarget plane;
  plane.kind = CaseTarget::Kind::plane;
  plane.name = "across";
  sdk::Scanned scanned = test::ball();
  ScanState image = test::image(test::held());
  EXPECT_FALSE(planExercises(opened, scanned, image, noProgress())) << "without a skin";
  scanned.skin = std::make_shared<ew::test::CylinderSkin>(40.0);
  Hold hold;
  hold.contact = scanned.skin->nearest({0.0, -500.0, 0.0});
  hold.press_mm = usualPress_mm(image.probe);
  plane.probeToFile = Transform<frame::File, frame::Probe>{poseOf(hold).probeToWorld.matrix};
  opened.targets = {plane};
  const auto plan = planExercises(opened, scanned, image, noProgress());
  ASSERT_TRUE(plan) << plan.error();
  ASSERT_EQ(plan->list.offered.size(), 1u);
  EXPECT_EQ(plan->list.offered.front().id, "home/plane/across");
  EXPECT_EQ(plan->ground.depth_mm, 80.0);
}

TEST(ExerciseOverview, CountsWhatIsDueAndNamesWhatIsHardAndWhatIsKnown) {
  EXPECT_EQ(overviewOf({}, "home", kNow).tried, 0u);
  std::vector<RepetitionState> states;
  const auto tried = [&](const std::string& target, int repetitions, double interval_days, int lapses, int hours) {
    RepetitionState state;
    state.exerciseId = exercise(ExerciseKind::findPlane, target).id;
    state.repetitions = repetitions;
    state.interval_days = interval_days;
    state.lapses = lapses;
    state.tries = repetitions + lapses;
    state.due = kNow + std::chrono::hours(hours);
    states.push_back(state);
  };
  tried("hard", 0, 0.0, 3, -1);
  tried("less hard", 0, 0.0, 1, -2);
  tried("new", 0, 0.0, 0, 0);  // never tried
  tried("once", 1, 1.0, 0, 20);
  tried("known", 3, 15.0, 5, 300);
  tried("known less well", 2, 6.0, 0, 100);
  states.push_back(states.front());
  states.back().exerciseId = "other/plane/hard";
  const ExerciseOverview overview = overviewOf(states, "home", kNow);
  EXPECT_EQ(overview.tried, 5u);
  EXPECT_EQ(overview.due, 2u);
  EXPECT_EQ(overview.nextDue, kNow + std::chrono::hours(20));
  ASSERT_TRUE(overview.weakest && overview.strongest);
  EXPECT_EQ(overview.weakest->target, "hard");
  EXPECT_EQ(overview.strongest->target, "known");
}

}  // namespace
}  // namespace ew::lessons
