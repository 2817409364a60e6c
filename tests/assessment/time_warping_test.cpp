#include "ew/assessment/time_warping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

namespace ew {
namespace {

glm::dmat4 scanned(double t) {
  glm::dmat4 pose = glm::translate(glm::dmat4(1.0), glm::dvec3(9.0 * t, 12.0 * std::sin(t), 0.0));
  pose = glm::rotate(pose, 0.4 * std::sin(1.3 * t), glm::dvec3(1.0, 0.0, 0.0));
  return glm::rotate(pose, 0.2 * t, glm::dvec3(0.0, 1.0, 0.0));
}

std::vector<Pose> scan(int count, const std::function<double(double)>& clock) {
  std::vector<Pose> poses;
  for (int n = 0; n < count; ++n) poses.push_back({{scanned(clock(0.05 * n))}, PoseStatus::ok, 0.05 * n});
  return poses;
}

double same(double t) { return t; }

/// Every way there is, tried.
double leastSum(std::span<const Pose> a, std::span<const Pose> b, std::size_t i, std::size_t j) {
  const double cost = poseDistance_mm(a[i].probeToWorld, b[j].probeToWorld);
  if (i == 0 && j == 0) return 2.0 * cost;
  double least = std::numeric_limits<double>::infinity();
  if (i > 0 && j > 0) least = std::min(least, leastSum(a, b, i - 1, j - 1) + 2.0 * cost);
  if (i > 0) least = std::min(least, leastSum(a, b, i - 1, j) + cost);
  if (j > 0) least = std::min(least, leastSum(a, b, i, j - 1) + cost);
  return least;
}

class StopsAtOnce final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

TEST(PoseDistance, IsAMetricThatCountsTurnsByTheirLever) {
  const Transform<frame::World, frame::Probe> a{scanned(0.3)}, b{scanned(1.9)}, c{scanned(4.0)};
  EXPECT_NEAR(poseDistance_mm(a, a), 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(poseDistance_mm(a, b), poseDistance_mm(b, a));
  EXPECT_LE(poseDistance_mm(a, c), poseDistance_mm(a, b) + poseDistance_mm(b, c));
  EXPECT_NEAR(poseDistance_mm({glm::translate(glm::dmat4(1.0), glm::dvec3(3.0, 4.0, 0.0))}, {}), 5.0, 1e-9);
  EXPECT_NEAR(poseDistance_mm({glm::rotate(glm::dmat4(1.0), 0.1, glm::dvec3(0.0, 1.0, 0.0))}, {}), 6.0, 1e-9);
  EXPECT_NEAR(poseDistance_mm({glm::rotate(glm::dmat4(1.0), 3.0, glm::dvec3(0.0, 1.0, 0.0))}, {}), 180.0, 1e-9);
}

TEST(WarpTime, FindsAKnownDistortionWithinOneSample) {
  const auto clock = [](double t) { return t + 0.9 * std::sin(0.6 * t) * std::min(1.0, t) * std::min(1.0, std::max(0.0, 9.95 - t)); };
  const auto even = scan(200, same), bent = scan(200, clock);
  const auto warped = warpTime(bent, even);
  ASSERT_TRUE(warped);
  for (std::size_t n = 0; n < bent.size(); ++n)
    EXPECT_NEAR(warped->inSecond(n), std::clamp(clock(0.05 * static_cast<double>(n)) / 0.05, 0.0, 199.0), 1.0) << n;
  EXPECT_LT(warped->mean_mm, 0.5);
}

TEST(WarpTime, OfTheSameScanIsTheSameClock) {
  const auto one = scan(150, same);
  const auto warped = warpTime(one, one);
  ASSERT_TRUE(warped);
  ASSERT_EQ(warped->pairs.size(), one.size());
  for (std::size_t n = 0; n < one.size(); ++n) EXPECT_EQ(warped->pairs[n], std::pair(n, n));
  EXPECT_NEAR(warped->mean_mm, 0.0, 1e-6);
  const auto half = scan(75, [](double t) { return 2.0 * t; });
  const auto faster = warpTime(half, one);
  ASSERT_TRUE(faster);
  for (std::size_t n = 0; n < half.size(); ++n) EXPECT_NEAR(faster->inSecond(n), 2.0 * static_cast<double>(n), 1.0);
}

TEST(WarpTime, IsTheLeastSumOfAllWays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 6.0);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Pose> a, b;
    for (int n = 0; n < 6; ++n) a.push_back({{scanned(place(random))}, PoseStatus::ok, 0.05 * n});
    for (int n = 0; n < 5; ++n) b.push_back({{scanned(place(random))}, PoseStatus::ok, 0.05 * n});
    const auto warped = warpTime(a, b);
    ASSERT_TRUE(warped);
    double sum = 0.0;
    for (std::size_t n = 0; n < warped->pairs.size(); ++n) {
      const auto [i, j] = warped->pairs[n];
      const bool isDiagonal = n == 0 || (i > warped->pairs[n - 1].first && j > warped->pairs[n - 1].second);
      sum += (isDiagonal ? 2.0 : 1.0) * poseDistance_mm(a[i].probeToWorld, b[j].probeToWorld);
    }
    EXPECT_NEAR(sum, leastSum(a, b, 5, 4), 1e-9 * sum);
    EXPECT_EQ(warped->pairs.front(), std::pair(std::size_t(0), std::size_t(0)));
    EXPECT_EQ(warped->pairs.back(), std::pair(std::size_t(5), std::size_t(4)));
  }
}

TEST(WarpTime, RefusesWhatItCannotDo) {
  const auto one = scan(10, same);
  EXPECT_EQ(warpTime({}, one).error().code, ErrorCode::badUsage);
  EXPECT_EQ(warpTime(one, {}).error().code, ErrorCode::badUsage);
  const auto large = warpTime(one, one, noProgress(), 99);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::tooLarge);
  EXPECT_TRUE(warpTime(one, one, noProgress(), 100));
  StopsAtOnce stop;
  EXPECT_EQ(warpTime(one, one, stop).error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace ew
