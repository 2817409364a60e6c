#include "logic/scan_path.h"

#include <gtest/gtest.h>

#include "ew/scanning/contact.h"
#include "made_log.h"

namespace ew::review {
namespace {

using test::allOf;
using test::at;
using test::logOf;

TEST(SkinPath, FollowsTheFaceAndBreaksWhereNothingTouches) {
  const ScanLog log = logOf(10, 0.1, [](int n, ScanState& state) {
    state.pose = at({2.0 * n, 0.0, 0.0});
    if (n == 4) state.gaps_mm.assign(kPointsOfFace, 30.0F);
    if (n == 7) state.pose.status = PoseStatus::missing;
  });
  const SkinPath path = skinPathOf(log, allOf(log));
  ASSERT_EQ(path.size(), 3U);
  EXPECT_EQ(path[0].size(), 4U);
  EXPECT_EQ(path[1].size(), 2U);
  EXPECT_EQ(path[2].size(), 2U);
  EXPECT_EQ(path[1].front().at_mm, glm::dvec3(10.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(path[1].front().time_s, 0.5);
}

TEST(SkinPath, LeavesOutPointsThatAreNearButNotItsEnds) {
  const ScanLog log = logOf(26, 0.1, [](int n, ScanState& state) { state.pose = at({0.1 * n, 0.0, 0.0}); });
  const SkinPath path = skinPathOf(log, allOf(log));
  ASSERT_EQ(path.size(), 1U);
  ASSERT_EQ(path[0].size(), 4U) << "at 0, 1, 2 and 2.5 mm";
  EXPECT_DOUBLE_EQ(path[0].back().at_mm.x, 2.5);
}

TEST(SkinPath, BreaksWhereNoFrameWasMade) {
  const ScanLog log = logOf(4, 2.0, [](int n, ScanState& state) { state.pose = at({5.0 * n, 0.0, 0.0}); });
  EXPECT_EQ(skinPathOf(log, allOf(log)).size(), 4U);
}

TEST(PlaneVisits, AreWhereTheProbeRested) {
  // 2 s at 0, then 1 s of 20 mm/s, 0.5 s of rest, on again, and 3 s at the end.
  const ScanLog log = logOf(81, 0.1, [](int n, ScanState& state) {
    const double x = n <= 20 ? 0.0 : n <= 30 ? 2.0 * (n - 20) : n <= 35 ? 20.0 : n <= 50 ? 20.0 + 2.0 * (n - 35) : 50.0;
    state.pose = at({x, 0.0, 0.0});
  });
  const auto planes = planeVisitsOf(log, allOf(log));
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(carried(planes[0].probeToWorld, glm::dvec3(0.0)), glm::dvec3(0.0));
  EXPECT_NEAR(planes[0].end_s - planes[0].begin_s, 2.0, 0.21);
  EXPECT_NEAR(carried(planes[1].probeToWorld, glm::dvec3(0.0)).x, 50.0, 2.0);
  EXPECT_FALSE(planes[1].isFrozen);
}

TEST(PlaneVisits, AreWhereItWasFrozenHoweverShort) {
  ScanLog log = logOf(10, 0.1, [](int n, ScanState& state) { state.pose = at({10.0 * n, 0.0, 0.0}); });
  log.setFrozen(0.95, true);
  log.setFrozen(1.2, false);
  ScanState more;
  more.probe = test::straightProbe();
  more.time_s = 1.3;
  more.pose = at({200.0, 0.0, 0.0});
  log.addFrame(more);
  const auto planes = planeVisitsOf(log, allOf(log));
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_TRUE(planes[0].isFrozen);
  EXPECT_EQ(carried(planes[0].probeToWorld, glm::dvec3(0.0)).x, 90.0);
}

}  // namespace
}  // namespace ew::review
