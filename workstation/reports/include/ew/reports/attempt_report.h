#pragma once

#include "ew/assessment/pseudonym.h"
#include "ew/reports/report_document.h"
#include "ew/reports/reported_attempt.h"

namespace ew {

/// One attempt: who, what and when; what it is worth and why; each step with its verdict, figures, metrics beside the expert's, remarks,
/// stored pictures and the way of the probe; ratings, comments, earlier scores; and what the score was made of. Reads the pictures' names
/// and, unless options.pictures is false, the recordings.
[[nodiscard]] ReportDocument attemptReport(const ReportedAttempt& attempt, const ReportedLesson& lesson, const Pseudonyms& codes,
                                           const ReportOptions& options = {});

/// How people are called in reports: by code, or by name when that is asked for.
[[nodiscard]] std::string calledIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person);
/// The same of who rates and comments.
[[nodiscard]] std::string reviewerIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person);

}  // namespace ew
