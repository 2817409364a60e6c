#include "ew/assessment/repetition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "ew/assessment/repetition_record.h"

namespace ew {
namespace {

using std::chrono::days;
using std::chrono::minutes;
using std::chrono::seconds;
using std::chrono::sys_seconds;

const sys_seconds kNow{seconds(1'790'000'000)};

std::vector<Exercise> exercises(int count) {
  std::vector<Exercise> list;
  for (int n = 0; n < count; ++n) {
    Exercise exercise;
    exercise.id = "case/plane/" + std::to_string(n);
    list.push_back(exercise);
  }
  return list;
}

RepetitionState& stateOf(std::vector<RepetitionState>& states, const std::string& id) {
  for (RepetitionState& each : states)
    if (each.exerciseId == id) return each;
  states.emplace_back().exerciseId = id;
  return states.back();
}

TEST(Repetition, HasTheIntervalsAndTheEaseOfSm2) {
  RepetitionState state;
  sys_seconds when = kNow;
  state = afterwards(state, 4, when);
  EXPECT_EQ(state.interval_days, 1.0);
  EXPECT_DOUBLE_EQ(state.ease, 2.5) << "grade 4 changes nothing";
  when = state.due;
  state = afterwards(state, 4, when);
  EXPECT_EQ(state.interval_days, 6.0);
  when = state.due;
  state = afterwards(state, 5, when);
  EXPECT_DOUBLE_EQ(state.ease, 2.6);
  EXPECT_DOUBLE_EQ(state.interval_days, 15.6);
  when = state.due;
  state = afterwards(state, 3, when);
  EXPECT_NEAR(state.ease, 2.46, 1e-12);
  EXPECT_NEAR(state.interval_days, 15.6 * 2.46, 1e-4);
}

TEST(Repetition, IntervalsGrowOnSuccess) {
  for (int grade = 3; grade <= 5; ++grade) {
    RepetitionState state;
    sys_seconds when = kNow;
    double before = 0.0;
    for (int n = 0; n < 8; ++n) {
      state = afterwards(state, grade, when);
      EXPECT_GT(state.interval_days, before);
      EXPECT_EQ(state.due, when + seconds(std::llround(86400.0 * state.interval_days)));
      before = state.interval_days;
      when = state.due;
    }
    EXPECT_GE(state.ease, kLeastEase);
  }
}

TEST(Repetition, CrammingDoesNotMakeMonths) {
  RepetitionState state;
  for (int n = 0; n < 20; ++n) state = afterwards(state, 5, kNow + minutes(n));
  EXPECT_LE(state.interval_days, 1.0);
}

TEST(Repetition, AFailureComesBackWithinTheSession) {
  RepetitionState state;
  sys_seconds when = kNow;
  for (int n = 0; n < 4; ++n) {
    state = afterwards(state, 5, when);
    when = state.due;
  }
  const RepetitionState failed = afterwards(state, 1, when);
  EXPECT_EQ(failed.due, when + kBackAfter);
  EXPECT_EQ(failed.repetitions, 0);
  EXPECT_EQ(failed.lapses, 1);
  EXPECT_EQ(failed.level, state.level - 1);
  EXPECT_EQ(failed.ease, state.ease);
  std::vector<RepetitionState> states{failed};
  auto list = exercises(1);
  states.front().exerciseId = list.front().id;
  EXPECT_TRUE(nextExercise(states, list, failed.due, 1));
}

TEST(Repetition, LevelsRiseWithEaseAndStayWithinTheirRange) {
  RepetitionState state;
  for (int n = 0; n < 9; ++n) state = afterwards(state, 5, kNow + days(100 * n));
  EXPECT_EQ(state.level, kExerciseLevels);
  EXPECT_EQ(afterwards(state, 3, kNow + days(2000)).level, kExerciseLevels);
  for (int n = 0; n < 9; ++n) state = afterwards(state, 0, kNow + days(3000 + n));
  EXPECT_EQ(state.level, 1);
}

TEST(Repetition, TakesWhatFailedBeforeWhatIsMerelyDue) {
  const auto list = exercises(3);
  std::vector<RepetitionState> states;
  stateOf(states, list[0].id) = afterwards(stateOf(states, list[0].id), 5, kNow - days(3));
  stateOf(states, list[1].id) = afterwards(stateOf(states, list[1].id), 0, kNow - days(1));
  stateOf(states, list[2].id) = afterwards(stateOf(states, list[2].id), 5, kNow);
  stateOf(states, list[2].id).tries = 2;  // four in all
  ASSERT_TRUE(nextExercise(states, list, kNow, 1));
  EXPECT_EQ(nextExercise(states, list, kNow, 1)->exerciseId, list[1].id);
}

TEST(Repetition, NeverStarvesAnyExercise) {
  const auto list = exercises(30);
  std::vector<RepetitionState> states;
  std::map<std::string, int> times;
  sys_seconds now = kNow;
  for (int n = 0; n < 1200; ++n) {
    const auto planned = nextExercise(states, list, now, 7);
    ASSERT_TRUE(planned);
    ++times[planned->exerciseId];
    RepetitionState& state = stateOf(states, planned->exerciseId);
    // Half of them are failed for ever.
    const int number = std::stoi(planned->exerciseId.substr(std::string("case/plane/").size()));
    state = afterwards(state, number % 2 == 0 ? 0 : 5, now);
    now += n % 20 == 19 ? seconds(86400) : seconds(120);
  }
  EXPECT_EQ(times.size(), list.size());
  for (const auto& [id, count] : times) EXPECT_GE(count, 3) << id;
}

TEST(Repetition, IsTheSameForTheSameSeedWhateverTheOrderOfLists) {
  auto list = exercises(12);
  const auto first = nextExercise({}, list, kNow, 5);
  std::reverse(list.begin(), list.end());
  EXPECT_EQ(nextExercise({}, list, kNow, 5), first);
  std::map<std::string, int> firsts;
  for (std::uint64_t seed = 0; seed < 60; ++seed) ++firsts[nextExercise({}, list, kNow, seed)->exerciseId];
  EXPECT_GE(firsts.size(), 8U);
  EXPECT_FALSE(nextExercise({}, {}, kNow, 5));
}

TEST(Repetition, DoesNotAskTheSameTwiceInARowUnlessThereIsNoOther) {
  const auto list = exercises(2);
  std::vector<RepetitionState> states;
  sys_seconds now = kNow;
  std::string before;
  for (int n = 0; n < 40; ++n) {
    const auto planned = nextExercise(states, list, now, 1);
    ASSERT_TRUE(planned);
    EXPECT_NE(planned->exerciseId, before);
    before = planned->exerciseId;
    stateOf(states, before) = afterwards(stateOf(states, before), n % 6, now);
    now += seconds(60);
  }
  EXPECT_TRUE(nextExercise(states, exercises(1), now, 1));
}

TEST(Repetition, OfTwoTriesInOneSecondTheLaterWasLast) {
  for (const auto& [first, second] : {std::pair("case/plane/0", "case/plane/1"), std::pair("case/plane/1", "case/plane/0")}) {
    auto states = withTry({}, first, 1, kNow);
    states = withTry(std::move(states), second, 5, kNow);
    const auto planned = nextExercise(states, exercises(2), kNow, 1);
    ASSERT_TRUE(planned);
    EXPECT_EQ(planned->exerciseId, first);
    states = withTry(std::move(states), first, 5, kNow);
    EXPECT_EQ(nextExercise(states, exercises(2), kNow, 1)->exerciseId, second);
  }
}

TEST(Repetition, SurvivesItsFile) {
  std::vector<RepetitionState> states;
  for (int n = 0; n < 5; ++n) {
    RepetitionState& state = stateOf(states, "ä/plane/" + std::to_string(n));
    for (int t = 0; t <= n; ++t) state = afterwards(state, (n + 2 * t) % 6, kNow + days(3 * t));
  }
  const auto read = repetitionFromJson(nlohmann::json::parse(jsonOf(states).dump()));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, states);
}

TEST(Repetition, RefusesFilesThatItCannotUse) {
  auto document = jsonOf({RepetitionState{"a"}});
  document["format"] = kRepetitionFormat + 1;
  document["exercises"] = "of a later form";
  ASSERT_FALSE(repetitionFromJson(document));
  EXPECT_EQ(repetitionFromJson(document).error().code, ErrorCode::newerFormat);
  const auto refused = [](const char* field, const nlohmann::json& value) {
    auto changed = jsonOf({RepetitionState{"a"}});
    changed["exercises"][0][field] = value;
    const auto read = repetitionFromJson(changed);
    return !read && read.error().code == ErrorCode::badField;
  };
  EXPECT_FALSE(refused("level", 5));
  EXPECT_TRUE(refused("level", 6));
  EXPECT_TRUE(refused("ease", 1.0));
  EXPECT_TRUE(refused("ease", "much"));
  EXPECT_TRUE(refused("due_s", -1));
  EXPECT_TRUE(refused("id", ""));
  EXPECT_TRUE(!repetitionFromJson(jsonOf({RepetitionState{"a"}, RepetitionState{"a"}})));
  EXPECT_FALSE(repetitionFromJson(nlohmann::json::array()));
}

TEST(Grade, OfAJudgement) {
  const auto graded = [](double score, bool passed, int hints = 0) {
    StepResult judged;
    judged.score = score;
    judged.verdict = passed ? StepVerdict::passed : StepVerdict::failed;
    return gradeOf(judged, hints);
  };
  EXPECT_EQ(graded(1.0, true), 5);
  EXPECT_EQ(graded(0.85, true), 4);
  EXPECT_EQ(graded(0.7, true), 3);
  EXPECT_EQ(graded(1.0, true, 1), 4);
  EXPECT_EQ(graded(0.7, true, 9), 3) << "passed is passed";
  EXPECT_EQ(graded(0.5, false), 2);
  EXPECT_EQ(graded(0.0, false), 0);
}

}  // namespace
}  // namespace ew
