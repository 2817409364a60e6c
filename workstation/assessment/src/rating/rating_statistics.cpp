#include "ew/assessment/rating_statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace ew {
namespace {

using Scores = std::vector<double>;

/// The counting ratings of one attempt, by rater.
struct RatingsByRater {
  Standing standing = Standing::unknown;
  std::map<std::string, const Rating*> byRater;

  [[nodiscard]] const Rating* of(const std::string& rater) const {
    const auto found = byRater.find(rater);
    return found == byRater.end() ? nullptr : found->second;
  }
  [[nodiscard]] std::optional<int> score(const std::string& rater, const std::string& item) const {
    const Rating* rating = of(rater);
    const ItemRating* rated = rating == nullptr ? nullptr : rating->itemOf(item);
    return rated == nullptr ? std::nullopt : rated->score;
  }
};

double meanOfScores(const Scores& scores) {
  return std::accumulate(scores.begin(), scores.end(), 0.0) / static_cast<double>(scores.size());
}

RaterScores scoresOf(const std::string& rater, const Scores& scores) {
  RaterScores made{rater, scores.size(), std::nullopt, std::nullopt};
  if (scores.empty()) return made;
  const double mean = meanOfScores(scores);
  made.mean = mean;
  if (scores.size() < 2) return made;
  double squares = 0.0;
  for (const double each : scores) squares += (each - mean) * (each - mean);
  made.deviation = std::sqrt(squares / static_cast<double>(scores.size() - 1));
  return made;
}

bool isCounted(const Rating& rating, RatingFilter counted) {
  if (counted == RatingFilter::blinded) return rating.isBlinded();
  return counted == RatingFilter::all || !rating.sawOthers;
}

/// Sorts what counts from what does not, and counts both.
class Selection {
 public:
  Selection(const RatingForm& form, const RatingStatisticsOptions& options, RatingStatistics& found)
      : content_(contentOf(form)), options_(options), only_(options.raters.begin(), options.raters.end()), found_(found) {}

  RatingsByRater of(const AttemptRatings& attempt) {
    RatingsByRater made{attempt.standing, {}};
    for (const Rating& rating : attempt.ratings) {
      if (!isWanted(rating)) continue;
      const Rating*& kept = made.byRater[rating.rater];
      found_.superseded += kept != nullptr ? 1 : 0;
      if (kept == nullptr || rating.revision > kept->revision) kept = &rating;
    }
    return made;
  }

 private:
  bool isWanted(const Rating& rating) {
    if (!only_.empty() && !only_.contains(rating.rater)) return false;
    std::size_t* reason = !rating.finished                       ? &found_.drafts
                          : rating.formContent != content_       ? &found_.otherForms
                          : !isCounted(rating, options_.counted) ? &found_.notBlinded
                                                                 : nullptr;
    if (reason != nullptr) ++*reason;
    return reason == nullptr;
  }

  std::string content_;
  const RatingStatisticsOptions& options_;
  std::set<std::string> only_;
  RatingStatistics& found_;
};

PairAgreement agreementOn(const std::string& item, const std::string& first, const std::string& second,
                          const std::vector<RatingsByRater>& attempts, const Bootstrap& bootstrap) {
  PairAgreement pair{first, second, 0, 0, std::nullopt};
  std::vector<std::pair<int, int>> both;
  for (const RatingsByRater& attempt : attempts) {
    const auto a = attempt.score(first, item), b = attempt.score(second, item);
    if (a && b) both.emplace_back(*a, *b);
    pair.leftOut += a.has_value() != b.has_value() ? 1 : 0;
  }
  pair.bothRated = both.size();
  pair.kappa = weightedKappa(both, KappaWeights::quadratic, bootstrap);
  return pair;
}

ItemStatistics statisticsOf(const std::string& item, const std::vector<std::string>& raters, const std::vector<RatingsByRater>& attempts,
                            const Bootstrap& bootstrap) {
  ItemStatistics made{item, {}, {}};
  for (auto first = raters.begin(); first != raters.end(); ++first) {
    Scores scores;
    for (const RatingsByRater& attempt : attempts)
      if (const auto score = attempt.score(*first, item)) scores.push_back(*score);
    made.raters.push_back(scoresOf(*first, scores));
    for (auto second = first + 1; second != raters.end(); ++second)
      made.pairs.push_back(agreementOn(item, *first, *second, attempts, bootstrap));
  }
  return made;
}

/// Totals of one attempt in the order of `raters`; nothing where there is none.
std::vector<std::optional<double>> totalsIn(const RatingForm& form, const RatingsByRater& attempt, const std::vector<std::string>& raters) {
  std::vector<std::optional<double>> totals;
  for (const std::string& rater : raters) {
    const Rating* rating = attempt.of(rater);
    totals.push_back(rating == nullptr ? std::nullopt : totalOf(form, *rating));
  }
  return totals;
}

void compareTotals(const RatingForm& form, const std::vector<RatingsByRater>& attempts, const Bootstrap& bootstrap,
                   RatingStatistics& found) {
  RatingTable complete;
  std::vector<Scores> byRater(found.raters.size());
  Scores failing, passing;
  for (const RatingsByRater& attempt : attempts) {
    Scores row;
    const auto totals = totalsIn(form, attempt, found.raters);
    for (std::size_t n = 0; n < totals.size(); ++n) {
      if (!totals[n]) continue;
      row.push_back(*totals[n]);
      byRater[n].push_back(*totals[n]);
    }
    if (attempt.standing != Standing::unknown && !row.empty())
      (attempt.standing == Standing::shouldFail ? failing : passing).push_back(meanOfScores(row));
    if (row.size() == found.raters.size()) complete.push_back(std::move(row));
  }
  found.complete = complete.size();
  found.incomplete = attempts.size() - complete.size();
  for (std::size_t n = 0; n < found.raters.size(); ++n) {
    found.totalsOf.push_back(scoresOf(found.raters[n], byRater[n]));
    if (complete.empty()) continue;
    double above = 0.0;
    for (const Scores& row : complete) above += row[n] - meanOfScores(row);
    found.leniency.push_back({found.raters[n], above / static_cast<double>(complete.size())});
  }
  found.totals = intraclassCorrelation(complete, bootstrap);
  found.failing = failing.size();
  found.passing = passing.size();
  found.passLevel = contrastingGroups(failing, passing, bootstrap);
}

}  // namespace

RatingStatistics ratingStatistics(const RatingForm& form, const std::vector<AttemptRatings>& attempts,
                                  const RatingStatisticsOptions& options) {
  RatingStatistics found;
  Selection selection(form, options, found);
  std::vector<RatingsByRater> counted;
  std::set<std::string> raters;
  for (const AttemptRatings& attempt : attempts) {
    RatingsByRater each = selection.of(attempt);
    if (each.byRater.empty()) continue;
    for (const auto& [rater, rating] : each.byRater) raters.insert(rater);
    counted.push_back(std::move(each));
  }
  found.raters.assign(raters.begin(), raters.end());
  found.attempts = counted.size();
  compareTotals(form, counted, options.bootstrap, found);
  for (const RatingItem& item : form.items) found.items.push_back(statisticsOf(item.id, found.raters, counted, options.bootstrap));
  return found;
}

}  // namespace ew
