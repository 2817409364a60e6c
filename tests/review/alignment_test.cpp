#include "logic/alignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "made_log.h"

namespace ew::review {
namespace {

using test::allOf;
using test::at;
using test::logOf;

/// Along a curve that nowhere comes back, where `place` (0 to 1) says.
Pose along(double place) { return at({200.0 * place, 0.0, 40.0 * std::sin(3.0 * place)}); }

/// The expert goes evenly in 20 s; the trainee slowly first, in 30 s, and begins at 100 s of their own clock.
ScanLog expert() {
  return logOf(201, 0.1, [](int n, ScanState& state) { state.pose = along(n / 200.0); });
}
ScanLog trainee() {
  return logOf(
      301, 0.1, [](int n, ScanState& state) { state.pose = along(std::pow(n / 300.0, 2.0)); }, 100.0);
}

TEST(Alignment, FindsAKnownDistortionOfTimeWithinAStep) {
  const ScanLog first = trainee(), second = expert();
  const auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_TRUE(found) << found.error();
  for (double passed_s = 0.0; passed_s <= 30.0; passed_s += 0.5)
    EXPECT_NEAR(found->inSecond_s(100.0 + passed_s), 20.0 * std::pow(passed_s / 30.0, 2.0), 0.1) << passed_s;
  EXPECT_LT(found->mean_mm(), 1.0);
}

TEST(Alignment, NeverGoesBackAndBeginsAndEndsWithBoth) {
  const ScanLog first = trainee(), second = expert();
  const auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_TRUE(found);
  double before_s = -1.0;
  for (double time_s = 95.0; time_s <= 135.0; time_s += 0.05) {
    EXPECT_GE(found->inSecond_s(time_s), before_s);
    before_s = found->inSecond_s(time_s);
  }
  EXPECT_EQ(found->inSecond_s(100.0), 0.0);
  EXPECT_EQ(found->inSecond_s(130.0), 20.0);
  EXPECT_NEAR(found->inFirst_s(found->inSecond_s(120.0)), 120.0, 0.1);
}

TEST(Alignment, LeavesOutPosesThatNobodyKnows) {
  const ScanLog second = expert();
  const ScanLog first = logOf(301, 0.1, [](int n, ScanState& state) {
    state.pose = along(n / 300.0);
    if (n % 7 != 0) return;
    state.pose = at({-900.0, 500.0, 300.0});
    state.pose.status = n % 2 == 0 ? PoseStatus::invalid : PoseStatus::missing;
  });
  const auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_TRUE(found);
  for (double time_s = 1.0; time_s < 29.0; time_s += 0.5) EXPECT_NEAR(found->inSecond_s(time_s), time_s / 1.5, 0.15) << time_s;
  EXPECT_LT(found->mean_mm(), 1.0);
}

TEST(Alignment, EndsWithAnExpertWhoRestsAtTheEnd) {
  const ScanLog first = logOf(101, 0.1, [](int n, ScanState& state) { state.pose = along(n / 100.0); });
  const ScanLog second = logOf(201, 0.1, [](int n, ScanState& state) { state.pose = along(std::min(1.0, n / 100.0)); });
  const auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inSecond_s(10.0), 20.0);
  EXPECT_NEAR(found->inSecond_s(5.0), 5.0, 0.1);
}

TEST(Alignment, SaysWhenThereIsNoPoseAtAll) {
  const ScanLog second = expert();
  const ScanLog first = logOf(10, 0.1, [](int, ScanState& state) { state.pose.status = PoseStatus::invalid; });
  const auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::noValidPose);
}

TEST(Alignment, ComparesALongScanInLargerSteps) {
  const ScanLog first = trainee(), second = expert();
  const auto found = Alignment::of(first, allOf(first), second, allOf(second), noProgress(), {.mostPoses = 20});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->inSecond_s(115.0), 5.0, 2.0);
}

TEST(TwoScans, GoOnTogetherOnOneClock) {
  TwoScans scans({100.0, 130.0}, {0.0, 20.0});
  EXPECT_EQ(scans.range(), (Part{0.0, 30.0}));
  EXPECT_EQ(scans.inFirst_s(4.0), 104.0);
  EXPECT_EQ(scans.inSecond_s(4.0), 4.0);
  scans.setOneClock(5.0);
  EXPECT_EQ(scans.inSecond_s(4.0), 0.0) << "it has not begun";
  EXPECT_EQ(scans.inSecond_s(8.0), 3.0);
  EXPECT_EQ(scans.fromSecond_s(3.0), 8.0);
  EXPECT_EQ(scans.fromFirst_s(104.0), 4.0);
  scans.setOneClock(-3.0);
  EXPECT_EQ(scans.range(), (Part{-3.0, 30.0}));
  EXPECT_EQ(scans.inFirst_s(-2.0), 100.0);
  EXPECT_EQ(scans.inSecond_s(-2.0), 1.0);
}

TEST(TwoScans, FollowTheFirstWhenTheyAreAligned) {
  const ScanLog first = trainee(), second = expert();
  auto found = Alignment::of(first, allOf(first), second, allOf(second));
  ASSERT_TRUE(found);
  TwoScans scans(allOf(first), allOf(second));
  scans.setAligned(std::make_shared<const Alignment>(std::move(*found)));
  EXPECT_EQ(scans.range(), (Part{0.0, 30.0}));
  EXPECT_NEAR(scans.inSecond_s(15.0), 5.0, 0.1);
  EXPECT_NEAR(scans.fromSecond_s(5.0), 15.0, 0.15);
  scans.setOneClock(0.0);
  EXPECT_FALSE(scans.isAligned());
}

}  // namespace
}  // namespace ew::review
