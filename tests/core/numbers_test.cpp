#include "ew/core/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace ew::numbers_test {
namespace {

TEST(Numbers, AreReadAsFilesWriteThem) {
  EXPECT_DOUBLE_EQ(parseNumber("8.4e-005").value(), 8.4e-5);
  EXPECT_DOUBLE_EQ(parseNumber(" +3 ").value(), 3.0);
  EXPECT_EQ(parseNumbers("600                        400\t\n1").value(), (std::vector<double>{600, 400, 1}));
  EXPECT_EQ(parseIntegers("820 616 21     ").value(), (std::vector<long long>{820, 616, 21}));
}

TEST(Numbers, RefuseWhatIsNotANumber) {
  EXPECT_FALSE(parseNumber(""));
  EXPECT_FALSE(parseNumber("1 2"));
  EXPECT_FALSE(parseNumber("1,5"));
  EXPECT_FALSE(parseNumbers("1 2 x"));
  EXPECT_FALSE(parseIntegers("99999999999999999999"));
  EXPECT_FALSE(parseIntegers("1.5"));
}

TEST(Numbers, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "C.UTF-8"}) std::setlocale(LC_ALL, name);
  EXPECT_DOUBLE_EQ(parseNumber("1.5").value(), 1.5);
  EXPECT_EQ(textOf(1.5), "1.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Numbers, OfFloatsAreTheDecimalsTheyWereWrittenFor) {
  EXPECT_EQ(decimalOf(0.0005F), 0.0005);
  EXPECT_EQ(decimalOf(-0.3F), -0.3);
  EXPECT_EQ(decimalOf(16777216.0F), 16777216.0);
  EXPECT_EQ(decimalOf(0.0F), 0.0);
  EXPECT_TRUE(std::isnan(decimalOf(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_EQ(decimalOf(-std::numeric_limits<float>::infinity()), -std::numeric_limits<double>::infinity());
}

RC_GTEST_PROP(Numbers, OfFloatsReadBackAsTheSameFloat, (float value)) { RC_ASSERT(static_cast<float>(decimalOf(value)) == value); }

RC_GTEST_PROP(Numbers, SurviveTheRoundTripThroughText, (double value)) {
  RC_PRE(std::isfinite(value));
  RC_ASSERT(parseNumber(textOf(value)).value() == value);
}

}  // namespace
}  // namespace ew::numbers_test
