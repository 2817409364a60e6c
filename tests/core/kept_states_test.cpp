#include "ew/core/kept_states.h"

#include <gtest/gtest.h>

#include <string>

namespace ew::kept_states_test {
namespace {

TEST(KeptStates, GoBackAndOnAndForgetWhatWasTakenBackOnceSomethingNewIsDone) {
  KeptStates<std::string> states("a");
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

TEST(KeptStates, ADragIsOneStep) {
  KeptStates<int> states(0);
  states.step(1);
  for (int n = 2; n < 50; ++n) states.step(n, Change::goesOn);
  EXPECT_EQ(states.now(), 49);
  EXPECT_TRUE(states.undo());
  EXPECT_EQ(states.now(), 0);
  // With nothing that it could go on with, it is a step of its own.
  KeptStates<int> fresh(0);
  fresh.step(1, Change::goesOn);
  EXPECT_TRUE(fresh.undo());
  EXPECT_EQ(fresh.now(), 0);
}

TEST(KeptStates, KeepTheLatestThousand) {
  KeptStates<int> states(0);
  for (int n = 1; n <= 1500; ++n) states.step(n);
  int back = 0;
  while (states.undo()) ++back;
  EXPECT_EQ(back, static_cast<int>(KeptStates<int>::kMost) - 1);
  EXPECT_EQ(states.now(), 1500 - back);
}

}  // namespace
}  // namespace ew::kept_states_test
