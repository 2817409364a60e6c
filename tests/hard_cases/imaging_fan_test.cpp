// Hard cases of beam grids, fans and scan conversion; each test's name is the documented outcome.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "ew/imaging/scan_conversion.h"
#include "imaging/support/probes_at_random.h"

namespace ew::imaging_fan_test {
namespace {

constexpr ProbeKind kKinds[] = {ProbeKind::linear, ProbeKind::convex, ProbeKind::phased, ProbeKind::endocavity, ProbeKind::sweptSector};

std::size_t pixelsOf(const Spans& spans) {
  std::size_t pixels = 0;
  for (const auto& row : spans)
    for (const RowSpan& span : row) pixels += static_cast<std::size_t>(span.end - span.begin);
  return pixels;
}

/// Converts beams that end exactly where their memory ends, so that a sanitizer run sees a read beyond them.
GreyImage converted(const ScanConversionTable& table, float level) {
  const std::size_t count = static_cast<std::size_t>(table.lines) * static_cast<std::size_t>(table.samples);
  const std::unique_ptr<float[]> levels(new float[count]);
  std::fill_n(levels.get(), count, level);
  GreyImage image(table.width, table.height);
  scanConvert(table, {levels.get(), table.lines, table.samples, table.lines}, 0, table.height, viewOf(image));
  return image;
}

/// Every pixel in the fan shows a constant, and every tap has its four neighbours on the grid.
void expectFilled(const Probe& probe, const Knobs& knobs, const BeamGrid& grid, const DisplayGeometry& geometry) {
  const ScanConversionTable table = makeScanConversion(probe, knobs, grid, geometry);
  for (const auto& tap : table.taps) {
    ASSERT_LT(tap.first % static_cast<std::uint32_t>(table.lines) + 1, static_cast<std::uint32_t>(table.lines));
    ASSERT_LT(tap.first / static_cast<std::uint32_t>(table.lines) + 1, static_cast<std::uint32_t>(table.samples));
    ASSERT_LE(tap.lineWeight, 32768);
    ASSERT_LE(tap.sampleWeight, 32768);
  }
  const GreyImage image = converted(table, 77.0F);
  const auto filled = static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), 77));
  EXPECT_EQ(filled, pixelsOf(fanSpans(probe, knobs, geometry)));
}

TEST(HardFan, TwoLinesWithTwoSamplesFillTheWholeFan) {
  for (const ProbeKind kind : kKinds) {
    Probe probe = testing::probeOf(kind);
    probe.lines = 2;
    const DisplayGeometry geometry = fitDisplay(probe, {}, 200, 150);
    const BeamGrid grid = makeBeamGrid(probe, {}, geometry.depth_mm, 1e6);
    EXPECT_EQ(grid.samples, 2);
    EXPECT_EQ(grid.sampleSpacing_mm, geometry.depth_mm);
    expectFilled(probe, {}, grid, geometry);
  }
}

TEST(HardFan, FourThousandLinesKeepTheirPlaces) {
  for (const ProbeKind kind : kKinds) {
    Probe probe = testing::probeOf(kind);
    probe.lines = 4096;
    const DisplayGeometry geometry = fitDisplay(probe, {}, 200, 150);
    const BeamGrid grid = makeBeamGrid(probe, {}, geometry.depth_mm, 0.1);
    for (std::size_t n = 0; n < 4096; n += 273) {
      const glm::dvec2 p_mm = grid.lines[n].origin_mm + 50.0 * grid.lines[n].direction;
      EXPECT_NEAR(lineAndSampleAt(probe, {}, grid, p_mm).x, static_cast<double>(n), 1e-8);
    }
    expectFilled(probe, {}, grid, geometry);
  }
}

TEST(HardFan, AnImageOfOnePixelShowsTheMiddleOfTheFanOrNothing) {
  for (const ProbeKind kind : kKinds)
    for (const double zoom : {1.0, 8.0}) {
      const Probe probe = testing::probeOf(kind);
      const DisplayGeometry geometry = fitDisplay(probe, {.zoom = zoom}, 1, 1);
      expectFilled(probe, {}, makeBeamGrid(probe, {}, geometry.depth_mm, 0.5), geometry);
      EXPECT_EQ(pixelsOf(fanSpans(probe, {}, geometry)), 1U);
    }
}

TEST(HardFan, TheSmallestAndTheLargestDepthFillTheirFans) {
  for (const ProbeKind kind : kKinds)
    for (const double depth_mm : {1e-3, 1e6}) {
      const Probe probe = testing::probeOf(kind);
      const DisplayGeometry geometry = fitDisplay(probe, {.depth_mm = depth_mm}, 173, 140);
      EXPECT_EQ(geometry.depth_mm, depth_mm < 1.0 ? probe.minDepth_mm : probe.maxDepth_mm);
      expectFilled(probe, {}, makeBeamGrid(probe, {}, geometry.depth_mm, 0.3), geometry);
    }
}

