#include "ew/measurement/on_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ew/imaging/resolution.h"

namespace ew::measurement {
namespace {

Probe convex() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.55;
  probe.carrier_hz = 3.5e6;
  probe.maxDepth_mm = 240.0;
  return probe;
}

Scene focused() {
  Scene scene;
  scene.focus.emplace();
  return scene;
}

TEST(OnImage, ADistanceAlongTheBeamIsSurerThanOneAcrossAndSurestAtTheFocus) {
  Knobs knobs;
  knobs.depth_mm = 160.0;
  knobs.focus_mm = 80.0;
  const DisplayGeometry geometry = fitDisplay(convex(), knobs, 600, 500);
  const UncertaintyAt at = uncertaintyOn(convex(), knobs, focused(), geometry);
  const auto uncertainty = [&](glm::dvec2 from, glm::dvec2 to) {
    return measure({CaliperKind::distance, {{0, {from, to}}}}, at)->figures[0].quantity.uncertainty;
  };
  const double along = uncertainty({0.0, 70.0}, {0.0, 90.0}), across = uncertainty({-10.0, 80.0}, {10.0, 80.0});
  EXPECT_GT(across, 1.5 * along);
  EXPECT_GT(uncertainty({-10.0, 150.0}, {10.0, 150.0}), 1.5 * across);
  // What it is made of, at the focus: pixel / sqrt 12 and half of a width's standard deviation, of both ends.
  const Resolution there = ResolutionMap(convex(), knobs, focused(), geometry.depth_mm).at({0.0, 80.0});
  EXPECT_NEAR(at(0, {0.0, 80.0}).lateral_mm, there.lateral_mm, 1e-12);
  EXPECT_NEAR(at(0, {0.0, 80.0}).pixel.x, geometry.pixel_mm, 1e-12);
  const double expected = std::numbers::sqrt2 * std::hypot(geometry.pixel_mm / std::sqrt(12.0), edgeDeviation_mm(there.lateral_mm));
  EXPECT_NEAR(across, expected, 0.05 * expected);
}

TEST(OnImage, BeamsOfACurvedProbeLeanOutwards) {
  Knobs knobs;
  knobs.depth_mm = 160.0;
  const ResolutionMap map(convex(), knobs, focused(), 160.0);
  EXPECT_NEAR(map.at({0.0, 80.0}).beam_rad, 0.0, 0.01);
  EXPECT_NEAR(map.at({40.0, 80.0}).beam_rad, std::atan2(40.0, 140.0), 0.01);
  EXPECT_NEAR(map.at({-40.0, 80.0}).beam_rad, -std::atan2(40.0, 140.0), 0.01);
  EXPECT_LT(map.at({0.0, 40.0}).axial_mm, 1.5);
  EXPECT_GT(map.at({0.0, 40.0}).axial_mm, 0.2);
  EXPECT_TRUE(std::isfinite(map.at({500.0, -80.0}).lateral_mm));
}

/// @param size of everything: of the image's depth as well
void tracesADisc(double size, bool markerLeft, bool upsideDown) {
  const double radius_mm = 30.0 * size;
  const glm::dvec2 middle = size * glm::dvec2(12.0, 75.0);
  Probe probe = convex();
  probe.minDepth_mm = 10.0;
  probe.radius_mm *= size;
  Knobs knobs;
  knobs.depth_mm = 160.0 * size;
  knobs.markerLeft = markerLeft;
  knobs.upsideDown = upsideDown;
  const DisplayGeometry geometry = fitDisplay(probe, knobs, 600, 500);
  Image<std::uint8_t> image(600, 500);
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 600; ++x) viewOf(image).at(x, y) = glm::distance(geometry.probePoint_mm(x, y), middle) < radius_mm ? 30 : 140;
  std::vector<glm::dvec2> clicks;
  for (int n = 0; n < 8; ++n) {
    const double turn = 2.0 * std::numbers::pi * n / 8.0;
    clicks.push_back(middle + (radius_mm + (n % 2 == 0 ? 2.0 : -2.0) * size) * glm::dvec2(std::cos(turn), std::sin(turn)));
  }
  const auto outline = traceOnImage(viewOf(std::as_const(image)), geometry, clicks);
  ASSERT_TRUE(outline.has_value());
  const auto measured = measure({CaliperKind::trace, {{0, *outline}}});
  EXPECT_NEAR(measured->figure(FigureKind::circumference)->quantity.value, 2.0 * std::numbers::pi * radius_mm, 4.0 * size);
  for (const glm::dvec2& point : *outline) EXPECT_NEAR(glm::distance(point, middle), radius_mm, size);
}

TEST(OnImage, TracesTheSameOutlineHoweverTheImageIsTurned) {
  for (const bool markerLeft : {true, false})
    for (const bool upsideDown : {true, false}) tracesADisc(1.0, markerLeft, upsideDown);
}

TEST(OnImage, TracesSmallThingsAsWellAsLargeOnes) { tracesADisc(0.25, true, false); }

}  // namespace
}  // namespace ew::measurement
