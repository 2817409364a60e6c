#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/rating.h"
#include "ew/assessment/statistics.h"

namespace ew {

// How far several raters agree on many attempts that they judged with one form.

/// What is known of whoever made an attempt, from elsewhere than its rating.
enum class Standing {
  unknown,
  shouldFail,  ///< a novice
  shouldPass   ///< somebody who does this in practice
};

struct AttemptRatings {
  std::string attemptId;
  std::vector<Rating> ratings;  ///< of any rater, form and revision, drafts among them
  Standing standing = Standing::unknown;
};

/// Which ratings count. Of one rater and attempt it is the latest of those that do.
enum class RatingFilter {
  blinded,      ///< neither name nor others' ratings were seen
  independent,  ///< others' ratings were not seen: what a rater changed afterwards agrees by talking
  all
};

struct RatingStatisticsOptions {
  RatingFilter counted = RatingFilter::independent;
  std::vector<std::string> raters = {};  ///< whose ratings are looked at; empty: everybody's
  Bootstrap bootstrap = {};
};

/// Scores of one rater.
struct RaterScores {
  std::string rater;
  std::size_t count = 0;
  std::optional<double> mean;       ///< nothing without scores
  std::optional<double> deviation;  ///< of the sample (n - 1); nothing for fewer than 2
};

/// Two raters on one item.
struct PairAgreement {
  std::string first, second;
  std::size_t bothRated = 0;      ///< attempts with a score of both
  std::size_t leftOut = 0;        ///< attempts with a score of one of them alone
  std::optional<Estimate> kappa;  ///< weighted, quadratic; nothing where all scores of both are the same one, or there are none
};

struct ItemStatistics {
  std::string item;
  std::vector<RaterScores> raters;
  std::vector<PairAgreement> pairs;
};

struct Leniency {
  std::string rater;
  double aboveMean = 0.0;  ///< mean of this rater's total less the mean total of all raters, over `complete` attempts
};

struct RatingStatistics {
  std::vector<std::string> raters;       ///< in the order of their names
  std::size_t attempts = 0;              ///< with at least one rating that counts
  std::size_t complete = 0;              ///< of these, with a total of every rater
  std::size_t incomplete = 0;            ///< of these, without: left out of `totals` and `leniency`
  std::vector<RaterScores> totalsOf;     ///< each rater's totals, of everything they rated
  std::optional<RaterAgreement> totals;  ///< ICC(2,1) and ICC(2,k) of totals, over `complete` attempts
  std::vector<Leniency> leniency;        ///< empty without complete attempts
  std::vector<ItemStatistics> items;     ///< as the form has them
  std::size_t failing = 0, passing = 0;  ///< attempts of known standing with a rating that counts
  std::optional<Estimate> passLevel;     ///< contrasting groups, of each attempt's mean total over its raters
  // Ratings that were given and do not count:
  std::size_t drafts = 0;
  std::size_t otherForms = 0;  ///< of another form, or of this one with another content
  std::size_t notBlinded = 0;  ///< that `counted` leaves out
  std::size_t superseded = 0;  ///< earlier revisions of one that counts
};

/// @param attempts each once. Nothing depends on their order but the drawing of intervals
[[nodiscard]] RatingStatistics ratingStatistics(const RatingForm& form, const std::vector<AttemptRatings>& attempts,
                                                const RatingStatisticsOptions& options = {});

}  // namespace ew
