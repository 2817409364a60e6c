#include "ew/core/depth_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ew::depth_curves_test {
namespace {

/// Two owners that see the same places at depths which differ, the more so to the sides; `off` is what they truly differ by.
template <class Off>
std::vector<DepthDifference> seenByTwo(const Off& off) {
  std::vector<DepthDifference> seen;
  for (int depth = 10; depth <= 110; depth += 4)
    for (int beside = -20; beside <= 20; beside += 5) {
      const double first = depth + 0.3 * beside, second = depth - 0.3 * beside;
      seen.push_back({0, 1, first, second, off(first, second, beside), 1.0});
    }
  return seen;
}

TEST(DepthCurves, DoNotTakeAnotherDifferenceForACurveThatAllHaveInCommon) {
  // Each owner is weaker to one side: as if a fan's edge were dark. A common slope with depth would explain it, and blacken half the image.
  const auto seen = seenByTwo([](double, double, int beside) { return 3.0 - 0.8 * beside; });
  DepthCurves free, held;
  ASSERT_TRUE(fitDepthCurves(seen, 2, {15.0, 0.02}, noProgress(), free));
  ASSERT_TRUE(fitDepthCurves(seen, 2, {15.0, 0.02, 1.0}, noProgress(), held));
  const auto common = [](const DepthCurves& curves, double depth) {
    return 0.5 * (atDepth(curves.grey[0], 15.0, depth) + atDepth(curves.grey[1], 15.0, depth));
  };
  EXPECT_GT(std::abs(common(free, 100.0) - common(free, 20.0)), 50.0);
  EXPECT_LT(std::abs(common(held, 100.0) - common(held, 20.0)), 15.0);
  for (const double depth : {20.0, 60.0, 100.0})
    EXPECT_NEAR(atDepth(held.grey[1], 15.0, depth) - atDepth(held.grey[0], 15.0, depth), 3.0, 0.5) << depth;
}

TEST(DepthCurves, HeldInCommonStillFindWhatDiffers) {
  const auto gain = [](double depth) { return 8.0 + 0.1 * depth; };
  const auto seen = seenByTwo([&](double first, double second, int) { return 0.5 * gain(first) + 0.5 * gain(second); });
  DepthCurves curves;
  ASSERT_TRUE(fitDepthCurves(seen, 2, {15.0, 0.02, 1.0}, noProgress(), curves));
  for (const double depth : {20.0, 60.0, 100.0})
    EXPECT_NEAR(atDepth(curves.grey[1], 15.0, depth) - atDepth(curves.grey[0], 15.0, depth), gain(depth), 0.5) << depth;
  EXPECT_LT(curves.medianAfter, 0.3);
}

TEST(DepthCurves, HoldEachGroupByItself) {
  std::vector<DepthDifference> seen = seenByTwo([](double, double, int beside) { return -0.8 * beside; });
  for (const DepthDifference& pair : std::vector(seen)) seen.push_back({2, 3, pair.firstDepth_mm, pair.secondDepth_mm, -pair.difference});
  DepthCurves curves;
  ASSERT_TRUE(fitDepthCurves(seen, 4, {15.0, 0.02, 1.0}, noProgress(), curves));
  for (std::size_t owner = 0; owner < 4; ++owner)
    for (const double grey : curves.grey[owner]) EXPECT_LT(std::abs(grey), 20.0) << owner;  // opposite slopes do not make up for each other
}

}  // namespace
}  // namespace ew::depth_curves_test
