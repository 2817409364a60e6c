#include "ew/scanning/breathing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ew::breathing_test {
namespace {

BodyRhythms rhythmsOf(bool hasPulse) {
  BodyRhythms rhythms;
  rhythms.breathing = BodyRhythms::Breathing{{4.0, 0.0}, 0.3, 0.4};
  if (hasPulse) rhythms.pulse = BodyRhythm{0.9, 0.0};
  return rhythms;
}

TEST(BreathControl, GoesOnAsItWillWhenNobodyAsks) {
  const BodyRhythms rhythms = rhythmsOf(true);
  const BreathControl breathing;
  for (double time_s = 0.0; time_s < 9.0; time_s += 0.13) EXPECT_EQ(breathing.at(rhythms, time_s), bodyAt(rhythms, time_s));
  EXPECT_TRUE(breathing.movesAfter(rhythms, 3.0));
}

TEST(BreathControl, IsHeldWhereItWasAskedToBeAndTheHeartGoesOn) {
  const BodyRhythms rhythms = rhythmsOf(true);
  BreathControl breathing;
  breathing.ask(BreathingRequest::breatheInAndHold, rhythms, 10.0);
  for (const double time_s : {11.5, 14.0, 60.0}) {
    EXPECT_EQ(breathing.at(rhythms, time_s).breath, 1.0) << time_s;
    EXPECT_EQ(breathing.at(rhythms, time_s).pulse, bodyAt(rhythms, time_s).pulse) << time_s;
  }
  breathing.ask(BreathingRequest::breatheOutAndHold, rhythms, 60.0);
  EXPECT_EQ(breathing.at(rhythms, 60.0).breath, 1.0);
  EXPECT_EQ(breathing.at(rhythms, 61.5).breath, 0.0);
  breathing.ask(BreathingRequest::free, rhythms, 70.0);
  EXPECT_EQ(breathing.at(rhythms, 71.6), bodyAt(rhythms, 71.6));
}

TEST(BreathControl, NeverJumpsHoweverOftenItIsAsked) {
  const BodyRhythms rhythms = rhythmsOf(false);
  BreathControl breathing;
  constexpr double kStep_s = 0.01;
  double before = breathing.at(rhythms, 0.0).breath;
  for (int n = 1; n < 2000; ++n) {
    const double time_s = n * kStep_s;
    if (n % 170 == 60) breathing.ask(BreathingRequest::breatheInAndHold, rhythms, time_s);
    if (n % 170 == 100) breathing.ask(BreathingRequest::breatheOutAndHold, rhythms, time_s);
    if (n % 170 == 120) breathing.ask(BreathingRequest::free, rhythms, time_s);
    const double breath = breathing.at(rhythms, time_s).breath;
    // Full breath within 1.5 s as a smooth step, and a quiet one on top.
    EXPECT_LE(std::abs(breath - before), kStep_s * (1.5 / 1.5 + 0.4 * 1.3)) << time_s;
    EXPECT_TRUE(breath >= 0.0 && breath <= 1.0) << time_s;
    before = breath;
  }
}

TEST(BreathControl, StandsOnceHeldUnlessSomethingElseMoves) {
  BreathControl breathing;
  breathing.ask(BreathingRequest::breatheOutAndHold, rhythmsOf(false), 5.0);
  EXPECT_TRUE(breathing.movesAfter(rhythmsOf(false), 6.0));
  EXPECT_FALSE(breathing.movesAfter(rhythmsOf(false), 6.6));
  EXPECT_TRUE(breathing.movesAfter(rhythmsOf(true), 6.6));
  EXPECT_FALSE(breathing.movesAfter({}, 0.0));
}

}  // namespace
}  // namespace ew::breathing_test
