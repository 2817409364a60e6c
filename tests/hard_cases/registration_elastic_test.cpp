// Hard cases of registration: what the three-dimensional elastic method must do with them stands in resources/docs/science/hard-cases.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ew/registration/elastic.h"
#include "registration/fields.h"
#include "registration/tissue.h"

namespace ew::registration_elastic_test {
namespace {

using namespace registration;
using test::imaged;
using test::Tissue;
using test::uprightGrid;

ElasticResult registered(const Volume& fixed, const Volume& moving, const ElasticOptions& options = {}) {
  auto found = registerElastic({&fixed, {}}, {&moving, {}}, {}, options, noProgress());
  EXPECT_TRUE(found) << found.error();
  return found ? std::move(*found) : ElasticResult{};
}

void expectUsable(const ElasticResult& found) {
  EXPECT_FALSE(found.reason.empty());
  EXPECT_EQ(found.jacobian.folded, 0U);
  EXPECT_GE(found.jacobian.smallest, 0.1);
  for (const glm::vec3& u : found.fixedToMoving.control.displacement_mm)
    ASSERT_TRUE(std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z));
  for (const float u : found.uncertainty) ASSERT_TRUE(u >= 0.0F && u <= 1.0F);
}

const Grid kGrid = uprightGrid({44, 40, 48}, 1.0);

glm::dvec3 warp(const glm::dvec3& p) { return {2.0 * std::sin(p.y / 11.0), 1.5 * std::cos(p.z / 12.0), std::sin(p.x / 13.0)}; }

double errorAt(const ElasticResult& found, const glm::dvec3& p) { return glm::distance(movingPoint(found.fixedToMoving, p), p + warp(p)); }

TEST(HardElastic, ConstantImagesAreNamedSingularAndMoveNothing) {
  const Volume grey = imaged(kGrid, [](const glm::dvec3&) { return 90.0; });
  const ElasticResult found = registered(grey, grey);
  expectUsable(found);
  EXPECT_EQ(found.verdict, Verdict::cannotTell);
  EXPECT_EQ(found.stop, StopReason::singular);
  EXPECT_NE(found.reason.english().find("singular"), std::string::npos);
  EXPECT_EQ(found.largestMotion_mm, 0.0);
  for (const float u : found.uncertainty) EXPECT_EQ(u, 1.0F);
}

TEST(HardElastic, OneConstantImageIsNotCalledAligned) {
  const Tissue tissue(1);
  const Volume grey = imaged(kGrid, [](const glm::dvec3&) { return 90.0; });
  const Volume seen = imaged(kGrid, [&](const glm::dvec3& p) { return tissue.at(p); });
  const ElasticResult found = registered(grey, seen);
  expectUsable(found);
  EXPECT_NE(found.verdict, Verdict::aligned) << found.reason;
  EXPECT_EQ(found.largestMotion_mm, 0.0);
}

TEST(HardElastic, SaturatedImagesFollowWhatIsLeft) {
  const Tissue tissue(2, 6.0, 70.0);
  const Volume fixed = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p + warp(p)) + 150.0; }, 8.0, 1);
  const Volume moving = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p) + 150.0; }, 8.0, 2);
  ASSERT_GT(std::count(fixed.echo.begin(), fixed.echo.end(), 255), static_cast<std::ptrdiff_t>(fixed.echo.size() / 4));
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_EQ(found.verdict, Verdict::aligned) << found.reason;
  EXPECT_LT(errorAt(found, {22.0, 20.0, 24.0}), 0.9);
  const Volume white = imaged(kGrid, [](const glm::dvec3&) { return 255.0; });
  EXPECT_EQ(registered(white, white).verdict, Verdict::cannotTell);
}

TEST(HardElastic, PureSpeckleWithoutStructureIsNotCalledAligned) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Volume fixed = imaged(
        kGrid, [](const glm::dvec3&) { return 100.0; }, 35.0, 2 * seed);
    const Volume moving = imaged(
        kGrid, [](const glm::dvec3&) { return 100.0; }, 35.0, 2 * seed + 1);
    const ElasticResult found = registered(fixed, moving);
    expectUsable(found);
    EXPECT_NE(found.verdict, Verdict::aligned) << found.reason;
    EXPECT_EQ(found.largestMotion_mm, 0.0);
  }
}

TEST(HardElastic, RepeatedStructureStaysWithTheNearestRepetition) {
  const auto stripes = [](const glm::dvec3& p) {
    return 110.0 + 60.0 * std::sin(p.x * 0.7854) * std::cos(p.y * 0.5) + 30.0 * std::sin(p.z * 0.6);
  };  // 8 mm along x
  const Volume fixed = imaged(
      kGrid, [&](const glm::dvec3& p) { return stripes(p + glm::dvec3(1.5, 0.0, 0.0)); }, 6.0, 1);
  const Volume moving = imaged(kGrid, stripes, 6.0, 2);
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_LT(glm::distance(movingPoint(found.fixedToMoving, {22.0, 20.0, 24.0}), glm::dvec3(23.5, 20.0, 24.0)), 1.0);
}

