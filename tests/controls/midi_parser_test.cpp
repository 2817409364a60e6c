#include "ew/controls/midi_parser.h"

#include <gtest/gtest.h>

namespace ew::controls {
namespace {

std::vector<ControlEvent> parsed(const std::vector<std::uint8_t>& bytes) {
  MidiParser parser("made");
  std::vector<ControlEvent> events;
  parser.take(bytes, events);
  return events;
}

ControlEvent made(ControlKind kind, int channel, int number, int value) { return {{"made", kind, channel, number}, value}; }

TEST(MidiParser, ReadsControlChangesNotesAndBend) {
  EXPECT_EQ(parsed({0xB0, 7, 100, 0x93, 60, 127, 0x83, 60, 64, 0xEF, 0x01, 0x40}),
            (std::vector{made(ControlKind::midiControl, 1, 7, 100), made(ControlKind::midiNote, 4, 60, 127),
                         made(ControlKind::midiNote, 4, 60, 0), made(ControlKind::midiBend, 16, 0, 8193)}));
}

TEST(MidiParser, KeepsTheRunningStatusAcrossClockAndPieces) {
  MidiParser parser("made");
  std::vector<ControlEvent> events;
  for (const std::vector<std::uint8_t>& piece : std::vector<std::vector<std::uint8_t>>{{0xB2, 70}, {0xF8, 1, 70}, {0xFE}, {2, 71, 0xF8, 3}})
    parser.take(piece, events);
  EXPECT_EQ(events, (std::vector{made(ControlKind::midiControl, 3, 70, 1), made(ControlKind::midiControl, 3, 70, 2),
                                 made(ControlKind::midiControl, 3, 71, 3)}));
}

TEST(MidiParser, PassesOverWhatItDoesNotRead) {
  // Data without a status, system exclusive (which ends running status), program change, pressure, a mode message.
  EXPECT_TRUE(parsed({5, 6, 7}).empty());
  EXPECT_TRUE(parsed({0xB0, 0xF0, 1, 2, 3, 0xF7, 7, 100}).empty());
  EXPECT_TRUE(parsed({0xC0, 5, 6, 0xD1, 7, 8, 0xA0, 1, 2, 0xB0, 123, 0}).empty());
  EXPECT_EQ(parsed({0xB0, 7, 0x90, 61, 1}), (std::vector{made(ControlKind::midiNote, 1, 61, 1)}));  // a status ends what was not whole
}

TEST(MidiParser, JoinsThePairsOfFourteenBits) {
  EXPECT_EQ(parsed({0xB0, 1, 64, 33, 5, 33, 6}),
            (std::vector{made(ControlKind::midiControl, 1, 1, 64), made(ControlKind::midiControl, 1, 33, 5),
                         made(ControlKind::midiControl14, 1, 1, 64 * 128 + 5), made(ControlKind::midiControl, 1, 33, 6),
                         made(ControlKind::midiControl14, 1, 1, 64 * 128 + 6)}));
  EXPECT_EQ(parsed({0xB0, 1, 64, 0xB1, 33, 5}).size(), 2U);  // of another channel: no pair
}

TEST(MidiParser, ReadsNonRegisteredParameters) {
  EXPECT_EQ(parsed({0xB0, 99, 2, 98, 3, 6, 10, 38, 20}), (std::vector{made(ControlKind::midiParameter, 1, 2 * 128 + 3, 10 * 128),
                                                                      made(ControlKind::midiParameter, 1, 2 * 128 + 3, 10 * 128 + 20)}));
  // No parameter chosen, or a registered one: 6 is a control like any other.
  for (const std::vector<std::uint8_t>& bytes :
       std::vector<std::vector<std::uint8_t>>{{0xB0, 6, 10}, {0xB0, 99, 127, 98, 127, 6, 10}, {0xB0, 99, 1, 98, 1, 101, 0, 100, 0, 6, 10}})
    EXPECT_EQ(parsed(bytes), (std::vector{made(ControlKind::midiControl, 1, 6, 10)}));
}

}  // namespace
}  // namespace ew::controls
