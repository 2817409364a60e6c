#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/rating.h"
#include "ew/assessment/review_comment.h"
#include "ew/assessment/standings.h"
#include "ew/library/attempt.h"
#include "ew/library/case_words.h"
#include "ew/reports/report_document.h"
#include "ew/scanning/events.h"

namespace ew {

/// An attempt with everything that people and the program have said about it.
struct ReportAttempt {
  std::filesystem::path folder;
  Attempt attempt;
  std::optional<Lesson> lesson = {};  ///< as it was when it was tried, else as it is now; empty: the library does not have it
  AssessmentPlan plan = {};           ///< of the lesson, that counts now
  std::optional<AttemptScore> score;  ///< the latest that was kept, counts where result().isScored; empty: never scored
  std::vector<AttemptScore> earlier;  ///< that were kept before it and no longer count, the first one first
  RatingRecords ratings;              ///< of everybody; drafts are left out of reports
  CommentList comments;

  /// What it amounts to, as every other surface says it.
  [[nodiscard]] AttemptResult result() const;
};

/// What lies in an attempt's folder now. @param results of the library, for lesson and plan; null: without them
/// @error notFound, badHeader, badField, newerFormat (attempt.json)
[[nodiscard]] Result<ReportAttempt> readReportedAttempt(const std::filesystem::path& folder, AttemptResults* results = nullptr);

/// What the reports of a lesson's attempts have in common.
struct ReportLesson {
  std::string caseId;
  std::string lessonId;
  std::string caseTitle;    ///< as a trainee may read it; the id of a case that is not in the library
  std::string lessonTitle;  ///< as the lesson has it now; the id where it is gone
  CaseWords words;          ///< of the case, in the report's language
  std::optional<Lesson> lesson;
  AssessmentPlan plan;
  std::optional<AttemptScore> expert;                                       ///< of the plan's expert attempt
  std::map<std::string, std::vector<std::vector<glm::dvec2>>> expertPaths;  ///< by step, as PathPlot
  std::set<std::pair<std::string, std::string>> offByDefault = {};          ///< kind of step and metric (metric_defaults.h)
  StandingsByAttempt standings = {};                                        ///< that instructors have said, of attempts of any lesson
  std::optional<Error> standingsProblem = {};                               ///< why they cannot be read; raters' word alone counts then
};
/// Reads as much of it as there is in the library: a report is written though its case is gone.
[[nodiscard]] ReportLesson readReportedLesson(const std::string& caseId, const std::string& lessonId, const std::filesystem::path& library,
                                              const ReportOptions& options);

/// The way of the middle of the probe's face over the body, in pieces between poses that cannot be used; a piece has two points at least,
/// half a millimetre apart. Empty: no such piece.
[[nodiscard]] std::vector<std::vector<glm::dvec2>> pathOf(const ScanLog& log);

}  // namespace ew