TEST(HardElastic, DisjointVolumesAreNamedSo) {
  const Tissue tissue(3);
  Grid far = kGrid;
  far.origin_mm = {300.0, 0.0, 0.0};
  const Volume fixed = imaged(kGrid, [&](const glm::dvec3& p) { return tissue.at(p); });
  const Volume moving = imaged(far, [&](const glm::dvec3& p) { return tissue.at(p); });
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_EQ(found.verdict, Verdict::cannotTell);
  EXPECT_EQ(found.stop, StopReason::noOverlap);
  EXPECT_NE(found.reason.english().find("overlap"), std::string::npos);
}

TEST(HardElastic, AShadowOverHalfOfOneImageIsFilledAndTheOtherHalfIsNotHurt) {
  const Tissue tissue(4);
  const Volume fixed = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p + warp(p)); }, 8.0, 1);
  std::mt19937 random(9);
  Volume moving = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 2);
  for (int k = 0; k < kGrid.dims.z; ++k) {
    for (int j = 0; j < kGrid.dims.y; ++j) {
      for (int i = kGrid.dims.x / 2; i < kGrid.dims.x; ++i) moving.echo[kGrid.indexOf(i, j, k)] = static_cast<std::uint8_t>(random() % 25U);
    }
  }
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_EQ(found.verdict, Verdict::aligned) << found.reason;
  EXPECT_LT(errorAt(found, {10.0, 20.0, 24.0}), 1.2);  // 2.4 with nothing done
  EXPECT_LT(errorAt(found, {32.0, 20.0, 24.0}), 4.0);  // a guess, but no runaway
}

TEST(HardElastic, InvertedGainIsNotCalledAligned) {
  const Tissue tissue(5);
  const Volume fixed = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p); }, 5.0, 1);
  const Volume moving = imaged(
      kGrid, [&](const glm::dvec3& p) { return 220.0 - tissue.at(p); }, 5.0, 2);
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_NE(found.verdict, Verdict::aligned) << found.reason;
  EXPECT_LT(found.before.correlation, -0.5);
  EXPECT_EQ(found.largestMotion_mm, 0.0);
}

TEST(HardElastic, OneVoxelOfThicknessIsRegisteredInItsPlane) {
  const Tissue tissue(6);
  const Grid layer = uprightGrid({72, 64, 1}, 0.8);
  const auto truth = [](const glm::dvec3& p) { return p + glm::dvec3(1.5 * std::sin(p.y / 12.0), std::cos(p.x / 14.0), 0.0); };
  const Volume fixed = imaged(
      layer, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 5.0, 1);
  const Volume moving = imaged(
      layer, [&](const glm::dvec3& p) { return tissue.at(p); }, 5.0, 2);
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  EXPECT_EQ(found.verdict, Verdict::aligned) << found.reason;
  const glm::dvec3 p(28.0, 26.0, 0.0);
  EXPECT_LT(glm::distance(movingPoint(found.fixedToMoving, p), truth(p)), 0.5);
  for (const glm::vec3& u : found.fixedToMoving.control.displacement_mm) EXPECT_NEAR(u.z, 0.0F, 1e-3F);
  // As thin, but of another plane of the same tissue: nothing to follow out of it.
  const Grid volume = uprightGrid({72, 64, 20}, 0.8);
  const Volume thick = imaged(
      volume, [&](const glm::dvec3& p3) { return tissue.at(p3); }, 5.0, 3);
  expectUsable(registered(fixed, thick));
}

TEST(HardElastic, ADisplacementThatFoldsIsNotFollowedIntoTheFold) {
  const Tissue tissue(7);
  // Points cross each other along x: no unfolded field explains the pair.
  const auto folding = [](const glm::dvec3& p) { return glm::dvec3(p.x + 7.0 * std::sin(p.x / 4.0), p.y, p.z); };
  const Volume fixed = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(folding(p)); }, 4.0, 1);
  const Volume moving = imaged(
      kGrid, [&](const glm::dvec3& p) { return tissue.at(p); }, 4.0, 2);
  ElasticOptions options;
  options.stiffness = 1e-3;  // soft enough to fold, were it allowed
  options.leastJacobian = 0.2;
  const ElasticResult found = registered(fixed, moving, options);
  expectUsable(found);
  EXPECT_GE(found.jacobian.smallest, 0.2 - 1e-6);
}

TEST(HardElastic, IndependentSpeckleOnASmallMotionIsNeverWorseThanNothing) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const Tissue tissue(10 + seed, 6.0, 30.0);
    const auto truth = [](const glm::dvec3& p) { return p + 0.4 * warp(p); };
    const Volume fixed = imaged(
        kGrid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 30.0, seed);
    const Volume moving = imaged(
        kGrid, [&](const glm::dvec3& p) { return tissue.at(p); }, 30.0, seed + 50);
    const ElasticResult found = registered(fixed, moving);
    expectUsable(found);
    double after = 0.0, before = 0.0;
    for (int k = 4; k < kGrid.dims.z - 4; k += 3) {
      for (int j = 4; j < kGrid.dims.y - 4; j += 3) {
        for (int i = 4; i < kGrid.dims.x - 4; i += 3) {
          const glm::dvec3 p(i, j, k);
          after += glm::distance(movingPoint(found.fixedToMoving, p), truth(p));
          before += glm::distance(p, truth(p));
        }
      }
    }
    EXPECT_LT(after, before) << seed;
  }
}

