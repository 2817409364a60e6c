#include <gtest/gtest.h>
// gtest before rapidcheck: its header relies on it
#include <rapidcheck/gtest.h>

#include <cmath>

#include "recipes.h"

namespace ew::shapes_test {
namespace {

using testing::bodyOf;

glm::dvec3 anyPoint(int reach_mm) {
  const auto number = [&] { return *rc::gen::inRange(-reach_mm * 16, reach_mm * 16) / 16.0; };
  return {number(), number(), number()};
}

RC_GTEST_PROP(Ellipsoid, WithEqualRadiiIsExactlyASphere, ()) {
  static const auto ball = bodyOf(R"({"ellipsoid": {"centre_mm": [3, -4, 5], "radii_mm": [20, 20, 20]}})");
  const glm::dvec3 p = anyPoint(80);
  RC_PRE(glm::distance(p, glm::dvec3(3, -4, 5)) > 1e-3);
  RC_ASSERT(std::abs(ball->signedDistance_mm(p) - (glm::distance(p, glm::dvec3(3, -4, 5)) - 20.0)) < 1e-9);
}

RC_GTEST_PROP(Ellipsoid, HasTheExactSignEverywhere, ()) {
  static const auto body = bodyOf(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [50, 10, 25]}})");
  const glm::dvec3 p = anyPoint(60);
  const glm::dvec3 s = p / glm::dvec3(50, 10, 25);
  const double level = glm::dot(s, s) - 1.0;
  RC_PRE(std::abs(level) > 1e-9);
  RC_ASSERT((body->signedDistance_mm(p) < 0.0) == (level < 0.0));
}

TEST(Ellipsoid, IsExactOnItsAxesAndHasUnitSlopeOnItsSurface) {
  const auto body = bodyOf(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [50, 10, 25], "turned_deg": [0, 0, 90]}})");
  EXPECT_NEAR(body->signedDistance_mm({0, 62, 0}), 12.0, 1e-9);  // the long radius now points along y
  EXPECT_NEAR(body->signedDistance_mm({14, 0, 0}), 4.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 20}), -5.0, 1e-9);
  for (double angle = 0.1; angle < 6.2; angle += 0.37) {
    const glm::dvec3 on(10.0 * std::sin(angle), 50.0 * std::cos(angle), 0.0);
    const glm::dvec3 normal = outwardNormal(*body, on, 1e-4);
    const double slope = (body->signedDistance_mm(on + 1e-4 * normal) - body->signedDistance_mm(on - 1e-4 * normal)) / 2e-4;
    EXPECT_NEAR(slope, 1.0, 1e-4) << "at angle " << angle;
  }
}

RC_GTEST_PROP(Capsule, TaperedIsTheUnionOfTheBallsAlongIt, ()) {
  static const auto body =
      bodyOf(R"({"capsule": {"from_mm": [-20, 5, 0], "to_mm": [30, -10, 8], "from_radius_mm": 14, "to_radius_mm": 5}})");
  const glm::dvec3 from(-20, 5, 0), to(30, -10, 8), p = anyPoint(70);
  // |p - c(t)| - r(t) is convex in t, so a ternary search finds the nearest ball; inside, where distances are to the hull, only the sign.
  double low = 0.0, high = 1.0;
  const auto ballAt = [&](double t) { return glm::distance(p, glm::mix(from, to, t)) - (14.0 + (5.0 - 14.0) * t); };
  for (int n = 0; n < 100; ++n) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (ballAt(a) < ballAt(b) ? high : low) = ballAt(a) < ballAt(b) ? b : a;
  }
  const double nearest = ballAt(0.5 * (low + high)), found = body->signedDistance_mm(p);
  RC_ASSERT(std::abs(nearest) < 1e-6 || (found < 0.0) == (nearest < 0.0));
  if (nearest > 0.0) {
    RC_ASSERT(std::abs(found - nearest) < 1e-6);
  }
}

TEST(Tube, PassesThroughItsPointsWithTheirRadii) {
  const auto body = bodyOf(R"({"tube": {"points": [[0, 0, 0, 4], [20, 10, 0, 6], [40, 0, 5, 3], [60, 0, 5, 3]]}})");
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 0}), -4.0, 1e-6);
  EXPECT_LT(body->signedDistance_mm({20, 10, 0}), -5.9);
  EXPECT_NEAR(body->signedDistance_mm({60, 0, 5}), -3.0, 1e-6);
  EXPECT_NEAR(body->signedDistance_mm({70, 0, 5}), 7.0, 1e-6) << "beyond the end it is a ball";
  EXPECT_NEAR(body->signedDistance_mm({-10, 0, 0}), 6.0, 0.5);
}

