#include "ew/assessment/assessment_plan.h"

#include <algorithm>
#include <array>
#include <set>

#include "attempts/series_files.h"
#include "ew/assessment/metric.h"
#include "ew/core/data_file.h"
#include "ew/core/find_entry.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/library/instructor_log.h"
#include "ew/library/timestamp.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kHeaviest = 1000.0, kFarthest = 1e9;
constexpr std::size_t kMostSteps = 1000, kMostMetrics = 100;
constexpr std::size_t kLargestPlan_bytes = 4u << 20;
constexpr std::array<std::string_view, 8> kFields = {"format",     "case",  "lesson",     "expert_attempt",
                                                     "pass_level", "steps", "changed_by", "changed_at"};

std::optional<double> optionalNumber(const JsonFields& fields, std::string_view key, double highest) {
  if (!fields.has(key)) return std::nullopt;
  return fields.number(key, 0.0, highest);
}

StepPlan readStepPlan(const JsonFields& fields) {
  fields.only({"step", "weight", "pass_level", "task_weight", "metrics"});
  StepPlan step;
  step.stepId = fields.text("step", {}, 1, 100);
  step.weight = optionalNumber(fields, "weight", kHeaviest);
  step.passLevel = optionalNumber(fields, "pass_level", 1.0);
  step.taskWeight = fields.number("task_weight", 0.0, kHeaviest, 1.0);
  for (const JsonFields& each : fields.objects("metrics", 0, kMostMetrics)) {
    each.only({"metric", "weight", "worst", "best"});
    MetricWeight weight{each.text("metric", {}, 1, 100), each.number("weight", 0.0, kHeaviest, 1.0),
                        each.number("worst", -kFarthest, kFarthest), each.number("best", -kFarthest, kFarthest)};
    if (each.good() && metricOf(weight.metric) == nullptr) each.refuse("metric", say<"one of the metrics that this program knows">());
    if (each.good() && weight.worst == weight.best) each.refuse("best", say<"another number than the worst">());
    step.metrics.push_back(std::move(weight));
  }
  double sum = step.taskWeight;
  for (const MetricWeight& each : step.metrics) sum += each.weight;
  if (fields.good() && !(sum > 0.0)) fields.refuse("task_weight", say<"above 0 where no metric counts">());
  return step;
}

json jsonOf(const StepPlan& step) {
  json made = {{"step", step.stepId}, {"task_weight", step.taskWeight}};
  if (step.weight) made["weight"] = *step.weight;
  if (step.passLevel) made["pass_level"] = *step.passLevel;
  for (const MetricWeight& each : step.metrics)
    made["metrics"].push_back({{"metric", each.metric}, {"weight", each.weight}, {"worst", each.worst}, {"best", each.best}});
  return made;
}

/// What was decided, without who and when.
json decisionsOf(const AssessmentPlan& plan) {
  json decided = jsonOf(plan);
  decided.erase("changed_by");
  decided.erase("changed_at");
  return decided;
}

Result<AssessmentPlan> readPlanFile(const assessment::SeriesFile& from) {
  const auto document = readJsonFile(from.file, verbatim(from.file.filename().string()), kLargestPlan_bytes);
  if (!document) return passOn(document.error());
  auto plan = planFromJson(*document);
  if (plan) plan->revision = from.number;
  return plan;
}

}  // namespace

double shareOf(const MetricWeight& weight, double value) {
  return std::clamp((value - weight.worst) / (weight.best - weight.worst), 0.0, 1.0);
}

const StepPlan* AssessmentPlan::of(const std::string& stepId) const { return entryWith(steps, &StepPlan::stepId, stepId); }

StepPlan& AssessmentPlan::at(const std::string& stepId) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const StepPlan& one) { return one.stepId == stepId; });
  if (found != steps.end()) return *found;
  StepPlan made;
  made.stepId = stepId;
  return steps.emplace_back(std::move(made));
}

