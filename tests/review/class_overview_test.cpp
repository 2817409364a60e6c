#include "logic/class_overview.h"

#include <gtest/gtest.h>

#include <limits>

namespace ew::review {
namespace {

TEST(Distribution, HasTheQuartilesOfTypeSeven) {
  const Distribution made = distributionOf({4.0, 1.0, 3.0, 2.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(made.values, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
  EXPECT_DOUBLE_EQ(made.lowerQuartile, 1.75);
  EXPECT_DOUBLE_EQ(made.median, 2.5);
  EXPECT_DOUBLE_EQ(made.upperQuartile, 3.25);
  EXPECT_DOUBLE_EQ(made.mean, 2.5);
  EXPECT_TRUE(distributionOf({}).values.empty());
  EXPECT_EQ(distributionOf({0.7}).median, 0.7);
}

TEST(Distribution, CountsEveryValueInOneBin) {
  const std::vector<double> values{0.0, 0.1, 0.5, 0.99, 1.0, 1.5, -0.1};
  EXPECT_EQ(histogramOf(values, 0.0, 1.0, 2), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(histogramOf(values, 0.0, 1.0, 10), (std::vector<std::size_t>{1, 1, 0, 0, 0, 1, 0, 0, 0, 2}));
  EXPECT_EQ(histogramOf(std::vector<double>{3.0, 3.0}, 3.0, 3.0, 4), (std::vector<std::size_t>{2, 0, 0, 0}));
}

}  // namespace
}  // namespace ew::review
