#include "ew/imaging/box_zoom.h"

#include <gtest/gtest.h>

#include <random>

namespace ew {
namespace {

Probe convex() {
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.55;
  probe.minDepth_mm = 30.0;
  probe.maxDepth_mm = 250.0;
  probe.defaultDepth_mm = 150.0;
  return probe;
}

glm::dvec2 pixelOf(const DisplayGeometry& shown, glm::dvec2 p_mm) {
  return shown.face_px + glm::dvec2(shown.markerLeft ? -p_mm.x : p_mm.x, shown.upsideDown ? -p_mm.y : p_mm.y) / shown.pixel_mm;
}

glm::dvec2 pointOf(const DisplayGeometry& shown, glm::dvec2 at_px) {
  const glm::dvec2 from_mm = (at_px - shown.face_px) * shown.pixel_mm;
  return {shown.markerLeft ? -from_mm.x : from_mm.x, shown.upsideDown ? -from_mm.y : from_mm.y};
}

TEST(BoxZoom, FillsTheImageWithTheBox) {
  const Probe probe = convex();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.3, 0.7);
  for (int n = 0; n < 200; ++n) {
    Knobs knobs;
    knobs.markerLeft = n % 2 == 0;
    knobs.upsideDown = n % 3 == 0;
    const DisplayGeometry whole = fitDisplay(probe, knobs, 700, 520);
    const glm::dvec2 a(700.0 * share(random), 520.0 * share(random)), b = a + glm::dvec2(95.0 + n % 7, n % 5 == 0 ? 40.0 : 80.0);
    const Detail detail = detailOfBox(whole, {}, n % 4 < 2 ? a : b, n % 4 < 2 ? b : a);
    EXPECT_NEAR(detail.zoom, std::min(700.0 / (b.x - a.x), 520.0 / (b.y - a.y)), 1e-9);
    knobs.zoom = detail.zoom;
    const DisplayGeometry shown = fitDisplay(probe, knobs, 700, 520, detail.pan);
    const glm::dvec2 first = pixelOf(shown, pointOf(whole, a)), second = pixelOf(shown, pointOf(whole, b));
    // Sideways the image is panned in whole pixels.
    EXPECT_NEAR(0.5 * (first.x + second.x), 349.5, 0.51);
    EXPECT_NEAR(0.5 * (first.y + second.y), 259.5, 0.01);
    EXPECT_NEAR(std::max(std::abs(second.x - first.x) / 700.0, std::abs(second.y - first.y) / 520.0), 1.0, 1e-6);
    // A box in the detail goes on from there.
    const Detail deeper = detailOfBox(shown, {knobs.zoom, panWithinFan(probe, knobs, detail.pan)}, {300.0, 240.0}, {650.0, 500.0});
    Knobs closer = knobs;
    closer.zoom = deeper.zoom;
    if (deeper.zoom < kLargestZoom) {
      const DisplayGeometry there = fitDisplay(probe, closer, 700, 520, deeper.pan);
      EXPECT_NEAR(pixelOf(there, pointOf(shown, {475.0, 370.0})).x, 349.5, 1.1);
      EXPECT_NEAR(pixelOf(there, pointOf(shown, {475.0, 370.0})).y, 259.5, 0.01);
    }
  }
}

TEST(BoxZoom, GoesNoCloserThanTheLargestZoom) {
  const DisplayGeometry whole = fitDisplay(convex(), {}, 700, 520);
  EXPECT_EQ(detailOfBox(whole, {}, {300.0, 200.0}, {301.0, 202.0}).zoom, kLargestZoom);
  EXPECT_EQ(detailOfBox(whole, {8.0, {}}, {0.0, 0.0}, {350.0, 200.0}).zoom, kLargestZoom);
  EXPECT_EQ(detailOfBox(whole, {2.0, {}}, {-100.0, -100.0}, {900.0, 900.0}).zoom, 2.0) << "a box never makes the image smaller";
}

}  // namespace
}  // namespace ew
