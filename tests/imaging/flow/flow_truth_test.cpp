#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ew/imaging/flow_field.h"

namespace ew::flow_truth_test {
namespace {

using std::numbers::pi;

constexpr double kRadius_mm = 3.0;
constexpr double kFlow_mm3PerS = 6000.0;  // 360 ml/min

FlowStream straightStream() {
  FlowStream stream;
  stream.name = "straight";
  for (int n = 0; n <= 20; ++n) stream.line.push_back({.place_mm = {0.0, 0.0, 5.0 * n}, .radius_mm = kRadius_mm});
  stream.flow_mm3PerS = kFlow_mm3PerS;
  return stream;
}

/// Of a common carotid, made up: a rise, a notch, and a fall.
FlowWave carotidWave() {
  return waveThrough(
      {0.62, 0.60, 0.95, 2.10, 2.35, 1.75, 1.40, 1.15, 0.95, 1.10, 1.00, 0.90, 0.82, 0.76, 0.72, 0.70, 0.68, 0.66, 0.65, 0.64}, 8);
}

FlowField fieldOf(const FlowStream& stream) {
  FlowField field;
  field.rhythms.pulse = BodyRhythm{.period_s = 0.86, .variation = 0.0};
  field.streams = {stream};
  return field;
}

/// Narrowed to half of its radius at 40 mm, opening again within 4 mm, with a jet that fills the vessel after 30 mm.
FlowStream narrowedStream() {
  FlowStream stream = straightStream();
  stream.line.clear();
  for (int n = 0; n <= 400; ++n) {
    const double z = 0.25 * n;
    const double narrowed = 0.5 * std::exp(-std::pow((z - 40.0) / 4.0, 2.0));
    const double radius_mm = kRadius_mm * (1.0 - narrowed);
    double jet = 1.0;
    if (z > 36.0 && z < 72.0) jet = std::min(0.95, 0.5 * kRadius_mm / radius_mm + std::max(0.0, z - 42.0) / 60.0);
    stream.line.push_back(
        {.place_mm = {0.0, 0.0, z}, .radius_mm = radius_mm, .jet = jet, .backflow = jet < 0.95 ? 0.12 : 0.0, .turbulence = 0.0});
  }
  return stream;
}

/// Flow through a section across z, by rings.
double flowAcross_mm3PerS(const FlowTruth& truth, double z_mm, double radius_mm, double time_s) {
  constexpr int kRings = 400;
  double flow = 0.0;
  for (int n = 0; n < kRings; ++n) {
    const double r = radius_mm * (n + 0.5) / kRings, turn = 2.399963 * n;
    flow += 2.0 * pi * r * radius_mm / kRings * truth.at({r * std::cos(turn), r * std::sin(turn), z_mm}, time_s).mean_mmPerS.z;
  }
  return flow;
}

TEST(FlowTruth, IsAParabolaWithoutABeat) {
  FlowField field = fieldOf(straightStream());
  field.rhythms.pulse.reset();
  const FlowTruth truth(field);
  const double mean = kFlow_mm3PerS / (pi * kRadius_mm * kRadius_mm);
  EXPECT_NEAR(truth.at({0.0, 0.0, 50.0}, 3.0).mean_mmPerS.z, 2.0 * mean, 1e-9);
  EXPECT_NEAR(truth.at({0.0, 1.5, 50.0}, 3.0).mean_mmPerS.z, 1.5 * mean, 1e-9);
  EXPECT_EQ(truth.at({0.0, 1.5, 50.0}, 3.0).stream, 0);
}

TEST(FlowTruth, BluntsTheSteadyProfileAndKeepsItsFlow) {
  FlowStream stream = straightStream();
  stream.bluntness = 9.0;
  FlowField field = fieldOf(stream);
  field.rhythms.pulse.reset();
  const FlowTruth truth(field);
  const double mean = kFlow_mm3PerS / (pi * kRadius_mm * kRadius_mm);
  EXPECT_NEAR(truth.at({0.0, 0.0, 50.0}, 0.0).mean_mmPerS.z, 11.0 / 9.0 * mean, 1e-9);
  EXPECT_NEAR(flowAcross_mm3PerS(truth, 50.0, kRadius_mm, 0.0), kFlow_mm3PerS, 2e-4 * kFlow_mm3PerS);
}

TEST(FlowTruth, PassesTheSameFlowThroughEverySectionAtEveryTime) {
  FlowStream stream = narrowedStream();
  stream.wave = carotidWave();
  const FlowTruth truth(fieldOf(stream));
  for (const double time_s : {0.0, 0.12, 0.2, 0.45, 0.8})
    for (const double z_mm : {10.0, 38.1, 40.0, 45.0, 55.0, 90.0}) {
      const auto section = truth.sectionNear(0, {0.0, 0.0, z_mm}, time_s);
      ASSERT_TRUE(section);
      const double expected = truth.flowThrough_mm3PerS(0, z_mm, time_s);
      EXPECT_NEAR(section->flow_mm3PerS, expected, 1e-9 * std::abs(expected));
      EXPECT_NEAR(flowAcross_mm3PerS(truth, z_mm, section->radius_mm, time_s), expected, 3e-3 * kFlow_mm3PerS) << z_mm << ", " << time_s;
    }
}

TEST(FlowTruth, IsFasterInAStenosisByContinuity) {
  FlowField field = fieldOf(narrowedStream());
  field.rhythms.pulse.reset();
  const FlowTruth truth(field);
  const auto before = truth.sectionNear(0, {0.0, 0.0, 10.0}, 0.0), throat = truth.sectionNear(0, {0.0, 0.0, 40.0}, 0.0);
  ASSERT_TRUE(before && throat);
  EXPECT_NEAR(throat->mean_mmPerS / before->mean_mmPerS, 4.0, 1e-6) << "half of the diameter";
}

TEST(FlowTruth, TurnsBackBesideAJet) {
  FlowField field = fieldOf(narrowedStream());
  field.rhythms.pulse.reset();
  const FlowTruth truth(field);
  EXPECT_LT(truth.at({2.4, 0.0, 48.0}, 0.0).mean_mmPerS.z, 0.0);
  const auto jet = truth.at({0.0, 0.0, 48.0}, 0.0), before = truth.at({0.0, 0.0, 10.0}, 0.0);
  EXPECT_GT(jet.mean_mmPerS.z, 1.5 * before.mean_mmPerS.z) << "the jet goes on behind the stenosis";
  EXPECT_GT(truth.at({2.4, 0.0, 80.0}, 0.0).mean_mmPerS.z, 0.0) << "and the ring ends with it";
}

/// By central differences, per radius of the fastest velocity.
double divergence(const FlowTruth& truth, const glm::dvec3& p_mm, double time_s) {
  const double step = 1e-4;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 shift(0.0);
    shift[axis] = step;
    sum += (truth.at(p_mm + shift, time_s).mean_mmPerS[axis] - truth.at(p_mm - shift, time_s).mean_mmPerS[axis]) / (2.0 * step);
  }
  return sum;
}

TEST(FlowTruth, NeitherMakesNorLosesBlood) {
  FlowStream stream = narrowedStream();
  stream.wave = carotidWave();
  const FlowTruth truth(fieldOf(stream));
  const double scale = truth.at({0.0, 0.0, 40.1}, 0.2).mean_mmPerS.z / kRadius_mm;
  // Between nodes, where line and radius are straight.
  for (const double z_mm : {33.12, 38.12, 41.12, 44.12, 50.12, 60.12, 71.12})
    for (const double y : {0.1, 0.4, 0.7, 0.9}) {
      const auto section = truth.sectionNear(0, {0.0, 0.0, z_mm}, 0.2);
      const double r = y * section->radius_mm;
      EXPECT_NEAR(divergence(truth, {0.6 * r, 0.8 * r, z_mm}, 0.2) / scale, 0.0, 2e-5) << z_mm << ", " << y;
    }
}

TEST(FlowTruth, FollowsTheWallAndStandsStillAtIt) {
  FlowField field = fieldOf(narrowedStream());
  field.rhythms.pulse.reset();
  const FlowTruth truth(field);
  const auto section = truth.sectionNear(0, {0.0, 0.0, 37.12}, 0.0);
  const double r = 0.9999 * section->radius_mm;
  EXPECT_LT(glm::length(truth.at({r, 0.0, 37.12}, 0.0).mean_mmPerS), 2e-3 * section->greatest_mmPerS());
  // Where it narrows without a jet, blood goes in along the wall's slope.
  const auto early = truth.sectionNear(0, {0.0, 0.0, 34.12}, 0.0), later = truth.sectionNear(0, {0.0, 0.0, 34.20}, 0.0);
  const glm::dvec3 blood = truth.at({0.8 * early->radius_mm, 0.0, 34.12}, 0.0).mean_mmPerS;
  EXPECT_NEAR(blood.x / blood.z, 0.8 * (later->radius_mm - early->radius_mm) / 0.08, 1e-3);
}

TEST(FlowTruth, RunsAsAWaveAlongTheLine) {
  FlowStream stream = straightStream();
  stream.wave = carotidWave();
  stream.pulseWave_mmPerS = 5000.0;
  stream.delay_s = 0.05;
  const FlowTruth truth(fieldOf(stream));
  for (const double time_s : {0.1, 0.33, 0.7})
    EXPECT_NEAR(truth.flowThrough_mm3PerS(0, 100.0, time_s + 0.02), truth.flowThrough_mm3PerS(0, 0.0, time_s), 1e-6);
  FlowStream early = stream;
  early.delay_s = 0.0;
  EXPECT_NEAR(FlowTruth(fieldOf(early)).flowThrough_mm3PerS(0, 0.0, 0.3), truth.flowThrough_mm3PerS(0, 0.0, 0.35), 1e-6);
}

TEST(FlowTruth, IsMoreWithTheBreathThatDrawsIt) {
  FlowStream stream = straightStream();
  stream.breathShare = 0.4;
  FlowField field = fieldOf(stream);
  field.rhythms.breathing = BodyRhythms::Breathing{};
  const FlowTruth truth(field);
  const double inspired_s = 0.5 * 0.7 * 4.0;  // the middle of the moving part of a breath
  EXPECT_NEAR(truth.flowThrough_mm3PerS(0, 0.0, inspired_s), 1.4 * kFlow_mm3PerS, 1e-6);
  EXPECT_NEAR(truth.flowThrough_mm3PerS(0, 0.0, 3.9), kFlow_mm3PerS, 1e-6);
}

TEST(FlowTruth, GivesAPlaceToTheVesselInWhichItLiesDeepest) {
  FlowStream wide = straightStream(), thin = straightStream();
  for (FlowNode& node : thin.line) node = {.place_mm = node.place_mm + glm::dvec3(3.4, 0.0, 0.0), .radius_mm = 1.0};
  FlowField field = fieldOf(wide);
  field.streams.push_back(thin);
  const FlowTruth truth(field);
  EXPECT_EQ(truth.at({2.3, 0.0, 50.0}, 0.0).stream, 0);
  EXPECT_EQ(truth.at({2.9, 0.0, 50.0}, 0.0).stream, 1);
  EXPECT_EQ(truth.at({4.5, 0.0, 50.0}, 0.0).stream, -1);
  EXPECT_EQ(truth.at({0.0, 0.0, -0.1}, 0.0).stream, -1) << "before its beginning";
}

TEST(FlowTruth, StaysFiniteForStreamsThatAreNone) {
  FlowStream point = straightStream(), still = straightStream(), folded = straightStream();
  point.line = {{.place_mm = {1.0, 2.0, 3.0}}, {.place_mm = {1.0, 2.0, 3.0}}};
  for (FlowNode& node : still.line) node.radius_mm = 0.0;
  folded.line = {{.place_mm = {0.0, 0.0, 0.0}}, {.place_mm = {0.0, 0.0, 5.0}}, {.place_mm = {0.0, 0.0, 0.0}}};
  FlowField field = fieldOf(point);
  field.streams.push_back(still);
  field.streams.push_back(folded);
  const FlowTruth truth(field);
  EXPECT_EQ(truth.at({1.0, 2.0, 3.0}, 0.0).stream, -1);
  EXPECT_FALSE(truth.sectionNear(1, {0.0, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(std::isfinite(glm::length(truth.at({0.2, 0.0, 4.999}, 0.0).mean_mmPerS)));
  EXPECT_EQ(truth.at(glm::dvec3(std::numeric_limits<double>::quiet_NaN()), 0.0).stream, -1);
  EXPECT_EQ(truth.flowThrough_mm3PerS(7, 0.0, 0.0), 0.0);
}

TEST(FlowWave, GoesThroughTheSamplesItIsMadeOf) {
  const std::vector<double> samples = {1.0, 3.0, 2.0, 1.5, 0.5, -0.5, 0.25};
  const FlowWave wave = waveThrough(samples, 16);
  ASSERT_EQ(wave.harmonics.size(), 3u) << "seven samples know three";
  for (std::size_t n = 0; n < samples.size(); ++n) EXPECT_NEAR(flowAtPhase(wave, static_cast<double>(n) / 7.0), samples[n], 1e-12);
  EXPECT_EQ(waveThrough({}, 4).mean, 0.0);
}

}  // namespace
}  // namespace ew::flow_truth_test
