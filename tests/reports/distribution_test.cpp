#include "ew/reports/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ew {
namespace {

TEST(FiveNumbers, LieBetweenTheValuesInOrder) {
  EXPECT_EQ(fiveNumbersOf({4.0, 1.0, 3.0, 2.0}), (FiveNumbers{4, 1.0, 1.75, 2.5, 3.25, 4.0, 2.5}));
  EXPECT_EQ(fiveNumbersOf({7.0}), (FiveNumbers{1, 7.0, 7.0, 7.0, 7.0, 7.0, 7.0}));
  EXPECT_EQ(fiveNumbersOf({}), FiveNumbers{});
}

TEST(FiveNumbers, LeaveOutWhatIsNotFinite) {
  EXPECT_EQ(fiveNumbersOf({std::nan(""), 2.0, std::numeric_limits<double>::infinity()}), fiveNumbersOf({2.0}));
}

TEST(CountsInParts, CountAValueOnABorderAboveItAndTheHighestInTheLastPart) {
  const std::vector<double> values = {0.0, 0.25, 0.5, 1.0, -0.1, 1.1, std::nan("")};
  EXPECT_EQ(countsIn(values, 0.0, 1.0, 4), (std::vector<std::size_t>{1, 1, 1, 1}));
}

}  // namespace
}  // namespace ew
