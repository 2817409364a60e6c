#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ew {

// What figures and ratings of many attempts are worth. Every estimate comes with an interval that covers 95 %, found by drawing the
// attempts again with replacement (percentile bootstrap; Efron & Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13): it
// assumes no distribution. The same seed gives the same interval.

struct Bootstrap {
  int draws = 2000;  ///< > 0
  std::uint64_t seed = 1;
};

struct Estimate {
  double value = 0.0;
  double low = 0.0;  ///< of the 95 % interval
  double high = 0.0;
  bool operator==(const Estimate&) const = default;
};

enum class KappaWeights { linear, quadratic };
/// Agreement of two raters on an ordered scale beyond what chance gives (Cohen, Psychol Bull 70:213, 1968).
/// @param ratings of both raters, an attempt each; whole numbers whose distance counts
/// @return nothing when there are none, or when both raters gave one same rating throughout: chance then agrees as well
[[nodiscard]] std::optional<Estimate> weightedKappa(std::span<const std::pair<int, int>> ratings, KappaWeights weights,
                                                    const Bootstrap& bootstrap = {});

/// Ratings of several attempts (rows) by the same raters (columns).
using RatingTable = std::vector<std::vector<double>>;
/// Two-way random effects, absolute agreement: how far one rater's figure (`single`, ICC(2,1)) and the mean of all of them (`mean`,
/// ICC(2,k)) can be relied upon. Shrout & Fleiss, Psychol Bull 86:420, 1979.
struct RaterAgreement {
  Estimate single;
  Estimate mean;
};
/// @param table rows of one length
/// @return nothing for fewer than 2 rows or columns, or when no rating differs
[[nodiscard]] std::optional<RaterAgreement> intraclassCorrelation(const RatingTable& table, const Bootstrap& bootstrap = {});

/// The pass level that two groups of known standing suggest: where the normal curves of both cross between their means (contrasting groups;
/// Yudkowsky, Downing & Tekian, Assessment in Health Professions Education, 2009, chapter 6).
/// @param failing, passing scores of those who should fail and pass
/// @return nothing when a group has fewer than 2 scores, when those who should pass do not score higher, or when neither varies
[[nodiscard]] std::optional<Estimate> contrastingGroups(std::span<const double> failing, std::span<const double> passing,
                                                        const Bootstrap& bootstrap = {});

}  // namespace ew
