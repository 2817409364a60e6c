#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ew/registration/elastic.h"
#include "ew/registration/quality.h"
#include "registration/planar_pairs.h"

/// Hard cases of the two-dimensional registration and of the quality figures: DESIGN.md, section 12, "registration".
namespace registration_elastic2d_test {
namespace {

using namespace ew;
using namespace ew::registration;
using namespace ew::test;

constexpr int kSide = 128;
constexpr double kPixel_mm = 0.5;
constexpr double kExtent_mm = kSide * kPixel_mm;

Elastic2dResult registered(const GreyImage& fixed, const GreyImage& moving, const Elastic2dOptions& options = {}) {
  auto found = registerElastic2d(viewOf(fixed), viewOf(moving), glm::dvec2(kPixel_mm), options, noProgress());
  EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
  return found ? *found : Elastic2dResult{};
}

bool everywhereZero(const Elastic2dResult& found) {
  return std::all_of(found.displacement_mm.begin(), found.displacement_mm.end(), [](glm::vec2 u) { return u == glm::vec2(0.0F); });
}
bool everywhereFinite(const Elastic2dResult& found) {
  return std::all_of(found.displacement_mm.begin(), found.displacement_mm.end(),
                     [](glm::vec2 u) { return std::isfinite(u.x) && std::isfinite(u.y); });
}

GreyImage noise(unsigned seed, int side = kSide) {
  GreyImage image(side, side);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(120.0, 30.0);
  for (auto& p : image.pixels) p = grey(normal(random));
  return image;
}

TEST(HardElastic2d, LeavesConstantImagesAloneAndNamesThem) {
  const Pattern pattern(31, 1.1, 30.0, 30.0);
  const GreyImage flat(kSide, kSide, 90), shown = pairOf(kSide, kPixel_mm, pattern, pattern, warp(0.0, 60.0)).fixed;
  for (const auto& [a, b] : {std::pair{&flat, &flat}, std::pair{&flat, &shown}, std::pair{&shown, &flat}}) {
    const auto found = registered(*a, *b);
    EXPECT_EQ(found.verdict, Verdict::cannotTell);
    EXPECT_TRUE(everywhereZero(found));
    EXPECT_TRUE(found.stop == StopReason::singular || found.stop == StopReason::noImprovement) << nameOf(found.stop);
    EXPECT_FALSE(found.reason.empty());
  }
}

TEST(HardElastic2d, BelievesNothingInBlackImages) {
  const GreyImage black(kSide, kSide, 0);
  const auto found = registered(black, black);
  EXPECT_EQ(found.verdict, Verdict::cannotTell);
  EXPECT_EQ(found.stop, StopReason::noOverlap);
  EXPECT_TRUE(everywhereZero(found));
}

TEST(HardElastic2d, BendsASaturatedImageByWhatIsNotSaturated) {
  const Pattern pattern(32, 1.1, 30.0, 40.0);
  const Motion truth = warp(3.0, kExtent_mm);
  const auto saturate = [](double v, glm::dvec2) { return v + 105.0; };  // a quarter of the pixels and more end at 255
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, truth, saturate);
  const auto white = std::count(pair.moving.pixels.begin(), pair.moving.pixels.end(), 255);
  EXPECT_GT(white, kSide * kSide / 5);
  const auto found = registered(pair.fixed, pair.moving);
  EXPECT_LT(meanError_mm(found.displacement_mm, kSide, kPixel_mm, truth), 0.25);
  EXPECT_GT(found.smallestJacobian, 0.05);
}

TEST(HardElastic2d, DoesNotBendUnrelatedSpeckleOntoItself) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto found = registered(noise(seed), noise(100 + seed));
    EXPECT_NE(found.verdict, Verdict::aligned) << found.reason;
    EXPECT_TRUE(everywhereZero(found)) << found.reason;
  }
}

TEST(HardElastic2d, IsNeverWorseThanNothingOnSmallMotionUnderIndependentSpeckle) {
  // Same patches, other speckle: little to go by, and a motion that is small against it.
  double found_mm = 0.0, nothing_mm = 0.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Pattern mine(seed, 1.1, 26.0, 26.0), structure(seed, 1.1, 0.0, 26.0), grain(900 + seed, 1.1, 26.0, 0.0);
    const Motion truth = warp(1.5, kExtent_mm);
    Pair2d pair = pairOf(kSide, kPixel_mm, mine, mine, truth);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec2 p{x * kPixel_mm, y * kPixel_mm};
        pair.moving.pixels[static_cast<std::size_t>(y * kSide + x)] = grey(structure.at(p) + grain.at(p) - 120.0);
      }
    const auto found = registered(pair.fixed, pair.moving);
    found_mm += meanError_mm(found.displacement_mm, kSide, kPixel_mm, truth) / 5.0;
    nothing_mm += meanError_mm(std::vector<glm::vec2>(static_cast<std::size_t>(kSide * kSide)), kSide, kPixel_mm, truth) / 5.0;
    EXPECT_LT(found.speckleCorrelation, 0.6);
  }
  EXPECT_LE(found_mm, 1.05 * nothing_mm);
}

TEST(HardElastic2d, SaysThatInvertedGainAgreesWithNothing) {
  const Pattern pattern(33, 1.1, 30.0, 30.0);
  const auto inverted = [](double v, glm::dvec2) { return 240.0 - v; };
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, warp(1.0, kExtent_mm), inverted);
  const auto found = registered(pair.fixed, pair.moving, {.largestMotion_mm = 0.0});
  EXPECT_LT(found.before.correlation, 0.0);
  EXPECT_TRUE(everywhereFinite(found));
  EXPECT_GT(found.smallestJacobian, 0.05);
  // A warp may find chance likeness in a negative; it must not look like a fit.
  EXPECT_LT(found.after.correlation, 0.5) << found.reason;
}