TEST(Tube, IsDeepestOnItsCentreLineAcrossSpanJoints) {
  // The joint of two spans lies inside both: whichever is asked first, the deeper one must win.
  const auto body = bodyOf(R"({"tube": {"points": [[0, 0, 0, 10], [50, 0, 0, 10], [100, 0, 0, 10]]}})");
  for (double x = 0.0; x <= 100.0; x += 0.5) EXPECT_NEAR(body->signedDistance_mm({x, 3, 0}), -7.0, 1e-9) << "x = " << x;
}

TEST(Loft, PassesThroughItsSections) {
  const auto body = bodyOf(R"({"loft": {"sections": [
    {"z_mm": -50, "half_width_mm": 30, "front_mm": 20, "back_mm": 15},
    {"z_mm": 0, "half_width_mm": 40, "front_mm": 30, "back_mm": 25, "squareness": 0.5},
    {"z_mm": 60, "centre_y_mm": 10, "half_width_mm": 20, "front_mm": 20, "back_mm": 15}]}})");
  EXPECT_NEAR(body->signedDistance_mm({40, 0, 0}), 0.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({-40, 0, 0}), 0.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({0, -30, 0}), 0.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({0, 25, 0}), 0.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 75}), 15.0, 1e-9) << "capped at its last section";
  EXPECT_GT(body->signedDistance_mm({35, 22, 0}), 0.0);
  const auto round = bodyOf(R"({"loft": {"sections": [{"z_mm": -50, "half_width_mm": 30, "front_mm": 30, "back_mm": 30},
    {"z_mm": 50, "half_width_mm": 30, "front_mm": 30, "back_mm": 30}]}})");
  EXPECT_NEAR(round->signedDistance_mm({30, 40, 7}), 20.0, 1e-9) << "a cylinder is exact";
}

RC_GTEST_PROP(SmoothUnion, HasAGradientWithoutJumps, ()) {
  static const auto body = bodyOf(R"({"union": [{"ellipsoid": {"centre_mm": [-18, 0, 0], "radii_mm": [20, 20, 20]}},
    {"ellipsoid": {"centre_mm": [18, 0, 0], "radii_mm": [20, 20, 20]}, "blend_mm": 24}]})");
  glm::dvec3 p = anyPoint(30);
  if (*rc::gen::inRange(0, 2) == 0) {
    p.x = 0.0;  // where both parts are equally far: a plain minimum has its crease here
  }
  RC_PRE(glm::distance(p, glm::dvec3(-18, 0, 0)) > 2.0 && glm::distance(p, glm::dvec3(18, 0, 0)) > 2.0);
  // Second differences of a function with continuous gradient vanish with the step; across a crease they do not.
  const double h = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = h;
    const double curved = body->signedDistance_mm(p + step) - 2.0 * body->signedDistance_mm(p) + body->signedDistance_mm(p - step);
    RC_ASSERT(std::abs(curved) / h < 2.0 * h);  // curvature here stays below 2 per mm
  }
}

RC_GTEST_PROP(SmoothUnion, NeverLiesAboveItsPartsNorMoreThanAQuarterOfTheBlendBelow, ()) {
  static const auto joined = bodyOf(R"({"union": [{"ellipsoid": {"centre_mm": [-18, 0, 0], "radii_mm": [20, 20, 20]}},
    {"ellipsoid": {"centre_mm": [18, 0, 0], "radii_mm": [20, 20, 20]}, "blend_mm": 24}]})");
  const glm::dvec3 p = anyPoint(60);
  const double plain = std::min(glm::distance(p, glm::dvec3(-18, 0, 0)), glm::distance(p, glm::dvec3(18, 0, 0))) - 20.0;
  RC_ASSERT(joined->signedDistance_mm(p) <= plain + 1e-9);
  RC_ASSERT(joined->signedDistance_mm(p) >= plain - 6.0 - 1e-9);
}

TEST(Difference, TakesTheOtherPartsAway) {
  const auto body = bodyOf(R"({"difference": [{"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [30, 30, 30]}},
    {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [20, 20, 20]}}, {"half_space": {"point_mm": [0, 0, 0], "outward": [0, 0, 1]}}]})");
  EXPECT_GT(body->signedDistance_mm({0, 0, 10}), 0.0);
  EXPECT_LT(body->signedDistance_mm({0, 0, 25}), 0.0);
  EXPECT_GT(body->signedDistance_mm({0, 0, -25}), 0.0);
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 32}), 2.0, 1e-9);
}

