#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ew/imaging/flow_field.h"
#include "flow/womersley.h"

namespace ew::womersley_test {
namespace {

// Womersley 1955, evaluated with numpy from his formula: centre over mean, and its lag in degrees.
struct CentreOfProfile {
  double alpha, ratio, phase_deg;
};
constexpr CentreOfProfile kKnown[] = {{1.0, 2.00, -1.0},  {2.0, 1.98, -5.0},  {3.0, 1.90, -10.0}, {4.0, 1.75, -15.0}, {5.0, 1.54, -19.0},
                                      {6.0, 1.35, -18.0}, {8.0, 1.18, -12.0}, {10.0, 1.14, -9.0}, {13.0, 1.12, -7.0}};

TEST(Womersley, HasTheCentreOfTheTables) {
  for (const CentreOfProfile& known : kKnown) {
    const auto centre = womersleyProfile(known.alpha, 0.0);
    EXPECT_NEAR(std::abs(centre), known.ratio, 0.006) << known.alpha;
    EXPECT_NEAR(std::arg(centre) * 180.0 / std::numbers::pi, known.phase_deg, 0.7) << known.alpha;
  }
}

TEST(Womersley, BecomesAParabolaForSlowWaves) {
  for (const double y : {0.0, 0.3, 0.8, 1.0})
    for (const double alpha : {0.0, 1e-9, 1e-3}) EXPECT_NEAR(std::abs(womersleyProfile(alpha, y) - 2.0 * (1.0 - y * y)), 0.0, 1e-6);
}

TEST(Womersley, StandsStillAtTheWallAndIsOneOnAverage) {
  for (const double alpha : {0.0, 0.5, 3.0, 10.0, 21.9, 22.1, 40.0, 90.0, 300.0}) {
    EXPECT_LT(std::abs(womersleyProfile(alpha, 1.0)), 1e-9) << alpha;
    EXPECT_LT(std::abs(detail::womersleyAt(alpha, 1.0).within - 1.0), 1e-9) << alpha;
    std::complex<double> mean(0.0);
    constexpr int kSteps = 20000;
    for (int n = 0; n < kSteps; ++n) {
      const double y = (n + 0.5) / kSteps;
      mean += 2.0 * y / kSteps * womersleyProfile(alpha, y);
    }
    EXPECT_LT(std::abs(mean - 1.0), 1e-5) << alpha;
  }
}

TEST(Womersley, IsTheDerivativeOfTheFlowWithin) {
  for (const double alpha : {0.0, 4.0, 21.0, 30.0, 80.0})
    for (const double y : {0.1, 0.5, 0.9}) {
      const double step = 1e-5;
      const auto slope = (detail::womersleyAt(alpha, y + step).within - detail::womersleyAt(alpha, y - step).within) / (2.0 * step);
      EXPECT_LT(std::abs(slope - 2.0 * y * womersleyProfile(alpha, y)), 1e-6) << alpha << ", " << y;
    }
}

TEST(Womersley, GoesOnWhereTheSeriesGivesWayToAsymptotes) {
  for (const double y : {0.0, 0.2, 0.7, 0.95, 0.999}) {
    const auto before = womersleyProfile(21.999999, y), after = womersleyProfile(22.000001, y);
    EXPECT_LT(std::abs(after - before), 1e-6) << y;
  }
}

TEST(Womersley, HasTheNumberOfACommonCarotid) {
  EXPECT_NEAR(womersleyNumber(3.1, 70.0 / 60.0, 1060.0, 3.5), 4.6, 0.05);
  EXPECT_NEAR(womersleyNumber(9.0, 70.0 / 60.0, 1060.0, 3.5), 13.4, 0.1);
}

}  // namespace
}  // namespace ew::womersley_test