TEST(HardElastic2d, TakesImagesOfOneColumnOneRowAndOnePixel) {
  const GreyImage shown = noise(7);
  for (const auto& [width, height] : {std::pair{1, kSide}, std::pair{kSide, 1}, std::pair{1, 1}, std::pair{2, 2}, std::pair{3, 200}}) {
    GreyImage thin(width, height);
    for (std::size_t n = 0; n < thin.pixels.size(); ++n) thin.pixels[n] = shown.pixels[n];
    const auto found = registered(thin, thin);
    EXPECT_EQ(found.displacement_mm.size(), thin.pixels.size());
    EXPECT_TRUE(everywhereFinite(found));
    EXPECT_LT(found.largestMotion_mm, 0.5) << width << " x " << height;
  }
}

TEST(HardElastic2d, NamesImagesThatCoverNothingInCommon) {
  const GreyImage shown = noise(8);
  GreyImage left = shown, right = shown;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::size_t n = static_cast<std::size_t>(y * kSide + x);
      if (x >= kSide / 2 - 4) left.pixels[n] = 0;
      if (x < kSide / 2 + 4) right.pixels[n] = 0;
    }
  }
  const auto found = registered(left, right);
  EXPECT_EQ(found.verdict, Verdict::cannotTell);
  EXPECT_EQ(found.stop, StopReason::noOverlap);
  EXPECT_TRUE(everywhereZero(found));
}

TEST(HardElastic2d, IsNotDrawnByAShadowOverHalfOfOneImage) {
  const Pattern pattern(34, 1.1, 30.0, 30.0);
  const Motion truth = warp(2.5, kExtent_mm);
  const auto shadowed = [](double v, glm::dvec2 p) {
    const double across = 1.0 / (1.0 + std::exp((std::abs(p.x - 40.0) - 16.0) / 0.8)), down = 1.0 / (1.0 + std::exp(-(p.y - 14.0) / 0.8));
    return v - 110.0 * across * down;
  };
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, truth, shadowed);
  const auto found = registered(pair.fixed, pair.moving);
  EXPECT_TRUE(everywhereFinite(found));
  double clear_mm = 0.0;
  int count = 0;
  for (int y = 8; y < kSide - 8; ++y) {
    for (int x = 8; x < 40; ++x, ++count) {  // left of the shadow
      const glm::dvec2 p{x * kPixel_mm, y * kPixel_mm};
      clear_mm += glm::length(glm::dvec2(found.displacement_mm[static_cast<std::size_t>(y * kSide + x)]) - truth(p));
    }
  }
  EXPECT_LT(clear_mm / count, 0.25);
  EXPECT_LT(found.largestMotion_mm, 5.0);
  EXPECT_GT(found.smallestJacobian, 0.05);
}

TEST(HardElastic2d, DoesNotFoldWhenTheTruthDoes) {
  const Pattern pattern(35, 1.1, 30.0, 30.0);
  const Motion folds = [](glm::dvec2 p) { return glm::dvec2(6.0 * std::sin(2.0 * 3.14159 * p.x / 20.0), 0.0); };  // slope 1.9
  const Pair2d pair = pairOf(kSide, kPixel_mm, pattern, pattern, folds);
  for (const bool single : {false, true}) {
    const auto found = registered(pair.fixed, pair.moving, {.singleResolution = single});
    EXPECT_GT(found.smallestJacobian, 0.0);
    EXPECT_TRUE(everywhereFinite(found));
  }
}

TEST(HardElastic2d, KeepsToTheNearestOfRepeatedStructures) {
  GreyImage stripes(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      stripes.pixels[static_cast<std::size_t>(y * kSide + x)] = grey(120.0 + 60.0 * std::sin(2.0 * 3.14159 * x * kPixel_mm / 6.0));
  const auto found = registered(stripes, stripes);
  EXPECT_LT(found.largestMotion_mm, 0.2);  // not one period on
}

TEST(HardQuality, OfConstantOrDisjointVolumesIsZeroAndSaysNothingIsKnown) {
  Volume flat;
  flat.grid.dims = glm::ivec3(20);
  flat.echo.assign(8000, 90);
  const auto same = assessQuality({&flat, {}}, {&flat, {}}, {}, {}, nullptr, {}, noProgress());
  ASSERT_TRUE(same);
  EXPECT_EQ(same->after.correlation, 0.0);
  EXPECT_EQ(same->greyCorrelationAfter, 0.0);
  for (const RegionQuality& region : same->regions) EXPECT_TRUE(std::isinf(region.uncertainty_mm));
  Transform<frame::Moving, frame::Fixed> away;
  away.matrix[3] = glm::dvec4(500.0, 0.0, 0.0, 1.0);
  const auto apart = assessQuality({&flat, {}}, {&flat, {}}, {}, {away, {}}, nullptr, {}, noProgress());
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->after.overlapShare, 0.0);
  EXPECT_EQ(apart->after.chance, 1.0);
  EXPECT_TRUE(apart->regions.empty());
  EXPECT_FALSE(apart->inverseConsistencyMedian_mm.has_value());
}

TEST(HardQuality, TakesVolumesOfOneVoxelThickness) {
  Volume thin;
  thin.grid.dims = {40, 40, 1};
  const GreyImage shown = noise(9, 40);
  thin.echo = shown.pixels;
  const auto found = assessQuality({&thin, {}}, {&thin, {}}, {}, {}, nullptr, {}, noProgress());
  ASSERT_TRUE(found) << found.error().sentence();
  EXPECT_NEAR(found->after.correlation, 1.0, 1e-6);
  EXPECT_EQ(found->residualRms_grey, 0.0);
}

}  // namespace
}  // namespace registration_elastic2d_test
