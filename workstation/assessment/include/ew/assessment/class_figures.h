#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ew/assessment/attempt_result.h"
#include "ew/assessment/rating.h"
#include "ew/assessment/rating_statistics.h"
#include "ew/assessment/statistics.h"

namespace ew {

// What a class has done in a lesson, as figures: the one statistics that the window's overview, the report and the command give
// (decision 0073).

/// What everybody who rated an attempt says of whoever made it, where all of them say the same: of finished ratings whose forms have a pass
/// level and whose raters saw no others' ratings. unknown: nobody says anything, or they differ.
[[nodiscard]] Standing standingBy(const RatingRecords& ratings);

/// An attempt of a class.
struct ClassAttempt {
  std::string id;
  AttemptResult result = {};
  std::set<std::string> ended = {};       ///< ids of the steps that have an outcome
  Standing said = Standing::unknown;      ///< by an instructor, and kept (standings.h)
  Standing byRaters = Standing::unknown;  ///< standingBy

  /// What an instructor has said, else what its raters agree on.
  [[nodiscard]] Standing standing() const { return said != Standing::unknown ? said : byRaters; }
  /// What it has of a step. Null: nothing, for it ended before the step, the step waits for somebody who judges it, or nobody knows which
  /// steps count.
  [[nodiscard]] const StepScore* judged(const std::string& stepId) const;
};
[[nodiscard]] ClassAttempt classAttemptOf(const Attempt& attempt, AttemptResult result, Standing said, Standing byRaters);

/// All values of one figure of one step.
struct ClassMetric {
  std::string id;        ///< of the metric, or the name of a figure that the task was judged by
  int version = 1;       ///< attempts whose value has an older version are left out
  std::string unit;      ///< as Metric::unit
  bool isMetric = true;  ///< false: a figure that the task was judged by, of attempts that were never scored
  std::vector<double> values;
  bool operator==(const ClassMetric&) const = default;
};
/// All attempts of one step.
struct ClassStep {
  std::string stepId;
  std::string title;
  std::string kind;
  double weight = 1.0;     ///< weightIn, by the latest attempt; 0: it does not count
  double passLevel = 0.7;  ///< by the latest attempt
  std::size_t passed = 0, failed = 0, skipped = 0;
  std::size_t notReached = 0;  ///< attempts that ended before it
  std::vector<double> scores;  ///< of those that passed or failed
  std::vector<ClassMetric> metrics;
  std::size_t shouldPass = 0, shouldFail = 0;  ///< of known standing, among the scores
  std::optional<Estimate> suggested;           ///< pass level by contrasting groups; see ClassFigures

  [[nodiscard]] std::size_t reached() const { return passed + failed + skipped; }
  /// Of those that reached it, 0..1; skipped is not passed. 0 of nobody.
  [[nodiscard]] double notPassedShare() const;
  bool operator==(const ClassStep&) const = default;
};
/// Attempts that nobody has judged do not count, and are counted.
struct ClassFigures {
  std::size_t scored = 0, unscored = 0, passed = 0;
  std::vector<double> scores;                ///< of the whole lesson
  std::vector<ClassStep> steps;              ///< in the lesson's order
  std::optional<std::size_t> hardest;        ///< the step that the largest share did not pass; empty: nobody failed one that counts
  std::map<std::string, Standing> standing;  ///< by attempt
  std::size_t shouldPass = 0, shouldFail = 0;
  std::optional<Estimate> suggested;  ///< pass level of the lesson's score by contrasting groups
  bool operator==(const ClassFigures&) const = default;
};
/// The figures of a class, by these rules:
/// - The hardest step is the one that the largest share of those who reached it did not pass, the first of several. Only steps that weigh
///   something in the score count (weightIn): reading and watching do not unless the plan says so, and all count alike where nothing
///   weighs. Skipped is not passed. An attempt that never reached a step, or whose step was handed in and not judged yet, says nothing of
///   it; a step that was judged counts though another one of its attempt still waits.
/// - Of a metric the values of the newest version count alone. Attempts that were never scored have no metrics: theirs are the figures that
///   the lesson judged by.
/// - Pass levels come from contrastingGroups() over ClassAttempt::standing, for the lesson and for each step that weighs something. A group
///   of one and the same score suggests nothing: the normal curve is none, and where it crosses the other means nothing.
/// @param attempts of one lesson, each once; their order does not matter, the earliest counts as the first
[[nodiscard]] ClassFigures classFiguresOf(const std::vector<ClassAttempt>& attempts);

}  // namespace ew
