#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "ew/assessment/step_work.h"
#include "ew/core/figure.h"
#include "ew/library/step_answer.h"
#include "ew/simulated_people/simulated_trainee.h"
#include "places.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shippedCases() {
  std::vector<std::string> ids;
  for (const auto& each : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "cases"))
    if (each.is_directory()) ids.push_back(each.path().filename().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

StepOutcome judged(const LessonStep& step, const SimulatedStep& made, const TraineeCase& on) {
  StepOutcome outcome;
  outcome.seconds = made.seconds;
  auto work = workOf(step, on.ground());
  EXPECT_TRUE(work) << work.error().sentence();
  if (!work) return outcome;
  for (std::size_t n = 0; n < made.log.frameCount(); ++n) (*work)->see(made.log.frame(n));
  outcome.result() = (*work)->judge(made.answer);
  conclude(step, step.passLevel, outcome);
  return outcome;
}

class SimulatedLessons : public ::testing::TestWithParam<std::string> {};

TEST_P(SimulatedLessons, AreDoneByAHandWithoutErrorsAndTriedByANovice) {
  const auto opened = loadCase(fs::path(EW_SOURCE_DIR) / "cases" / GetParam());
  ASSERT_TRUE(opened) << opened.error().sentence();
  auto teaching = teachingCaseOf(*opened, true, 0, noProgress());
  ASSERT_TRUE(teaching) << teaching.error().sentence();
  const auto on = TraineeCase::of(*std::move(teaching), noProgress());
  ASSERT_TRUE(on) << on.error().sentence();
  ASSERT_FALSE(on->lessons().empty());
  for (const Lesson& lesson : on->lessons()) {
    // Pressed on as firmly as a person does, for a plane that only touches the skin loses most of a curved face.
    TraineeHabits faultless;
    faultless.press = 1.0;
    const auto steps = simulateAttempt(lesson, *on, faultless, 1);
    const auto novices = simulateAttempt(lesson, *on, habitsOf(SkillLevel::novice), 1, {.rate_hz = 5.0});
    ASSERT_EQ(steps.size(), lesson.steps.size());
    ASSERT_EQ(novices.size(), lesson.steps.size());
    for (std::size_t n = 0; n < steps.size(); ++n) {
      const LessonStep& step = lesson.steps[n];
      SCOPED_TRACE(lesson.id + ", " + step.id + " [" + std::string(taskWord(step.task)) + "]: " + jsonOf(steps[n].answer).dump());
      const StepOutcome outcome = judged(step, steps[n], *on);
      std::string figures;
      for (const Figure& each : outcome.figures) figures += " " + each.name + " " + std::to_string(each.value);
      EXPECT_EQ(outcome.verdict, StepVerdict::passed) << outcome.score << " in " << outcome.seconds << " s;" << figures;
      const StepOutcome tried = judged(step, novices[n], *on);
      EXPECT_GE(tried.score, 0.0);
      EXPECT_LE(tried.seconds, step.time_s.value_or(600.0) + 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, SimulatedLessons, ::testing::ValuesIn(shippedCases()), [](const auto& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace ew
