#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display.h"
#include "imaging/support/probes_at_random.h"

namespace ew::fan_test {
namespace {

RC_GTEST_PROP(FanOutline, RunsAlongTheEdgesOfTheBeams, ()) {
  const auto [probe, knobs] = *testing::probeAtRandom();
  const double depth_mm = testing::numberBetween(5.0, 300.0);
  const int points = *rc::gen::inRange(2, 60);
  const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, 0.5);
  const auto outline = fanOutline_mm(probe, knobs, depth_mm, points);
  RC_ASSERT(outline.size() >= 4U);
  RC_ASSERT(outline.front() == outline.back());
  for (std::size_t n = 0; n + 1 < outline.size(); ++n) {
    if (n > 0) RC_ASSERT(outline[n] != outline[n - 1]);  // inside RC_ASSERT an || looks at both of its sides
    const glm::dvec2 at = lineAndSampleAt(probe, knobs, grid, outline[n]);
    const double last = probe.lines - 1.0, bottom = grid.samples - 1.0;
    RC_ASSERT(at.x > -1e-6 && at.x < last + 1e-6 && at.y > -1e-6 && at.y < bottom + 1e-6);
    RC_ASSERT(std::abs(at.y) < 1e-6 || std::abs(at.y - bottom) < 1e-6);
  }
  // The four corners are the ends of the first and last line.
  for (const std::size_t line : {std::size_t{0}, grid.lines.size() - 1})
    for (const double at_mm : {0.0, depth_mm}) {
      const glm::dvec2 corner = grid.lines[line].origin_mm + at_mm * grid.lines[line].direction;
      const auto isCorner = [&](const glm::dvec2& p) { return glm::distance(p, corner) < 1e-9; };
      RC_ASSERT(std::any_of(outline.begin(), outline.end(), isCorner));
    }
}

RC_GTEST_PROP(FitDisplay, ShowsEveryFanWholeAndAsLargeAsItFits, ()) {
  auto [probe, knobs] = *testing::probeAtRandom();
  knobs.markerLeft = *rc::gen::arbitrary<bool>();
  knobs.upsideDown = *rc::gen::arbitrary<bool>();
  const int width = *rc::gen::inRange(60, 1200), height = *rc::gen::inRange(60, 1200);
  const DisplayGeometry geometry = fitDisplay(probe, knobs, width, height);
  glm::dvec2 lowest(1e9), highest(-1e9);
  const auto probeToImage = inverse(geometry.imageToProbe());
  for (const glm::dvec2& p_mm : fanOutline_mm(probe, knobs, geometry.depth_mm, 400)) {
    const glm::dvec2 p_px((probeToImage * Point<frame::Probe>{{p_mm, 0.0}}).at);
    lowest = glm::min(lowest, p_px);
    highest = glm::max(highest, p_px);
  }
  RC_ASSERT(lowest.x >= -0.5 && lowest.y >= -0.5 && highest.x <= width - 0.5 && highest.y <= height - 0.5);
  // The face stays in the middle, so a fan that leans to one side may leave the other side free.
  const double middle = 0.5 * (width - 1);
  const double across = 2.0 * std::max(highest.x - middle, middle - lowest.x) / width, along = (highest.y - lowest.y) / height;
  RC_ASSERT(std::abs(std::max(across, along) - 0.96) < 1e-3);
}

RC_GTEST_PROP(DisplayGeometry, SaysTheSamePlaceForAPixelAsItsMatrixAndMirrorsColumnsToTheBit, ()) {
  auto [probe, knobs] = *testing::probeAtRandom();
  knobs.zoom = testing::numberBetween(1.0, 8.0);
  knobs.markerLeft = *rc::gen::arbitrary<bool>();
  knobs.upsideDown = *rc::gen::arbitrary<bool>();
  const int width = *rc::gen::inRange(1, 4000), height = *rc::gen::inRange(1, 3000);
  const DisplayGeometry geometry = fitDisplay(probe, knobs, width, height);
  const int x = *rc::gen::inRange(0, width), y = *rc::gen::inRange(0, height);
  const glm::dvec3 place = (geometry.imageToProbe() * Point<frame::Image>{{x, y, 0.0}}).at;
  RC_ASSERT(glm::distance(glm::dvec2(place), geometry.probePoint_mm(x, y)) < 1e-9);
  const glm::dvec3 mirrored = (geometry.imageToProbe() * Point<frame::Image>{{width - 1 - x, y, 0.0}}).at;
  RC_ASSERT(mirrored == glm::dvec3(-place.x, place.y, place.z));
  RC_ASSERT(geometry.probePoint_mm(width - 1 - x, y).x == -geometry.probePoint_mm(x, y).x);
}

TEST(FanOutline, HasTwoEndsForAStraightEdgeAndOnePointForAFaceWithoutRadius) {
  const Probe linear = testing::probeOf(ProbeKind::linear);
  EXPECT_EQ(fanOutline_mm(linear, {}, 60.0, 48).size(), 5U);
  EXPECT_EQ(fanOutline_mm(linear, {.steering_rad = 0.2}, 60.0, 48).size(), 5U);
  EXPECT_EQ(fanOutline_mm(linear, {.trapezoid = true}, 60.0, 48).size(), 2U + 48U + 1U);
  EXPECT_EQ(fanOutline_mm(testing::probeOf(ProbeKind::phased), {}, 60.0, 48).size(), 1U + 48U + 1U);
  EXPECT_EQ(fanOutline_mm(testing::probeOf(ProbeKind::endocavity), {}, 60.0, 48).size(), 48U + 48U + 1U);
}

}  // namespace
}  // namespace ew::fan_test
