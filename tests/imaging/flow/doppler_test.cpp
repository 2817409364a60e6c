#include "ew/imaging/doppler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace ew::doppler_test {
namespace {

using std::numbers::pi;
using Packet = std::vector<std::complex<float>>;

Packet toneOf(int samples, double velocity) {
  Packet packet;
  for (int n = 0; n < samples; ++n) packet.emplace_back(std::polar(1.0, 0.7 + pi * velocity * n));
  return packet;
}

/// Packets of a source with noise, filtered or not, and what is estimated of them.
struct Spread {
  double mean = 0.0, deviation = 0.0, fading = 0.0;  ///< fading: standard deviation over mean of r0
};
Spread estimates(int samples, double velocity, double spread, double noiseToSignal, const WallFilter* filter = nullptr) {
  const PacketSource source(samples);
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0.0F, std::sqrt(0.5F));
  Packet white(static_cast<std::size_t>(samples)), packet(white.size());
  const auto noise = static_cast<float>(std::sqrt(noiseToSignal));
  constexpr int kPackets = 20000;
  double sum = 0.0, squares = 0.0, power = 0.0, power2 = 0.0;
  for (int n = 0; n < kPackets; ++n) {
    for (auto& each : white) each = {normal(random), normal(random)};
    source.make(velocity, spread, white, packet);
    for (auto& each : packet) each += noise * std::complex<float>(normal(random), normal(random));
    if (filter) filter->apply(packet);
    const PacketSums sums = sumsOf(packet);
    // About the true velocity, so that those that went around count as near.
    const double off = meanVelocity({sums.r0, sums.r1 * std::polar(1.0, -pi * velocity)});
    sum += off;
    squares += off * off;
    power += sums.r0;
    power2 += sums.r0 * sums.r0;
  }
  Spread found{sum / kPackets, 0.0, 0.0};
  found.deviation = std::sqrt(squares / kPackets - found.mean * found.mean);
  const double mean = power / kPackets;
  found.fading = std::sqrt(power2 / kPackets - mean * mean) / mean;
  return found;
}

TEST(Doppler, HasTheNyquistVelocitiesOfTheTables) {
  EXPECT_NEAR(nyquist_mmPerS(3000.0, 2.5e6), 462.0, 0.1);
  EXPECT_NEAR(nyquist_mmPerS(4000.0, 3.5e6), 440.0, 0.1);
  EXPECT_NEAR(nyquist_mmPerS(4000.0, 5e6), 308.0, 0.1);
  EXPECT_NEAR(nyquist_mmPerS(8000.0, 5e6), 616.0, 0.1);
  EXPECT_NEAR(nyquist_mmPerS(6000.0, 7.5e6), 308.0, 0.1);
}

TEST(Doppler, AliasesExactlyAtTheScale) {
  EXPECT_NEAR(aliased_mmPerS(400.0, 308.0), -216.0, 1e-9);
  EXPECT_NEAR(aliased_mmPerS(307.9, 308.0), 307.9, 1e-9);
  EXPECT_NEAR(aliased_mmPerS(308.0, 308.0), -308.0, 1e-9);
  EXPECT_NEAR(aliased_mmPerS(-308.0, 308.0), -308.0, 1e-9);
  EXPECT_NEAR(aliased_mmPerS(5.0 * 616.0 + 10.0, 308.0), 10.0, 1e-9);
}

TEST(Doppler, ReadsATonesVelocityAndNoSpread) {
  for (const int samples : {2, 8, 16})
    for (const double velocity : {-0.99, -0.3, 0.0, 0.25, 0.99}) {
      const PacketSums sums = sumsOf(toneOf(samples, velocity));
      EXPECT_NEAR(meanVelocity(sums), velocity, 1e-6);
      EXPECT_NEAR(velocitySpread(sums), 0.0, 2e-3) << "each sum divided by its own count";
    }
  EXPECT_EQ(velocitySpread({1.0, {0.5, 0.0}}, 2.0), 0.0) << "nothing but noise";
}

// Edges of regression filters computed with numpy: -3 dB of orders 0 to 3, -20 dB of orders 1 to 3, in units of Nyquist.
struct FilterEdges {
  int samples;
  double atThree[4], atTwenty[3];
};
constexpr FilterEdges kEdges[] = {{6, {0.15, 0.29, 0.44, 0.61}, {0.09, 0.19, 0.31}},
                                  {8, {0.11, 0.22, 0.32, 0.43}, {0.07, 0.14, 0.22}},
                                  {10, {0.09, 0.17, 0.25, 0.34}, {0.05, 0.11, 0.17}},
                                  {12, {0.07, 0.14, 0.21, 0.28}, {0.05, 0.09, 0.14}},
                                  {16, {0.06, 0.11, 0.16, 0.21}, {0.03, 0.07, 0.10}}};

