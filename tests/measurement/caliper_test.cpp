#include "ew/measurement/caliper.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/figure.h"
#include "measurement/calipers.h"

namespace ew::measurement::caliper_test {
namespace {

using test::caliper;
using test::oneOfEachKind;

constexpr double kPi = std::numbers::pi;

double valueOf(const Caliper& drawn, FigureKind kind) {
  const auto measured = measure(drawn);
  if (!measured) return std::nan("");
  const CaliperFigure* figure = measured->figure(kind);
  return figure == nullptr ? std::nan("") : figure->quantity.value;
}

/// A sharp image with a known resolution everywhere.
UncertaintyAt evenly(double pixel_mm, double axial_mm, double lateral_mm) {
  return [=](int, const glm::dvec2&) { return PointUncertainty{glm::dvec2(pixel_mm), axial_mm, lateral_mm, 0.0}; };
}

TEST(Calipers, MeasureExactlyWhatCanBeDrawnExactly) {
  EXPECT_DOUBLE_EQ(valueOf(caliper(CaliperKind::distance, {{1, 2}, {4, 6}}), FigureKind::length), 5.0);
  EXPECT_DOUBLE_EQ(valueOf(caliper(CaliperKind::polyLine, {{0, 0}, {3, 4}, {3, 10}}), FigureKind::length), 11.0);
  const auto square = caliper(CaliperKind::trace, {{10, 10}, {20, 10}, {20, 25}, {10, 25}});
  EXPECT_DOUBLE_EQ(valueOf(square, FigureKind::area), 150.0);
  EXPECT_DOUBLE_EQ(valueOf(square, FigureKind::circumference), 50.0);
  const auto ellipse = caliper(CaliperKind::ellipse, {{-5, 0}, {5, 0}, {0, -3}, {0, 3}});
  EXPECT_DOUBLE_EQ(valueOf(ellipse, FigureKind::area), kPi * 15.0);
  EXPECT_NEAR(valueOf(ellipse, FigureKind::circumference), 25.526998863398130, 1e-12);  // 20 E(0.8)
  EXPECT_DOUBLE_EQ(valueOf(caliper(CaliperKind::angle, {{1, 0}, {0, 0}, {0, 7}}), FigureKind::angle), 90.0);
  EXPECT_NEAR(valueOf(caliper(CaliperKind::angle, {{0, 0}, {2, 0}, {5, 5}, {6, 6}}), FigureKind::angle), 45.0, 1e-12);
  EXPECT_DOUBLE_EQ(valueOf({CaliperKind::ratio, {{0, {{0, 0}, {2, 0}}}, {0, {{0, 0}, {8, 0}}}}}, FigureKind::ratio), 0.25);
  const Caliper ellipsoid{CaliperKind::ellipsoid, {{0, {{0, 0}, {100, 0}}}, {0, {{0, 0}, {0, 80}}}, {1, {{0, 0}, {60, 0}}}}};
  EXPECT_NEAR(valueOf(ellipsoid, FigureKind::volume), kPi / 6.0 * 480.0, 1e-9);
  EXPECT_DOUBLE_EQ(valueOf(caliper(CaliperKind::slope, {{0.5, 20}, {1.0, 10}}), FigureKind::slope), -20.0);
  EXPECT_DOUBLE_EQ(valueOf({CaliperKind::heartRate, {{0, {{0.25, 3}, {1.75, 9}}}}, 3}, FigureKind::heartRate), 120.0);
}

TEST(Calipers, StackDiscsToTheExactVolumeOfACylinderAndNearlyToThatOfAnEllipsoid) {
  const std::vector<glm::dvec2> cylinder{{0, 0}, {60, 0}, {0, -10}, {60, -10}, {60, 10}, {0, 10}};
  EXPECT_NEAR(valueOf(caliper(CaliperKind::discs, cylinder), FigureKind::volume), kPi * 100.0 * 60.0 * 1e-3, 1e-9);
  std::vector<glm::dvec2> narrow{{0, 0}, {60, 0}, {0, -5}, {60, -5}, {60, 5}, {0, 5}};
  EXPECT_NEAR(valueOf({CaliperKind::biplane, {{0, cylinder}, {1, narrow}}}, FigureKind::volume), kPi * 10.0 * 5.0 * 60.0 * 1e-3, 1e-9);
  std::vector<glm::dvec2> ellipsoid{{-40, 0}, {40, 0}};
  for (const glm::dvec2& point : pointsOn({{0, 0}, 40.0, 20.0, 0.0}, 400)) ellipsoid.push_back(point);
  EXPECT_NEAR(valueOf(caliper(CaliperKind::discs, ellipsoid), FigureKind::volume), 4.0 / 3.0 * kPi * 40.0 * 400.0 * 1e-3, 0.15);  // 0.2 %
}

TEST(Calipers, RefuseWhatCannotBeMeasuredInASentence) {
  const auto sentence = [](const Caliper& drawn) {
    const auto measured = measure(drawn);
    return measured ? std::string("measured") : measured.error().sentence();
  };
  EXPECT_EQ(sentence(caliper(CaliperKind::distance, {{1, 1}, {1, 1}})), "Both points lie on each other; move one of them.");
  EXPECT_EQ(sentence(caliper(CaliperKind::angle, {{1, 1}, {1, 1}, {2, 2}})), "One leg of the angle has no length; move one of its ends.");
  EXPECT_EQ(sentence(caliper(CaliperKind::slope, {{1, 1}, {1, 5}})), "Both points lie at the same moment; move one of them.");
  EXPECT_EQ(sentence(caliper(CaliperKind::ellipse, {{1, 1}, {1, 1}, {0, 0}, {2, 0}})),
            "One axis of the ellipse has no length; move one of its ends.");
  EXPECT_EQ(sentence(caliper(CaliperKind::fittedEllipse, {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}})),
            "No ellipse goes through these points; put them around the outline, not along a line.");
  EXPECT_EQ(sentence(caliper(CaliperKind::discs, {{0, 0}, {10, 0}, {50, 1}, {60, 1}, {55, 5}})),
            "The outline does not lie along its long axis; draw the axis through it.");
  EXPECT_EQ(sentence(caliper(CaliperKind::trace, {{0, 0}, {1, 1}})),
            "A caliper of the kind 'trace' has 3 to 10000 points in a part, this one has 2.");
  EXPECT_EQ(sentence({CaliperKind::ratio, {{0, {{0, 0}, {1, 1}}}}}), "A caliper of the kind 'ratio' has 2 parts, this one has 1.");
  EXPECT_EQ(sentence(caliper(CaliperKind::distance, {{0, 0}, {std::nan(""), 1}})), "A point of a caliper lies nowhere; set it again.");
  EXPECT_EQ(sentence({CaliperKind::heartRate, {{0, {{0, 0}, {1, 1}}}}, 0}), "A heart rate is measured over 1 to 20 cycles, not over 0.");
}

TEST(Calipers, SayWhenAnOutlineCrossesItself) {
  const auto bow = measure(caliper(CaliperKind::trace, {{0, 0}, {10, 10}, {10, 0}, {0, 10}}));
  ASSERT_TRUE(bow);
  ASSERT_EQ(bow->remarks.size(), 1u);
  EXPECT_TRUE(measure(caliper(CaliperKind::trace, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}))->remarks.empty());
}

