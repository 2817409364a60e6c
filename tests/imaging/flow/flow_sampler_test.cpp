#include "ew/imaging/flow_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace ew::flow_sampler_test {
namespace {

FlowWave carotidWave() {
  return waveThrough(
      {0.62, 0.60, 0.95, 2.10, 2.35, 1.75, 1.40, 1.15, 0.95, 1.10, 1.00, 0.90, 0.82, 0.76, 0.72, 0.70, 0.68, 0.66, 0.65, 0.64}, 8);
}

/// A vessel on an arc, narrowed half way, with a jet; beside it a straight one that crosses its end.
FlowField twoVessels(double variation = 0.1) {
  FlowField field;
  field.rhythms.pulse = BodyRhythm{.period_s = 0.86, .variation = variation};
  field.rhythms.breathing = BodyRhythms::Breathing{};
  FlowStream bent;
  bent.name = "bent";
  for (int n = 0; n <= 120; ++n) {
    const double turn = 0.012 * n, z = 0.6 * n, narrow = 0.5 * std::exp(-std::pow((z - 30.0) / 4.0, 2.0));
    const double radius_mm = 3.0 * (1.0 - narrow);
    FlowNode node{.place_mm = {50.0 * std::cos(turn), 50.0 * std::sin(turn), 3.0 * std::sin(2.0 * turn)}, .radius_mm = radius_mm};
    if (z > 26.0 && z < 56.0) {
      node.jet = std::min(0.95, 1.5 / radius_mm + std::max(0.0, z - 32.0) / 50.0);
      node.backflow = node.jet < 0.95 ? 0.1 : 0.0;
      node.turbulence = 0.1;
    }
    bent.line.push_back(node);
  }
  bent.flow_mm3PerS = 6000.0;
  bent.wave = carotidWave();
  bent.pulseWave_mmPerS = 6000.0;
  bent.delay_s = 0.04;
  FlowStream vein;
  vein.name = "vein";
  for (int n = 0; n <= 10; ++n) vein.line.push_back({.place_mm = {48.0, 4.0 * n, -6.0}, .radius_mm = 4.0});
  vein.flow_mm3PerS = -9000.0;
  vein.breathShare = 0.5;
  field.streams = {bent, vein};
  return field;
}

TEST(FlowSampler, SaysWhatTheTruthSaysWithinAHundredth) {
  const FlowField field = twoVessels();
  const FlowTruth truth(field);
  const FlowSampler sampler(field);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(20.0, 58.0), y(-5.0, 52.0), z(-11.0, 8.0), when(-3.0, 40.0);
  FlowMoment moment;
  int met[2] = {0, 0};
  for (int round = 0; round < 40; ++round) {
    const double time_s = when(random);
    sampler.prepare(time_s, moment);
    for (int n = 0; n < 400; ++n) {
      const double px = x(random), py = y(random);
      const glm::dvec3 p_mm(px, py, z(random));
      const BloodVelocity exact = truth.at(p_mm, time_s), found = sampler.at(moment, p_mm);
      ASSERT_EQ(found.stream, exact.stream) << "at " << p_mm.x << " " << p_mm.y << " " << p_mm.z;
      if (exact.stream < 0) continue;
      ++met[exact.stream];
      const double greatest = std::abs(truth.sectionNear(exact.stream, p_mm, time_s)->greatest_mmPerS());
      EXPECT_LT(glm::length(found.mean_mmPerS - exact.mean_mmPerS), 0.01 * greatest + 0.5);
      EXPECT_NEAR(found.turbulence_mmPerS, exact.turbulence_mmPerS, 0.01 * exact.turbulence_mmPerS + 0.01);
    }
  }
  EXPECT_GT(met[0], 200);
  EXPECT_GT(met[1], 200);
}

TEST(FlowSampler, SharesOneTableAmongVesselsThatAreNearlyAsWide) {
  FlowField one = twoVessels(), many = one;
  for (int n = 0; n < 20; ++n) {
    FlowStream copy = one.streams[0];
    for (FlowNode& node : copy.line) node.place_mm.z += 20.0 * (n + 1);
    many.streams.push_back(copy);
  }
  const std::size_t alone = FlowSampler(one).bytes(), together = FlowSampler(many).bytes();
  EXPECT_LT(together, 12 * alone) << "twenty-one times the vessels";
}

TEST(FlowSampler, AllocatesNothingForItsSecondMoment) {
  const FlowSampler sampler(twoVessels());
  FlowMoment moment;
  sampler.prepare(0.0, moment);
  const auto* streams = moment.streams.data();
  sampler.prepare(0.4, moment);
  EXPECT_EQ(moment.streams.data(), streams);
}

TEST(FlowSampler, HasNoBloodWhereThereIsNone) {
  const FlowSampler none{FlowField{}};
  FlowMoment moment;
  none.prepare(1.0, moment);
  EXPECT_EQ(none.at(moment, {0.0, 0.0, 0.0}).stream, -1);
  EXPECT_GT(none.bounds().lowest_mm.x, none.bounds().highest_mm.x);

  const FlowSampler sampler(twoVessels());
  sampler.prepare(std::numeric_limits<double>::quiet_NaN(), moment);
  EXPECT_EQ(sampler.at(moment, {1e9, 0.0, 0.0}).stream, -1);
  EXPECT_EQ(sampler.at(moment, glm::dvec3(std::numeric_limits<double>::quiet_NaN())).stream, -1);
  EXPECT_TRUE(std::isfinite(glm::length(sampler.at(moment, {50.0, 0.0, 0.0}).mean_mmPerS)));
}

}  // namespace
}  // namespace ew::flow_sampler_test
