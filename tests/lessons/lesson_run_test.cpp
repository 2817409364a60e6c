#include "logic/lesson_run.h"

#include <gtest/gtest.h>

#include "ew/scanning/recording.h"
#include "lessons/made_scene.h"
#include "library/temporary_folder.h"

namespace ew::lessons {
namespace {

using ew::test::EnvironmentValue;
using ew::test::TemporaryFolder;
using test::held;
using test::image;
using test::scene;

Lesson lesson() {
  Lesson made;
  made.id = "lesson";
  made.title = "Lesson";
  for (const auto& [id, task] :
       {std::pair<const char*, LessonTask>{"read", ReadingTask{}}, {"plane", PlaneTask{"middle", {}, {}}}, {"end", ReadingTask{}}}) {
    made.steps.push_back(test::step(task));
    made.steps.back().id = id;
    made.steps.back().hints = {"First.", "Second."};
  }
  return made;
}

void show(LessonRun& run, const ScanState& state) { run.see({state.time_s, FrameMade{state.pose, {}, state.number, {}}}, state); }

TEST(LessonRunOfALesson, KeepsEachStepWithItsRecording) {
  const TemporaryFolder folder;
  auto run = LessonRun::begin(lesson(), "home", "me", folder.path());
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE(run->startStep(scene(), 10.0));
  ASSERT_TRUE(run->endStep({}, 12.0));
  ASSERT_TRUE(run->next());
  ASSERT_TRUE(run->startStep(scene(), 20.0));
  show(*run, image(held(1.0), 21.0));
  EXPECT_EQ(run->nextHint(), "First.");
  const auto outcome = run->endStep({}, 24.0);
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, StepVerdict::passed);
  EXPECT_DOUBLE_EQ(outcome->seconds, 4.0);
  EXPECT_EQ(outcome->hints, 1);
  const auto recording = readRecording(run->attempt()->folder() / outcome->recording);
  ASSERT_TRUE(recording) << recording.error();
  EXPECT_EQ(recording->log.frameCount(), 1u);
  ASSERT_TRUE(run->next());
  ASSERT_TRUE(run->startStep(scene(), 30.0));
  ASSERT_TRUE(run->endStep({}, 31.0));
  ASSERT_TRUE(run->next());
  EXPECT_TRUE(run->isOver());
  for (const LessonStep& step : run->lesson().steps) EXPECT_EQ(run->outcomeOf(step.id)->verdict, StepVerdict::passed) << step.id;
  const auto kept = listAttempts(folder.path());
  ASSERT_EQ(kept.attempts.size(), 1u);
  EXPECT_TRUE(kept.attempts[0].second.finishedAt);
  EXPECT_EQ(kept.attempts[0].second.outcomes.size(), 3u);
}

TEST(LessonRunOfALesson, GoesOnAtTheStepThatWasNotEnded) {
  const TemporaryFolder folder;
  std::filesystem::path kept;
  {
    auto run = LessonRun::begin(lesson(), "home", "", folder.path());
    ASSERT_TRUE(run);
    kept = run->attempt()->folder();
    ASSERT_TRUE(run->startStep(scene(), 0.0));
    ASSERT_TRUE(run->endStep({}, 1.0));
    ASSERT_TRUE(run->next());
    ASSERT_TRUE(run->startStep(scene(), 2.0));
  }  // as if it were killed
  auto again = AttemptFolder::open(kept);
  ASSERT_TRUE(again);
  const LessonRun run(lesson(), std::move(*again));
  EXPECT_EQ(run.step().id, "plane");
  EXPECT_EQ(run.lostStep(), "plane");
}

TEST(LessonRunOfALesson, IsFinishedWithItsLastOutcomeThoughNobodyGoesOn) {
  const TemporaryFolder folder;
  auto run = LessonRun::begin(lesson(), "home", "", folder.path());
  ASSERT_TRUE(run);
  for (int n = 0; n < 2; ++n) {
    ASSERT_TRUE(run->startStep(scene(), 10.0 * n));
    ASSERT_TRUE(run->skipStep(10.0 * n + 1.0));
    ASSERT_TRUE(run->next());
  }
  ASSERT_TRUE(run->startStep(scene(), 20.0));
  EXPECT_FALSE(AttemptFolder::open(run->attempt()->folder())->attempt().finishedAt);
  ASSERT_TRUE(run->endStep({}, 21.0));
  const auto kept = AttemptFolder::open(run->attempt()->folder());  // the window is closed on the outcome
  ASSERT_TRUE(kept->attempt().finishedAt);
  EXPECT_EQ(*kept->attempt().finishedAt, kept->attempt().outcomes.back().at);
  ASSERT_TRUE(run->startStep(scene(), 30.0)) << "the last step may be tried again";
  ASSERT_TRUE(run->endStep({}, 31.0));
  ASSERT_TRUE(run->next());
  EXPECT_EQ(run->attempt()->attempt().outcomes.size(), 4u);
  EXPECT_EQ(run->attempt()->attempt().finishedAt, run->attempt()->attempt().outcomes.back().at);
}

TEST(LessonRunOfALesson, IsFinishedWhenAnAttemptWhoseStepsHaveAllEndedIsGoneOnWith) {
  const TemporaryFolder folder;
  Attempt attempt;
  attempt.id = "20260105-090000-885f5f0e";
  attempt.caseId = "home";
  attempt.lessonId = lesson().id;
  for (const LessonStep& each : lesson().steps) {
    StepOutcome outcome;
    outcome.stepId = each.id;
    outcome.verdict = StepVerdict::passed;
    outcome.score = 1.0;
    outcome.at = std::chrono::sys_days(std::chrono::year(2026) / 1 / 5) + std::chrono::hours(9);
    attempt.outcomes.push_back(outcome);
  }
  auto kept = AttemptFolder::begin(folder.path(), attempt);
  ASSERT_TRUE(kept) << kept.error();
  const auto place = kept->folder();
  const auto run = LessonRun::goOnWith(lesson(), std::move(*kept));
  ASSERT_TRUE(run) << run.error();
  EXPECT_TRUE(run->isOver());
  EXPECT_EQ(AttemptFolder::open(place)->attempt().finishedAt, attempt.outcomes.back().at) << "as of its last outcome";
  EXPECT_EQ(run->result({}).passed(), true);
}

TEST(LessonRunOfALesson, ThatWasRevisedMeanwhileIsTheOneTheAttemptGoesOnAt) {
  const TemporaryFolder folder;
  auto begun = LessonRun::begin(lesson(), "home", "", folder.path());
  ASSERT_TRUE(begun) << begun.error();
  const auto place = begun->attempt()->folder();
  Lesson revised = lesson();
  revised.title = "Revised";
  revised.steps.pop_back();
  const auto run = LessonRun::goOnWith(revised, *AttemptFolder::open(place));
  ASSERT_TRUE(run) << run.error();
  const Attempt kept = AttemptFolder::open(place)->attempt();
  EXPECT_EQ(kept.lessonContent, contentOf(revised)) << "what window, reports and learning systems judge it by";
  EXPECT_EQ(kept.lessonTitle, "Revised");
}

TEST(LessonRunOfALesson, SaysWhichLaunchBeganIt) {
  const TemporaryFolder folder;
  const EnvironmentValue launch(kLaunchVariable, "0a5f-17.4");
  const auto run = LessonRun::begin(lesson(), "home", "", folder.path());
  ASSERT_TRUE(run);
  EXPECT_EQ(AttemptFolder::open(run->attempt()->folder())->attempt().launch, "0a5f-17.4");
  const EnvironmentValue odd(kLaunchVariable, "not a launch\n");
  EXPECT_EQ(launchOfEnvironment(), "");
}

TEST(LessonRunOfALesson, SaysWhatScoreItsLaunchAsksFor) {
  const TemporaryFolder folder;
  const EnvironmentValue mastery(kMasteryVariable, "0.65");
  EXPECT_FALSE(masteryScoreOfEnvironment()) << "nobody launched it";
  const EnvironmentValue launch(kLaunchVariable, "0a5f-17.4");
  const auto run = LessonRun::begin(lesson(), "home", "", folder.path());
  ASSERT_TRUE(run);
  EXPECT_EQ(AttemptFolder::open(run->attempt()->folder())->attempt().masteryScore, 0.65);
  EXPECT_EQ(run->result({}).masteryScore, 0.65);
  for (const char* odd : {"", "much", "1.5", "-0.1"}) {
    const EnvironmentValue other(kMasteryVariable, odd);
    EXPECT_FALSE(masteryScoreOfEnvironment()) << odd;
  }
}

TEST(LessonRunOfALesson, LeavesPausesOutOfTheTimeAndTheRecording) {
  LessonRun run(lesson(), std::nullopt);
  ASSERT_TRUE(run.startStep(scene(), 0.0));
  ASSERT_TRUE(run.endStep({}, 1.0));
  ASSERT_TRUE(run.next());
  ASSERT_TRUE(run.startStep(scene(), 10.0));
  run.pause(13.0);
  EXPECT_TRUE(run.isPaused());
  show(run, image(held(), 15.0));
  EXPECT_DOUBLE_EQ(run.used_s(100.0), 3.0);
  run.goOn(100.0);
  EXPECT_DOUBLE_EQ(run.used_s(102.0), 5.0);
  EXPECT_TRUE(run.missing({})) << "what was shown while it rested does not count";
}

TEST(LessonRunOfALesson, FailsAStepThatTakesTooLong) {
  Lesson timed = lesson();
  timed.steps.front().time_s = 10.0;
  LessonRun run(timed, std::nullopt);
  ASSERT_TRUE(run.startStep(scene(), 0.0));
  EXPECT_DOUBLE_EQ(*run.left_s(4.0), 6.0);
  EXPECT_EQ(run.endStep({}, 12.0)->verdict, StepVerdict::failed);
}

TEST(LessonRunOfALesson, WaitsUntilSomethingWasDone) {
  Lesson scanned;
  scanned.steps = {test::step(PlaneTask{"middle", {}, {}})};
  const auto missingAfter = [&](const std::vector<ScanState>& images, bool isFrozen = false) {
    LessonRun run(scanned, std::nullopt);
    EXPECT_TRUE(run.startStep(scene(), 0.0));
    for (const ScanState& each : images) show(run, each);
    if (isFrozen) run.see({1.0, FreezeChanged{true}}, images.back());
    return run.missing({}).has_value();
  };
  ScanState deeper = image(held(), 0.5), finer = image(held(), 0.5);
  deeper.knobs.depth_mm = 90.0;
  finer.knobs.quality = Quality::cubic;
  EXPECT_TRUE(missingAfter({image(held())})) << "a second click ends nothing";
  EXPECT_TRUE(missingAfter({image(held()), image(held(0.4), 0.5)})) << "a tremor";
  EXPECT_TRUE(missingAfter({image(held()), finer})) << "the program did that";
  EXPECT_FALSE(missingAfter({image(held()), image(held(2.0), 0.5)}));
  EXPECT_FALSE(missingAfter({image(held()), image(held(0.0, 3.0), 0.5)}));
  EXPECT_FALSE(missingAfter({image(held()), deeper}));
  EXPECT_FALSE(missingAfter({image(held())}, true));
  LessonRun reading(lesson(), std::nullopt);
  ASSERT_TRUE(reading.startStep(scene(), 0.0));
  EXPECT_FALSE(reading.missing({})) << "nothing is to be done";
}

TEST(LessonRunOfALesson, SaysOnceThatItsTimeIsUp) {
  Lesson timed = lesson();
  timed.steps.front().time_s = 10.0;
  LessonRun run(timed, std::nullopt);
  ASSERT_TRUE(run.startStep(scene(), 0.0));
  EXPECT_FALSE(run.takeTimeUp(9.0));
  EXPECT_TRUE(run.takeTimeUp(10.1));
  EXPECT_FALSE(run.takeTimeUp(10.4)) << "what could not be ended then is not ended again and again";
  run.pause(10.1);
  EXPECT_EQ(run.endStep({}, 60.0)->verdict, StepVerdict::passed) << "its time stood";
}

TEST(LessonRunOfALesson, LeadsBackToAStepAndToTheEndAgain) {
  const TemporaryFolder folder;
  auto run = LessonRun::begin(lesson(), "home", "me", folder.path());
  ASSERT_TRUE(run) << run.error();
  for (int n = 0; n < 3; ++n) {
    ASSERT_TRUE(run->startStep(scene(), 10.0 * n));
    ASSERT_TRUE(n == 1 ? run->skipStep(10.0 * n + 1.0) : run->endStep({}, 10.0 * n + 1.0));
    ASSERT_TRUE(run->next());
  }
  ASSERT_TRUE(run->isOver());
  run->goBackTo(1);
  EXPECT_EQ(run->step().id, "plane");
  ASSERT_TRUE(run->startStep(scene(), 40.0));
  show(*run, image(held(1.0), 41.0));
  ASSERT_TRUE(run->endStep({}, 42.0));
  ASSERT_TRUE(run->next());
  EXPECT_TRUE(run->isOver());
  for (const LessonStep& step : run->lesson().steps) EXPECT_EQ(run->outcomeOf(step.id)->verdict, StepVerdict::passed) << step.id;
  EXPECT_EQ(listAttempts(folder.path()).attempts[0].second.outcomes.size(), 4u);
}

TEST(LessonRunOfALesson, KeepsAStepThatIsTriedAgain) {
  LessonRun run(lesson(), std::nullopt);
  ASSERT_TRUE(run.startStep(scene(), 0.0));
  ASSERT_TRUE(run.skipStep(1.0));
  EXPECT_EQ(run.outcomeOf("read")->verdict, StepVerdict::skipped);
  ASSERT_TRUE(run.startStep(scene(), 2.0));
  ASSERT_TRUE(run.endStep({}, 3.0));
  EXPECT_EQ(run.outcomeOf("read")->verdict, StepVerdict::passed);
}

TEST(LessonRunOfALesson, GoesBackToAStepThatWasLostWhileItWasTriedAgain) {
  const TemporaryFolder folder;
  std::filesystem::path kept;
  {
    auto run = LessonRun::begin(lesson(), "home", "", folder.path());
    ASSERT_TRUE(run);
    kept = run->attempt()->folder();
    ASSERT_TRUE(run->startStep(scene(), 0.0));
    ASSERT_TRUE(run->endStep({}, 1.0));
    ASSERT_TRUE(run->startStep(scene(), 2.0));
  }  // as if it were killed
  LessonRun run(lesson(), *AttemptFolder::open(kept));
  EXPECT_EQ(run.step().id, "plane") << "what was ended before stands";
  ASSERT_TRUE(run.goBackToLost());
  EXPECT_EQ(run.step().id, "read");
  ASSERT_TRUE(run.startStep(scene(), 3.0));
  ASSERT_TRUE(run.endStep({}, 4.0));
  ASSERT_TRUE(run.next());
  EXPECT_EQ(run.step().id, "plane") << "and it goes on from there";
  ASSERT_TRUE(run.startStep(scene(), 5.0));
  LessonRun lost(lesson(), *AttemptFolder::open(kept));
  EXPECT_FALSE(lost.goBackToLost()) << "a step that nobody has ended is the one it stands at";
  EXPECT_EQ(lost.step().id, "plane");
}

TEST(LessonRunOfALesson, GoesOnWithTheStepWhenItsOutcomeCannotBeKept) {
  const TemporaryFolder folder;
  auto run = LessonRun::begin(lesson(), "home", "", folder.path());
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->startStep(scene(), 0.0));
  std::filesystem::remove_all(run->attempt()->folder());
  EXPECT_FALSE(run->endStep({}, 1.0));
  EXPECT_TRUE(run->isRunning());
  std::filesystem::create_directories(run->attempt()->folder());
  EXPECT_TRUE(run->endStep({}, 2.0));
}

}  // namespace
}  // namespace ew::lessons
