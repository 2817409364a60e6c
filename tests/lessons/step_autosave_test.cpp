// The step of a lesson that runs outlives a kill, and goes on where it stood.
#include "logic/step_autosave.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "ew/scanning/recording.h"
#include "io/file_size_limit.h"
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
  auto attempt = AttemptFolder::open(attempts.attempts[0].first);
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
  run.resume(left->log, left->used_s, left->hints, 3.0);
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

void beKilled() { ::kill(::getpid(), SIGKILL); }

/// Does it in a program of its own. @param work ends with beKilled(), before anything is destroyed
template <class Work>
void doAndBeKilled(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(StepAutosave, NothingIsOfferedOfAnAttemptThatEndedWithTheStep) {
  const TemporaryFolder folder;
  doAndBeKilled([&] {
    auto run = LessonRun::begin(oneStep(), "home", "me", folder / "attempts");
    StepAutosave kept(folder / "kept");
    if (!run || !run->startStep(scene(), 100.0)) return;
    kept.begin(*run, "/cases/home", "Home");
    see(*run, image(held(1.0), 101.0));
    kept.grow(*run, 102.0);
    if (run->endStep({}, 103.0)) kept.endStep(*run);
    kept.flush();
    beKilled();
  });
  const auto attempts = listAttempts(folder / "attempts");
  ASSERT_EQ(attempts.attempts.size(), 1u);
  EXPECT_TRUE(attempts.attempts[0].second.finishedAt);
  EXPECT_TRUE(Autosave(folder / "kept").takeLeft().empty()) << "the window was killed on the last outcome";
}

TEST(StepAutosave, AStepThatIsTriedOnceMoreGoesOnInItsAttemptAlthoughThatIsFinished) {
  const TemporaryFolder folder;
  doAndBeKilled([&] {
    auto run = LessonRun::begin(oneStep(), "home", "me", folder / "attempts");
    StepAutosave kept(folder / "kept");
    if (!run || !run->startStep(scene(), 100.0)) return;
    kept.begin(*run, "/cases/home", "Home");
    see(*run, image(held(30.0), 101.0));
    if (!run->endStep({}, 103.0)) return;
    kept.endStep(*run);
    if (!run->next()) return;
    run->goBackTo(0);
    if (!run->startStep(scene(), 110.0)) return;
    kept.begin(*run, "/cases/home", "Home");
    see(*run, image(held(1.0), 111.0));
    kept.grow(*run, 112.0);
    kept.flush();
    beKilled();
  });
  const auto attempts = listAttempts(folder / "attempts");
  ASSERT_EQ(attempts.attempts.size(), 1u);
  const std::filesystem::path tried = attempts.attempts[0].first;
  StepAutosave here(folder / "kept");
  const auto left = here.takeLeftOfAny({"/somebody/else", tried});
  ASSERT_TRUE(left);
  EXPECT_EQ(left->attempt, tried);
  EXPECT_EQ(left->log.frameCount(), 1u);
  auto run = LessonRun::goOnWith(oneStep(), *AttemptFolder::open(tried));
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE(run->isOver());
  ASSERT_TRUE(run->goBackToLost());
  EXPECT_EQ(run->step().id, left->stepId);
  ASSERT_TRUE(run->startStep(scene(), 3.0));
  run->resume(left->log, left->used_s, left->hints, 3.0);
  const auto outcome = run->endStep({}, 4.0);
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, StepVerdict::passed);
  ASSERT_TRUE(run->next());
  EXPECT_TRUE(run->isOver());
  EXPECT_EQ(listAttempts(folder / "attempts").attempts.size(), 1u);
}

