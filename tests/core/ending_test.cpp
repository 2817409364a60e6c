#include "ew/core/ending.h"

#include <gtest/gtest.h>

namespace ew::ending_test {
namespace {

TEST(Ending, IsTheSameWhateverTheSizeOfItsLetters) {
  for (const char* name : {"sheet.csv", "Sheet.CSV", "folder.png/a.b.Csv"}) {
    EXPECT_TRUE(hasEnding(name, ".csv")) << name;
    EXPECT_EQ(endingOf(name), ".csv") << name;
  }
  for (const char* name : {"csv", "sheet.csv.png", "sheet_csv", "folder.csv/sheet", ""}) EXPECT_FALSE(hasEnding(name, ".csv")) << name;
  EXPECT_TRUE(hasEnding("v.NII.gz", ".nii.gz"));
  EXPECT_EQ(endingOf("v.NII.Gz"), ".gz");
  EXPECT_EQ(endingOf("folder.csv/sheet"), "");
  EXPECT_EQ(endingOf("\xc3\x84.\xc3\x96"), ".\xc3\x96") << "letters beyond ASCII stay";
}

}  // namespace
}  // namespace ew::ending_test