TEST(FigureOf, NamesWhatACaliperMeasuredAndHowFarItIsKnown) {
  const CaliperFigure longAxis{FigureKind::longAxis, {41.25, 0.5, Unit::mm}, {}};
  EXPECT_EQ(figureOf(longAxis), (Figure{"long_axis", 41.25, "mm", 0.5}));
  EXPECT_EQ(figureOf({FigureKind::ratio, {0.75, 0.0, Unit::one}, {}}), (Figure{"ratio", 0.75, "1", 0.0}));
}

RC_GTEST_PROP(Calipers, HaveTheDerivativesThatDifferencesHave, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  for (const Caliper& drawn : oneOfEachKind(seed)) {
    const auto measured = measure(drawn);
    RC_ASSERT(measured.has_value());
    for (const CaliperFigure& figure : measured->figures) {
      std::size_t n = 0;
      double largest = 1e-12;
      for (const glm::dvec2& slope : figure.gradient) largest = std::max(largest, glm::length(slope));
      for (std::size_t part = 0; part < drawn.parts.size(); ++part)
        for (std::size_t point = 0; point < drawn.parts[part].points.size(); ++point, ++n)
          for (int axis = 0; axis < 2; ++axis) {
            constexpr double kStep = 1e-5;
            Caliper above = drawn, below = drawn;
            above.parts[part].points[point][axis] += kStep;
            below.parts[part].points[point][axis] -= kStep;
            // Where the middle line of a disc passes a corner of the outline within a step, the value bends; one side still has the slope.
            const double here = figure.quantity.value, slope = figure.gradient[n][axis];
            const double forwards = (valueOf(above, figure.kind) - here) / kStep, backwards = (here - valueOf(below, figure.kind)) / kStep;
            const double apart =
                std::min({std::abs(0.5 * (forwards + backwards) - slope), std::abs(forwards - slope), std::abs(backwards - slope)});
            if (apart > 2e-4 * largest)
              RC_FAIL(std::string(wordOf(drawn.kind)) + " " + std::string(wordOf(figure.kind)) + " point " + std::to_string(n) + ": " +
                      std::to_string(forwards) + " and " + std::to_string(backwards) + " are not " + std::to_string(slope));
          }
      RC_ASSERT(n == figure.gradient.size());
    }
  }
}