TEST(WallFilter, HasTheEdgesOfTheTables) {
  for (const FilterEdges& known : kEdges)
    for (int order = 0; order <= 3; ++order) {
      const WallFilter filter(known.samples, order);
      EXPECT_NEAR(filter.edge(3.0), known.atThree[order], 0.0065) << known.samples << ", " << order;
      if (order > 0) {
        EXPECT_NEAR(filter.edge(20.0), known.atTwenty[order - 1], 0.0065) << known.samples << ", " << order;
      }
    }
}

TEST(WallFilter, TakesOutWhatItFitsAndLeavesTheRestAsItSays) {
  for (const int order : {-1, 0, 1, 3}) {
    const WallFilter filter(10, order);
    Packet drift;
    for (int n = 0; n < 10; ++n) drift.emplace_back(3.0F + 0.5F * static_cast<float>(n), -1.0F);
    const double before = sumsOf(drift).r0;
    filter.apply(drift);
    if (order >= 1) {
      EXPECT_LT(sumsOf(drift).r0, 1e-10 * before) << "a wall that drifts evenly";
    }
    if (order == -1) {
      EXPECT_EQ(sumsOf(drift).r0, before);
    }
    for (const double velocity : {0.05, 0.3, 0.9}) {
      Packet tone = toneOf(10, velocity);
      filter.apply(tone);
      EXPECT_NEAR(sumsOf(tone).r0, filter.response(velocity), 1e-5) << order << ", " << velocity;
    }
  }
  EXPECT_NEAR(WallFilter(8, 2).noiseShare(), 5.0 / 8.0, 1e-12);
  EXPECT_EQ(WallFilter(8, -1).edge(), 0.0);
}

// Standard deviations of 20,000 packets computed with numpy, mean 0.3 of Nyquist, by samples, spread and noise.
struct PacketDeviation {
  int samples;
  double spread, noiseToSignal, measured, formula;
};
constexpr PacketDeviation kDeviations[] = {{8, 0.1, 0.01, 0.060, 0.057},  {8, 0.2, 0.01, 0.097, 0.094},  {8, 0.3, 0.01, 0.142, 0.136},
                                           {8, 0.1, 0.1, 0.079, 0.059},   {12, 0.1, 0.01, 0.049, 0.048}, {12, 0.2, 0.01, 0.077, 0.077},
                                           {12, 0.3, 0.01, 0.112, 0.110}, {12, 0.1, 0.1, 0.056, 0.050},  {16, 0.1, 0.01, 0.042, 0.042},
                                           {16, 0.2, 0.01, 0.066, 0.067}, {16, 0.3, 0.01, 0.095, 0.095}, {16, 0.1, 0.1, 0.046, 0.044}};

TEST(PacketSource, SpreadsTheEstimateAsPacketsOfBloodDo) {
  for (const PacketDeviation& known : kDeviations) {
    const Spread found = estimates(known.samples, 0.3, known.spread, known.noiseToSignal);
    EXPECT_NEAR(found.deviation, known.measured, 0.05 * known.measured) << known.samples << ", " << known.spread;
    EXPECT_NEAR(found.mean, 0.0, 4.0 * known.measured / std::sqrt(20000.0)) << "no bias";
    EXPECT_NEAR(meanVelocityDeviation(known.samples, known.spread, known.noiseToSignal), known.formula, 0.0007);
  }
}

TEST(PacketSource, FadesLikeSpeckle) {
  // A still spectrum has one speckle value for the whole packet, whose power is exponential; a wide one averages over many.
  EXPECT_NEAR(estimates(8, 0.0, 0.0, 0.0).fading, 1.0, 0.03);
  EXPECT_NEAR(estimates(8, 0.0, 1.0, 0.0).fading, 1.0 / std::sqrt(8.0), 0.03);
}

TEST(PacketSource, IsDrivenAwayFromZeroNearTheEdgeOfTheFilterAndNotBeyond) {
  const WallFilter filter(12, 2);
  const double edge = filter.edge(3.0);
  EXPECT_GT(estimates(12, 0.6 * edge, 0.1, 0.01, &filter).mean, 0.02);
  for (const double beyond : {2.0, 3.0})
    EXPECT_NEAR(estimates(12, beyond * edge, 0.05, 0.001, &filter).mean, 0.0, 0.05 * beyond * edge) << beyond << " times the edge";
}

}  // namespace
}  // namespace ew::doppler_test
