#pragma once

#include <string>
#include <vector>

#include "ew/assessment/class_figures.h"
#include "ew/assessment/pseudonym.h"
#include "ew/assessment/standings.h"
#include "ew/reports/distribution.h"
#include "ew/reports/report_attempt.h"
#include "ew/reports/report_document.h"

namespace ew {

/// An attempt as the statistics of a class takes it. @param standings what instructors have said (ReportLesson::standings)
[[nodiscard]] ClassAttempt classAttemptOf(const ReportAttempt& attempt, const StandingsByAttempt& standings = {});
/// The figures of a class (class_figures.h) of attempts as reports have them.
[[nodiscard]] ClassFigures classFiguresOf(const std::vector<ReportAttempt>& attempts, const StandingsByAttempt& standings = {});

/// All attempts of a lesson: how the class did, the step where most fail, each step's scores and metrics, how far raters agree, what pass
/// level people's verdicts suggest, and every attempt in a table.
/// @param pages file names of the attempts' own pages, one each or none at all
[[nodiscard]] ReportDocument classReport(const std::vector<ReportAttempt>& attempts, const ReportLesson& lesson, const Pseudonyms& codes,
                                         const std::vector<std::string>& pages = {}, const ReportOptions& options = {});

}  // namespace ew
