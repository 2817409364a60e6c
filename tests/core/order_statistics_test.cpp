#include "ew/core/order_statistics.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace ew {
namespace {

TEST(OrderStatistics, AreThoseOfAFewValues) {
  const std::vector<double> odd = {5.0, 1.0, 3.0}, even = {4.0, 1.0, 3.0, 2.0};
  EXPECT_EQ(medianOf(odd), 3.0);
  EXPECT_EQ(medianOf(even), 2.5);
  EXPECT_EQ(upperMedianOf(odd), 3.0);
  EXPECT_EQ(upperMedianOf(even), 3.0);
  EXPECT_EQ(valueAtRank(even, 0), 1.0);
  EXPECT_EQ(valueAtRank(even, 3), 4.0);
  EXPECT_EQ(quantileOf(even, 0.0), 1.0);
  EXPECT_EQ(quantileOf(even, 0.4), 2.0);
  EXPECT_EQ(quantileOf(even, 1.0), 4.0);
  EXPECT_EQ(medianOf(std::vector<float>{7.0F}), 7.0F);
  EXPECT_EQ(upperMedianOf(std::deque<int>{2, 9}), 9);
}

TEST(OrderStatistics, LeaveWhatTheyAreGivenAsItWas) {
  std::deque<double> latest = {3.0, 1.0, 2.0, 9.0};  // in the order of time
  EXPECT_EQ(upperMedianOf(latest), 3.0);
  EXPECT_EQ(medianOf(latest), 2.5);
  EXPECT_EQ(quantileOf(latest, 0.25), 1.0);
  EXPECT_EQ(latest, (std::deque<double>{3.0, 1.0, 2.0, 9.0}));
  std::vector<double> scratch = {3.0, 1.0, 2.0, 9.0};
  EXPECT_EQ(valueAtRank(std::span(scratch), 0), 1.0) << "a span copies nothing";
}

RC_GTEST_PROP(OrderStatistics, AreWhatSortingFinds, (std::vector<int> values)) {
  RC_PRE(!values.empty());
  std::vector<int> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::vector<double> floating(sorted.rbegin(), sorted.rend());
  for (std::size_t rank = 0; rank < values.size(); ++rank) RC_ASSERT(valueAtRank(values, rank) == sorted[rank]);
  const std::size_t middle = sorted.size() / 2;
  RC_ASSERT(upperMedianOf(values) == sorted[middle]);
  const double upper = sorted[middle], lower = sorted[sorted.size() % 2 == 1 ? middle : middle - 1];
  RC_ASSERT(medianOf(floating) == (upper + lower) / 2);
}

}  // namespace
}  // namespace ew
