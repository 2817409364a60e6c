#include "ew/controls/learn.h"

#include <gtest/gtest.h>

#include "ew/controls/midi_parser.h"

namespace ew::controls {
namespace {

const ControlId kKnob{"made", ControlKind::midiControl, 1, 20};

std::optional<Learned> learned(const ControlId& id, const std::vector<int>& values, Target::Kind wanted = Target::Kind::setting) {
  Learner learner(wanted);
  for (const int value : values) learner.take({id, value});
  return learner.found();
}

TEST(Learner, TellsAKnobFromThreeKindsOfEncoders) {
  EXPECT_EQ(learned(kKnob, {20, 21, 23, 24, 26, 27}), (Learned{kKnob, Encoding::absolute}));
  EXPECT_EQ(learned(kKnob, {60, 61, 62, 63, 64, 65, 66}), (Learned{kKnob, Encoding::absolute}));  // through the middle
  EXPECT_EQ(learned(kKnob, {0, 1, 2, 3, 4, 5}), (Learned{kKnob, Encoding::absolute}));
  EXPECT_EQ(learned(kKnob, {127, 126, 124, 123, 121, 120}), (Learned{kKnob, Encoding::absolute}));
  EXPECT_EQ(learned(kKnob, {1, 1, 1, 127, 127, 127}), (Learned{kKnob, Encoding::twosComplement}));
  EXPECT_EQ(learned(kKnob, {65, 65, 66, 63, 63, 63}), (Learned{kKnob, Encoding::offset64}));
  EXPECT_EQ(learned(kKnob, {1, 1, 2, 65, 65, 65}), (Learned{kKnob, Encoding::signBit}));
}

TEST(Learner, AsksToTurnBackWhenStepsMayMeanTwoThings) {
  for (const int step : {1, 65}) {
    Learner learner(Target::Kind::setting);
    for (int n = 0; n < 12; ++n) learner.take({kKnob, step});
    EXPECT_FALSE(learner.found());
    EXPECT_EQ(learner.needs(), Learner::Needs::turnBack);
  }
  EXPECT_EQ(learned(kKnob, {1, 1, 1, 1, 1, 1, 1, 1, 127}), (Learned{kKnob, Encoding::twosComplement}));
  EXPECT_EQ(learned(kKnob, {65, 65, 65, 65, 65, 65, 65, 63}), (Learned{kKnob, Encoding::offset64}));
  EXPECT_EQ(learned(kKnob, {65, 65, 65, 65, 65, 65, 65, 1}), (Learned{kKnob, Encoding::signBit}));
}

TEST(Learner, TakesThePairOfAFineFader) {
  Learner learner(Target::Kind::setting);
  MidiParser parser("made");
  for (int value = 3000; value < 9000 && !learner.found(); value += 90) {
    std::vector<ControlEvent> events;
    parser.take(std::vector<std::uint8_t>{0xB0, 20, static_cast<std::uint8_t>(value >> 7), 52, static_cast<std::uint8_t>(value & 127)},
                events);
    for (const ControlEvent& event : events) learner.take(event);
  }
  EXPECT_EQ(learner.found(), (Learned{{"made", ControlKind::midiControl14, 1, 20}, Encoding::absolute}));
}

TEST(Learner, FindsAxisAndWheelAmongTheBytesOfAReport) {
  const ControlId axis{"pad", ControlKind::hidByte, 0, 1}, fine{"pad", ControlKind::hidByte, 0, 0};
  Learner learner(Target::Kind::setting);
  for (int value = 0x8000; value < 0xFFFF && !learner.found(); value += 777) {
    learner.take({fine, value & 255});
    learner.take({axis, value >> 8});
  }
  EXPECT_EQ(learner.found(), (Learned{axis, Encoding::absolute}));
  Learner stick(Target::Kind::setting);  // both of its axes move
  for (int step = 0; step < 200 && !stick.found(); ++step) {
    const int at = 5 * step % 500;
    stick.take({axis, at < 250 ? at : 500 - at});
    stick.take({fine, 120 + step % 3});
  }
  EXPECT_EQ(stick.found(), (Learned{axis, Encoding::absolute}));
  EXPECT_EQ(learned(axis, {250, 251, 252, 253, 254, 255, 0, 1}), (Learned{axis, Encoding::counter}));
  EXPECT_EQ(learned(axis, {10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20}), (Learned{axis, Encoding::counter}));
  EXPECT_EQ(learned(axis, {1, 0, 4, 0, 1, 0, 128, 0}), std::nullopt);  // buttons
}

TEST(Learner, TakesPressesForActionsAndNotForSettings) {
  const ControlId pad{"made", ControlKind::midiNote, 10, 36}, bit{"pad", ControlKind::hidBit, 0, 12};
  EXPECT_EQ(learned(pad, {100}, Target::Kind::action), (Learned{pad, Encoding::button}));
  EXPECT_EQ(learned(bit, {0, 1}, Target::Kind::action), (Learned{bit, Encoding::button}));
  EXPECT_EQ(learned(kKnob, {127}, Target::Kind::action), (Learned{kKnob, Encoding::button}));
  EXPECT_EQ(learned(kKnob, {0, 127}, Target::Kind::action), (Learned{kKnob, Encoding::button}));
  EXPECT_EQ(learned(kKnob, {60, 61, 62, 63, 64, 65, 66, 67}, Target::Kind::action), std::nullopt);  // a knob
  Learner learner(Target::Kind::setting);
  learner.take({pad, 100});
  learner.take({pad, 0});
  EXPECT_FALSE(learner.found());
  EXPECT_EQ(learner.needs(), Learner::Needs::knobInsteadOfButton);
}

}  // namespace
}  // namespace ew::controls
