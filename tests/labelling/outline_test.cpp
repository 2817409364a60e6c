#include "ew/labelling/outline.h"

#include <gtest/gtest.h>

#include "labelling/support.h"

namespace ew::labelling {
namespace {

using test::emptyLabels;
using test::planeAt;

double areaOf(const std::vector<glm::dvec2>& outline) {
  double twice = 0.0;
  for (std::size_t n = 0; n < outline.size(); ++n) {
    const glm::dvec2 &a = outline[n], &b = outline[(n + 1) % outline.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2.0;
}

TEST(Outlines, OfABallAreTheCircleThatThePlaneCuts) {
  Volume labels = emptyLabels({60, 60, 60}, glm::dvec3(0.5), 0.4);
  const glm::dvec3 middle(0.0);
  paintBall(labels, {&middle, 1}, 10.0, {.label = 4});
  const auto plane = planeAt({0.0, 0.0, 6.0}, 0.3, {0.0, 0.0, 1.0});
  const auto outlines = outlinesOf(labels, 4, labels.grid.toVoxel<frame::File>() * plane, {-14.0, 14.0, -14.0, 14.0, 0.5});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(areaOf(outlines.front()), std::numbers::pi * 64.0, 0.02 * std::numbers::pi * 64.0);
  for (const glm::dvec2& p : outlines.front()) EXPECT_NEAR(glm::length(p), 8.0, 0.45);
}

TEST(Outlines, AreClosedAlongTheBorderOfTheArea) {
  Volume labels = emptyLabels({30, 30, 30}, glm::dvec3(1.0));
  std::fill(labels.echo.begin(), labels.echo.end(), std::uint8_t{1});
  const auto outlines = outlinesOf(labels, 1, labels.grid.toVoxel<frame::File>() * planeAt({0.0, 0.0, 0.0}), {-5.0, 5.0, -4.0, 4.0, 1.0});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(areaOf(outlines.front()), 11.0 * 9.0, 1.0);
}

TEST(Outlines, OfTwoPiecesAreTwoAndOfNothingNone) {
  Volume labels = emptyLabels({40, 30, 30}, glm::dvec3(1.0));
  const glm::dvec3 left(-9, 0, 0), right(9, 0, 0);
  paintBall(labels, {&left, 1}, 5.0, {.label = 2});
  paintBall(labels, {&right, 1}, 5.0, {.label = 2});
  const auto toVoxel = labels.grid.toVoxel<frame::File>();
  EXPECT_EQ(outlinesOf(labels, 2, toVoxel * planeAt({0, 0, 0}), {-19, 19, -14, 14, 1.0}).size(), 2u);
  EXPECT_TRUE(outlinesOf(labels, 2, toVoxel * planeAt({0, 0, 8}), {-19, 19, -14, 14, 1.0}).empty());
  EXPECT_TRUE(outlinesOf(labels, 3, toVoxel * planeAt({0, 0, 0}), {-19, 19, -14, 14, 1.0}).empty());
}

}  // namespace
}  // namespace ew::labelling