RC_GTEST_PROP(Calipers, DoNotDependOnWhereAndHowTheyAreTurned, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const double angle_rad = 0.001 * *rc::gen::inRange(-3141, 3142);
  test::Scatter scatter(seed + 1);
  const glm::dvec2 shift = scatter.point(300.0);
  const glm::dmat2 turn(std::cos(angle_rad), std::sin(angle_rad), -std::sin(angle_rad), std::cos(angle_rad));
  for (const Caliper& drawn : oneOfEachKind(seed)) {
    if (shapeOf(drawn.kind).isInStrip) continue;
    Caliper moved = drawn;
    for (CaliperPart& part : moved.parts)
      for (glm::dvec2& point : part.points) point = turn * point + shift;
    const auto before = measure(drawn), after = measure(moved);
    RC_ASSERT(before.has_value() && after.has_value());
    for (std::size_t n = 0; n < before->figures.size(); ++n) {
      const double a = before->figures[n].quantity.value, b = after->figures[n].quantity.value;
      if (std::abs(a - b) > 1e-7 * std::abs(a))
        RC_FAIL(std::string(wordOf(drawn.kind)) + ": " + std::to_string(a) + " became " + std::to_string(b));
    }
  }
}

TEST(Uncertainty, OfADistanceIsThatOfItsTwoEndsAlongIt) {
  const double pixel_mm = 0.3, axial_mm = 0.6, lateral_mm = 2.4;
  const auto at = evenly(pixel_mm, axial_mm, lateral_mm);
  const auto along = measure(caliper(CaliperKind::distance, {{0, 50}, {0, 90}}), at);
  const auto across = measure(caliper(CaliperKind::distance, {{-20, 70}, {20, 70}}), at);
  ASSERT_TRUE(along && across);
  const double pixel2 = pixel_mm * pixel_mm / 12.0;
  EXPECT_NEAR(along->figures[0].quantity.uncertainty, std::sqrt(2.0 * (pixel2 + std::pow(0.5 * axial_mm / 2.35482, 2))), 1e-6);
  EXPECT_NEAR(across->figures[0].quantity.uncertainty, std::sqrt(2.0 * (pixel2 + std::pow(0.5 * lateral_mm / 2.35482, 2))), 1e-6);
  EXPECT_EQ(measure(caliper(CaliperKind::distance, {{0, 50}, {0, 90}}))->figures[0].quantity.uncertainty, 0.0);
}

TEST(Uncertainty, FollowsTheBeamsDirection) {
  const auto at = [](int, const glm::dvec2&) { return PointUncertainty{{0, 0}, 0.0, 2.0, 0.5}; };
  // Along the beam the lateral width does nothing, across it everything.
  const glm::dvec2 beam(std::sin(0.5), std::cos(0.5)), across(std::cos(0.5), -std::sin(0.5));
  EXPECT_NEAR(measure(caliper(CaliperKind::distance, {{0, 0}, 30.0 * beam}), at)->figures[0].quantity.uncertainty, 0.0, 1e-12);
  EXPECT_NEAR(measure(caliper(CaliperKind::distance, {{0, 0}, 30.0 * across}), at)->figures[0].quantity.uncertainty,
              std::sqrt(2.0) * edgeDeviation_mm(2.0), 1e-12);
}

