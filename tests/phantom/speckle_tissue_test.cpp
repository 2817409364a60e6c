#include "ew/phantom/speckle_tissue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ew::speckle_tissue_test {
namespace {

TissueView cube(int side, double spacing_mm) {
  TissueView view;
  view.grid.dims = glm::ivec3(side);
  view.grid.spacing_mm = glm::dvec3(spacing_mm);
  return view;
}

double correlationOf(const Volume& a, const Volume& b) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  const auto n = static_cast<double>(a.echo.size());
  for (std::size_t q = 0; q < a.echo.size(); ++q) {
    const double x = a.echo[q], y = b.echo[q];
    sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
  }
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

TEST(SpeckleTissue, SpeckleHasTheSamePowerBetweenScatterersAsOnThemAndIsRayleigh) {
  const SpeckleTissue tissue(3);
  std::mt19937 draw(1);
  std::uniform_real_distribution<double> side(-100.0, 100.0);
  for (const double offset : {0.0, 0.13, 0.265}) {
    double power = 0.0, envelope = 0.0;
    constexpr int kPoints = 40000;
    for (int n = 0; n < kPoints; ++n) {
      const glm::dvec3 p = glm::floor(glm::dvec3(side(draw), side(draw), side(draw)) / 0.53) * 0.53 + offset;
      const glm::dvec2 f = tissue.field(p, 0);
      power += glm::dot(f, f) / kPoints;
      envelope += glm::length(f) / kPoints;
    }
    EXPECT_NEAR(power, 1.0, 0.03) << offset;
    EXPECT_NEAR(envelope, std::sqrt(std::acos(-1.0)) / 2.0, 0.03) << offset;
  }
}

TEST(SpeckleTissue, IsTheSameForAnyNumberOfThreadsAndFollowsThePose) {
  const SpeckleTissue tissue(5);
  const auto once = imageOf(tissue, cube(32, 0.6), 1, noProgress());
  const auto twice = imageOf(tissue, cube(32, 0.6), 8, noProgress());
  ASSERT_TRUE(once && twice);
  EXPECT_EQ(*once, *twice);
  TissueView shifted = cube(32, 0.6);
  shifted.toTissue = [](const glm::dvec3& p) { return p + glm::dvec3(3.0, 0.0, 0.0); };  // five voxels
  const auto moved = imageOf(tissue, shifted, 1, noProgress());
  ASSERT_TRUE(moved);
  int differing = 0;
  for (int k = 0; k < 32; ++k)
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i + 5 < 32; ++i)
        differing += std::abs(moved->echo[moved->grid.indexOf(i, j, k)] - once->echo[once->grid.indexOf(i + 5, j, k)]) > 1 ? 1 : 0;
  EXPECT_EQ(differing, 0);
}

TEST(SpeckleTissue, SharedSpeckleCorrelatesAndIndependentSpeckleLeavesTheStructure) {
  const SpeckleTissue tissue(7), other(8);
  const auto fixed = imageOf(tissue, cube(40, 0.6), 0, noProgress());
  std::vector<double> correlation;
  for (const double shared : {1.0, 0.7, 0.0}) {
    TissueView view = cube(40, 0.6);
    view.shared = shared;
    view.view = 2;
    const auto seen = imageOf(tissue, view, 0, noProgress());
    ASSERT_TRUE(fixed && seen);
    correlation.push_back(correlationOf(*fixed, *seen));
  }
  EXPECT_NEAR(correlation[0], 1.0, 1e-9);
  EXPECT_LT(correlation[1], 0.9);
  EXPECT_LT(correlation[2], correlation[1] - 0.05);
  EXPECT_GT(correlation[2], 0.3) << "the structure is seen in both";
  EXPECT_LT(std::abs(correlationOf(*fixed, *imageOf(other, cube(40, 0.6), 0, noProgress()))), 0.3);
}

}  // namespace
}  // namespace ew::speckle_tissue_test