double weightOf(const LessonStep& step, const AssessmentPlan& plan) {
  const bool isOnlySeen = std::holds_alternative<ReadingTask>(step.task) || std::holds_alternative<WatchTask>(step.task);
  const StepPlan* decided = plan.of(step.id);
  return (decided != nullptr ? decided->weight : std::nullopt).value_or(isOnlySeen ? 0.0 : 1.0);
}

double passLevelOf(const LessonStep& step, const AssessmentPlan& plan) {
  const StepPlan* decided = plan.of(step.id);
  return (decided != nullptr ? decided->passLevel : std::nullopt).value_or(step.passLevel);
}

Result<AssessmentPlan> planFromJson(const json& document) {
  JsonReading reading(say<"the assessment plan">());
  const JsonFields fields(document, reading);
  requireFormat(fields, kAssessmentPlanFormat);
  AssessmentPlan plan;
  plan.caseId = fields.text("case", {}, 1, 100);
  plan.lessonId = fields.text("lesson", {}, 1, 100);
  plan.expertAttempt = fields.text("expert_attempt", std::string(), 0, 100);
  plan.passLevel = optionalNumber(fields, "pass_level", 1.0);
  plan.changedBy = fields.text("changed_by", std::string(), 0);
  plan.changedAt = readTimestamp(fields, "changed_at", true).value_or(std::chrono::sys_seconds{});
  std::set<std::string> seen;
  for (const JsonFields& each : fields.objects("steps", 0, kMostSteps)) {
    plan.steps.push_back(readStepPlan(each));
    if (each.good() && !seen.insert(plan.steps.back().stepId).second) each.refuse("step", say<"a step that is not in the list yet">());
  }
  if (reading.problem()) return passOn(*reading.problem());
  for (const auto& [key, value] : document.items())
    if (std::find(kFields.begin(), kFields.end(), key) == kFields.end()) plan.otherFields[key] = value;
  return plan;
}

json jsonOf(const AssessmentPlan& plan) {
  json made = plan.otherFields.is_object() ? plan.otherFields : json::object();
  made["format"] = kAssessmentPlanFormat;
  made["case"] = plan.caseId;
  made["lesson"] = plan.lessonId;
  if (!plan.expertAttempt.empty()) made["expert_attempt"] = plan.expertAttempt;
  if (plan.passLevel) made["pass_level"] = *plan.passLevel;
  if (!plan.changedBy.empty()) made["changed_by"] = plan.changedBy;
  made["changed_at"] = timestampText(plan.changedAt);
  made["steps"] = json::array();
  for (const StepPlan& each : plan.steps) made["steps"].push_back(jsonOf(each));
  return made;
}

fs::path planFolder(const fs::path& library, const std::string& caseId, const std::string& lessonId) {
  return library / "assessment" / "plans" / idFor(caseId, {}, "case") / idFor(lessonId, {}, "lesson");
}

Result<AssessmentPlan> readPlan(const fs::path& library, const std::string& caseId, const std::string& lessonId) {
  const auto files = assessment::numberedFiles(planFolder(library, caseId, lessonId));
  if (!files.empty()) return readPlanFile(files.back());
  AssessmentPlan none;
  none.caseId = caseId;
  none.lessonId = lessonId;
  return none;
}

Result<AssessmentPlan> keepPlan(const fs::path& library, AssessmentPlan plan) {
  if (auto good = planFromJson(jsonOf(plan)); !good) return passOn(good.error());
  const fs::path folder = planFolder(library, plan.caseId, plan.lessonId);
  nlohmann::json before;
  if (const auto files = assessment::numberedFiles(folder); !files.empty())
    if (auto last = readPlanFile(files.back()); last) {
      if (decisionsOf(*last) == decisionsOf(plan)) return last;
      before = decisionsOf(*last);
    }
  // What is not written down is not decided.
  if (auto logged = logChange(library, "plan changed", plan.caseId + "/" + plan.lessonId, std::move(before), decisionsOf(plan)); !logged)
    return passOn(logged.error());
  const auto added = assessment::addNumbered(folder, jsonOf(plan).dump(1) + "\n");
  if (!added) return passOn(added.error());
  plan.revision = added->number;
  return plan;
}

}  // namespace ew