TEST(HardElastic, VolumesOfAFewVoxelsComeBackWithAVerdict) {
  const Tissue tissue(8);
  for (const glm::ivec3& dims :
       {glm::ivec3(1, 1, 1), glm::ivec3(2, 2, 2), glm::ivec3(3, 1, 5), glm::ivec3(1, 40, 1), glm::ivec3(7, 7, 7)}) {
    const Volume volume = imaged(uprightGrid(dims, 1.0), [&](const glm::dvec3& p) { return tissue.at(p); });
    const ElasticResult found = registered(volume, volume);
    expectUsable(found);
    EXPECT_LT(found.largestMotion_mm, 1.0);
  }
}

/// Waves along all axes, as `length_mm` and `height_mm` say: 0.8 of the height in the mean.
glm::dvec3 wave(const glm::dvec3& p, double length_mm, double height_mm) {
  const double turn = 2.0 * 3.14159265358979323846 / length_mm;
  return height_mm / 1.5 * glm::dvec3(std::sin(turn * p.y), std::cos(turn * (p.z + 10.0)), std::sin(turn * (p.x + p.z)));
}

TEST(HardElastic, AWaveTooShortForTheNodesIsNotCalledAlignedAndMarked) {
  const Grid grid = uprightGrid({64, 64, 64}, 1.0);
  struct Case {
    double length_mm, height_mm;
    unsigned seed;
  };
  for (const Case& c : {Case{25.0, 4.0, 3}, Case{25.0, 4.0, 4}, Case{20.0, 3.2, 5}, Case{16.0, 2.5, 6}, Case{12.0, 1.9, 7}}) {
    const Tissue tissue(c.seed);
    const auto truth = [&](const glm::dvec3& p) { return p + wave(p, c.length_mm, c.height_mm); };
    const Volume fixed = imaged(
        grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 8.0, 11);
    const Volume moving = imaged(
        grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 12);
    const ElasticResult found = registered(fixed, moving);
    expectUsable(found);
    EXPECT_EQ(found.verdict, Verdict::cannotTell) << c.length_mm << ": " << found.reason;
    ASSERT_EQ(found.remarks.size(), 1u);
    EXPECT_EQ(found.remarks[0].what, RemarkCode::motionRemains) << c.length_mm << ": " << found.reason;
    const auto unsure = std::count_if(found.uncertainty.begin(), found.uncertainty.end(), [](float u) { return u > 0.5F; });
    EXPECT_GT(static_cast<double>(unsure), 0.5 * static_cast<double>(found.uncertainty.size())) << c.length_mm;
  }
}

TEST(HardElastic, WavesInPartOfAVolumeAreMarkedThereAndNowhereElse) {
  const Grid grid = uprightGrid({96, 48, 48}, 1.0);
  const Tissue tissue(8);
  const auto truth = [](const glm::dvec3& p) { return p + wave(p, 25.0, 4.0) / (1.0 + std::exp((60.0 - p.x) / 3.0)); };
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 8.0, 11);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 8.0, 12);
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  const auto& nodes = found.fixedToMoving.control.nodes;
  int marked[2] = {0, 0}, all[2] = {0, 0};
  for (int k = 0; k < nodes.dims.z; ++k) {
    for (int j = 0; j < nodes.dims.y; ++j) {
      for (int i = 0; i < nodes.dims.x; ++i) {
        const double x = nodes.origin_mm.x + i * nodes.spacing_mm.x;
        if (x > 46.0 && x < 74.0) continue;
        ++all[x < 60.0 ? 0 : 1];
        if (found.uncertainty[nodes.indexOf(i, j, k)] > 0.5F) ++marked[x < 60.0 ? 0 : 1];
      }
    }
  }
  EXPECT_LT(marked[0], 0.1 * all[0]);
  EXPECT_GT(marked[1], 0.4 * all[1]);
  EXPECT_GT(found.residualShare, 0.05);
}

TEST(HardElastic, AnisotropyOfTwentyToOneIsSurvived) {
  Grid grid = uprightGrid({64, 64, 4}, 0.6);
  grid.spacing_mm.z = 12.0;
  const Tissue tissue(9);
  const auto truth = [](const glm::dvec3& p) { return p + glm::dvec3(1.2 * std::sin(p.y / 9.0), 0.8, 0.0); };
  const Volume fixed = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(truth(p)); }, 5.0, 1);
  const Volume moving = imaged(
      grid, [&](const glm::dvec3& p) { return tissue.at(p); }, 5.0, 2);
  const ElasticResult found = registered(fixed, moving);
  expectUsable(found);
  const glm::dvec3 p(19.0, 19.0, 12.0);
  EXPECT_LT(glm::distance(movingPoint(found.fixedToMoving, p), truth(p)), 0.8);
}

}  // namespace
}  // namespace ew::registration_elastic_test
