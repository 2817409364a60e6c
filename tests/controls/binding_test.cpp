#include "ew/controls/binding.h"

#include <gtest/gtest.h>

namespace ew::controls {
namespace {

Binding bound(Encoding encoding, ControlKind kind = ControlKind::midiControl, bool reversed = false) {
  return {{"made", kind, 1, 20}, encoding, {encoding == Encoding::button ? Target::Kind::action : Target::Kind::setting, "gain"}, reversed};
}
Motion to(double value) { return {Motion::Kind::to, value}; }
Motion by(double steps) { return {Motion::Kind::by, steps}; }

TEST(Follower, TakesOverOnceTheKnobPassesTheSetting) {
  Follower follower;
  const Binding knob = bound(Encoding::absolute);
  const double setting = 0.5;
  EXPECT_EQ(follower.take(knob, 0, setting).kind, Motion::Kind::wait);
  EXPECT_EQ(follower.take(knob, 30, setting).kind, Motion::Kind::wait);
  EXPECT_EQ(follower.take(knob, 80, setting), to(80.0 / 127.0));  // fast past it
  follower.settle(80.0 / 127.0);
  EXPECT_EQ(follower.take(knob, 127, 80.0 / 127.0), to(1.0));
}

TEST(Follower, LetsGoWhenSomebodyElseMovesTheSetting) {
  Follower follower;
  const Binding knob = bound(Encoding::absolute);
  EXPECT_EQ(follower.take(knob, 64, 0.5), to(64.0 / 127.0));
  follower.settle(0.5);  // the setting rounds
  EXPECT_EQ(follower.take(knob, 70, 0.5), to(70.0 / 127.0));
  follower.settle(70.0 / 127.0);
  EXPECT_EQ(follower.take(knob, 71, 0.9), (Motion{Motion::Kind::wait, 71.0 / 127.0}));
  EXPECT_EQ(follower.take(knob, 113, 0.9).kind, Motion::Kind::to);  // near enough: 0.8898
}

TEST(Follower, ReadsTheStepsOfEncoders) {
  const auto steps = [](Encoding encoding, int value, bool reversed = false) {
    return Follower().take(bound(encoding, ControlKind::midiControl, reversed), value, 0.2);
  };
  EXPECT_EQ(steps(Encoding::twosComplement, 1), by(1));
  EXPECT_EQ(steps(Encoding::twosComplement, 127), by(-1));
  EXPECT_EQ(steps(Encoding::twosComplement, 64), by(-64));
  EXPECT_EQ(steps(Encoding::offset64, 65), by(1));
  EXPECT_EQ(steps(Encoding::offset64, 61), by(-3));
  EXPECT_EQ(steps(Encoding::offset64, 64), Motion{});
  EXPECT_EQ(steps(Encoding::signBit, 2), by(2));
  EXPECT_EQ(steps(Encoding::signBit, 66), by(-2));
  EXPECT_EQ(steps(Encoding::signBit, 66, true), by(2));
}

TEST(Follower, CountsAroundTheWheel) {
  Follower follower;
  const Binding wheel = bound(Encoding::counter, ControlKind::hidByte);
  EXPECT_EQ(follower.take(wheel, 254, 0.5), Motion{});  // where it stands
  EXPECT_EQ(follower.take(wheel, 1, 0.5), by(3));
  EXPECT_EQ(follower.take(wheel, 255, 0.5), by(-2));
}

TEST(Follower, PressesOnceUntilTheButtonIsLetGo) {
  Follower follower;
  const Binding pad = bound(Encoding::button, ControlKind::midiNote);
  EXPECT_EQ(follower.take(pad, 5, {}).kind, Motion::Kind::press);  // softly, yet pressed
  EXPECT_EQ(follower.take(pad, 90, {}).kind, Motion::Kind::none);
  EXPECT_EQ(follower.take(pad, 0, {}).kind, Motion::Kind::none);
  EXPECT_EQ(follower.take(pad, 90, {}).kind, Motion::Kind::press);
}

TEST(Follower, MovesWhatHasNoRangeByAsMuchAsItWasTurned) {
  Follower follower;
  const Binding knob = bound(Encoding::absolute, ControlKind::hidByte);
  EXPECT_EQ(follower.take(knob, 0, {}), Motion{});
  EXPECT_EQ(follower.take(knob, 51, {}), by(0.2 * Follower::kStepsOfRange));
  EXPECT_EQ(follower.take(knob, 0, {}), by(-0.2 * Follower::kStepsOfRange));
}

TEST(Encoding, FitsOnlyControlsThatCanSendIt) {
  EXPECT_TRUE(fits(Encoding::twosComplement, ControlKind::midiControl));
  EXPECT_FALSE(fits(Encoding::twosComplement, ControlKind::midiControl14));
  EXPECT_FALSE(fits(Encoding::absolute, ControlKind::hidBit));
  EXPECT_FALSE(fits(Encoding::counter, ControlKind::midiControl));
  EXPECT_TRUE(fits(Encoding::button, ControlKind::midiNote));
}

}  // namespace
}  // namespace ew::controls
