#include <thread>

#include "formation.h"

namespace ew::testing::formation_speckle_test {
namespace {

struct Setting {
  const char* probe;
  double depth_mm;
};
void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.probe; }

class Speckle : public ::testing::TestWithParam<Setting> {};

TEST_P(Speckle, HasASignalToNoiseRatioOf1p91AndTheTissuesMeanLevelAtEveryDepth) {
  const Setting setting = GetParam();
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe(setting.probe), onlySpeckle(setting.depth_mm));
  constexpr int kFrames = 3, kBands = 4;
  std::vector<std::vector<double>> bands(kBands);
  for (int n = 0; n < kFrames; ++n) {
    const Image<float> envelope = envelopeOf(*scanner, held(30.0 * (n - 1)));
    for (int b = 0; b < kBands; ++b) {
      const double from = (0.12 + 0.21 * b) * setting.depth_mm;
      const auto values = band(*scanner, envelope, from, from + 0.2 * setting.depth_mm);
      bands[static_cast<std::size_t>(b)].insert(bands[static_cast<std::size_t>(b)].end(), values.begin(), values.end());
    }
  }
  for (int b = 0; b < kBands; ++b) {
    const auto& values = bands[static_cast<std::size_t>(b)];
    const Moments moments = momentsOf(values);
    const double snr = moments.mean / moments.deviation;
    RecordProperty(std::string(setting.probe) + " snr " + std::to_string(b), std::to_string(snr));
    EXPECT_NEAR(snr, 1.9131, 0.03 * 1.9131) << "band " << b;  // sqrt(pi / (4 - pi))
    EXPECT_NEAR(meanLevel(values), 150.0, 1.5) << "band " << b;
  }
}

INSTANTIATE_TEST_SUITE_P(OfProbes, Speckle,
                         ::testing::Values(Setting{"linear-7.5", 40.0}, Setting{"convex-3.5", 120.0}, Setting{"phased-2.5", 120.0}));

TEST(Speckle, LosesGrainWithTheRootOfItsLooksAndKeepsItsLevel) {
  FormationOptions options = onlySpeckle(40.0);
  options.looks = 3;
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe("linear-7.5"), options);
  std::vector<double> values;
  for (int n = 0; n < 4; ++n) {
    const auto more = band(*scanner, envelopeOf(*scanner, held(12.0 * (n - 1.5))), 8.0, 36.0);
    values.insert(values.end(), more.begin(), more.end());
  }
  const Moments moments = momentsOf(values);
  // Three looks whose neighbours correlate by 1/e^2 in intensity are worth 2.54 independent ones.
  EXPECT_NEAR(moments.mean / moments.deviation, 1.9131 * std::sqrt(9.0 / (3.0 + 4.0 * std::exp(-2.0))), 0.15);
  EXPECT_NEAR(meanLevel(values), 150.0, 2.0);
  EXPECT_NEAR(scanner->pointSpreadAt(20.0).axial_mm, 2.0 * 1540.0 / 7.5e3, 1e-6);  // twice two half wavelengths
}

TEST(Speckle, IsTheSameForEveryThreadAndOrderOfCalls) {
  Probe probe = shippedProbe("linear-7.5");
  FormationOptions options;
  options.depth_mm = 20.0;
  const auto patient = blockOfTissue(
      R"({"name": "vessel", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 12, 0], "radii_mm": [4, 4, 9]}}, "border": {"echo_level": 200, "width_mm": 1}})");
  const auto alone = scannerOf(patient, probe, options);
  constexpr int kFrames = 8;
  std::vector<Image<float>> one(kFrames), many(kFrames);
  for (int n = 0; n < kFrames; ++n) one[static_cast<std::size_t>(n)] = envelopeOf(*alone, held(0.3 * n), static_cast<std::uint64_t>(n));
  const auto shared = scannerOf(patient, probe, options);
  std::vector<std::jthread> threads;
  for (int n = kFrames - 1; n >= 0; --n)
    threads.emplace_back([&, n] { many[static_cast<std::size_t>(n)] = envelopeOf(*shared, held(0.3 * n), static_cast<std::uint64_t>(n)); });
  threads.clear();
  for (std::size_t n = 0; n < kFrames; ++n) EXPECT_TRUE(one[n] == many[n]) << "frame " << n;
  EXPECT_FALSE(one[0] == one[1]);
}

}  // namespace
}  // namespace ew::testing::formation_speckle_test
