#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/lesson.h"

namespace ew {

inline constexpr int kAssessmentPlanFormat = 1;  ///< `format`; a larger one is refused with newerFormat

/// How a metric counts in the score of a step: `worst` gives 0, `best` gives 1, evenly between them.
struct MetricWeight {
  std::string metric;   ///< id
  double weight = 1.0;  ///< beside the task's, 0 to 1000
  double worst = 0.0;   ///< in the metric's unit; not equal to best
  double best = 1.0;
  bool operator==(const MetricWeight&) const = default;
};
/// 0..1
[[nodiscard]] double shareOf(const MetricWeight& weight, double value);

struct StepPlan {
  std::string stepId;
  std::optional<double> weight;     ///< in the lesson's score, 0 to 1000; absent: 1, and 0 of what is only read or watched
  std::optional<double> passLevel;  ///< 0 to 1; absent: the lesson's
  double taskWeight = 1.0;          ///< of the task itself in the step's score, 0 to 1000
  std::vector<MetricWeight> metrics;
  bool operator==(const StepPlan&) const = default;
};

/// What an instructor has decided counts in a lesson. Nothing decided: the tasks alone count, at the lesson's pass levels, and every step
/// has to be passed.
struct AssessmentPlan {
  std::string caseId;
  std::string lessonId;
  std::string expertAttempt;        ///< id of the attempt that others are compared with; empty: the lesson's own recordings
  std::optional<double> passLevel;  ///< of the whole lesson's score, 0 to 1; absent: every step has to be passed
  std::vector<StepPlan> steps;      ///< those about which something was decided
  std::string changedBy;            ///< as they call themselves; may be empty
  std::chrono::sys_seconds changedAt{};
  int revision = 0;  ///< of the file it was read from; 0: nothing was ever decided. Not saved
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const AssessmentPlan&) const = default;

  [[nodiscard]] const StepPlan* of(const std::string& stepId) const;
  /// The entry of a step, made when it is not there.
  [[nodiscard]] StepPlan& at(const std::string& stepId);
};
[[nodiscard]] double weightOf(const LessonStep& step, const AssessmentPlan& plan);
[[nodiscard]] double passLevelOf(const LessonStep& step, const AssessmentPlan& plan);

/// @error badField, newerFormat
[[nodiscard]] Result<AssessmentPlan> planFromJson(const nlohmann::json& document);
/// planFromJson(jsonOf(p)) == p but for the revision.
[[nodiscard]] nlohmann::json jsonOf(const AssessmentPlan& plan);

/// LIBRARY/assessment/plans/CASE/LESSON: 0001.json and on, of which the last one counts and none is ever changed.
[[nodiscard]] std::filesystem::path planFolder(const std::filesystem::path& library, const std::string& caseId,
                                               const std::string& lessonId);
/// The plan that counts; one of revision 0 where nothing was decided. @error notReadable, badHeader, badField, newerFormat
[[nodiscard]] Result<AssessmentPlan> readPlan(const std::filesystem::path& library, const std::string& caseId, const std::string& lessonId);
/// Keeps a plan as the next revision; the same decisions as the last one's are not kept again.
/// @return with its revision. @error notWritable; badField (what planFromJson would refuse)
[[nodiscard]] Result<AssessmentPlan> keepPlan(const std::filesystem::path& library, AssessmentPlan plan);

}  // namespace ew
