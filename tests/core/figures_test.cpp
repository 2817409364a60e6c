#include "ew/core/figures.h"

#include <gtest/gtest.h>

#include <limits>

namespace ew::figures_test {
namespace {

TEST(FigureText, HasTheDigitsThatSomebodyReads) {
  EXPECT_EQ(figureText(0.3999999943166175), "0.4");
  EXPECT_EQ(figureText(0.40000000947984643), "0.4");
  EXPECT_EQ(figureText(0.061599999666213996), "0.0616");
  EXPECT_EQ(figureText(0.5104970559477806), "0.5105");
  EXPECT_EQ(figureText(1234567.0), "1235000");
  EXPECT_EQ(figureText(1234567.0, 7), "1234567");
  EXPECT_EQ(figureText(-5065.0), "-5065");
  EXPECT_EQ(figureText(9.99996), "10");
  EXPECT_EQ(figureText(0.0), "0");
  EXPECT_EQ(figureText(-0.0), "0");
  EXPECT_EQ(figureText(0.00012345, 2), "0.00012");
  EXPECT_EQ(figureText(3e-7), "3e-07");
  EXPECT_EQ(figureText(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(figureText(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(FixedText, HasItsDecimalsAndNoMinusBeforeZeros) {
  EXPECT_EQ(fixedText(2.0, 2), "2.00");
  EXPECT_EQ(fixedText(-2.345, 1), "-2.3");
  EXPECT_EQ(fixedText(0.125, 2), "0.12") << "half to even, as printf has it";
  EXPECT_EQ(fixedText(99.5, 0), "100");
  EXPECT_EQ(fixedText(-0.04, 1), "0.0");
  EXPECT_EQ(fixedText(1e300, 0).size(), 301u);
  EXPECT_EQ(fixedText(-std::numeric_limits<double>::infinity(), 1), "-inf");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::quiet_NaN(), 1), "nan");
  EXPECT_EQ(fixedNumeral(2.25, 1).english(), "2.2");
}

TEST(RoundedText, HasNoZerosBehind) {
  EXPECT_EQ(roundedText(2.04, 1), "2");
  EXPECT_EQ(roundedText(2.05, 1), "2.1");
  EXPECT_EQ(roundedText(-1234.5, 0), "-1235");
}

TEST(MemoryText, IsRoundedUpForLimitsAndShortForPeople) {
  EXPECT_EQ(mebibytesText(1.0), "1 MiB");
  EXPECT_EQ(mebibytesText(512.0 * 1048576.0), "512 MiB");
  EXPECT_EQ(mebibytesText(512.0 * 1048576.0 + 1.0), "513 MiB");
  EXPECT_EQ(memoryFigure(3.5 * 1048576.0).decimals, 1);
  EXPECT_EQ(memoryFigure(10.0 * 1048576.0).decimals, 0);
  EXPECT_FALSE(memoryFigure(1023.0 * 1048576.0).isGibibytes);
  EXPECT_TRUE(memoryFigure(1536.0 * 1048576.0).isGibibytes);
  EXPECT_EQ(memoryFigure(1536.0 * 1048576.0).value, 1.5);
}

TEST(MinutesText, HasMinutesSecondsAndTenths) {
  EXPECT_EQ(minutesText(0.0), "0:00.0");
  EXPECT_EQ(minutesText(65.34), "1:05.3");
  EXPECT_EQ(minutesText(59.96), "1:00.0");
  EXPECT_EQ(minutesText(3601.0), "60:01.0");
  EXPECT_EQ(minutesText(-2.0), "-0:02.0");
  EXPECT_EQ(minutesText(-0.04), "0:00.0");
}

}  // namespace
}  // namespace ew::figures_test