constexpr const char* kPlate = R"("half_space": {"point_mm": [0, 0, 0], "outward": [0, 0, 1]})";

TEST(Relief, IsAsHighOnItsLineAsItSaysAndGoneAtItsHalfWidth) {
  const auto body =
      bodyOf(std::string("{") + kPlate + R"(, "relief": [{"points": [[-20, 0, 7], [20, 0, -3]], "half_width_mm": 8, "height_mm": 2.5}]})");
  const auto heightAt = [&](double x, double y) { return -body->signedDistance_mm({x, y, 0.0}); };
  EXPECT_NEAR(heightAt(0, 0), 2.5, 1e-9) << "its points are put on the surface";
  EXPECT_NEAR(body->signedDistance_mm({3, 0, 2.5}), 0.0, 1e-9);
  EXPECT_NEAR(heightAt(5, 4), 2.5 * 0.75 * 0.75, 1e-9);
  EXPECT_EQ(heightAt(5, 8), 0.0);
  EXPECT_EQ(heightAt(28, 0), 0.0);
  EXPECT_EQ(body->signedDistance_mm({0, 0, -31}), -31.0) << "what lies deep does not know of it";
  EXPECT_EQ(body->signedDistance_mm({0, 0, 31}), 31.0);
}

TEST(Relief, RunsOutWhereItsShareOfTheHeightDoes) {
  const auto body =
      bodyOf(std::string("{") + kPlate +
             R"(, "relief": [{"points": [[-20, 0, 0, 0], [0, 0, 0], [20, 0, 0, 0.5]], "half_width_mm": 8, "height_mm": -2}]})");
  EXPECT_NEAR(body->signedDistance_mm({-20, 0, 0}), 0.0, 1e-9);
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 0}), 2.0, 1e-9) << "below 0 it is a furrow";
  EXPECT_NEAR(body->signedDistance_mm({20, 0, 0}), 1.0, 1e-9);
}

TEST(Relief, ThatIsMirroredIsTheSameOnBothSidesAndNoHigherWhereItsHalvesMeet) {
  const auto body =
      bodyOf(std::string("{") + kPlate +
             R"(, "relief": [{"points": [[0, 0, 0], [9, 4, 0], [20, 0, 0]], "half_width_mm": 6, "height_mm": 2, "mirrored": true}]})");
  EXPECT_NEAR(body->signedDistance_mm({0, 0, 0}), -2.0, 1e-9);
  for (double x = 0; x < 30; x += 1.7)
    for (double y = -9; y < 9; y += 1.3) EXPECT_EQ(body->signedDistance_mm({x, y, 0.3}), body->signedDistance_mm({-x, y, 0.3}));
}

TEST(Relief, IsRefusedWithItsPlaceWhenItCannotBe) {
  const testing::Folder folder;
  const auto sentenceOf = [&](const std::string& relief) {
    const auto body =
        readBodyShape(folder.write("body.json", testing::bodyRecipe(std::string("{") + kPlate + R"(, "relief": [)" + relief + "]}")));
    return body ? std::string("read") : body.error().sentence();
  };
  EXPECT_NE(sentenceOf(R"({"points": [], "half_width_mm": 8, "height_mm": 1})").find("points"), std::string::npos);
  EXPECT_NE(sentenceOf(R"({"points": [[0, 0, 0, 2]], "half_width_mm": 8, "height_mm": 1})").find("share"), std::string::npos);
  EXPECT_NE(sentenceOf(R"({"points": [[0, 0, 0]], "half_width_mm": 0, "height_mm": 1})").find("half_width_mm"), std::string::npos);
  EXPECT_NE(sentenceOf(R"({"points": [[0, 0, 0]], "half_width_mm": 8, "height_mm": 11})").find("height_mm"), std::string::npos);
}

TEST(Mirrored, IsTheSameOnBothSidesAndSmoothInTheMiddle) {
  const auto body =
      bodyOf(R"({"ellipsoid": {"centre_mm": [12, 0, 0], "radii_mm": [20, 15, 15]}, "mirrored": true, "mirror_smoothing_mm": 10})");
  EXPECT_EQ(body->signedDistance_mm({17, 3, -5}), body->signedDistance_mm({-17, 3, -5}));
  const double h = 1e-3;
  const double curved =
      body->signedDistance_mm({h, -14, 0}) - 2.0 * body->signedDistance_mm({0, -14, 0}) + body->signedDistance_mm({-h, -14, 0});
  EXPECT_LT(std::abs(curved) / h, 1e-2);
}

}  // namespace
}  // namespace ew::shapes_test
