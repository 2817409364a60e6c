#include "logic/outline.h"

#include <gtest/gtest.h>

#include "lessons/made_scene.h"

namespace ew::lessons::outline_test {
namespace {

using test::held;
using test::image;

/// How far the ends of the lines lie from a circle about a point of the image plane, mm.
double worstFrom(const std::vector<sdk::OverlayLine<frame::Probe>>& lines, const glm::dvec2& middle_mm, double radius_mm) {
  double worst = 0.0;
  for (const auto& line : lines)
    for (const auto& point : line.points) worst = std::max(worst, std::abs(glm::distance(glm::dvec2(point.at), middle_mm) - radius_mm));
  return worst;
}

TEST(Outline, FollowsTheBorderWithoutSteps) {
  const auto lines = outlineOf(test::ball(), 7, image(held()), 1.5);
  ASSERT_GT(lines.size(), 60u);
  EXPECT_LT(worstFrom(lines, {0.0, 40.0}, 20.0), 0.8) << "steps of the grid would be off by more";
  EXPECT_TRUE(outlineOf(test::ball(), 7, image(held(30.0)), 1.5).empty()) << "beside the ball";
}

TEST(Outline, EndsAtTheBorderOfTheFan) {
  ScanState narrow = image(held());
  narrow.probe.width_mm = 20.0;
  const auto linear = outlineOf(test::ball(), 7, narrow, 1.5);
  ASSERT_FALSE(linear.empty());
  for (const auto& line : linear)
    for (const auto& point : line.points) EXPECT_LE(std::abs(point.at.x), 10.0);
  EXPECT_LT(worstFrom(linear, {0.0, 40.0}, 20.0), 0.8) << "and does not run along it";

  ScanState sector = image(held());
  sector.probe.kind = ProbeKind::convex;
  sector.probe.radius_mm = 60.0;
  sector.probe.halfAngle_rad = 0.15;
  const auto within = outlineOf(test::ball(), 7, sector, 1.5);
  ASSERT_FALSE(within.empty());
  for (const auto& line : within)
    for (const auto& point : line.points) EXPECT_LE(std::abs(std::atan2(point.at.x, point.at.y + 60.0)), 0.15 + 1e-9);
}

}  // namespace
}  // namespace ew::lessons::outline_test
