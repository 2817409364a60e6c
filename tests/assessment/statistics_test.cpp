#include "ew/assessment/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ew {
namespace {

using Values = std::vector<double>;

Values normal(double mean, double deviation, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> draw(mean, deviation);
  Values values;
  for (int n = 0; n < count; ++n) values.push_back(draw(random));
  return values;
}

TEST(Estimates, HaveIntervalsThatCoverTheTruthAboutAsOftenAsTheySay) {
  int covered = 0;
  constexpr int kTrials = 200;
  for (int n = 0; n < kTrials; ++n) {
    const auto found = contrastingGroups(normal(0.0, 1.0, 30, 1000u + static_cast<unsigned>(n)),
                                         normal(2.0, 1.0, 30, 5000u + static_cast<unsigned>(n)), {.draws = 400});
    ASSERT_TRUE(found);
    EXPECT_LE(found->low, found->value);
    EXPECT_GE(found->high, found->value);
    covered += found->low <= 1.0 && 1.0 <= found->high ? 1 : 0;
  }
  // 95 % of 200 are 190, give or take three standard deviations of 3.1, and a little for 30 attempts.
  EXPECT_GE(covered, 178);
}

TEST(Estimates, AreTheSameForASeed) {
  const Values low = normal(0.0, 1.0, 25, 3), high = normal(1.5, 1.0, 25, 4);
  EXPECT_EQ(contrastingGroups(low, high, {.seed = 7}), contrastingGroups(low, high, {.seed = 7}));
  EXPECT_NE(contrastingGroups(low, high, {.seed = 7}), contrastingGroups(low, high, {.seed = 8}));
}

TEST(WeightedKappa, HasTheValuesOfACountByHand) {
  std::vector<std::pair<int, int>> ratings = {{1, 1}, {1, 2}, {2, 2}, {2, 3}, {3, 3}, {3, 1}};
  // Linear: 1 + 1 + 2 = 4 seen; both raters gave each rating twice, so chance gives (4 / 6) * (1 + 2 + 1 + 1 + 2 + 1) = 16 / 3.
  EXPECT_DOUBLE_EQ(weightedKappa(ratings, KappaWeights::linear)->value, 0.25);
  // Quadratic: 1 + 1 + 4 = 6 seen, chance (4 / 6) * (1 + 4 + 1 + 1 + 4 + 1) = 8.
  EXPECT_DOUBLE_EQ(weightedKappa(ratings, KappaWeights::quadratic)->value, 0.25);
  for (auto& [a, b] : ratings) b = a;
  EXPECT_EQ(weightedKappa(ratings, KappaWeights::quadratic), (Estimate{1.0, 1.0, 1.0}));
  for (auto& [a, b] : ratings) b = 4 - a;
  EXPECT_DOUBLE_EQ(weightedKappa(ratings, KappaWeights::linear)->value, 1.0 - 8.0 / (16.0 / 3.0));
  EXPECT_FALSE(weightedKappa({}, KappaWeights::linear));
  for (auto& each : ratings) each = {3, 3};
  EXPECT_FALSE(weightedKappa(ratings, KappaWeights::linear));
}

/// Table 2 of Shrout & Fleiss 1979: six targets, four judges; their table 4 has .29 and .62.
TEST(IntraclassCorrelation, HasThePublishedValues) {
  const RatingTable table = {{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
  const auto found = intraclassCorrelation(table);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->single.value, 0.29, 0.005);
  EXPECT_NEAR(found->mean.value, 0.62, 0.005);
  EXPECT_LT(found->single.low, found->single.value);
  EXPECT_GT(found->single.high, found->single.value);
}

TEST(IntraclassCorrelation, FallsWhenARaterIsStricterAndIsOneInAgreement) {
  const RatingTable same = {{1, 1, 1}, {3, 3, 3}, {4, 4, 4}, {2, 2, 2}};
  EXPECT_NEAR(intraclassCorrelation(same)->single.value, 1.0, 1e-12);
  RatingTable stricter = same;
  for (auto& row : stricter) row[2] -= 1.0;
  const auto less = intraclassCorrelation(stricter);
  EXPECT_LT(less->single.value, 0.95);
  EXPECT_GT(less->single.value, 0.5);
  EXPECT_FALSE(intraclassCorrelation({{1, 2}}));
  EXPECT_FALSE(intraclassCorrelation({{1}, {2}}));
  EXPECT_FALSE(intraclassCorrelation({{3, 3}, {3, 3}}));
}

TEST(ContrastingGroups, CrossWhereBothCurvesAreAsHigh) {
  const Values failing = {1.0, 2.0, 3.0}, passing = {4.0, 5.0, 6.0};
  EXPECT_NEAR(contrastingGroups(failing, passing)->value, 3.5, 1e-9) << "as wide: in the middle";
  const double level = contrastingGroups(Values{1.0, 2.0, 3.0}, Values{8.0, 11.0, 14.0})->value;
  const auto density = [](double x, double mean, double deviation) {
    return std::exp(-0.5 * std::pow((x - mean) / deviation, 2)) / deviation;
  };
  EXPECT_NEAR(density(level, 2.0, 1.0), density(level, 11.0, 3.0), 1e-9);
  EXPECT_GT(level, 2.0);
  EXPECT_LT(level, 6.5) << "nearer to the narrow group";
  EXPECT_FALSE(contrastingGroups(passing, failing));
  EXPECT_FALSE(contrastingGroups(failing, Values{9.0}));
  EXPECT_FALSE(contrastingGroups(Values{1.0, 1.0}, Values{2.0, 2.0}));
}

}  // namespace
}  // namespace ew
