#pragma once

#include <map>
#include <optional>

#include "ew/assessment/pseudonym.h"
#include "ew/assessment/rating_statistics.h"
#include "ew/reports/distribution.h"
#include "ew/reports/report_document.h"
#include "ew/reports/reported_attempt.h"

namespace ew {

/// All attempts of one metric of one step.
struct ClassMetric {
  std::string id;
  int version = 1;  ///< attempts whose value has another version are left out
  std::vector<double> values;
};
/// All attempts of one step.
struct ClassStep {
  std::string stepId;
  std::string title;
  std::string kind;
  double weight = 1.0;     ///< by the latest score
  double passLevel = 0.7;  ///< by the latest score
  std::size_t passed = 0, failed = 0, skipped = 0;
  std::size_t notReached = 0;  ///< attempts that ended before it
  std::vector<double> scores;  ///< of those that passed or failed
  std::vector<ClassMetric> metrics;
  std::optional<Estimate> suggested;  ///< pass level by contrasting groups; see ClassFigures::standing

  [[nodiscard]] std::size_t reached() const { return passed + failed + skipped; }
  /// Of those that reached it, 0..1; skipped is not passed. 0 of nobody.
  [[nodiscard]] double notPassedShare() const;
};
/// What a class has done in a lesson, as figures. Attempts that nobody has judged do not count, and are counted.
struct ClassFigures {
  std::size_t scored = 0, unscored = 0, passed = 0;
  std::vector<double> scores;
  std::vector<ClassStep> steps;              ///< in the lesson's order
  std::optional<std::size_t> hardest;        ///< the step that most did not pass, of those that count; empty: nobody failed
  std::map<std::string, Standing> standing;  ///< by attempt: what its raters say, where all of them say the same
  std::size_t shouldPass = 0, shouldFail = 0;
  std::optional<Estimate> suggested;  ///< pass level of the lesson's score by contrasting groups
};
/// @param attempts of one lesson. Standings come from finished ratings whose forms have a pass level and whose raters saw no others'
/// ratings:
///                 people's judgement, which does not know the score
[[nodiscard]] ClassFigures classFiguresOf(const std::vector<ReportedAttempt>& attempts);

/// All attempts of a lesson: how the class did, the step where most fail, each step's scores and metrics, how far raters agree, what pass
/// level their verdicts suggest, and every attempt in a table.
/// @param pages file names of the attempts' own pages, one each or none at all
[[nodiscard]] ReportDocument classReport(const std::vector<ReportedAttempt>& attempts, const ReportedLesson& lesson,
                                         const Pseudonyms& codes, const std::vector<std::string>& pages = {},
                                         const ReportOptions& options = {});

}  // namespace ew