TEST(HardFan, ZoomedInEightTimesRowsBesideTheFanAreEmptyAndTheOthersFilled) {
  for (const ProbeKind kind : kKinds)
    for (const bool upsideDown : {false, true}) {
      const Probe probe = testing::probeOf(kind);
      const Knobs knobs{.zoom = 8.0, .upsideDown = upsideDown};
      DisplayGeometry geometry = fitDisplay(probe, knobs, 160, 120);
      const BeamGrid grid = makeBeamGrid(probe, knobs, geometry.depth_mm, 0.3);
      expectFilled(probe, knobs, grid, geometry);
      geometry.face_px.y = upsideDown ? -50.0 : 170.0;  // the whole fan lies below (above) the image, but for the ends of its face
      expectFilled(probe, knobs, grid, geometry);
      geometry.face_px = {1e7, -1e7};
      EXPECT_EQ(pixelsOf(fanSpans(probe, knobs, geometry)), 0U);
      expectFilled(probe, knobs, grid, geometry);
    }
}

TEST(HardFan, SteeringBeyondItsLimitIsTheLimitAndWhatIsNoNumberIsNone) {
  Probe probe = testing::probeOf(ProbeKind::linear);
  probe.maxSteering_rad = 0.785;
  const auto geometryAt = [&](double steering_rad) { return fitDisplay(probe, {.steering_rad = steering_rad}, 150, 150); };
  EXPECT_EQ(geometryAt(7.0), geometryAt(0.785));
  EXPECT_EQ(geometryAt(-std::numeric_limits<double>::infinity()), geometryAt(0.0));
  EXPECT_EQ(geometryAt(std::nan("")), geometryAt(0.0));
  for (const double steering_rad : {-7.0, -0.785, 0.785, 7.0, std::nan("")}) {
    const Knobs knobs{.steering_rad = steering_rad};
    const DisplayGeometry geometry = geometryAt(steering_rad);
    expectFilled(probe, knobs, makeBeamGrid(probe, knobs, geometry.depth_mm, 0.3), geometry);
  }
}

TEST(HardFan, ATrapezoidOfAProbeThatHasNoneIsARectangle) {
  Probe probe = testing::probeOf(ProbeKind::linear);
  probe.trapezoidHalfAngle_rad = 0.0;
  EXPECT_EQ(makeBeamGrid(probe, {.trapezoid = true}, 60.0, 0.3), makeBeamGrid(probe, {}, 60.0, 0.3));
  EXPECT_EQ(fanOutline_mm(probe, {.trapezoid = true}, 60.0), fanOutline_mm(probe, {}, 60.0));
  // A sector has neither.
  const Probe convex = testing::probeOf(ProbeKind::convex);
  EXPECT_EQ(makeBeamGrid(convex, {.steering_rad = 0.3, .trapezoid = true}, 60.0, 0.3), makeBeamGrid(convex, {}, 60.0, 0.3));
}

TEST(HardFan, ThePixelWhereAllLinesOfAPhasedArrayMeetShowsTheMiddleLine) {
  const Probe probe = testing::probeOf(ProbeKind::phased);
  DisplayGeometry geometry = fitDisplay(probe, {}, 101, 90);
  geometry.face_px = {50.0, 10.0};
  const BeamGrid grid = makeBeamGrid(probe, {}, geometry.depth_mm, 0.5);
  EXPECT_EQ(lineAndSampleAt(probe, {}, grid, glm::dvec2(0.0)), glm::dvec2(0.5 * (probe.lines - 1), 0.0));
  EXPECT_EQ(fanSpans(probe, {}, geometry)[10], (std::vector<RowSpan>{{50, 51}}));
  EXPECT_TRUE(fanSpans(probe, {}, geometry)[9].empty());
  expectFilled(probe, {}, grid, geometry);
}

TEST(HardFan, PointsBehindTheApexLieOutsideTheGrid) {
  for (const ProbeKind kind : kKinds)
    for (const bool trapezoid : {false, true}) {
      const Probe probe = testing::probeOf(kind);
      const Knobs knobs{.trapezoid = trapezoid};
      const BeamGrid grid = makeBeamGrid(probe, knobs, 100.0, 0.5);
      for (const double y_mm : {-20.0, -94.08, -94.1, -200.0, -1e5})
        for (const double x_mm : {-300.0, -1e-3, 0.0, 1e-3, 300.0}) {
          const glm::dvec2 at = lineAndSampleAt(probe, knobs, grid, {x_mm, y_mm});
          const bool inside = at.x >= 0.0 && at.x <= probe.lines - 1 && at.y >= 0.0 && at.y <= grid.samples - 1;
          // The ends of a wide convex face lie behind its middle.
          if (kind == ProbeKind::linear || kind == ProbeKind::phased || y_mm < -probe.radius_mm) {
            EXPECT_FALSE(inside) << x_mm << ' ' << y_mm;
          }
        }
    }
}

}  // namespace
}  // namespace ew::imaging_fan_test