/// A program that is killed in a step of which it has seen two images. @return the attempt's folder
std::filesystem::path attemptKilledInAStep(const TemporaryFolder& folder) {
  doAndBeKilled([&] {
    auto run = LessonRun::begin(oneStep(), "home", "me", folder / "attempts");
    StepAutosave kept(folder / "kept");
    if (!run || !run->startStep(scene(), 100.0)) return;
    kept.begin(*run, "/cases/home", "Home");
    see(*run, image(held(30.0), 101.0));
    see(*run, image(held(1.0), 102.0));
    kept.grow(*run, 103.0);
    kept.flush();
    beKilled();
  });
  const auto attempts = listAttempts(folder / "attempts");
  EXPECT_EQ(attempts.attempts.size(), 1u);
  return attempts.attempts.empty() ? std::filesystem::path() : attempts.attempts[0].first;
}

std::vector<std::filesystem::path> journalsIn(const std::filesystem::path& kept) {
  std::vector<std::filesystem::path> found;
  for (const auto& each : std::filesystem::directory_iterator(kept))
    if (std::filesystem::exists(each.path() / "step.jsonl")) found.push_back(each.path() / "step.jsonl");
  return found;
}

TEST(StepAutosave, AStepThatCannotBeKeptAgainIsNotTakenFromWhereItWas) {
  const TemporaryFolder folder;
  const auto attempt = attemptKilledInAStep(folder);
  const auto goOn = [&](StepAutosave& here, LessonRun& run) {
    auto left = here.takeLeft(attempt);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->log.frameCount(), 2u);
    ASSERT_TRUE(run.startStep(scene(), 3.0));
    run.resume(left->log, left->used_s, left->hints, 3.0);
    const ew::test::FileSizeLimit full(0);
    here.begin(run, "/cases/home", "Home");
    here.grow(run, 5.0);
    here.discardOnceKept(left->kept);
    here.flush();
  };
  {
    StepAutosave here(folder / "kept");
    LessonRun run(oneStep(), *AttemptFolder::open(attempt));
    goOn(here, run);
    EXPECT_EQ(journalsIn(folder / "kept").size(), 1u) << "the only copy there is";
  }
  StepAutosave here(folder / "kept");
  LessonRun run(oneStep(), *AttemptFolder::open(attempt));
  goOn(here, run);
  const auto before = journalsIn(folder / "kept");
  ASSERT_EQ(before.size(), 1u);
  see(run, image(held(2.0), 6.0));
  here.grow(run, 7.0);  // there is room again
  here.flush();
  EXPECT_FALSE(std::filesystem::exists(before[0])) << "all of it is kept here";
  EXPECT_EQ(journalsIn(folder / "kept").size(), 1u);
}

TEST(StepAutosave, OfTwoThatWereLeftTheOneWithMoreOfTheStepIsTakenUp) {
  const TemporaryFolder folder;
  const auto attempt = attemptKilledInAStep(folder);
  doAndBeKilled([&] {
    StepAutosave kept(folder / "kept");
    LessonRun run(oneStep(), *AttemptFolder::open(attempt));
    if (!run.startStep(scene(), 3.0)) return;
    kept.begin(run, "/cases/home", "Home");  // and no more, as on a full medium
    kept.flush();
    beKilled();
  });
  const auto left = StepAutosave(folder / "kept").takeLeft(attempt);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->log.frameCount(), 2u);
  EXPECT_DOUBLE_EQ(left->used_s, 3.0);
}

TEST(StepAutosave, WhatANewerProgramLeftStaysForIt) {
  const TemporaryFolder folder;
  const auto attempt = attemptKilledInAStep(folder);
  const auto journals = journalsIn(folder / "kept");
  ASSERT_EQ(journals.size(), 1u);
  std::string text = ew::test::textOf(journals[0]);
  ASSERT_NE(text.find("\"recording\":1,"), std::string::npos);
  ew::test::writeText(journals[0], text.replace(text.find("\"recording\":1,"), 14, "\"recording\":99,"));
  {
    StepAutosave here(folder / "kept");
    EXPECT_FALSE(here.takeLeft(attempt)) << "nothing of it can be taken up, so nothing may be discarded for it";
  }
  EXPECT_EQ(Autosave(folder / "kept").takeLeft().size(), 1u);
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
