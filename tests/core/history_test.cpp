#include "ew/core/history.h"

#include <gtest/gtest.h>

#include <string>

namespace ew::history_test {
namespace {

TEST(History, GoBackAndOnAndForgetWhatWasTakenBackOnceSomethingNewIsDone) {
  History<std::string> states("a");
  EXPECT_FALSE(states.undo());
  states.step("b");
  states.step("c");
  const auto kept = states.kept();
  EXPECT_TRUE(states.undo());
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), "a");
  EXPECT_FALSE(states.undo());
  EXPECT_TRUE(states.redo());
  EXPECT_EQ(states.now(), "b");
  states.step("d");
  EXPECT_FALSE(states.canRedo());
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), "b");
  EXPECT_EQ(*kept, "c") << "what somebody keeps stays as it is";
}

TEST(History, ADragIsOneStep) {
  History<int> states(0);
  states.step(1);
  for (int n = 2; n < 50; ++n) states.step(n, Change::goesOn);
  EXPECT_EQ(states.now(), 49);
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), 0);
  // With nothing that it could go on with, it is a step of its own.
  History<int> fresh(0);
  fresh.step(1, Change::goesOn);
  EXPECT_TRUE(fresh.undo());
  EXPECT_EQ(fresh.now(), 0);
}

TEST(History, KeepTheLatestThousand) {
  History<int> states(0);
  for (int n = 1; n <= 1500; ++n) states.step(n);
  int back = 0;
  while (states.undo()) ++back;
  EXPECT_EQ(back, static_cast<int>(History<int>::kMost) - 1);
  EXPECT_EQ(states.now(), 1500 - back);
}

TEST(History, ForgetsTheOldestWhenTheyCostTooMuch) {
  const auto costOf = [](int value) { return static_cast<std::size_t>(value); };
  History<int> states(1000, 4);  // what is before the first step costs nothing
  for (const int value : {10, 20, 30}) states.step(value, "add", {});
  EXPECT_EQ(states.cost(costOf), 60u);
  states.forgetBeyond(55, costOf);
  EXPECT_EQ(states.cost(costOf), 50u);
  EXPECT_EQ(states.steps(), 3u);
  EXPECT_EQ(states.forgotten(), 1u);
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.steps(), 2u);
  EXPECT_EQ(states.cost(costOf), 50u) << "what was taken back counts";
  states.forgetBeyond(0, costOf);
  EXPECT_EQ(states.undoName(), "add") << "the latest step stays";
  EXPECT_TRUE(states.redo());
  for (const int value : {1, 2, 3}) states.step(value);
  EXPECT_EQ(states.steps(), 6u);
  EXPECT_EQ(states.forgotten(), 3u) << "no more than four states";
}

TEST(History, NamesItsStepsAndMergesThoseOfOneKey) {
  History<int> states(0);
  EXPECT_EQ(states.undoName(), "");
  states.step(1, "move", "drag");
  states.step(2, "move farther", "drag");
  EXPECT_EQ(states.undoName(), "move farther");
  ASSERT_NE(states.beforeMerging("drag"), nullptr);
  EXPECT_EQ(*states.beforeMerging("drag"), 0);
  EXPECT_EQ(states.beforeMerging("other"), nullptr);
  states.endMerging();
  states.step(3, "move", "drag");
  states.step(4, "name", {});
  states.step(5, "name", {});
  EXPECT_TRUE(states.undo() && states.undo());
  EXPECT_EQ(states.now(), 3) << "without a key every step is one of its own";
  EXPECT_EQ(states.redoName(), "name");
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), 2);
  states.step(6, "move", "drag");
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), 2) << "after undo nothing is merged";
  EXPECT_TRUE(states.wasEver([](int value) { return value == 6; })) << "also what was taken back";
  EXPECT_FALSE(states.wasEver([](int value) { return value == 5; }));
}

TEST(History, ForgetsAStepThatWasGivenBack) {
  History<int> states(0);
  states.step(1, "name", {});
  const auto before = states.kept();
  states.step(2, "move", "drag");
  states.step(1, "move", "drag");
  ASSERT_EQ(*states.beforeMerging("drag"), states.now());
  states.forgetStep();
  EXPECT_EQ(states.kept(), before) << "the state itself, not one that is equal";
  EXPECT_EQ(states.undoName(), "name");
  EXPECT_FALSE(states.canRedo());
  EXPECT_EQ(states.beforeMerging("drag"), nullptr);
}

}  // namespace
}  // namespace ew::history_test
