#include "ew/sdk/placement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ew/core/frames.h"

namespace ew::sdk::placement_test {
namespace {

using FileToWorld = Transform<frame::World, frame::File>;

double largestDifference(const FileToWorld& a, const FileToWorld& b) {
  double largest = 0.0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) largest = std::max(largest, std::abs(a.matrix[c][r] - b.matrix[c][r]));
  return largest;
}

TEST(Placement, TurnsAboutTheFixedAxesFirstXThenYThenZ) {
  const Placement placement{{1, 2, 3}, {10, 20, 30}};
  const auto turn = [](double angle_deg, glm::dvec3 axis) { return glm::rotate(glm::dmat4(1.0), glm::radians(angle_deg), axis); };
  const FileToWorld expected{glm::translate(glm::dmat4(1.0), {1, 2, 3}) * turn(30, {0, 0, 1}) * turn(20, {0, 1, 0}) * turn(10, {1, 0, 0})};
  EXPECT_LT(largestDifference(transformOf(placement), expected), 1e-15);
}

TEST(Placement, IsExactAtQuarterTurns) {
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) {
        const FileToWorld m = transformOf({{0, 0, 0}, {90.0 * x, 90.0 * y, 90.0 * z}});
        for (const double entry : rowsOf(m)) ASSERT_TRUE(entry == 0.0 || entry == 1.0 || entry == -1.0) << x << y << z << ' ' << entry;
        ASSERT_EQ(largestDifference(transformOf(placementOf(m)), m), 0.0);
      }
}

TEST(Placement, InGimbalLockCarriesTheWholeTurnInZ) {
  for (const double up : {90.0, -90.0}) {
    const FileToWorld m = transformOf({{5, 6, 7}, {25, up, 40}});
    const Placement found = placementOf(m);
    EXPECT_NEAR(found.rotation_deg.x, 0.0, 0.0);
    EXPECT_NEAR(found.rotation_deg.y, up, 1e-12);
    EXPECT_NEAR(found.rotation_deg.z, up > 0 ? 40 - 25 : 40 + 25, 1e-9);
    EXPECT_LT(largestDifference(transformOf(found), m), 1e-12);
  }
}

TEST(Placement, KeepsItsDigitsBesideTheGimbalLock) {
  for (const double beside : {1e-3, 1e-5, 1e-7, 1e-9, 1e-10})
    for (const double up : {90.0, -90.0}) {
      const FileToWorld m = transformOf({{0, 0, 0}, {12, up - beside, -77}});
      EXPECT_LT(largestDifference(transformOf(placementOf(m)), m), 1e-12) << beside;
    }
}

RC_GTEST_PROP(Placement, ComesBackFromItsMatrix, ()) {
  const auto number = [](int range, double unit) { return *rc::gen::inRange(-range, range + 1) * unit; };
  const Placement placement{{number(100000, 0.013), number(100000, 0.013), number(100000, 0.013)},
                            {number(17999, 0.01), number(8999, 0.01), number(17999, 0.01)}};
  const Placement found = placementOf(transformOf(placement));
  RC_ASSERT(found.at_mm == placement.at_mm);
  RC_ASSERT(glm::length(found.rotation_deg - placement.rotation_deg) < 1e-9);
}

RC_GTEST_PROP(Placement, GivesBackAnyRigidMatrix, ()) {
  const auto angle = [] { return *rc::gen::inRange(-400, 400) * 0.9 + *rc::gen::inRange(-1000, 1000) * 1e-9; };
  const FileToWorld m = transformOf({{1, 2, 3}, {angle(), angle(), angle()}});
  RC_ASSERT(static_cast<bool>(checkRigid(m, 1e-12)));
  const Placement found = placementOf(m);
  RC_ASSERT(largestDifference(transformOf(found), m) < 1e-12);
  RC_ASSERT(std::abs(found.rotation_deg.y) <= 90.0);
  RC_ASSERT(found.rotation_deg.x > -180.0 && found.rotation_deg.x <= 180.0);
}

}  // namespace
}  // namespace ew::sdk::placement_test
