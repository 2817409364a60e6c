#include "run/report.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "ew/core/version.h"

namespace ew::cli::report_test {
namespace {

TEST(Summarise, GivesMedianNinetyNinthPercentileAndLargestOfAKnownList) {
  std::vector<double> durations_us;
  for (int n = 200; n >= 1; --n) durations_us.push_back(n);
  const auto summary = summarise(durations_us);
  EXPECT_EQ(summary.count, 200u);
  EXPECT_EQ(summary.median_us, 100.5);
  EXPECT_EQ(summary.p99_us, 198.0);
  EXPECT_EQ(summary.max_us, 200.0);
  EXPECT_EQ(summarise({7.0}).p99_us, 7.0);
  EXPECT_EQ(summarise({}).count, 0u);
}

TEST(Summarise, OrdersItsThreeFiguresAndTakesTwoFromTheList) {
  rc::check("median <= p99 <= max", [] {
    const auto values = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<double>>(rc::gen::map(rc::gen::inRange(0, 1000000), [](int v) { return v / 8.0; })));
    const auto summary = summarise(values);
    RC_ASSERT(summary.median_us <= summary.p99_us);
    RC_ASSERT(summary.p99_us <= summary.max_us);
    RC_ASSERT(std::find(values.begin(), values.end(), summary.p99_us) != values.end());
    RC_ASSERT(summary.max_us == *std::max_element(values.begin(), values.end()));
  });
}

TEST(Report, HoldsExactlyTheKeysOfTheContract) {
  Report report;
  report.command = "slice";
  report.addStep("read", 3.0);
  report.addStep("slice", 1.0);
  report.addStep("slice", 2.0);
  const auto json = report.toJson();
  for (const char* key : {"command", "version", "inputs", "outputs", "options", "seconds", "steps", "quality", "memory_mib", "simd"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_FALSE(json.contains("verdict"));
  EXPECT_FALSE(json.contains("seed"));
  EXPECT_EQ(json["version"], kVersion);
  ASSERT_EQ(json["steps"].size(), 2u);
  EXPECT_EQ(json["steps"][1]["name"], "slice");
  EXPECT_EQ(json["steps"][1]["count"], 2);
  EXPECT_EQ(json["steps"][1]["median_us"], 1.5);
  EXPECT_GT(json["memory_mib"].get<double>(), 1.0);
  report.verdict = "cannot tell";
  report.seed = 18446744073709551615ull;
  EXPECT_EQ(report.toJson()["verdict"], "cannot tell");
  EXPECT_EQ(report.toJson()["seed"].get<std::uint64_t>(), 18446744073709551615ull);
}

}  // namespace
}  // namespace ew::cli::report_test
