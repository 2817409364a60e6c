#include "ew/labelling/between.h"

#include <gtest/gtest.h>

#include "labelling/support.h"

namespace ew::labelling {
namespace {

using test::circle;
using test::emptyLabels;
using test::kPi;
using test::planeAt;

TEST(SignedDistance, IsExactToSidesAndCorners) {
  const std::vector<glm::dvec2> square = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  EXPECT_DOUBLE_EQ(signedDistance_mm(square, {0.0, 0.5}), -1.5);
  EXPECT_DOUBLE_EQ(signedDistance_mm(square, {3.5, 1.0}), 1.5);
  EXPECT_DOUBLE_EQ(signedDistance_mm(square, {5.0, 6.0}), 5.0);
}

TEST(FillBetween, MakesATruncatedConeOfTwoCircles) {
  Volume labels = emptyLabels({80, 80, 80}, glm::dvec3(0.5), 0.25);
  const ContourTrace contours[] = {{planeAt({0, 0, -8}), circle(6.0, 360)}, {planeAt({0, 0, 8}), circle(12.0, 360)}};
  ASSERT_TRUE(fillBetween(labels, contours, {.label = 5}, noProgress()));
  // Distances to circles are linear, so the radius is: pi h (a^2 + a b + b^2) / 3.
  const double cone_ml = kPi * 16.0 * (36.0 + 72.0 + 144.0) / 3.0 * 1e-3;
  EXPECT_NEAR(volume_ml(labels, 5), cone_ml, 0.01 * cone_ml);
}

TEST(FillBetween, FollowsAnObliqueShiftAndDoesNotAskForAnOrder) {
  Volume labels = emptyLabels({80, 60, 80}, glm::dvec3(0.5));
  const ContourTrace ordered[] = {{planeAt({0, 0, -9}), circle(5.0, 360, {-6.0, 0.0})},
                                  {planeAt({0, 0, 0}), circle(5.0, 360)},
                                  {planeAt({0, 0, 9}), circle(5.0, 360, {6.0, 0.0})}};
  ASSERT_TRUE(fillBetween(labels, ordered, {}, noProgress()));
  Volume shuffled = emptyLabels({80, 60, 80}, glm::dvec3(0.5));
  const ContourTrace other[] = {ordered[1], ordered[2], ordered[0]};
  ASSERT_TRUE(fillBetween(shuffled, other, {}, noProgress()));
  EXPECT_EQ(labels.echo, shuffled.echo);
  // Half way both discs lie 3 mm beside: the cut is as wide as they are and sqrt(25 - 9) = 4 mm high.
  EXPECT_NEAR(volume_ml(labels, 1), 1.22, 0.03);
}

TEST(FillBetween, FillsAFanOfTiltedPlanes) {
  // Great circles of a ball about the origin would cross; planes through an axis beside it do not: cuts of a ball, tilted by 10 degrees
  // each.
  Volume labels = emptyLabels({90, 90, 90}, glm::dvec3(0.5));
  const double radius_mm = 10.0;
  std::vector<ContourTrace> contours;
  for (int n = -2; n <= 2; ++n) {
    const double tilt_rad = n * 10.0 * kPi / 180.0;
    // The apex is 25 mm above the ball's middle.
    const auto plane = Transform<frame::File, frame::Probe>{
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, -25.0, 0.0)), tilt_rad, glm::dvec3(1.0, 0.0, 0.0))};
    const glm::dvec3 middle = carried(rigidInverse(plane), glm::dvec3(0.0));
    contours.push_back({plane, circle(std::sqrt(radius_mm * radius_mm - middle.z * middle.z), 180, glm::dvec2(middle))});
  }
  ASSERT_TRUE(fillBetween(labels, contours, {}, noProgress()));
  Volume ball = emptyLabels({90, 90, 90}, glm::dvec3(0.5));
  const glm::dvec3 origin(0.0);
  paintBall(ball, {&origin, 1}, radius_mm, {});
  // The caps beyond the outermost planes are not filled.
  const double overlap = test::dice(labels, 1, ball.echo, 1);
  EXPECT_GT(overlap, 0.93);
  RecordProperty("dice_fan_of_five", std::to_string(overlap));
}

TEST(FillBetween, RefusesWhatHasNoShapeAndChangesNothingThen) {
  Volume labels = emptyLabels({20, 20, 20}, glm::dvec3(1.0));
  const Volume before = labels;
  const ContourTrace one[] = {{planeAt({0, 0, 0}), circle(5.0)}};
  EXPECT_EQ(fillBetween(labels, one, {}, noProgress()).error().code, ErrorCode::badUsage);
  const ContourTrace crossing[] = {{planeAt({0, 0, 0}), circle(5.0)}, {planeAt({0, 0, 0}, 0.8, {1.0, 0.0, 0.0}), circle(5.0)}};
  EXPECT_EQ(fillBetween(labels, crossing, {}, noProgress()).error().code, ErrorCode::badUsage);
  EXPECT_EQ(labels, before);
}

}  // namespace
}  // namespace ew::labelling
