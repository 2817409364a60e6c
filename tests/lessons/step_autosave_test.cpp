// The step of a lesson that runs outlives a kill, and goes on where it stood.
#include "logic/step_autosave.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "ew/scanning/recording.h"
#include "lessons/made_scene.h"
#include "library/temporary_folder.h"

namespace ew::lessons {
namespace {

using ew::test::TemporaryFolder;
using test::held;
using test::image;
using test::scene;

Lesson oneStep() {
  Lesson made;
  made.id = "lesson";
  made.title = "Lesson";
  made.steps.push_back(test::step(PlaneTask{"middle", {}, {}}));
  made.steps.back().id = "plane";
  made.steps.back().hints = {"First.", "Second."};
  return made;
}

void see(LessonRun& run, const ScanState& state) { run.see({state.time_s, FrameMade{state.pose, {}, state.number, {}}}, state); }

TEST(StepAutosave, AKilledStepGoesOnWhereItStood) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    auto run = LessonRun::begin(oneStep(), "home", "me", folder / "attempts");
    StepAutosave kept(folder / "kept");
    if (run && run->startStep(scene(), 100.0)) {
      kept.begin(*run, "/cases/home", "Home");
      see(*run, image(held(30.0), 101.0));
      kept.grow(*run, 102.0);
      static_cast<void>(run->nextHint());
      see(*run, image(held(1.0), 107.0));
      kept.grow(*run, 108.0);
      kept.flush();
    }
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto attempts = listAttempts(folder / "attempts");
  ASSERT_EQ(attempts.attempts.size(), 1u);
  auto attempt = KeptAttempt::open(attempts.attempts[0].first);
  ASSERT_TRUE(attempt);
  LessonRun run(oneStep(), std::move(*attempt));

  StepAutosave here(folder / "kept");
  EXPECT_FALSE(here.takeLeft("/somebody/else"));
  auto left = here.takeLeft(attempts.attempts[0].first);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->stepId, "plane");
  EXPECT_EQ(left->log.frameCount(), 2u);
  EXPECT_DOUBLE_EQ(left->used_s, 8.0);
  EXPECT_EQ(left->hints, 1);
  // The clock of the next program began anew.
  ASSERT_TRUE(run.startStep(scene(), 3.0));
  run.takeUp(left->log, left->used_s, left->hints, 3.0);
  EXPECT_DOUBLE_EQ(run.used_s(5.0), 10.0);
  EXPECT_EQ(run.hintsGiven(), 1);
  here.begin(run, "/cases/home", "Home");
  here.grow(run, 5.0);
  here.discardOnceKept(left->kept);
  left.reset();
  here.flush();
  EXPECT_FALSE(StepAutosave(folder / "kept").takeLeft(attempts.attempts[0].first)) << "it is not offered twice";
  const auto outcome = run.endStep({}, 6.0);
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, StepVerdict::passed) << "the plane was found before the crash";
  EXPECT_DOUBLE_EQ(outcome->seconds, 11.0);
  const auto recording = readRecording(run.attempt()->folder() / outcome->recording);
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->log.frameCount(), 2u);
  here.forget();
  here.flush();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "kept"));
}

TEST(StepAutosave, AnAuthorsTryIsNotKept) {
  const TemporaryFolder folder;
  LessonRun run(oneStep(), std::nullopt);
  StepAutosave kept(folder / "kept");
  ASSERT_TRUE(run.startStep(scene(), 1.0));
  kept.begin(run, "/cases/home", "Home");
  see(run, image(held(), 2.0));
  kept.grow(run, 3.0);
  kept.flush();
  EXPECT_FALSE(std::filesystem::exists(folder / "kept"));
}

}  // namespace
}  // namespace ew::lessons
