#include "ew/assessment/rating_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/made_ratings.h"

namespace ew::rating_statistics_test {
namespace {

using test::ratingOf;
using test::smallForm;

constexpr Bootstrap kFewDraws = {.draws = 100};

/// One item, a scale from 1 to 10: the total is the score.
RatingForm oneItemForm() {
  RatingForm form = smallForm();
  form.highest = 10;
  form.items.resize(1);
  form.items[0].anchors.back().score = 10;
  form.items[0].mayBeNotApplicable = true;
  return form;
}

/// As keepRating would have kept it.
Rating keptRating(const RatingForm& form, const std::string& rater, const std::vector<int>& scores, int revision = 1) {
  Rating rating = ratingOf(form, rater, scores);
  rating.formId = form.id;
  rating.formVersion = form.version;
  rating.formContent = contentOf(form);
  rating.revision = revision;
  return rating;
}

/// An attempt a row, a rater a column; 0: this rater has not rated it.
std::vector<AttemptRatings> attemptsOf(const RatingForm& form, const std::vector<std::vector<int>>& table) {
  std::vector<AttemptRatings> attempts;
  for (const auto& row : table) {
    AttemptRatings& attempt = attempts.emplace_back();
    attempt.attemptId = "attempt-" + std::to_string(attempts.size());
    for (std::size_t n = 0; n < row.size(); ++n)
      if (row[n] != 0) attempt.ratings.push_back(keptRating(form, std::string(1, static_cast<char>('A' + n)), {row[n]}));
  }
  return attempts;
}

const std::vector<std::vector<int>> kShroutFleiss = {{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};

/// Table 2 of Shrout & Fleiss 1979: six targets, four judges; their table 4 has .29 and .62.
TEST(RatingStatistics, HaveThePublishedAgreementOfTotals) {
  const RatingForm form = oneItemForm();
  const RatingStatistics found = ratingStatistics(form, attemptsOf(form, kShroutFleiss));
  EXPECT_EQ(found.raters, (std::vector<std::string>{"A", "B", "C", "D"}));
  EXPECT_EQ(found.attempts, 6u);
  EXPECT_EQ(found.complete, 6u);
  EXPECT_EQ(found.incomplete, 0u);
  ASSERT_TRUE(found.totals);
  EXPECT_NEAR(found.totals->single.value, 0.29, 0.005);
  EXPECT_NEAR(found.totals->mean.value, 0.62, 0.005);
  EXPECT_LT(found.totals->single.low, found.totals->single.value);
  EXPECT_GT(found.totals->single.high, found.totals->single.value);
}

TEST(RatingStatistics, SayHowLenientEachRaterIs) {
  const RatingForm form = oneItemForm();
  const RatingStatistics found = ratingStatistics(form, attemptsOf(form, kShroutFleiss), {.bootstrap = kFewDraws});
  // Sums of the columns 46, 15, 26, 40; the mean of all is 127 / 24.
  const std::vector<double> sums = {46.0, 15.0, 26.0, 40.0};
  ASSERT_EQ(found.leniency.size(), 4u);
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_NEAR(found.leniency[n].aboveMean, sums[n] / 6.0 - 127.0 / 24.0, 1e-12);
    EXPECT_NEAR(*found.totalsOf[n].mean, sums[n] / 6.0, 1e-12);
    EXPECT_EQ(found.totalsOf[n].count, 6u);
  }
  // Of B: 2 1 4 1 5 2, squares about 2.5: 0.25 + 2.25 + 2.25 + 2.25 + 6.25 + 0.25 = 13.5.
  EXPECT_NEAR(*found.totalsOf[1].deviation, std::sqrt(13.5 / 5.0), 1e-12);
}

TEST(RatingStatistics, HaveTheKappaOfACountByHandForEveryPairAndItem) {
  const RatingForm form = oneItemForm();
  // The table of the kappa's own test: 6 seen, 8 by chance.
  const std::vector<std::vector<int>> table = {{1, 1, 3}, {1, 2, 3}, {2, 2, 3}, {2, 3, 3}, {3, 3, 3}, {3, 1, 3}};
  const RatingStatistics found = ratingStatistics(form, attemptsOf(form, table), {.bootstrap = kFewDraws});
  ASSERT_EQ(found.items.size(), 1u);
  const ItemStatistics& item = found.items[0];
  EXPECT_EQ(item.item, "image");
  ASSERT_EQ(item.pairs.size(), 3u);
  EXPECT_EQ(item.pairs[0].first + item.pairs[0].second + item.pairs[1].first + item.pairs[1].second, "ABAC");
  EXPECT_EQ(item.pairs[0].bothRated, 6u);
  ASSERT_TRUE(item.pairs[0].kappa);
  EXPECT_DOUBLE_EQ(item.pairs[0].kappa->value, 1.0 - 6.0 / 8.0);
  // A against C, who gave 3 throughout: seen 4 + 4 + 1 + 1 = 10, as much by chance.
  EXPECT_NEAR(item.pairs[1].kappa->value, 0.0, 1e-12);
  EXPECT_NEAR(*item.raters[0].mean, 2.0, 1e-12);
  EXPECT_NEAR(*item.raters[0].deviation, std::sqrt(4.0 / 5.0), 1e-12);
  EXPECT_EQ(*item.raters[2].deviation, 0.0);
}

TEST(RatingStatistics, LeaveOutWhatIsMissingAndCountIt) {
  const RatingForm form = oneItemForm();
  auto attempts = attemptsOf(form, {{1, 1}, {1, 2}, {2, 0}, {2, 2}, {0, 3}, {3, 3}, {0, 0}});
  attempts[3].ratings[1].items[0].score.reset();  // rated, and the item is not applicable
  const RatingStatistics found = ratingStatistics(form, attempts, {.bootstrap = kFewDraws});
  EXPECT_EQ(found.attempts, 6u) << "one has no rating at all";
  EXPECT_EQ(found.complete, 3u);
  EXPECT_EQ(found.incomplete, 3u);
  const PairAgreement& pair = found.items[0].pairs[0];
  EXPECT_EQ(pair.bothRated, 3u);
  EXPECT_EQ(pair.leftOut, 3u);
  // 1 1, 1 2, 3 3: seen 1; by chance (1: 2, 3: 1 against 1, 2, 3): (2 (0 + 1 + 4) + 1 (4 + 1 + 0)) / 3 = 5.
  EXPECT_DOUBLE_EQ(pair.kappa->value, 0.8);
  EXPECT_EQ(found.items[0].raters[0].count, 5u);
  EXPECT_EQ(found.items[0].raters[1].count, 4u);
  EXPECT_EQ(found.totals->single, intraclassCorrelation({{1, 1}, {1, 2}, {3, 3}}, kFewDraws)->single);
  // A is at -0.5, B at +0.5 in one attempt of three.
  EXPECT_NEAR(found.leniency[0].aboveMean, -0.5 / 3.0, 1e-12);
}

TEST(RatingStatistics, LookAtTheRatersThatAreAskedFor) {
  const RatingForm form = oneItemForm();
  const auto attempts = attemptsOf(form, {{1, 2, 0}, {3, 3, 1}, {4, 5, 0}});
  EXPECT_EQ(ratingStatistics(form, attempts, {.bootstrap = kFewDraws}).complete, 1u);
  const RatingStatistics found = ratingStatistics(form, attempts, {.raters = {"A", "B"}, .bootstrap = kFewDraws});
  EXPECT_EQ(found.complete, 3u);
  EXPECT_EQ(found.raters.size(), 2u);
  EXPECT_TRUE(found.totals);
}

TEST(RatingStatistics, DoNotCountDraftsOtherFormsNorWhatSomebodyChangedAfterwards) {
  const RatingForm form = oneItemForm();
  auto attempts = attemptsOf(form, {{1, 1}, {4, 4}});
  Rating draft = keptRating(form, "A", {9}, 2);
  draft.finished = false;
  attempts[0].ratings.push_back(draft);
  RatingForm changed = form;
  changed.items[0].title.english = "Something else";
  attempts[0].ratings.push_back(keptRating(changed, "A", {9}, 3));
  Rating afterwards = keptRating(form, "A", {9}, 4);
  afterwards.sawOthers = true;
  attempts[0].ratings.push_back(afterwards);
  Rating again = keptRating(form, "B", {2}, 2);
  again.sawName = true;
  attempts[0].ratings.insert(attempts[0].ratings.begin(), again);

  const RatingStatistics usual = ratingStatistics(form, attempts, {.bootstrap = kFewDraws});
  EXPECT_EQ(usual.drafts, 1u);
  EXPECT_EQ(usual.otherForms, 1u);
  EXPECT_EQ(usual.notBlinded, 1u);
  EXPECT_EQ(usual.superseded, 1u) << "B rated again without having seen A's";
  EXPECT_EQ(*usual.totalsOf[0].mean, 2.5);
  EXPECT_EQ(*usual.totalsOf[1].mean, 3.0);

  const RatingStatistics blinded = ratingStatistics(form, attempts, {.counted = RatingFilter::blinded, .bootstrap = kFewDraws});
  EXPECT_EQ(blinded.notBlinded, 2u);
  EXPECT_EQ(blinded.superseded, 0u);
  EXPECT_EQ(*blinded.totalsOf[1].mean, 2.5);

  const RatingStatistics all = ratingStatistics(form, attempts, {.counted = RatingFilter::all, .bootstrap = kFewDraws});
  EXPECT_EQ(all.notBlinded, 0u);
  EXPECT_EQ(all.superseded, 2u);
  EXPECT_EQ(*all.totalsOf[0].mean, 6.5);
}

TEST(RatingStatistics, SuggestAPassLevelFromGroupsOfKnownStanding) {
  const RatingForm form = oneItemForm();
  auto attempts = attemptsOf(form, {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {7, 5}, {10, 10}});
  for (std::size_t n = 0; n < 6; ++n) attempts[n].standing = n < 3 ? Standing::shouldFail : Standing::shouldPass;
  RatingStatistics found = ratingStatistics(form, attempts, {.bootstrap = kFewDraws});
  EXPECT_EQ(found.failing, 3u);
  EXPECT_EQ(found.passing, 3u);
  ASSERT_TRUE(found.passLevel);
  EXPECT_NEAR(found.passLevel->value, 3.5, 1e-9) << "1 2 3 and 4 5 6, the last a mean of two raters: in the middle";
  for (AttemptRatings& attempt : attempts) attempt.standing = Standing::unknown;
  found = ratingStatistics(form, attempts, {.bootstrap = kFewDraws});
  EXPECT_FALSE(found.passLevel);
}

TEST(RatingStatistics, OfNothingAreEmptyAndOfOneRaterHaveNoAgreement) {
  const RatingForm form = oneItemForm();
  const RatingStatistics nothing = ratingStatistics(form, {});
  EXPECT_TRUE(nothing.raters.empty());
  EXPECT_EQ(nothing.attempts, 0u);
  EXPECT_EQ(nothing.complete, 0u);
  EXPECT_FALSE(nothing.totals);
  EXPECT_TRUE(nothing.leniency.empty());
  ASSERT_EQ(nothing.items.size(), 1u);
  EXPECT_TRUE(nothing.items[0].pairs.empty());
  const RatingStatistics alone = ratingStatistics(form, attemptsOf(form, {{3}, {5}}), {.bootstrap = kFewDraws});
  EXPECT_EQ(alone.complete, 2u);
  EXPECT_FALSE(alone.totals);
  EXPECT_EQ(alone.leniency[0].aboveMean, 0.0);
  const RatingStatistics same = ratingStatistics(form, attemptsOf(form, {{3, 3}, {3, 3}}), {.bootstrap = kFewDraws});
  EXPECT_FALSE(same.items[0].pairs[0].kappa) << "chance would agree as well";
  EXPECT_FALSE(same.totals);
}

TEST(RatingStatistics, WeighItemsInTotalsAndKeepThemApartElsewhere) {
  const RatingForm form = smallForm();  // weights 1, 2, 1
  std::vector<AttemptRatings> attempts(2);
  attempts[0].ratings = {keptRating(form, "A", {4, 2, 0}), keptRating(form, "B", {4, 3, 5})};
  attempts[1].ratings = {keptRating(form, "A", {1, 1, 5}), keptRating(form, "B", {2, 2, 2})};
  const RatingStatistics found = ratingStatistics(form, attempts, {.bootstrap = kFewDraws});
  EXPECT_NEAR(*found.totalsOf[0].mean, (8.0 / 3.0 + 8.0 / 4.0) / 2.0, 1e-12);
  EXPECT_NEAR(*found.totalsOf[1].mean, (15.0 / 4.0 + 2.0) / 2.0, 1e-12);
  ASSERT_EQ(found.items.size(), 3u);
  EXPECT_EQ(found.items[2].pairs[0].bothRated, 1u);
  EXPECT_EQ(found.items[2].pairs[0].leftOut, 1u);
  EXPECT_EQ(found.items[2].raters[0].count, 1u);
  EXPECT_FALSE(found.items[2].raters[0].deviation);
  EXPECT_EQ(found.complete, 2u) << "an item that is not applicable leaves a total";
}

}  // namespace
}  // namespace ew::rating_statistics_test
