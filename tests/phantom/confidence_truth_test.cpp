#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "ew/acquisition/confidence.h"
#include "ew/phantom/virtual_scanner.h"
#include "formation.h"

namespace ew::confidence_truth_test {
namespace {

/// Share of pairs (seen, shadowed) that the confidence puts in the right order.
double areaUnderCurve(std::vector<float> seen, const std::vector<float>& shadowed) {
  std::sort(seen.begin(), seen.end());
  double pairs = 0.0;
  for (const float c : shadowed) {
    const auto [from, to] = std::equal_range(seen.begin(), seen.end(), c);
    pairs += static_cast<double>(seen.end() - to) + 0.5 * static_cast<double>(to - from);
  }
  return pairs / (static_cast<double>(seen.size()) * static_cast<double>(shadowed.size()));
}

double meanOf(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

/// Truth is what the forward model takes away: the same frame is formed with and without losses, and what even tissue loses is taken off.
TEST(ConfidenceOfVirtualFrames, IsLowInTrueShadowsAndHighBesideThemAtTheSameDepths) {
  using namespace testing;
  const auto patient = blockOfTissue(R"(
    {"name": "stone 1", "tissue": "stone", "shape": {"ellipsoid": {"centre_mm": [-9, 26, 0], "radii_mm": [4, 3, 6]}}},
    {"name": "stone 2", "tissue": "stone", "shape": {"ellipsoid": {"centre_mm": [12, 18, 0], "radii_mm": [3, 2, 6]}}},
    {"name": "vessel", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [2, 34, 0], "radii_mm": [4, 4, 40]}}})");
  for (const auto& [name, depth_mm] : {std::pair{"linear-7.5", 60.0}, std::pair{"convex-3.5", 70.0}}) {
    const Probe probe = shippedProbe(name);
    FormationOptions options;
    options.depth_mm = depth_mm;
    options.penumbra = false;  // between shadow and sight there is nothing to judge by
    const auto scanner = scannerOf(patient, probe, options);
    GreyImage levels;
    compressEnvelope(envelopeOf(*scanner), options.dynamicRange_db, levels);
    options.noise_db = -300.0;
    options.tgc = {{0.0, 0.0}};
    const Image<float> with = envelopeOf(*scannerOf(patient, probe, options));
    options.attenuation = false;
    const Image<float> without = envelopeOf(*scannerOf(patient, probe, options));

    for (const auto method : {ConfidenceMethod::beamwise, ConfidenceMethod::randomWalk}) {
      ConfidenceScratch scratch;
      Image<float> confidence;
      ASSERT_TRUE(confidenceOfLines(viewOf(std::as_const(levels)), {.method = method}, scratch, confidence).has_value());
      std::vector<float> seen, shadowed;
      constexpr int kLines = 4, kSamples = 16;
      for (int s = 0; s + kSamples <= levels.height; s += kSamples)
        for (int l = 0; l + kLines <= levels.width; l += kLines) {
          const double depth = scanner->grid().depth_mm(s + 0.5 * kSamples);
          if (depth < 35.0 || depth > depth_mm - 5.0) continue;
          double kept = 0.0, whole = 0.0, found = 0.0;
          for (int v = s; v < s + kSamples; ++v)
            for (int u = l; u < l + kLines; ++u) {
              const auto at = static_cast<std::size_t>(v) * static_cast<std::size_t>(levels.width) + static_cast<std::size_t>(u);
              kept += std::pow(static_cast<double>(with.pixels[at]), 2.0);
              whole += std::pow(static_cast<double>(without.pixels[at]), 2.0);
              found += static_cast<double>(confidence.pixels[at]) / (kLines * kSamples);
            }
          const double expected_db = 2.0 * 0.5 * probe.carrier_hz * 1e-6 * depth / 10.0;
          const double excess_db = 10.0 * std::log10(whole / kept) - expected_db;
          if (!(whole > 1e-12)) continue;
          if (excess_db > 15.0) shadowed.push_back(static_cast<float>(found));
          if (excess_db < 3.0) seen.push_back(static_cast<float>(found));
        }
      ASSERT_GT(shadowed.size(), 30u) << name;
      ASSERT_GT(seen.size(), 100u) << name;
      const double area = areaUnderCurve(seen, shadowed);
      std::printf("%s, %s: area under the curve %.4f, mean in shadow %.3f, in sight %.3f (%zu and %zu blocks)\n", name,
                  method == ConfidenceMethod::beamwise ? "beam-wise" : "random walk", area, meanOf(shadowed), meanOf(seen), shadowed.size(),
                  seen.size());
      EXPECT_GE(area, 0.97) << name;
      EXPECT_LT(meanOf(shadowed), 0.2) << name;
      EXPECT_GT(meanOf(seen), 0.8) << name;
    }
  }
}

}  // namespace
}  // namespace ew::confidence_truth_test
