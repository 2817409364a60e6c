#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ew/assessment/class_figures.h"
#include "ew/assessment/standings.h"
#include "ew/core/progress.h"
#include "logic/scan_shelf.h"

namespace ew::review {

/// What raters say of whoever made an attempt, and which of them may be told.
struct RatersWord {
  Standing standing = Standing::unknown;
  /// Who has finished a rating with every form that was used: others are not told yet, or they would rate by it (ratingsVisibleTo).
  std::set<std::string> openTo = {};
};
[[nodiscard]] RatersWord ratersWordOf(const RatingRecords& ratings);

/// What was said and worked out of the attempts of a shelf.
struct ClassRecords {
  std::map<std::filesystem::path, AttemptScore> scores = {};     ///< the latest that was kept, by the attempt's folder
  std::map<std::filesystem::path, RatersWord> ratersWords = {};  ///< of attempts of known standing, by their folder
  StandingsByAttempt standings = {};                             ///< that instructors have said
  std::optional<Error> problem = {};                             ///< why these cannot be read; the rest holds without them

  void readRatings(const std::filesystem::path& attempt);  ///< of one attempt, anew
};
/// @error cancelled
[[nodiscard]] Result<ClassRecords> readClassRecords(const ScanShelf& shelf, const std::filesystem::path& library,
                                                    Progress& progress = noProgress());

/// Reads into `results` the lessons of the shelf that have changed since somebody tried them: resultOf and classOf then read no case. In a
/// job.
void readTriedLessons(const ScanShelf& shelf, AttemptResults& results);

/// What an attempt amounts to, as reports and records say it. @param number below that of the attempts
/// @param results of the library, for lessons that have changed since they were tried
[[nodiscard]] AttemptResult resultOf(const LessonAttempts& lesson, std::size_t number, const AssessmentPlan& plan,
                                     const ClassRecords& records, AttemptResults& results);
/// All attempts of a lesson for the statistics of its class (classFiguresOf), in the shelf's order.
[[nodiscard]] std::vector<ClassAttempt> classOf(const LessonAttempts& lesson, const AssessmentPlan& plan, const ClassRecords& records,
                                                AttemptResults& results);

/// The rows of the overview: the steps of the figures, then those of the lesson that no attempt has. What is only read or watched is left
/// out where it does not count.
[[nodiscard]] std::vector<ClassStep> overviewSteps(const ClassFigures& figures, const Lesson& lesson, const AssessmentPlan& plan);

}  // namespace ew::review
