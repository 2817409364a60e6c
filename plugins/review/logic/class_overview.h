#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/assessment/statistics.h"
#include "ew/reports/distribution.h"

namespace ew::review {

/// What one attempt has of one step, for the overview of a class.
struct StepResult {
  std::string stepId;
  double score = 0.0;  ///< 0 to 1
  bool isPassed = false;
  bool isSkipped = false;  ///< counts as not passed, and has no figures
  struct Figure {
    std::string name;
    double value = 0.0;
    std::string unit;
  };
  std::vector<Figure> figures;
};
struct AttemptResult {
  std::string attemptId;
  std::vector<StepResult> steps;  ///< one of each step that was ended
};

struct Distribution : FiveNumbers {
  std::vector<double> values;  ///< rising
};
/// @return all 0 of no values; values that are not finite are left out
[[nodiscard]] Distribution distributionOf(std::vector<double> values);
/// As countsIn; where lowest and highest are one, all values of that lie in the first part. @param bins > 0
[[nodiscard]] std::vector<std::size_t> histogramOf(std::span<const double> values, double lowest, double highest, int bins);

struct FigureOverview {
  std::string name;
  std::string unit;
  Distribution values;
};
struct StepOverview {
  std::string stepId;
  std::size_t ended = 0;  ///< attempts that ended it
  std::size_t passed = 0;
  std::size_t skipped = 0;
  Distribution scores;                  ///< skipped ones left out
  std::vector<FigureOverview> figures;  ///< by name, in the order they first came
  [[nodiscard]] double failedShare() const { return ended == 0 ? 0.0 : static_cast<double>(ended - passed) / static_cast<double>(ended); }
};
struct ClassOverview {
  std::size_t attempts = 0;
  std::vector<StepOverview> steps;  ///< as they were asked for, also those that nobody ended
  /// The step that the largest share of those who ended it did not pass; the first of several. Empty: nobody failed.
  std::optional<std::size_t> hardest;
};
/// @param steps ids in the order of the lesson
[[nodiscard]] ClassOverview overviewOf(std::span<const AttemptResult> attempts, std::span<const std::string> steps);

/// How an attempt's author stands by another judgement than the score: what contrasting groups compare.
enum class Standing { unknown, notYet, competent };
/// The pass level that the scores of a step suggest (contrastingGroups). @param standings one of each attempt
[[nodiscard]] std::optional<Estimate> suggestedPassLevel(std::span<const AttemptResult> attempts, std::span<const Standing> standings,
                                                         const std::string& stepId);

}  // namespace ew::review
