#include "ew/measurement/strip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "ew/imaging/resolution.h"

namespace ew::measurement::strip_test {
namespace {

constexpr int kWidth = 400, kHeight = 201;
constexpr double kSweep_s = 4.0, kDepth_mm = 160.0;  // a column is 10 ms, a row 0.8 mm

/// A strip with a beam every `interval_s`, from `from_s` on.
MModeStrip stripOf(double from_s, double interval_s, int beams) {
  MModeStrip strip;
  strip.configure(kWidth, kHeight, kSweep_s);
  const std::vector<std::uint8_t> beam(64, 90);
  for (int n = 0; n < beams; ++n) strip.add(from_s + interval_s * n, beam);
  return strip;
}

double valueOf(CaliperKind kind, std::vector<glm::dvec2> points, int cycles = 1) {
  return measure({kind, {{0, std::move(points)}}, cycles})->figures.front().quantity.value;
}

TEST(Strip, PixelsAreMomentsAndDepths) {
  const MModeStrip strip = stripOf(7.0, 0.05, 21);  // 7 to 8 s: columns 0 to 100
  const StripPlane plane(strip, kDepth_mm);
  EXPECT_EQ(plane.pointAt({0.0, 0.0}), glm::dvec2(7.0, 0.0));
  EXPECT_NEAR(plane.pointAt({60.0, 200.0})->x, 7.6, 1e-12);
  EXPECT_NEAR(plane.pointAt({60.0, 200.0})->y, kDepth_mm, 1e-12);
  EXPECT_NEAR(plane.pointAt({60.2, 100.0})->x, 7.6, 1e-12);  // a column is one moment
  EXPECT_FALSE(plane.pointAt({102.0, 50.0}));                // nothing there yet
  EXPECT_NEAR(plane.pixelOf({7.6, 80.0})->x, 60.0, 1e-9);
  EXPECT_NEAR(plane.pixelOf({7.6, 80.0})->y, 100.0, 1e-9);
  EXPECT_FALSE(plane.pixelOf({6.5, 80.0}));
  EXPECT_NEAR(plane.mmPerS(), 80.0, 1e-12);
}

TEST(Strip, EchoesStayInTheirColumnUntilTheBeamHasGoneRoundAndThenAreNotThere) {
  MModeStrip strip = stripOf(0.0, 0.01, 200);
  const double moment_s = 0.5;
  const double column = *strip.columnOf(moment_s);
  const std::vector<std::uint8_t> beam(64, 90);
  int shown = 0;
  for (int n = 200; n < 800; ++n) {
    strip.add(0.01 * n, beam);
    const auto now = strip.columnOf(moment_s);
    if (now) {
      EXPECT_NEAR(*now, column, 1e-9);
      ++shown;
    }
    EXPECT_EQ(now.has_value(), strip.timeOf(static_cast<int>(column)).value_or(9.0) < 1.0) << n;
  }
  // Until the seam comes to its column, 394 columns later; 149 of them had passed, and that one is black.
  EXPECT_EQ(shown, kWidth - 6 - 150);
}

RC_GTEST_PROP(Strip, AColumnsMomentIsInThatColumnHoweverOftenTheBeamWentRound, ()) {
  const double interval_s = 0.001 * *rc::gen::inRange(3, 80);
  const MModeStrip strip = stripOf(100.0 + 0.001 * *rc::gen::inRange(0, 1000), interval_s, *rc::gen::inRange(1, 900));
  int drawn = 0;
  for (int column = 0; column < kWidth; ++column) {
    const auto time_s = strip.timeOf(column);
    if (!time_s) continue;
    ++drawn;
    const auto back = strip.columnOf(*time_s);
    RC_ASSERT(back.has_value());
    RC_ASSERT(std::abs(*back - column) < 1e-6);
  }
  RC_ASSERT(drawn >= 1 && drawn <= kWidth - 6);
}

TEST(Strip, TimeIsAsSureAsColumnAndBeamsAndDepthAsRowAndPulse) {
  const MModeStrip strip = stripOf(0.0, 0.04, 60);
  EXPECT_NEAR(strip.beamInterval_s(1.0), 0.04, 1e-6);
  Probe probe;
  probe.kind = ProbeKind::convex;
  probe.radius_mm = 60.0;
  probe.halfAngle_rad = 0.55;
  probe.carrier_hz = 3.5e6;
  probe.maxDepth_mm = 240.0;
  Knobs knobs;
  knobs.depth_mm = kDepth_mm;
  DisplayGeometry geometry;
  geometry.depth_mm = kDepth_mm;
  const UncertaintyAt at = uncertaintyInStrip(probe, knobs, {}, geometry, strip);
  const double moment_s = std::hypot(0.01, 0.04) / std::sqrt(12.0);
  const auto time = measure({CaliperKind::interval, {{0, {{0.5, 40.0}, {2.0, 60.0}}}}}, at);
  ASSERT_EQ(time->figures.size(), 1U);
  EXPECT_NEAR(time->figures[0].quantity.value, 1.5, 1e-12);
  EXPECT_NEAR(time->figures[0].quantity.uncertainty, std::sqrt(2.0) * moment_s, 1e-6);
  // Over three beats the same cursors are three times as sure of one.
  const auto one = measure({CaliperKind::heartRate, {{0, {{0.5, 40.0}, {1.0, 60.0}}}}, 1}, at);
  const auto three = measure({CaliperKind::heartRate, {{0, {{0.5, 40.0}, {2.0, 60.0}}}}, 3}, at);
  EXPECT_NEAR(one->figures[0].quantity.value, 120.0, 1e-9);
  EXPECT_NEAR(three->figures[0].quantity.value, 120.0, 1e-9);
  EXPECT_NEAR(one->figures[0].quantity.uncertainty, 120.0 / 0.5 * std::sqrt(2.0) * moment_s, 1e-4);
  EXPECT_NEAR(three->figures[0].quantity.uncertainty, one->figures[0].quantity.uncertainty / 3.0, 1e-6);
  const auto depth = measure({CaliperKind::depthDistance, {{0, {{0.5, 40.0}, {2.0, 60.0}}}}}, at);
  const double axial_mm = ResolutionMap(probe, knobs, {}, kDepth_mm).at({0.0, 50.0}).axial_mm;
  EXPECT_NEAR(depth->figures[0].quantity.value, 20.0, 1e-12);
  EXPECT_NEAR(depth->figures[0].quantity.uncertainty, std::sqrt(2.0) * std::hypot(0.8 / std::sqrt(12.0), edgeDeviation_mm(axial_mm)), 0.02);
}

RC_GTEST_PROP(StripCalipers, DoNotDependOnWhenTheyAreAndInWhichOrderTheyAreSet, ()) {
  const double t = 0.001 * *rc::gen::inRange(1, 5000), later = 0.5 * *rc::gen::inRange(0, 4000);
  const double a = 0.01 * *rc::gen::inRange(0, 9000), b = 100.0 + 0.01 * *rc::gen::inRange(0, 9000);
  const int beats = *rc::gen::inRange(1, kMostCycles + 1);
  const glm::dvec2 p(2.0, a), q(2.0 + t, b), shift(later, 0.0);
  for (const CaliperKind kind : {CaliperKind::interval, CaliperKind::heartRate, CaliperKind::slope, CaliperKind::depthDistance}) {
    const double value = valueOf(kind, {p, q}, beats);
    RC_ASSERT(std::abs(valueOf(kind, {q, p}, beats) - value) <= 1e-9 * std::abs(value));
    RC_ASSERT(std::abs(valueOf(kind, {p + shift, q + shift}, beats) - value) <= 1e-6 * std::abs(value));
  }
  RC_ASSERT(std::abs(valueOf(CaliperKind::heartRate, {p, q}, beats) * valueOf(CaliperKind::interval, {p, q}) - 60.0 * beats) <
            1e-6 * beats * 60.0);
  RC_ASSERT(std::abs(valueOf(CaliperKind::slope, {p, q}) * t - (b - a)) < 1e-6);
}

TEST(StripCalipers, SayWhatCannotBeMeasured) {
  EXPECT_EQ(measure({CaliperKind::depthDistance, {{0, {{1.0, 5.0}, {2.0, 5.0}}}}}).error().sentence(),
            "Both points lie at the same depth; move one of them.");
  EXPECT_EQ(measure({CaliperKind::interval, {{0, {{1.0, 5.0}, {1.0, 9.0}}}}}).error().sentence(),
            "Both points lie at the same moment; move one of them.");
}

}  // namespace
}  // namespace ew::measurement::strip_test
