#pragma once

#include <vector>

#include "ew/reports/attempt_report.h"

namespace ew::reports {

/// What the parts of an attempt's report are made of.
struct PartOf {
  const ReportAttempt& one;
  const AttemptResult& result;  ///< of it
  const ReportLesson& lesson;
  const Pseudonyms& codes;
  const ReportOptions& options;
};
using Blocks = std::vector<ReportBlock>;

void addSteps(const PartOf& of, Blocks& blocks);          ///< a part for each step
void addRatings(const PartOf& of, Blocks& blocks);        ///< what people said, and comments on no step of the lesson
void addEarlierScores(const PartOf& of, Blocks& blocks);  ///< that no longer count
void addOrigin(const PartOf& of, Blocks& blocks);         ///< what the score was made of
void addMeaning(const PartOf& of, Blocks& blocks);        ///< what metrics are and what they are worth

/// What the metrics are, of those in `ids`.
[[nodiscard]] ReportTable metricsExplained(const std::vector<std::string>& ids);

}  // namespace ew::reports
