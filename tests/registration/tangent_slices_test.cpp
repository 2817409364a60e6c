#include <gtest/gtest.h>

#include "ew/registration/elastic.h"
#include "registration/planar_pairs.h"

namespace tangent_slices_test {
namespace {

using namespace ew;
using namespace ew::registration;
using namespace ew::test;

constexpr int kSide = 140;
constexpr double kSpacing_mm = 0.5;

/// Slabs whose slices across z are all alike: the fixed one warped, the moving one as the pattern is and 100 mm to the right.
struct Slabs {
  Volume fixed;
  Volume moving;
  Transform<frame::Moving, frame::Fixed> start;
};
Slabs slabs(const Motion& truth) {
  const Pattern pattern(21, 1.1, 30.0, 30.0);
  const Pair2d pair = pairOf(kSide, kSpacing_mm, pattern, pattern, truth);
  Slabs out;
  out.fixed.grid.dims = {kSide, kSide, 4};
  out.fixed.grid.spacing_mm = glm::dvec3(kSpacing_mm);
  out.moving.grid = out.fixed.grid;
  out.moving.grid.origin_mm = {100.0, 0.0, 0.0};
  out.start.matrix[3] = glm::dvec4(100.0, 0.0, 0.0, 1.0);
  for (int k = 0; k < 4; ++k) {
    out.fixed.echo.insert(out.fixed.echo.end(), pair.fixed.pixels.begin(), pair.fixed.pixels.end());
    out.moving.echo.insert(out.moving.echo.end(), pair.moving.pixels.begin(), pair.moving.pixels.end());
  }
  return out;
}

TEST(RegisterTangentSlices, BendsInThePlaneAndLeavesAlone20MmAway) {
  const Motion truth = warp(3.0, kSide * kSpacing_mm);
  const Slabs pair = slabs(truth);
  const auto found =
      registerTangentSlices({&pair.fixed, {}}, {&pair.moving, {}}, pair.start, {10.0, 10.0, 0.75}, {0.0, 0.0, 2.0}, {}, noProgress());
  ASSERT_TRUE(found) << found.error().sentence();
  EXPECT_EQ(found->slices.verdict, Verdict::aligned);
  EXPECT_EQ(found->share, 1.0);
  EXPECT_EQ(found->fallOff_mm, 20.0);
  EXPECT_GT(found->jacobian.smallest, 0.15);
  double sum = 0.0;
  int count = 0;
  for (double y = 8.0; y < 60.0; y += 4.0) {
    for (double x = 8.0; x < 60.0; x += 4.0, ++count) {
      const glm::dvec3 here{x, y, 0.75}, expected = here + glm::dvec3(100.0, 0.0, 0.0) + glm::dvec3(truth({x, y}), 0.0);
      sum += glm::length(movingPoint(found->fixedToMoving, here) - expected);
      // Half way the square of the cosine is a half; beyond the fall-off nothing is left.
      const glm::dvec3 at = movingPoint(found->fixedToMoving, here) - here - glm::dvec3(100.0, 0.0, 0.0);
      const glm::dvec3 half = movingPoint(found->fixedToMoving, here + glm::dvec3(0.0, 0.0, 10.0)) - here - glm::dvec3(100.0, 0.0, 10.0);
      EXPECT_NEAR(glm::length(half - 0.5 * at), 0.0, 1e-3);
      const glm::dvec3 gone = movingPoint(found->fixedToMoving, here + glm::dvec3(0.0, 0.0, -20.5)) - here - glm::dvec3(100.0, 0.0, -20.5);
      EXPECT_NEAR(glm::length(gone), 0.0, 1e-6);
    }
  }
  EXPECT_LT(sum / count, 0.15);
}

TEST(RegisterTangentSlices, LengthensAFallOffThatWouldShearTheTissue) {
  const Slabs pair = slabs(warp(3.0, kSide * kSpacing_mm));
  TangentWarpOptions options;
  options.fallOff_mm = 2.0;
  const auto found =
      registerTangentSlices({&pair.fixed, {}}, {&pair.moving, {}}, pair.start, {10.0, 10.0, 0.75}, {0.0, 0.0, 1.0}, options, noProgress());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->fallOff_mm, 2.5 * found->slices.largestMotion_mm, 1e-9);
  EXPECT_NE(found->reason.english().find("lengthened"), std::string::npos) << found->reason;
}

TEST(RegisterTangentSlices, TakesMotionBackUntilTheLeastJacobianHolds) {
  const Slabs pair = slabs(warp(5.0, kSide * kSpacing_mm));
  TangentWarpOptions options;
  options.leastJacobian = 0.9;
  const auto found =
      registerTangentSlices({&pair.fixed, {}}, {&pair.moving, {}}, pair.start, {10.0, 10.0, 0.75}, {0.0, 0.0, 1.0}, options, noProgress());
  ASSERT_TRUE(found);
  EXPECT_GE(found->jacobian.smallest, 0.9);
  EXPECT_LT(found->share, 1.0);
  EXPECT_NE(found->reason.english().find("motion was kept"), std::string::npos) << found->reason;
}

TEST(RegisterTangentSlices, CutsThePlaneAlongTheBeamWhateverItsNormal) {
  const Slabs pair = slabs(warp(2.0, kSide * kSpacing_mm));
  const auto found =
      registerTangentSlices({&pair.fixed, {}}, {&pair.moving, {}}, pair.start, {30.0, 30.0, 0.75}, {1.0, 0.0, 0.0}, {}, noProgress());
  ASSERT_TRUE(found) << found.error().sentence();
  EXPECT_NEAR(glm::length(found->slicePlane.directions[1] - glm::dvec3(0.0, 1.0, 0.0)), 0.0, 1e-12);  // y down the beam
  EXPECT_EQ(found->fixedSlice.height, kSide);
  EXPECT_EQ(found->fixedSlice.width, 4);
}

TEST(RegisterTangentSlices, RefusesAPlaneOutsideTheOverlapAndANormalWithoutDirection) {
  const Slabs pair = slabs(warp(2.0, kSide * kSpacing_mm));
  const auto code = [&](const Transform<frame::Moving, frame::Fixed>& start, const glm::dvec3& point, const glm::dvec3& normal) {
    const auto found = registerTangentSlices({&pair.fixed, {}}, {&pair.moving, {}}, start, point, normal, {}, noProgress());
    return found ? ErrorCode::internal : found.error().code;
  };
  EXPECT_EQ(code(pair.start, {0.0, 0.0, 50.0}, {0.0, 0.0, 1.0}), ErrorCode::badField);
  EXPECT_EQ(code({}, {0.0, 0.0, 0.75}, {0.0, 0.0, 1.0}), ErrorCode::badField);  // the moving volume lies elsewhere
  EXPECT_EQ(code(pair.start, {0.0, 0.0, 0.75}, {0.0, 0.0, 0.0}), ErrorCode::badField);
  EXPECT_EQ(code({glm::dmat4(2.0)}, {0.0, 0.0, 0.75}, {0.0, 0.0, 1.0}), ErrorCode::notRigid);
}

}  // namespace
}  // namespace tangent_slices_test
