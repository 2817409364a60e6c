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

}  // namespace
}  // namespace ew::figures_test
