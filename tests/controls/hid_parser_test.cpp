#include "ew/controls/hid_parser.h"

#include <gtest/gtest.h>

namespace ew::controls {
namespace {

TEST(HidParser, TellsTheBytesAndBitsThatChanged) {
  HidParser parser("pad", 0x1234, false);
  std::vector<ControlEvent> events;
  parser.take(std::vector<std::uint8_t>{10, 0x01}, events);
  EXPECT_TRUE(events.empty());  // how it stands; nobody moved anything
  parser.take(std::vector<std::uint8_t>{10, 0x01}, events);
  EXPECT_TRUE(events.empty());
  parser.take(std::vector<std::uint8_t>{10, 0x80}, events);
  EXPECT_EQ(events, (std::vector<ControlEvent>{{{"pad", ControlKind::hidByte, 0, 1}, 0x80},
                                               {{"pad", ControlKind::hidBit, 0, 8}, 0},
                                               {{"pad", ControlKind::hidBit, 0, 15}, 1}}));
}

TEST(HidParser, KeepsReportsOfDifferentNumbersApart) {
  HidParser parser("pad", 0x1234, true);
  std::vector<ControlEvent> events;
  for (const std::vector<std::uint8_t>& report : std::vector<std::vector<std::uint8_t>>{{1, 5}, {2, 9}, {1, 5}, {2, 8}})
    parser.take(report, events);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0], (ControlEvent{{"pad", ControlKind::hidByte, 2, 0}, 8}));
  EXPECT_EQ(events[1], (ControlEvent{{"pad", ControlKind::hidBit, 2, 0}, 0}));
}

TEST(HidParser, SpreadsTheRingOfAJogDialOverTheWholeRange) {
  HidParser parser("ShuttleXpress", 0x0b33, false);
  std::vector<ControlEvent> events;
  const std::vector<int> ring = {0, -7, 7, 1};
  for (const int at : ring) parser.take(std::vector<std::uint8_t>{static_cast<std::uint8_t>(at), 0, 0, 0, 0}, events);
  std::erase_if(events, [](const ControlEvent& each) { return each.id.kind != ControlKind::hidByte; });
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].value, 0);
  EXPECT_EQ(events[1].value, 255);
  EXPECT_EQ(events[2].value, 145);
}

TEST(HidParser, FindsNumbersOfReportsInADescriptor) {
  // A mouse of three buttons without numbers, and the same with "Report ID (1)"; the byte 0x85 as data is none.
  const std::vector<std::uint8_t> plain = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x26, 0x85, 0x85, 0xC0};
  const std::vector<std::uint8_t> numbered = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x85, 0x01, 0xC0};
  EXPECT_FALSE(numbersReports(plain));
  EXPECT_TRUE(numbersReports(numbered));
  EXPECT_FALSE(numbersReports(std::vector<std::uint8_t>{0xFE, 0x02, 0x00, 0x85, 0x85}));  // within a long item
  EXPECT_FALSE(numbersReports(std::vector<std::uint8_t>{0xFE}));
  EXPECT_FALSE(numbersReports({}));
}

}  // namespace
}  // namespace ew::controls
