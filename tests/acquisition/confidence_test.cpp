#include "ew/acquisition/confidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sweeps.h"

namespace ew::confidence_test {
namespace {

constexpr int kLines = 96;
constexpr int kSamples = 240;

/// Speckle of a mean level, the same on every run: Rayleigh amplitude, log compressed at 60 dB.
int speckled(double level, int x, int y) {
  std::uint64_t z = 0x9E3779B97F4A7C15ull * static_cast<std::uint64_t>(x + 1) + 0xBF58476D1CE4E5B9ull * static_cast<std::uint64_t>(y + 1);
  z = (z ^ (z >> 30)) * 0x94D049BB133111EBull;
  z ^= z >> 31;
  const double power = -std::log((static_cast<double>(z >> 11) + 0.5) / 9007199254740992.0);
  return static_cast<int>(std::clamp(level + 42.5 * std::log10(power) + 10.6, 0.0, 255.0));
}

/// Tissue of level 110; below sample 80 of lines 30 to 49 bone and its shadow, and a vessel of level 4 in lines 60 to 80.
GreyImage ribAndVessel() {
  return sweeps::imageOf(kLines, kSamples, [](int x, int y) {
    if (x >= 30 && x < 50) {
      if (y >= 78 && y < 84) return 240;
      if (y >= 84) return speckled(20.0, x, y);
    }
    const double u = (x - 70) / 10.0, v = (y - 150) / 20.0;
    if (u * u + v * v < 1.0) return 4;
    return speckled(110.0, x, y);
  });
}

double meanOf(const Image<float>& map, int left, int right, int top, int bottom) {
  double sum = 0.0;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) sum += static_cast<double>(viewOf(map).at(x, y));
  return sum / ((right - left) * (bottom - top));
}

class Confidence : public testing::TestWithParam<ConfidenceMethod> {
 protected:
  [[nodiscard]] Image<float> mapOf(const GreyImage& image) {
    Image<float> map;
    const auto done = confidenceOfLines(viewOf(image), {.method = GetParam()}, scratch_, map);
    EXPECT_TRUE(done.has_value()) << done.error();
    return map;
  }
  ConfidenceScratch scratch_;
};
INSTANTIATE_TEST_SUITE_P(BothMethods, Confidence, testing::Values(ConfidenceMethod::beamwise, ConfidenceMethod::randomWalk),
                         [](const auto& each) { return each.param == ConfidenceMethod::beamwise ? "beamwise" : "randomWalk"; });

TEST_P(Confidence, IsLostBehindARibAndKeptBesideItAndAboveIt) {
  const Image<float> map = mapOf(ribAndVessel());
  EXPECT_LT(meanOf(map, 34, 46, 100, 230), 0.2);
  EXPECT_GT(meanOf(map, 5, 25, 100, 230), 0.8);
  EXPECT_GT(meanOf(map, 34, 46, 5, 60), 0.8);
}

// The walls of a vessel hold random walkers up, though far less than a rib does: that is what the method costs.
TEST_P(Confidence, IsKeptBehindAVessel) {
  EXPECT_GT(meanOf(mapOf(ribAndVessel()), 62, 78, 180, 230), GetParam() == ConfidenceMethod::beamwise ? 0.8 : 0.65);
}

TEST_P(Confidence, OfAnEvenImageIsOneEverywhere) {
  for (const int level : {90, 255}) {
    const Image<float> map = mapOf(sweeps::imageOf(32, 64, [&](int, int) { return level; }));
    for (const float each : map.pixels) ASSERT_GT(each, 0.99F) << level;
  }
}

TEST_P(Confidence, OfAFrameWithoutEchoesIsNothing) {
  const Image<float> map = mapOf(GreyImage(32, 64));
  for (const float each : map.pixels) ASSERT_EQ(each, 0.0F);
}

TEST_P(Confidence, StaysBetweenZeroAndOneInTheSmallestAndOddestImages) {
  for (const auto& [width, height] : {std::pair{2, 2}, std::pair{2, 300}, std::pair{300, 2}, std::pair{3, 3}}) {
    const Image<float> map = mapOf(sweeps::imageOf(width, height, [](int x, int y) { return (x * 131 + y * 71 + 9) % 256; }));
    for (const float each : map.pixels) ASSERT_TRUE(each >= 0.0F && each <= 1.0F) << width << " x " << height;
  }
}

TEST_P(Confidence, OfAFanIsThatOfItsLines) {
  const double halfAngle = 0.5;
  const Clip clip{.fan = ClipFan{{150.0, -60.0}, -halfAngle, halfAngle, 60.0, 300.0}};
  const GreyImage lines = ribAndVessel();
  const GreyImage frame = sweeps::imageOf(300, 241, [&](int x, int y) {
    const double angle = std::atan2(x - 150.0, y + 60.0), radius = std::hypot(x - 150.0, y + 60.0);
    const int line = static_cast<int>(std::lround((angle + halfAngle) / (2 * halfAngle) * (kLines - 1)));
    const int sample = static_cast<int>(std::lround(radius - 60.0));
    return line < 0 || line >= kLines || sample < 0 || sample >= kSamples ? 0 : static_cast<int>(viewOf(lines).at(line, sample));
  });
  GreyImage map;
  ASSERT_TRUE(confidenceOfFrame(viewOf(frame), clip, {.method = GetParam()}, scratch_, map).has_value());
  const auto pixelAt = [&](double line, double sample) {
    const double angle = -halfAngle + 2 * halfAngle * line / (kLines - 1), radius = 60.0 + sample;
    return static_cast<double>(viewOf(map).at(static_cast<int>(std::lround(150.0 + radius * std::sin(angle))),
                                              static_cast<int>(std::lround(-60.0 + radius * std::cos(angle)))));
  };
  const auto meanOfLine = [&](double line) {
    double sum = 0.0;
    for (int sample = 110; sample < 230; ++sample) sum += pixelAt(line, sample) / 120.0;
    return sum;
  };
  EXPECT_LT(meanOfLine(40), 51.0);
  EXPECT_GT(meanOfLine(15), 204.0);
  EXPECT_EQ(viewOf(map).at(2, 2), 0) << "outside the fan nothing is known";
}

TEST_P(Confidence, OfManyFramesDoesNotDependOnTheThreads) {
  const sweeps::Sweep sweep = sweeps::stack(40, 80, 9, 1.0, [](int x, int y, int n) { return speckled(100.0 + 5 * n, x + 7 * n, y); });
  const auto one = confidenceOfFrames(sweep.frames, {}, {.method = GetParam()}, 1, noProgress());
  ASSERT_TRUE(one.has_value());
  for (const int threads : {2, 8}) {
    const auto many = confidenceOfFrames(sweep.frames, {}, {.method = GetParam()}, threads, noProgress());
    ASSERT_TRUE(many.has_value());
    EXPECT_EQ(*one, *many) << threads;
  }
}

TEST(ConfidenceOptions, OutOfRangeAreNamed) {
  const GreyImage image(8, 8, 9);
  ConfidenceScratch scratch;
  Image<float> map;
  const auto refused = confidenceOfLines(viewOf(image), {.beta = std::nan("")}, scratch, map);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence().find("beta"), std::string::npos);
  EXPECT_FALSE(confidenceOfLines(viewOf(GreyImage(1, 8)), {}, scratch, map).has_value());
}

}  // namespace
}  // namespace ew::confidence_test
