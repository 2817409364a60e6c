#include "ew/core/chart_axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ew::chart_axis_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Values = std::vector<double>;

Values ticksOf(const ChartAxis& axis) {
  Values values;
  for (const ChartTick& tick : axis.ticks) values.push_back(tick.value);
  return values;
}

ChartAxis linear(const Values& values, const LinearAxisOptions& options = {}) { return linearAxis(values, options); }
ChartAxis logarithmic(const Values& values, double room = 1.0) { return logarithmicAxis(values, room); }

TEST(LinearAxis, HasRoundTicksThatAreTheDoublesOfTheirDecimals) {
  EXPECT_EQ(ticksOf(linear({0.0, 1.0})), (Values{0.0, 0.2, 0.4, 0.6, 0.8, 1.0}));
  EXPECT_EQ(ticksOf(linear({0.0, 0.37})), (Values{0.0, 0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(ticksOf(linear({13.0, 1700.0})), (Values{0.0, 500.0, 1000.0, 1500.0, 2000.0}));
  EXPECT_EQ(ticksOf(linear({-0.3, 0.3})), (Values{-0.4, -0.2, 0.0, 0.2, 0.4}));
  EXPECT_EQ(ticksOf(linear({0.3, 0.8})), (Values{0.3, 0.4, 0.5, 0.6, 0.7, 0.8})) << "ends that are round stay";
  EXPECT_EQ(linear({0.0, 0.37}).ticks[1].decimals, 1);
  EXPECT_EQ(linear({0.0, 0.037}).ticks[1].decimals, 2);
  EXPECT_EQ(linear({0.0, 37.0}).ticks[1].decimals, 0);
}

TEST(LinearAxis, KeepsRoomInStepsAndNoLabelsCloserThanWanted) {
  const LinearAxisOptions accuracy{.steps = 6, .smallestStep = 5.0, .below = 0.3, .above = 0.5};
  EXPECT_EQ(ticksOf(linear({37.3, 56.7}, accuracy)), (Values{35.0, 40.0, 45.0, 50.0, 55.0, 60.0}));
  EXPECT_EQ(ticksOf(linear({40.0, 50.0}, accuracy)), (Values{35.0, 40.0, 45.0, 50.0, 55.0}));
  EXPECT_EQ(ticksOf(linear({2.0, 99.0}, accuracy)), (Values{-20.0, 0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 120.0}));
}

TEST(LinearAxis, OfNothingOneValueOrNoNumbersIsStillAnAxis) {
  EXPECT_EQ(ticksOf(linear({})), (Values{0.0, 0.2, 0.4, 0.6, 0.8, 1.0}));
  EXPECT_EQ(linear({kNan, kInfinity, -kInfinity}), linear({}));
  EXPECT_EQ(linear({kNan, 0.0, kInfinity, 1.0}), linear({0.0, 1.0}));
  EXPECT_EQ(ticksOf(linear({0.0})), (Values{-1.0, 0.0, 1.0}));
  EXPECT_EQ(ticksOf(linear({5.0})), (Values{4.0, 5.0, 6.0}));
  EXPECT_EQ(ticksOf(linear({0.37})), (Values{0.3, 0.4}));
  EXPECT_EQ(ticksOf(linear({-7.0, -7.0}, {.smallestStep = 5.0})), (Values{-10.0, -5.0}));
}

TEST(LogarithmicAxis, HasEveryOneTwoFiveBetweenItsEnds) {
  EXPECT_EQ(ticksOf(logarithmic({13.0, 1700.0})), (Values{10, 20, 50, 100, 200, 500, 1000, 2000}));
  EXPECT_EQ(ticksOf(logarithmic({0.3, 0.02})), (Values{0.02, 0.05, 0.1, 0.2, 0.5}));
  EXPECT_EQ(ticksOf(logarithmic({1.0, 10.0})), (Values{1, 2, 5, 10})) << "ends that are round stay";
  EXPECT_EQ(ticksOf(logarithmic({1.0, 10.0}, 1.15)), (Values{0.5, 1, 2, 5, 10, 20}));
  const ChartAxis axis = logarithmic({0.02, 20.0});
  EXPECT_EQ(axis.ticks.front().decimals, 2);
  EXPECT_EQ(axis.ticks.back().decimals, 0);
}

TEST(LogarithmicAxis, OfNothingOneValueOrNoLogarithmsIsStillAnAxis) {
  EXPECT_EQ(ticksOf(logarithmic({})), (Values{1, 2, 5, 10}));
  EXPECT_EQ(logarithmic({kNan, 0.0, -3.0, kInfinity}), logarithmic({}));
  EXPECT_EQ(logarithmic({0.0, 13.0, kNan, 1700.0}), logarithmic({13.0, 1700.0}));
  EXPECT_EQ(ticksOf(logarithmic({13.0})), (Values{10, 20}));
  EXPECT_EQ(ticksOf(logarithmic({20.0})), (Values{10, 20, 50}));
}

TEST(ChartAxis, MapsItsEndsToTheEndsAndKeepsProportionsBetween) {
  const ChartAxis even = linear({0.0, 1.0});
  EXPECT_EQ(even.at(0.0, 56.0, 456.0), 56.0);
  EXPECT_EQ(even.at(1.0, 56.0, 456.0), 456.0);
  EXPECT_EQ(even.at(0.25, 56.0, 456.0), 156.0);
  EXPECT_EQ(even.at(0.25, 400.0, 0.0), 300.0) << "upwards";
  EXPECT_EQ(even.at(1.5, 0.0, 100.0), 150.0) << "beyond the end";
  const ChartAxis decades = logarithmic({1.0, 100.0});
  EXPECT_EQ(decades.at(1.0, 0.0, 600.0), 0.0);
  EXPECT_EQ(decades.at(100.0, 0.0, 600.0), 600.0);
  EXPECT_NEAR(decades.at(10.0, 0.0, 600.0), 300.0, 1e-9);
  EXPECT_NEAR(decades.share(2.0), 0.5 * std::log10(2.0), 1e-12);
  for (const double none : {0.0, -1.0, kNan}) EXPECT_EQ(decades.share(none), 0.0) << none;
  EXPECT_EQ(even.share(kNan), 0.0);
}

RC_GTEST_PROP(ChartAxis, HoldsEveryValueInFewSteps, ()) {
  const double scale = std::pow(10.0, *rc::gen::inRange(-9, 10));
  Values values;
  for (const int n : *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(-1000, 1000)))) values.push_back(scale * n);
  const ChartAxis axis = linear(values);
  const double hair = 1e-6 * (axis.high - axis.low);
  for (const double value : values) RC_ASSERT(axis.low - hair <= value && value <= axis.high + hair);
  RC_ASSERT(axis.low < axis.high);
  RC_ASSERT(axis.ticks.size() >= 2U && axis.ticks.size() <= 8U);
  for (double& value : values) value = std::abs(value);
  const ChartAxis decades = logarithmic(values);
  RC_ASSERT(0.0 < decades.low && decades.low < decades.high);
  for (const double value : values) RC_ASSERT(value == 0.0 || (-1e-6 <= decades.share(value) && decades.share(value) <= 1.0 + 1e-6));
}

TEST(LinearAxis, TakesValuesThatRoundingAlonePartsForOne) {
  for (const double value : {-1.6, 31.7, 1e6, 1e-12}) {
    const double beside = value * (1.0 + 4e-16);
    const ChartAxis axis = linearAxis(std::vector<double>{value, beside});
    for (const double each : {value, beside}) {
      EXPECT_GE(axis.share(each), 0.0) << value;
      EXPECT_LE(axis.share(each), 1.0) << value;
    }
    EXPECT_LE(axis.ticks.size(), 12u) << value;
  }
}

}  // namespace
}  // namespace ew::chart_axis_test
