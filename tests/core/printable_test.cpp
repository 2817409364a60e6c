#include "ew/core/printable.h"

#include <gtest/gtest.h>

namespace ew::printable_test {
namespace {

const std::string kMark = "\xef\xbf\xbd";

TEST(Printable, LeavesWordsOfEveryLanguageAsTheyAre) {
  const std::string words =
      "Gallenstein, 12 mm\n\t\xc3\x9c"
      "bung \xe2\x80\x9e"
      "a\xe2\x80\x9c \xe8\x84\xbe \xf0\x9f\x98\x80";
  EXPECT_EQ(printable(words), words);
}

TEST(Printable, HoldsNothingThatCouldSteerATerminal) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a" + kMark + "[2Jb");
  EXPECT_EQ(printable("a\x1b]0;title\x07"), "a" + kMark + "]0;title" + kMark);
  EXPECT_EQ(printable("a\rb\b\x7f"), "a" + kMark + "b" + kMark + kMark);
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m\xc2\xa0"),
            kMark + "31m\xc2\xa0")
      << "the control of U+009B, and a space that is none";
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            kMark + "31m");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a" + kMark + "b");
  EXPECT_EQ(printable("a\r\nb"), "a\nb");
  for (int letter = 0; letter < 256; ++letter) {
    const std::string made = printable(std::string(1, static_cast<char>(letter)));
    const bool staysAsItIs = letter == '\n' || letter == '\t' || (letter >= 0x20 && letter < 0x7f);
    EXPECT_EQ(made, staysAsItIs ? std::string(1, static_cast<char>(letter)) : kMark) << letter;
  }
}

TEST(Printable, WhatIsNoUtf8IsMarkedByteByByte) {
  EXPECT_EQ(printable("\xc3"), kMark);
  EXPECT_EQ(printable("\xc0\xaf"), kMark + kMark) << "too long for what it says";
  EXPECT_EQ(printable("\xed\xa0\x80"), kMark + kMark + kMark) << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), kMark + kMark + kMark + kMark) << "beyond the last character";
  EXPECT_EQ(printable("\xe2\x82 x"), kMark + kMark + " x");
}

TEST(Printable, OneLineStaysOneLine) { EXPECT_EQ(printableLine("a\nb\tc\r\nd"), "a b c d"); }

TEST(Printable, KnowsWhereACharacterHasOnlyBegun) {
  EXPECT_EQ(unfinishedBytes("a"), 0u);
  EXPECT_EQ(unfinishedBytes("a\xc3"), 1u);
  EXPECT_EQ(unfinishedBytes("a\xf0\x9f\x98"), 3u);
  EXPECT_EQ(unfinishedBytes("a\xc3\x9c"), 0u);
  EXPECT_EQ(unfinishedBytes("\x80\x80\x80"), 0u);
  EXPECT_EQ(unfinishedBytes(""), 0u);
}

}  // namespace
}  // namespace ew::printable_test
