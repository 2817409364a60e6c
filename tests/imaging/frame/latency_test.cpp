#include "ew/imaging/latency.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ew::latency_test {
namespace {

TEST(LatencyHistogram, HasFourBucketsToADoublingFromSixteenMicrosecondsOn) {
  EXPECT_EQ(LatencyHistogram::edge_us(0), 16.0);
  for (int bucket = 0; bucket + 5 < LatencyHistogram::kBuckets; ++bucket)
    EXPECT_EQ(LatencyHistogram::edge_us(bucket + 4), 2.0 * LatencyHistogram::edge_us(bucket));
  for (int bucket = 0; bucket + 2 < LatencyHistogram::kBuckets; ++bucket)
    EXPECT_NEAR(LatencyHistogram::edge_us(bucket + 1) / LatencyHistogram::edge_us(bucket), std::pow(2.0, 0.25), 1e-12);
  EXPECT_TRUE(std::isinf(LatencyHistogram::edge_us(LatencyHistogram::kBuckets - 1)));
}

TEST(LatencyHistogram, CountsATimeInTheBucketWhoseEdgesHoldIt) {
  for (int bucket = 0; bucket + 1 < LatencyHistogram::kBuckets; ++bucket) {
    LatencyHistogram times;
    times.add(LatencyHistogram::edge_us(bucket));
    times.add(std::nextafter(LatencyHistogram::edge_us(bucket), 1e9));
    EXPECT_EQ(times.inBucket(bucket), 1U);
    EXPECT_EQ(times.inBucket(bucket + 1), 1U);
  }
}

TEST(LatencyHistogram, GivesQuantilesGoodToABucket) {
  LatencyHistogram times;
  EXPECT_EQ(times.quantile_us(0.5), 0.0);
  for (int n = 1; n <= 1000; ++n) times.add(10.0 * n);
  EXPECT_EQ(times.count(), 1000U);
  EXPECT_EQ(times.max_us(), 10000.0);
  for (const double share : {0.01, 0.5, 0.95, 0.99, 1.0}) {
    EXPECT_GE(times.quantile_us(share), 10000.0 * share);
    EXPECT_LE(times.quantile_us(share), 10000.0 * share * std::pow(2.0, 0.25));
  }
  EXPECT_EQ(times.quantile_us(0.0), 16.0) << "the edge of the first bucket that holds any";
  EXPECT_EQ(times.quantile_us(std::numeric_limits<double>::quiet_NaN()), 16.0);
  EXPECT_EQ(times.quantile_us(7.0), times.quantile_us(1.0));
  times.clear();
  for (const double us : {16.0, 32.0, 64.0}) times.add(us);
  EXPECT_EQ(times.quantile_us(0.33), 16.0);
  EXPECT_EQ(times.quantile_us(0.34), 32.0) << "one of three is less than this share";
  EXPECT_EQ(times.quantile_us(0.67), 64.0);
  times.clear();
  times.add(100.0);
  EXPECT_EQ(times.quantile_us(0.5), 100.0) << "never above the longest time";
  times.clear();
  EXPECT_EQ(times.count(), 0U);
  EXPECT_EQ(times.max_us(), 0.0);
}

TEST(LatencyHistogram, CountsNegativeTimesAsNoneAndLeavesOutWhatIsNoTime) {
  LatencyHistogram times;
  times.add(std::numeric_limits<double>::quiet_NaN());
  times.add(std::numeric_limits<double>::infinity());
  times.add(-std::numeric_limits<double>::infinity());
  EXPECT_EQ(times.count(), 0U);
  times.add(-5.0);
  EXPECT_EQ(times.inBucket(0), 1U);
  EXPECT_EQ(times.max_us(), 0.0);
  times.add(1e30);
  EXPECT_EQ(times.inBucket(LatencyHistogram::kBuckets - 1), 1U);
  EXPECT_EQ(times.quantile_us(1.0), 1e30);
}

}  // namespace
}  // namespace ew::latency_test
