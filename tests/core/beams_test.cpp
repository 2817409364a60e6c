#include "ew/core/beams.h"

#include <gtest/gtest.h>

namespace ew::beams_test {
namespace {

TEST(Beams, AreParallelWithoutAFan) {
  const Beams beams{{0.0, 2.0, 0.0}};
  EXPECT_EQ(beams.at({5.0, -7.0, 3.0}), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_DOUBLE_EQ(beams.depth_mm({5.0, -7.0, 3.0}), -7.0);
}

TEST(Beams, OfASweptFanLeaveTheNearestPlaceOfTheApex) {
  const Beams beams{{0.0, 1.0, 0.0}, Beams::Fan{{0.0, -50.0, 0.0}, {0.0, -50.0, 40.0}}};
  // Beside the way: in the frame that shows the point.
  EXPECT_NEAR(glm::distance(beams.at({30.0, -10.0, 25.0}), glm::dvec3(0.6, 0.8, 0.0)), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(beams.depth_mm({30.0, -10.0, 25.0}), 50.0);
  // Beyond its ends: from the end.
  EXPECT_NEAR(glm::distance(beams.at({0.0, -10.0, 70.0}), glm::dvec3(0.0, 0.8, 0.6)), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(beams.depth_mm({0.0, -10.0, 70.0}), 50.0);
  // At the apex there is no direction but the middle one.
  EXPECT_EQ(beams.at({0.0, -50.0, 12.0}), glm::dvec3(0.0, 1.0, 0.0));
}

TEST(Beams, OfAFanThatOnlyTiltsLeaveOnePlace) {
  const Beams beams{{0.0, 1.0, 0.0}, Beams::Fan{{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}};
  EXPECT_NEAR(glm::distance(beams.at({1.0, 2.0, 8.0}), glm::dvec3(0.0, 0.0, 1.0)), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(beams.depth_mm({1.0, 6.0, 6.0}), 5.0);
}

}  // namespace
}  // namespace ew::beams_test
