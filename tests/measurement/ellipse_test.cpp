#include "ew/measurement/ellipse.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "measurement/calipers.h"

namespace ew::measurement::ellipse_test {
namespace {

TEST(EllipseCircumference, IsExactForACircleAndForALine) {
  EXPECT_DOUBLE_EQ(ellipseCircumference_mm(3.0, 3.0), 6.0 * std::numbers::pi);
  EXPECT_NEAR(ellipseCircumference_mm(10.0, 1e-6), 40.0, 1e-9);
  EXPECT_DOUBLE_EQ(ellipseCircumference_mm(3.0, 5.0), ellipseCircumference_mm(5.0, 3.0));
  EXPECT_NEAR(ellipseCircumference_mm(5.0, 3.0), 25.526998863398130, 1e-12);
}

TEST(EllipseCircumference, HasTheSlopesOfDifferencesAlsoBesideACircle) {
  for (const auto& [a, b] : {std::pair{50.0, 40.0}, {40.0, 50.0}, {50.0, 1.0}, {50.0, 49.999}, {50.0, 49.9}, {50.0, 50.0}}) {
    const auto slopes = ellipseCircumferenceSlopes(a, b);
    const double step = 1e-4;
    EXPECT_NEAR(slopes[0], (ellipseCircumference_mm(a + step, b) - ellipseCircumference_mm(a - step, b)) / (2.0 * step), 1e-7)
        << a << " " << b;
    EXPECT_NEAR(slopes[1], (ellipseCircumference_mm(a, b + step) - ellipseCircumference_mm(a, b - step)) / (2.0 * step), 1e-7)
        << a << " " << b;
  }
}

RC_GTEST_PROP(EllipseFit, RecoversAnyEllipseFromPointsOnIt, ()) {
  const Ellipse truth{{*rc::gen::inRange(-200, 200), *rc::gen::inRange(0, 300)},
                      0.1 * *rc::gen::inRange(300, 900),
                      0.1 * *rc::gen::inRange(60, 295),
                      0.001 * *rc::gen::inRange(0, 3141)};
  const auto count = *rc::gen::inRange(6, 40);
  const auto fit = fitEllipse(pointsOn(truth, count));
  RC_ASSERT(fit.has_value());
  RC_ASSERT(fit->isConverged);
  RC_ASSERT(std::abs(fit->ellipse.semiMajor_mm - truth.semiMajor_mm) < 1e-6 * truth.semiMajor_mm);
  RC_ASSERT(std::abs(fit->ellipse.semiMinor_mm - truth.semiMinor_mm) < 1e-6 * truth.semiMajor_mm);
  RC_ASSERT(glm::length(fit->ellipse.centre_mm - truth.centre_mm) < 1e-5);
  RC_ASSERT(fit->residualRms_mm < 1e-6);
}

TEST(EllipseFit, OfACircleHasNoDirectionAndNoTrouble) {
  const auto fit = fitEllipse(pointsOn({{3, 4}, 10.0, 10.0, 0.0}, 8));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->ellipse.semiMajor_mm, 10.0, 1e-6);
  EXPECT_NEAR(fit->ellipse.semiMinor_mm, 10.0, 1e-6);
  for (const glm::dvec2& slope : fit->circumferenceByPoint) EXPECT_TRUE(std::isfinite(slope.x) && std::isfinite(slope.y));
}

/// Root of the mean square of the error of the circumference, percent, over many sets of eight rough clicks.
TEST(EllipseFit, FromEightRoughClicksCostsLittle) {
  const Ellipse head{{2.0, 75.0}, 52.0, 40.0, 0.4};
  const double truth_mm = ellipseCircumference_mm(52.0, 40.0);
  test::Scatter scatter(5);
  double squares = 0.0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    auto clicks = pointsOn(head, 8);
    for (glm::dvec2& click : clicks) click += glm::dvec2(scatter.normal(2.0), scatter.normal(2.0));
    const auto fit = fitEllipse(clicks);
    ASSERT_TRUE(fit) << fit.error();
    EXPECT_TRUE(fit->isConverged);
    const double error = 100.0 * (ellipseCircumference_mm(fit->ellipse.semiMajor_mm, fit->ellipse.semiMinor_mm) / truth_mm - 1.0);
    squares += error * error;
  }
  RecordProperty("rms_percent", std::to_string(std::sqrt(squares / kTrials)));
  EXPECT_LT(std::sqrt(squares / kTrials), 2.0);
}

TEST(EllipseFit, RefusesFourPointsAndPointsOnALine) {
  EXPECT_EQ(fitEllipse(pointsOn({{0, 0}, 3.0, 2.0, 0.0}, 4)).error().sentence(), "An ellipse needs at least 5 points; there are 4.");
  std::vector<glm::dvec2> line;
  for (int n = 0; n < 9; ++n) line.emplace_back(3.0 * n, 2.0 - n);
  EXPECT_FALSE(fitEllipse(line));
  EXPECT_FALSE(fitEllipse(std::vector<glm::dvec2>(7, glm::dvec2(1.0, 2.0))));
}

}  // namespace
}  // namespace ew::measurement::ellipse_test
