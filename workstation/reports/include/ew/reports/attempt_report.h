#pragma once

#include "ew/assessment/pseudonym.h"
#include "ew/reports/report_attempt.h"
#include "ew/reports/report_document.h"

namespace ew {

/// One attempt: who, what and when; what it is worth and why; each step with its verdict, figures, metrics beside the expert's, remarks,
/// stored images and the way of the probe; ratings, comments, earlier scores; and what the score was made of. Reads the images' names
/// and, unless options.images is false, the recordings.
[[nodiscard]] ReportDocument attemptReport(const ReportAttempt& attempt, const ReportLesson& lesson, const Pseudonyms& codes,
                                           const ReportOptions& options = {});

/// How people are called in reports: by code, or by name when that is asked for.
[[nodiscard]] std::string calledIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person);
/// The same of who rates and comments.
[[nodiscard]] std::string reviewerIn(const ReportOptions& options, const Pseudonyms& codes, const std::string& person);

}  // namespace ew
