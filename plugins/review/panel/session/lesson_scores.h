#pragma once

#include <QObject>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ew/assessment/assessment_plan.h"
#include "ew/assessment/attempt_result.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/metric.h"
#include "ew/library/folders.h"
#include "ew/sdk/host.h"
#include "logic/class_attempts.h"
#include "panel/session/review_scan.h"
#include "panel/session/review_selection.h"
#include "panel/session/reviewer.h"

namespace ew::review {

/// What counts in the lesson that is chosen, what its attempts are worth by that, and what is said of whoever made them.
class LessonScores final : public QObject {
  Q_OBJECT

 public:
  LessonScores(sdk::Host& host, const ReviewSelection& selection, const Reviewer& reviewer)
      : host_(host), selection_(selection), reviewer_(reviewer) {}

  [[nodiscard]] const AssessmentPlan& plan() const { return plan_; }
  void readPlan();                     ///< of the lesson that is chosen
  void keepPlan(AssessmentPlan plan);  ///< and scores all attempts of the lesson anew
  void scoreAll();                     ///< in a job, those whose score is out of date
  [[nodiscard]] bool isScoring() const { return scoring_; }
  /// Of a shelf that was read anew. @param results that readTriedLessons has filled
  void takeRecords(ClassRecords records, AttemptResults results);

  /// The score that counts; null: it was not scored.
  [[nodiscard]] const AttemptScore* scoreOf(std::size_t attempt) const;
  /// What an attempt of the lesson amounts to, as reports and records say it. @param attempt below their number
  [[nodiscard]] AttemptResult resultOf(std::size_t attempt) const;
  /// The attempts of the lesson for the statistics of their class, in the shelf's order.
  [[nodiscard]] std::vector<ClassAttempt> classAttempts() const;
  /// The figures of a scan, or none of null: as they were scored, where that was done for the plan that counts; else as they were worked
  /// out when it was opened.
  [[nodiscard]] std::vector<MetricValue> metricsOf(const ReviewScan* scan) const;

  /// Whether the reviewer may be told what raters say of an attempt. @param attempt folder
  [[nodiscard]] bool mayReadRaters(const std::filesystem::path& attempt) const;
  /// Keeps what is said of whoever made an attempt. @param standing unknown: raters decide
  /// @return false: it could not be kept, and the window was told why
  [[nodiscard]] bool keepStanding(const std::string& attemptId, Standing standing);
  void takeRating(const std::filesystem::path& attempt);  ///< a rating of it was finished

 Q_SIGNALS:
  void changed();

 private:
  sdk::Host& host_;
  const ReviewSelection& selection_;
  const Reviewer& reviewer_;
  AssessmentPlan plan_;
  ClassRecords records_;                             ///< of the shelf's attempts
  mutable AttemptResults results_{libraryFolder()};  ///< for lessons that have changed since they were tried
  bool scoring_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
