#include "logic/class_overview.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ew::review {
namespace {

AttemptResult attempt(const std::string& id, double first, bool passed, bool skippedSecond = false) {
  AttemptResult made{id, {{"first", first, passed, false, {{"angle", 100.0 * first, "deg"}}}}};
  if (skippedSecond) made.steps.push_back({"second", 0.0, false, true, {}});
  return made;
}

TEST(Distribution, HasTheQuartilesOfTypeSeven) {
  const Distribution made = distributionOf({4.0, 1.0, 3.0, 2.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(made.values, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
  EXPECT_DOUBLE_EQ(made.lowerQuartile, 1.75);
  EXPECT_DOUBLE_EQ(made.median, 2.5);
  EXPECT_DOUBLE_EQ(made.upperQuartile, 3.25);
  EXPECT_DOUBLE_EQ(made.mean, 2.5);
  EXPECT_TRUE(distributionOf({}).values.empty());
  EXPECT_EQ(distributionOf({0.7}).median, 0.7);
}

TEST(Distribution, CountsEveryValueInOneBin) {
  const std::vector<double> values{0.0, 0.1, 0.5, 0.99, 1.0, 1.5, -0.1};
  EXPECT_EQ(histogramOf(values, 0.0, 1.0, 2), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(histogramOf(values, 0.0, 1.0, 10), (std::vector<std::size_t>{1, 1, 0, 0, 0, 1, 0, 0, 0, 2}));
  EXPECT_EQ(histogramOf(std::vector<double>{3.0, 3.0}, 3.0, 3.0, 4), (std::vector<std::size_t>{2, 0, 0, 0}));
}

TEST(ClassOverview, NamesTheStepThatMostFail) {
  const std::vector<AttemptResult> attempts{attempt("a", 0.9, true, true), attempt("b", 0.5, false, true), attempt("c", 0.8, true)};
  const std::vector<std::string> steps{"first", "second", "third"};
  const ClassOverview made = overviewOf(attempts, steps);
  EXPECT_EQ(made.attempts, 3U);
  ASSERT_EQ(made.steps.size(), 3U);
  EXPECT_EQ(made.steps[0].ended, 3U);
  EXPECT_EQ(made.steps[0].passed, 2U);
  EXPECT_DOUBLE_EQ(made.steps[0].scores.median, 0.8);
  ASSERT_EQ(made.steps[0].figures.size(), 1U);
  EXPECT_EQ(made.steps[0].figures[0].unit, "deg");
  EXPECT_DOUBLE_EQ(made.steps[0].figures[0].values.highest, 90.0);
  EXPECT_EQ(made.steps[1].skipped, 2U);
  EXPECT_TRUE(made.steps[1].scores.values.empty()) << "skipped steps have no score";
  EXPECT_EQ(made.steps[2].ended, 0U);
  EXPECT_EQ(made.hardest, std::optional<std::size_t>(1));
}

TEST(ClassOverview, NamesNoStepWhenNobodyFails) {
  const std::vector<AttemptResult> attempts{attempt("a", 0.9, true)};
  EXPECT_FALSE(overviewOf(attempts, std::vector<std::string>{"first"}).hardest);
}

TEST(ClassOverview, SuggestsAPassLevelBetweenTwoGroups) {
  const std::vector<AttemptResult> attempts{attempt("a", 0.3, false), attempt("b", 0.5, false), attempt("c", 0.7, true),
                                            attempt("d", 0.9, true),  attempt("e", 0.0, false), attempt("f", 0.2, false, true)};
  std::vector<Standing> standings{Standing::notYet,    Standing::notYet,  Standing::competent,
                                  Standing::competent, Standing::unknown, Standing::unknown};
  const auto level = suggestedPassLevel(attempts, standings, "first");
  ASSERT_TRUE(level);
  EXPECT_NEAR(level->value, 0.6, 1e-9) << "both vary alike, so it lies half way between the means";
  standings[0] = Standing::unknown;
  EXPECT_FALSE(suggestedPassLevel(attempts, standings, "first")) << "one is no group";
}

}  // namespace
}  // namespace ew::review
