#include "ew/measurement/findings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "measurement/calipers.h"

namespace ew::measurement::findings_test {
namespace {

constexpr double kPixel_mm = 0.6, kAxial_mm = 0.9, kLateral_mm = 2.4;

Finding found(std::uint64_t image, int number, Caliper caliper) {
  const UncertaintyAt at = [](int, const glm::dvec2&) { return PointUncertainty{glm::dvec2(kPixel_mm), kAxial_mm, kLateral_mm, 0.0}; };
  Measurement measurement;
  measurement.number = number;
  measurement.caliper = std::move(caliper);
  auto measured = measure(measurement.caliper, at);
  return {image, measurement, measured.value_or(Measured{}), at};
}
Finding distance(std::uint64_t image, int number, glm::dvec2 a, glm::dvec2 b) {
  return found(image, number, test::caliper(CaliperKind::distance, {a, b}));
}
FigureRef length(std::uint64_t image, int number) { return {image, number, FigureKind::length}; }

TEST(Findings, RatiosOfMeasurementsThatShareNothingAddTheirRelativeUncertainties) {
  Findings findings;
  findings.measuredIn(1, {distance(1, 1, {0, 0}, {0, 15}), distance(1, 2, {30, 0}, {30, 60})});
  const auto ratio = findings.combine(CombinationKind::ratio, {length(1, 1), length(1, 2)});
  ASSERT_TRUE(ratio.has_value());
  EXPECT_DOUBLE_EQ(ratio->quantity.value, 0.25);
  EXPECT_EQ(ratio->quantity.unit, Unit::one);
  EXPECT_EQ(ratio->correlation, 0.0);
  const double u = findings.all()[0].measured.figures[0].quantity.uncertainty;  // both are along the beam: the same
  EXPECT_NEAR(ratio->quantity.uncertainty, 0.25 * std::hypot(u / 15.0, u / 60.0), 1e-12);
  const auto percent = findings.combine(CombinationKind::percent, {length(1, 1), length(1, 2)});
  EXPECT_DOUBLE_EQ(percent->quantity.value, 25.0);
  const auto stenosis = findings.combine(CombinationKind::reduction, {length(1, 1), length(1, 2)});
  EXPECT_DOUBLE_EQ(stenosis->quantity.value, 75.0);
  EXPECT_EQ(stenosis->quantity.unit, Unit::percent);
  EXPECT_NEAR(stenosis->quantity.uncertainty, 100.0 * ratio->quantity.uncertainty, 1e-10);
}

TEST(Findings, CrossesThatLieOnEachOtherAreOnePointSoTheRatioIsSurer) {
  Findings findings;
  // Both lines begin in one place, and one is a part of the other.
  findings.measuredIn(1, {distance(1, 1, {0, 0}, {0, 30}), distance(1, 2, {0, 0}, {0, 60}), distance(1, 3, {5, 0}, {5, 60})});
  const auto shared = findings.combine(CombinationKind::ratio, {length(1, 1), length(1, 2)});
  const auto apart = findings.combine(CombinationKind::ratio, {length(1, 1), length(1, 3)});
  EXPECT_NEAR(shared->correlation, 0.5, 1e-12);  // one of two equal points each
  EXPECT_EQ(apart->correlation, 0.0);
  EXPECT_LT(shared->quantity.uncertainty, apart->quantity.uncertainty);
  const double u = findings.all()[0].measured.figures[0].quantity.uncertainty;
  EXPECT_NEAR(shared->quantity.uncertainty, 0.5 * std::sqrt(u * u / 900 + u * u / 3600 - 2 * 0.5 * u * u / 1800), 1e-12);
  // In another image the same place is another one.
  findings.measuredIn(2, {distance(2, 1, {0, 0}, {0, 60})});
  EXPECT_EQ(findings.combine(CombinationKind::ratio, {length(1, 1), length(2, 1)})->correlation, 0.0);
}

TEST(Findings, AMeasurementOverItselfIsOneWithoutAnyDoubt) {
  Findings findings;
  findings.measuredIn(1, {distance(1, 1, {0, 0}, {7, 30})});
  const auto one = findings.combine(CombinationKind::ratio, {length(1, 1), length(1, 1)});
  EXPECT_DOUBLE_EQ(one->quantity.value, 1.0);
  EXPECT_NEAR(one->correlation, 1.0, 1e-12);
  EXPECT_NEAR(one->quantity.uncertainty, 0.0, 1e-9);
}

RC_GTEST_PROP(Findings, AFiguresCovarianceWithItselfIsItsUncertaintySquared, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  int number = 0;
  for (const Caliper& caliper : test::oneOfEachKind(seed)) {
    const Finding finding = found(1, ++number, caliper);
    for (const CaliperFigure& a : finding.measured.figures) {
      const double u = a.quantity.uncertainty;
      RC_ASSERT(std::abs(covariance(finding, a, finding, a) - u * u) <= 1e-9 * (u * u + 1e-12));
      for (const CaliperFigure& b : finding.measured.figures) {
        const double both = u * b.quantity.uncertainty;
        RC_ASSERT(std::abs(covariance(finding, a, finding, b)) <= both * (1.0 + 1e-6) + 1e-12);
        RC_ASSERT(std::abs(covariance(finding, a, finding, b) - covariance(finding, b, finding, a)) <= 1e-9 * both + 1e-12);
      }
    }
  }
}

RC_GTEST_PROP(Findings, ARatioTurnedRoundIsItsReciprocalWithTheSameRelativeUncertainty, ()) {
  test::Scatter scatter(*rc::gen::arbitrary<std::uint64_t>());
  const glm::dvec2 shared = scatter.point(50.0);
  Findings findings;
  findings.measuredIn(1, {distance(1, 1, shared, scatter.point(50.0) + glm::dvec2(120.0, 0.0)),
                          distance(1, 2, shared, scatter.point(50.0) - glm::dvec2(120.0, 0.0))});
  const auto there = findings.combine(CombinationKind::ratio, {length(1, 1), length(1, 2)});
  const auto back = findings.combine(CombinationKind::ratio, {length(1, 2), length(1, 1)});
  RC_ASSERT(std::abs(there->quantity.value * back->quantity.value - 1.0) < 1e-12);
  RC_ASSERT(std::abs(there->correlation - back->correlation) < 1e-12);
  RC_ASSERT(std::abs(there->quantity.uncertainty / there->quantity.value - back->quantity.uncertainty / back->quantity.value) < 1e-12);
}

TEST(Findings, RefuseInASentenceWhatIsNoRatioAndNoVolume) {
  Findings findings;
  const auto square = test::caliper(CaliperKind::trace, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const auto angle = test::caliper(CaliperKind::angle, {{1, 0}, {0, 0}, {0, 7}});
  findings.measuredIn(1, {distance(1, 1, {0, 0}, {0, 30}), found(1, 2, square), found(1, 3, angle)});
  const auto sentence = [&](CombinationKind kind, std::vector<FigureRef> of) {
    const auto combined = findings.combine(kind, of);
    return combined ? std::string("computed") : combined.error().sentence();
  };
  EXPECT_EQ(sentence(CombinationKind::ratio, {length(1, 1), {1, 2, FigureKind::area}}),
            "A ratio is of two quantities of one kind, but A is measured in mm and B in mm2; choose two lengths or two areas.");
  EXPECT_EQ(sentence(CombinationKind::ratio, {length(1, 1), {1, 2, FigureKind::circumference}}), "computed");
  EXPECT_EQ(sentence(CombinationKind::ellipsoid, {length(1, 1), length(1, 1), {1, 3, FigureKind::angle}}),
            "A volume is of three lengths, but one of them is measured in deg; choose lengths.");
  EXPECT_EQ(sentence(CombinationKind::ratio, {length(1, 1), length(1, 9)}), "Measurement 9, which this result was made from, was deleted.");
  EXPECT_EQ(sentence(CombinationKind::biplane, {length(1, 1), length(1, 1)}),
            "Discs of two planes need two measurements by discs; draw them in both images first.");
  EXPECT_EQ(sentence(CombinationKind::ellipsoid, {length(1, 1)}), "This result is of 3 measurements, not of 1.");
}

TEST(Findings, AnEllipsoidIsOfThreeLengthsOfTwoImagesAndAsSureAsTheyAre) {
  Findings findings;
  findings.measuredIn(1, {distance(1, 1, {-50, 40}, {50, 40})});
  findings.measuredIn(2, {distance(2, 1, {-30, 40}, {30, 40}), distance(2, 2, {0, 20}, {0, 100})});
  const auto volume = findings.combine(CombinationKind::ellipsoid, {length(1, 1), length(2, 1), length(2, 2)});
  ASSERT_TRUE(volume.has_value());
  EXPECT_NEAR(volume->quantity.value, std::numbers::pi / 6.0 * 480.0, 1e-9);
  EXPECT_EQ(volume->quantity.unit, Unit::ml);
  EXPECT_TRUE(volume->remarks.empty());
  const auto u = [&](int n) { return findings.all()[static_cast<std::size_t>(n)].measured.figures[0].quantity; };
  const double relative =
      std::sqrt(std::pow(u(0).uncertainty / 100, 2) + std::pow(u(1).uncertainty / 60, 2) + std::pow(u(2).uncertainty / 80, 2));
  EXPECT_NEAR(volume->quantity.uncertainty, relative * volume->quantity.value, 1e-9);
  const auto flat = findings.combine(CombinationKind::ellipsoid, {length(2, 1), length(2, 1), length(2, 2)});
  EXPECT_EQ(flat->remarks.size(), 2U);  // one image, and one length twice
}

TEST(Findings, DiscsOfTwoImagesAreThoseOfABiplaneCaliper) {
  const std::vector<glm::dvec2> wide{{0, 0}, {60, 0}, {0, -10}, {60, -10}, {60, 10}, {0, 10}};
  const std::vector<glm::dvec2> narrow{{0, 0}, {60, 0}, {0, -5}, {60, -5}, {60, 5}, {0, 5}};
  Findings findings;
  findings.measuredIn(1, {found(1, 1, test::caliper(CaliperKind::discs, wide))});
  findings.measuredIn(2, {found(2, 1, test::caliper(CaliperKind::discs, narrow))});
  const auto volume = findings.combine(CombinationKind::biplane, {{1, 1, FigureKind::volume}, {2, 1, FigureKind::volume}});
  ASSERT_TRUE(volume.has_value());
  const auto both = measure({CaliperKind::biplane, {{0, wide}, {1, narrow}}}, findings.all()[0].at);
  EXPECT_NEAR(volume->quantity.value, std::numbers::pi * 10.0 * 5.0 * 60.0 * 1e-3, 1e-9);
  EXPECT_NEAR(volume->quantity.uncertainty, both->figures[0].quantity.uncertainty, 1e-12);
  EXPECT_FALSE(findings.combine(CombinationKind::biplane, {{1, 1, FigureKind::volume}, {1, 1, FigureKind::volume}}));
}

TEST(Findings, ResultsFollowTheirMeasurementsAndStayWhenTheImageGoes) {
  Findings findings;
  findings.measuredIn(7, {distance(7, 1, {0, 0}, {0, 10}), distance(7, 2, {20, 0}, {20, 40})});
  findings.measuredIn(8, {});  // nothing was measured: it is not counted
  findings.measuredIn(9, {distance(9, 1, {0, 0}, {0, 50})});
  EXPECT_EQ(findings.ordinalOf(9), 2);
  EXPECT_EQ(findings.add(CombinationKind::percent, {length(7, 1), length(9, 1)}), 1);
  const auto value = [&] { return findings.combine(CombinationKind::percent, findings.combinations()[0].of)->quantity.value; };
  EXPECT_DOUBLE_EQ(value(), 20.0);
  findings.measuredIn(7, {distance(7, 1, {0, 0}, {0, 25}), distance(7, 2, {20, 0}, {20, 40})});
  EXPECT_DOUBLE_EQ(value(), 50.0);
  EXPECT_EQ(findings.all()[0].image, 7U);
  findings.measuredIn(7, {distance(7, 2, {20, 0}, {20, 40})});
  EXPECT_FALSE(findings.combine(CombinationKind::percent, findings.combinations()[0].of));
  EXPECT_TRUE(findings.remove(1));
  EXPECT_FALSE(findings.remove(1));
  EXPECT_EQ(findings.add(CombinationKind::ratio, {length(7, 2), length(9, 1)}), 2);  // a number is never given again
}

TEST(Findings, AreWrittenWithPlacesUnitsAndResults) {
  Findings findings;
  findings.measuredIn(3, {distance(3, 1, {0, 0}, {0, 12}), distance(3, 2, {9, 0}, {9, 48})});
  findings.measuredIn(kStripImage, {found(kStripImage, 1, {CaliperKind::heartRate, {{0, {{1.0, 5.0}, {2.5, 5.0}}}}, 3})});
  findings.add(CombinationKind::reduction, {length(3, 1), length(3, 2)});
  const auto json = toJson(findings, "A case");
  EXPECT_EQ(json["title"], "A case");
  EXPECT_EQ(json["note"], "simulation, not for diagnosis");
  ASSERT_EQ(json["measurements"].size(), 3U);
  EXPECT_EQ(json["measurements"][1]["image"], 1);
  EXPECT_EQ(json["measurements"][2]["strip"], true);
  EXPECT_EQ(json["measurements"][2]["cycles"], 3);
  EXPECT_EQ(json["measurements"][2]["figures"][0]["value"], 120.0);
  EXPECT_EQ(json["measurements"][2]["figures"][0]["unit"], "/min");
  EXPECT_EQ(json["results"][0]["value"], 75.0);
  EXPECT_EQ(json["results"][0]["correlation"], 0.0);
  EXPECT_EQ(json["results"][0]["of"][1]["number"], 2);
  const std::string csv = toCsv(findings, "A, case");
  EXPECT_NE(csv.find("image 1,1,distance,,,length,12,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("strip,1,heart_rate,,,heart_rate,120,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("result,1,reduction,,,reduction,75,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\"A, case: simulation, not for diagnosis\""), std::string::npos) << csv;
}

}  // namespace
}  // namespace ew::measurement::findings_test
