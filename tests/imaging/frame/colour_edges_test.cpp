#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/knobs.h"
#include "ew/imaging/probe.h"

namespace ew::colour_edges_test {
namespace {

Probe linear() {
  Probe probe;
  probe.kind = ProbeKind::linear;
  probe.width_mm = 40.0;
  probe.defaultDepth_mm = 50.0;
  probe.maxSteering_rad = 0.4;
  return probe;
}

Probe convex() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.5;
  probe.defaultDepth_mm = 150.0;
  probe.maxDepth_mm = 250.0;
  return probe;
}

Knobs coloured(double steering_rad = 0.0) {
  Knobs knobs;
  knobs.colour.emplace();
  knobs.colour->steering_rad = steering_rad;
  return knobs;
}

TEST(ColourPlaces, AreThoseOfTheOutline) {
  for (const Probe& probe : {linear(), convex()})
    for (const double steering_rad : {0.0, 0.3}) {
      const Knobs knobs = coloured(steering_rad);
      const ColourBox box = colourBoxOf(probe, knobs);
      const std::vector<glm::dvec2> outline = colourBoxOutline_mm(probe, knobs);
      const ColourPlace first = colourPlaceOf(probe, knobs, outline[0]), second = colourPlaceOf(probe, knobs, outline[1]);
      EXPECT_NEAR(first.across, box.left, 1e-9);
      EXPECT_NEAR(first.depth_mm, box.top_mm, 1e-9);
      EXPECT_NEAR(second.across, box.left, 1e-9);
      EXPECT_NEAR(second.depth_mm, box.bottom_mm, 1e-9);
    }
}

TEST(ColourEdges, GoWhereTheyAreMovedAndTheOthersStay) {
  const Probe probe = convex();
  const Knobs knobs = coloured(), moved = withColourEdgesAt(probe, knobs, {.left = true, .bottom = true}, {-0.8, 120.0});
  const ColourBox before = colourBoxOf(probe, knobs), box = colourBoxOf(probe, moved);
  EXPECT_NEAR(box.left, -0.8, 1e-9);
  EXPECT_NEAR(box.bottom_mm, 120.0, 1e-9);
  EXPECT_NEAR(box.right, before.right, 1e-9);
  EXPECT_NEAR(box.top_mm, before.top_mm, 1e-9);
  Knobs same = moved;
  same.colour->boxMiddle = knobs.colour->boxMiddle;
  same.colour->boxWidth = knobs.colour->boxWidth;
  same.colour->boxMiddle_mm = knobs.colour->boxMiddle_mm;
  same.colour->boxHeight_mm = knobs.colour->boxHeight_mm;
  EXPECT_EQ(same, knobs);
}

TEST(ColourEdges, StayWithinTheFanAndApartFromEachOther) {
  const Probe probe = linear();
  const Knobs knobs = coloured();
  const ColourBox before = colourBoxOf(probe, knobs);
  const ColourBox all = colourBoxOf(probe, withColourEdgesAt(probe, knobs, {.right = true, .top = true}, {7.0, -30.0}));
  EXPECT_NEAR(all.right, 1.0, 1e-9);
  EXPECT_NEAR(all.top_mm, 0.0, 1e-9);
  const ColourBox least = colourBoxOf(probe, withColourEdgesAt(probe, knobs, {.right = true, .top = true}, {-1.0, 1000.0}));
  EXPECT_NEAR(least.left, before.left, 1e-9);
  EXPECT_NEAR(least.right - least.left, 0.2, 1e-9);
  EXPECT_NEAR(least.bottom_mm, before.bottom_mm, 1e-9);
  EXPECT_NEAR(least.bottom_mm - least.top_mm, 5.0, 1e-9);
}

TEST(ColourBoxMiddle, IsWhereTheBoxWasPut) {
  const Probe probe = convex();
  const Knobs moved = withColourBoxMiddle(probe, coloured(), {0.2, 70.0});
  const ColourBox box = colourBoxOf(probe, moved);
  EXPECT_NEAR(0.5 * (box.left + box.right), 0.2, 1e-9);
  EXPECT_NEAR(0.5 * (box.top_mm + box.bottom_mm), 70.0, 1e-9);
  EXPECT_EQ(moved, withColourBoxMiddle(probe, moved, {0.2, 70.0}));
}

}  // namespace
}  // namespace ew::colour_edges_test
