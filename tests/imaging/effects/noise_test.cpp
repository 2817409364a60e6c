#include "ew/imaging/effects/noise.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "imaging/support/every_target.h"

namespace ew::noise_test {
namespace {

constexpr double kGreyPerDb = 255.0 / 60.0;

double powerOf(double level) { return std::pow(10.0, level / (10.0 * kGreyPerDb)); }

/// Noise alone: what it makes of echoes far below it.
BeamImage noiseAlone(float level, std::uint64_t frameNumber, int lines = 192, int samples = 750) {
  BeamImage echoes(lines, samples, -1000.0F);
  addNoise(std::vector<float>(static_cast<std::size_t>(samples), level), kGreyPerDb, frameNumber, 0, viewOf(echoes));
  return echoes;
}

std::vector<double> powersOf(const BeamImage& image) {
  std::vector<double> powers;
  for (const float level : image.pixels) powers.push_back(powerOf(static_cast<double>(level)));
  return powers;
}

TEST(NoiseLevels, GrowWithTheMachinesCompensation) {
  BeamGrid grid;
  grid.samples = 751;
  grid.sampleSpacing_mm = 0.2;
  NoiseEffect effect;
  effect.atFace_db = -80.0;
  effect.growth_dbPerCmMhz = 0.4;
  effect.largest_db = -45.0;
  const std::vector<float> levels = noiseLevels(effect, 3.5e6, 60.0, grid);
  ASSERT_EQ(levels.size(), 751U);
  for (const int s : {0, 100, 500, 750})
    EXPECT_NEAR(static_cast<double>(levels[static_cast<std::size_t>(s)]),
                255.0 + kGreyPerDb * std::min(-80.0 + 2.0 * 0.4 * 3.5 * 0.02 * s, -45.0), 1e-3);
}

TEST(Noise, HasTheExpectedPowerAndAnExponentialDistribution) {
  for (const float level : {40.0F, 100.0F}) {
    std::vector<double> powers = powersOf(noiseAlone(level, 3));
    double sum = 0.0;
    for (const double power : powers) sum += power;
    const double mean = sum / static_cast<double>(powers.size());
    EXPECT_NEAR(mean / powerOf(static_cast<double>(level)), 1.0, 0.01);
    std::sort(powers.begin(), powers.end());
    for (const double share : {0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.999}) {
      const double quantile = powers[static_cast<std::size_t>(share * static_cast<double>(powers.size()))] / mean;
      const double expected = -std::log(1.0 - share);
      const double deviation = std::sqrt(share / ((1.0 - share) * static_cast<double>(powers.size())));
      EXPECT_NEAR(quantile, expected, 5.0 * deviation + 1e-3 * expected) << share;
    }
  }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i];
    sb += b[i];
    saa += a[i] * a[i];
    sbb += b[i] * b[i];
    sab += a[i] * b[i];
  }
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

TEST(Noise, IsIndependentInNeighbouringLinesRowsAndFrames) {
  const int lines = 192;
  const std::vector<double> here = powersOf(noiseAlone(60.0F, 10));
  const double limit = 5.0 / std::sqrt(static_cast<double>(here.size()));
  for (const std::ptrdiff_t lag : {1, 2, 4, 8, 16, lines, lines + 1, 2 * lines}) {
    const std::vector<double> a(here.begin(), here.end() - lag), b(here.begin() + lag, here.end());
    EXPECT_LT(std::abs(correlation(a, b)), limit) << "lag " << lag;
  }
  for (const std::uint64_t other : {std::uint64_t{0}, std::uint64_t{9}, std::uint64_t{11}, std::uint64_t{10} << 32})
    EXPECT_LT(std::abs(correlation(here, powersOf(noiseAlone(60.0F, other)))), limit) << "frame " << other;
}

TEST(Noise, OfBandsIsThatOfTheWholeAndOfTheSameFrameTheSame) {
  EXPECT_TRUE(rc::check("bands", [] {
    const int lines = *rc::gen::inRange(1, 60);
    const int samples = *rc::gen::inRange(2, 40);
    const int cut = *rc::gen::inRange(1, samples);
    const auto frame = *rc::gen::arbitrary<std::uint64_t>();
    std::vector<float> levels;
    for (int s = 0; s < samples; ++s) levels.push_back(static_cast<float>(3 * s - 30));
    BeamImage whole(lines, samples, 30.0F);
    addNoise(levels, kGreyPerDb, frame, 0, viewOf(whole));
    BeamImage parts(lines, samples, 30.0F);
    float* const data = parts.pixels.data();
    addNoise(levels, kGreyPerDb, frame, cut, {data + cut * lines, lines, samples - cut, lines});
    addNoise(levels, kGreyPerDb, frame, 0, {data, lines, cut, lines});
    RC_ASSERT(parts == whole);
  }));
}

TEST(Noise, IsTheSameToTheBitWithEveryInstructionSet) {
  std::vector<float> levels;
  for (int s = 0; s < 100; ++s) levels.push_back(static_cast<float>(2 * s - 60));
  const auto made = [&] {
    BeamImage echoes(77, 100, 20.0F);
    addNoise(levels, kGreyPerDb, 42, 0, viewOf(echoes));
    return echoes;
  };
  const BeamImage expected = made();
  testing::onEveryTarget([&](const char* name) { EXPECT_EQ(made(), expected) << name; });
}

TEST(Noise, IsAddedAsPowerAndNeverDarkens) {
  BeamImage echoes(192, 200, 100.0F);
  addNoise(std::vector<float>(200, 100.0F), kGreyPerDb, 5, 0, viewOf(echoes));
  double sum = 0.0;
  for (const float level : echoes.pixels) {
    ASSERT_GE(level, 99.99F);
    sum += powerOf(static_cast<double>(level));
  }
  EXPECT_NEAR(sum / static_cast<double>(echoes.pixels.size()) / powerOf(100.0), 2.0, 0.05);
}

TEST(Noise, FarBelowBlackChangesNothing) {
  BeamImage echoes(192, 100, 0.0F);
  const BeamImage before = echoes;
  addNoise(std::vector<float>(100, static_cast<float>(-28.0 * kGreyPerDb) - 0.01F), kGreyPerDb, 1, 0, viewOf(echoes));
  EXPECT_EQ(echoes, before);
  addNoise(std::vector<float>(100, static_cast<float>(-27.9 * kGreyPerDb)), kGreyPerDb, 1, 0, viewOf(echoes));
  for (const float level : echoes.pixels) EXPECT_LT(level, 0.5F) << "what is skipped below this level could not be seen either";
}

}  // namespace
}  // namespace ew::noise_test
