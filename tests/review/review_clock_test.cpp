#include "logic/review_clock.h"

#include <gtest/gtest.h>

#include <array>

namespace ew::review {
namespace {

ReviewClock clockOf(double last_s) {
  ReviewClock clock;
  clock.setRange(0.0, last_s);
  return clock;
}

TEST(ReviewClock, GoesOnAtItsSpeedWhileItPlays) {
  ReviewClock clock = clockOf(10.0);
  clock.advance(1.0);
  EXPECT_EQ(clock.at_s(), 0.0) << "it rests";
  clock.play();
  clock.advance(1.0);
  EXPECT_EQ(clock.at_s(), 1.0);
  clock.setSpeed(4.0);
  clock.advance(0.5);
  EXPECT_EQ(clock.at_s(), 3.0);
  clock.setSpeed(0.25);
  clock.advance(4.0);
  EXPECT_EQ(clock.at_s(), 4.0);
  clock.pause();
  clock.advance(4.0);
  EXPECT_EQ(clock.at_s(), 4.0);
}

TEST(ReviewClock, KeepsItsSpeedWithinItsLimits) {
  ReviewClock clock = clockOf(1.0);
  clock.setSpeed(100.0);
  EXPECT_EQ(clock.speed(), kFastest);
  clock.setSpeed(0.0);
  EXPECT_EQ(clock.speed(), kSlowest);
}

TEST(ReviewClock, RestsAtItsEndAndPlaysFromTheBeginningAgain) {
  ReviewClock clock = clockOf(2.0);
  clock.play();
  clock.advance(5.0);
  EXPECT_EQ(clock.at_s(), 2.0);
  EXPECT_FALSE(clock.isPlaying());
  clock.play();
  EXPECT_EQ(clock.at_s(), 0.0);
  clock.setAtEnd(AtEnd::beginAnew);
  clock.advance(5.0);
  EXPECT_DOUBLE_EQ(clock.at_s(), 1.0) << "twice round, and half";
  EXPECT_TRUE(clock.isPlaying());
}

TEST(ReviewClock, RunsRoundALoop) {
  ReviewClock clock = clockOf(10.0);
  clock.setLoop(4.0, 6.0);
  clock.seek(5.0);
  clock.play();
  clock.advance(0.5);
  EXPECT_DOUBLE_EQ(clock.at_s(), 5.5);
  clock.advance(1.0);
  EXPECT_DOUBLE_EQ(clock.at_s(), 4.5);
  clock.seek(8.0);
  clock.advance(1.0);
  EXPECT_DOUBLE_EQ(clock.at_s(), 9.0) << "behind the loop it goes on";
}

TEST(ReviewClock, MarksALoopWhereItStands) {
  ReviewClock clock = clockOf(10.0);
  clock.seek(3.0);
  clock.markBegin();
  EXPECT_FALSE(clock.isLooping());
  clock.seek(7.0);
  clock.markEnd();
  ASSERT_TRUE(clock.isLooping());
  EXPECT_EQ(clock.loopBegin_s(), 3.0);
  EXPECT_EQ(clock.loopEnd_s(), 7.0);
  clock.markEnd();
  EXPECT_FALSE(clock.loopEnd_s()) << "the same place again";
  clock.seek(1.0);
  clock.markEnd();
  EXPECT_FALSE(clock.loopBegin_s()) << "an end before the beginning";
  EXPECT_EQ(clock.loopEnd_s(), 1.0);
  clock.setRange(2.0, 5.0);
  EXPECT_FALSE(clock.loopEnd_s()) << "outside of what there is";
}

TEST(ReviewClock, JumpsToTheNearestEventOnEitherSide) {
  ReviewClock clock = clockOf(10.0);
  const std::array<double, 5> events{7.0, 2.0, 5.0, 12.0, -1.0};
  EXPECT_TRUE(clock.jump(events, true));
  EXPECT_EQ(clock.at_s(), 2.0);
  EXPECT_TRUE(clock.jump(events, true));
  EXPECT_EQ(clock.at_s(), 5.0);
  EXPECT_TRUE(clock.jump(events, true));
  EXPECT_FALSE(clock.jump(events, true)) << "12 s is not there";
  EXPECT_EQ(clock.at_s(), 7.0);
  EXPECT_TRUE(clock.jump(events, false));
  EXPECT_EQ(clock.at_s(), 5.0);
}

TEST(ReviewClock, StaysWithinWhatThereIs) {
  ReviewClock clock = clockOf(10.0);
  clock.seek(-5.0);
  EXPECT_EQ(clock.at_s(), 0.0);
  clock.seek(50.0);
  EXPECT_EQ(clock.at_s(), 10.0);
  clock.setRange(-2.0, 4.0);
  EXPECT_EQ(clock.at_s(), 4.0);
}

}  // namespace
}  // namespace ew::review