TEST(Uncertainty, GrowsWithTheWidthOfTheBeamAtItsDepth) {
  const auto at = [](int, const glm::dvec2& p) { return PointUncertainty{glm::dvec2(0.2), 0.5, 0.03 * p.y, 0.0}; };
  const auto near = measure(caliper(CaliperKind::distance, {{-10, 30}, {10, 30}}), at);
  const auto far = measure(caliper(CaliperKind::distance, {{-10, 120}, {10, 120}}), at);
  EXPECT_GT(far->figures[0].quantity.uncertainty, 3.0 * near->figures[0].quantity.uncertainty);
}

TEST(Uncertainty, IsTheScatterOfManyMeasurementsOfPointsSetAtRandom) {
  const auto at = evenly(0.0, 1.2, 3.0);
  for (const Caliper& drawn : oneOfEachKind(11)) {
    if (drawn.kind == CaliperKind::trace || drawn.kind == CaliperKind::discs || drawn.kind == CaliperKind::biplane)
      continue;  // not set one by one
    if (shapeOf(drawn.kind).isInStrip) continue;
    const auto measured = measure(drawn, at);
    ASSERT_TRUE(measured);
    test::Scatter scatter(7);
    double sum = 0.0, squares = 0.0;
    constexpr int kTrials = 4000;
    for (int n = 0; n < kTrials; ++n) {
      Caliper moved = drawn;
      for (CaliperPart& part : moved.parts)
        for (glm::dvec2& point : part.points)
          point += glm::dvec2(scatter.normal(edgeDeviation_mm(3.0)), scatter.normal(edgeDeviation_mm(1.2)));
      const double value = valueOf(moved, measured->figures[0].kind);
      sum += value;
      squares += value * value;
    }
    const double deviation = std::sqrt(squares / kTrials - sum * sum / kTrials / kTrials);
    EXPECT_NEAR(measured->figures[0].quantity.uncertainty / deviation, 1.0, 0.06) << wordOf(drawn.kind);
  }
}

TEST(Uncertainty, OfAnOutlineDoesNotShrinkWithTheNumberOfItsPoints) {
  const auto at = evenly(0.0, 2.0, 2.0);
  const auto traced = [&](int points) {
    return measure(caliper(CaliperKind::trace, pointsOn({{0, 60}, 40.0, 30.0, 0.3}, points)), at)
        ->figure(FigureKind::area)
        ->quantity.uncertainty;
  };
  const double coarse = traced(200), fine = traced(1600);
  EXPECT_NEAR(fine / coarse, 1.0, 0.02);
  // Errors along an edge are those of about circumference / (sqrt(2 pi) width) independent pieces.
  const double width_mm = 2.0 / 2.35482, way_mm = ellipseCircumference_mm(40.0, 30.0);
  EXPECT_NEAR(fine, edgeDeviation_mm(2.0) * std::sqrt(way_mm * std::sqrt(2.0 * kPi) * width_mm), 0.05 * fine);
}

TEST(Uncertainty, OfACornerThatIsSharedCountsItOnce) {
  // Moving the common corner along the first leg lengthens one leg and shortens nothing else: the legs are not independent.
  const auto at = evenly(1.0, 0.0, 0.0);
  const auto straight = measure(caliper(CaliperKind::polyLine, {{0, 0}, {10, 0}, {20, 0}}), at);
  EXPECT_NEAR(straight->figures[0].quantity.uncertainty, std::sqrt(2.0 / 12.0), 1e-12);  // as of its two ends
}

TEST(Calipers, OfAThousandPointsAreMeasured) {
  const auto long_ = measure(caliper(CaliperKind::trace, pointsOn({{0, 60}, 40.0, 30.0, 0.3}, 2000)), evenly(0.1, 0.5, 1.0));
  ASSERT_TRUE(long_);
  EXPECT_NEAR(long_->figure(FigureKind::area)->quantity.value, kPi * 1200.0, 0.01);
}

}  // namespace
}  // namespace ew::measurement::caliper_test
