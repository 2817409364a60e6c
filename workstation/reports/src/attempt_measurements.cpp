#include "ew/reports/attempt_measurements.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/step_answer.h"
#include "ew/reports/attempt_report.h"
#include "page_names.h"
#include "report_words.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using measurement::Quantity;
using measurement::Worksheet;
using measurement::WorksheetRow;

/// A step that asks for a measurement, as the lesson or else the score has it.
struct MeasureStep {
  std::string id, title, caseId;
};

std::vector<MeasureStep> measureSteps(const ReportAttempt& attempt, const ReportLesson& lesson) {
  std::vector<MeasureStep> steps;
  if (lesson.lesson) {
    for (const LessonStep& step : lesson.lesson->steps)
      if (std::holds_alternative<MeasureTask>(step.task))
        steps.push_back({step.id, step.title, step.caseId.empty() ? attempt.attempt.caseId : step.caseId});
  } else if (attempt.score) {
    for (const StepScore& step : attempt.score->steps)
      if (step.kind == "measure") steps.push_back({step.stepId, step.title, attempt.attempt.caseId});
  }
  return steps;
}

/// What was handed in; empty: it is no measurement.
std::optional<Quantity> quantityOf(const MeasurementAnswer& answer) {
  const auto unit = measurement::unitOf(answer.unit);
  if (!unit || !std::isfinite(answer.value)) return std::nullopt;
  return Quantity{answer.value, 0.0, *unit};
}

Words bothAs(const std::string& text) { return {text, text}; }

WorksheetRow rowOf(const MeasureStep& step, const Quantity& value, const MeasurementAnswer& answer, std::size_t number) {
  WorksheetRow row;
  row.label = "M" + std::to_string(number);
  row.title = bothAs(step.title);  // the measurement's own name may be the finding, which the trainee was not told
  row.value = value;
  row.measured = {value};
  const std::string caliper = answer.caliper.value_or("");
  row.convention = bothAs("Step '" + step.title + "'" + (caliper.empty() ? "" : ", caliper: " + caliper));
  return row;
}

Worksheet sheetOf(const ReportAttempt& attempt, const ReportLesson& lesson) {
  Worksheet sheet;
  sheet.package = "lesson";
  sheet.title = {"Measurements of a lesson", "Messungen einer Lektion"};
  sheet.source = "EchoWeave, lesson " + attempt.attempt.caseId + "/" + attempt.attempt.lessonId;
  sheet.sections.push_back({bothAs(reports::lessonName(attempt.attempt, lesson)), {}});
  sheet.summaries.push_back({{"Attempt", "Versuch"}, bothAs(attempt.attempt.id)});
  const AttemptResult result = attempt.result();
  if (result.isKnown && result.passed()) {
    const std::string percent = percentText(*result.score()).english(), passed = std::to_string(result.stepsPassed);
    const std::string judged = std::to_string(result.stepsJudged);
    const Words verdict = *result.passed() ? Words{"passed", "bestanden"} : Words{"not passed", "nicht bestanden"};
    sheet.summaries.push_back({{"Result", "Ergebnis"},
                               {percent + ", " + verdict.english + ", " + passed + " of " + judged + " steps passed",
                                percent + ", " + verdict.german + ", " + passed + " von " + judged + " Schritten bestanden"}});
  }
  const std::string worked = durationText(result.worked_s).english();
  sheet.summaries.push_back({{"Time on steps", "Zeit für die Schritte"}, bothAs(worked)});
  return sheet;
}

std::chrono::sys_seconds lastMoment(const Attempt& attempt) {
  auto moment = attempt.startedAt;
  for (const StepOutcome& outcome : attempt.outcomes) moment = std::max(moment, outcome.at);
  return moment;
}

}  // namespace

std::vector<AttemptMeasurements> measurementsOf(const ReportAttempt& attempt, const ReportLesson& lesson) {
  std::vector<AttemptMeasurements> made;
  for (const MeasureStep& step : measureSteps(attempt, lesson)) {
    const StepOutcome* outcome = attempt.attempt.outcomeOf(step.id);
    if (outcome == nullptr || outcome->answerJson().is_null()) continue;
    auto of = std::find_if(made.begin(), made.end(), [&](const AttemptMeasurements& one) { return one.caseId == step.caseId; });
    if (of == made.end()) of = made.insert(made.end(), {step.caseId, sheetOf(attempt, lesson), {}});
    auto& rows = of->worksheet.sections.front().rows;
    const auto* answer = std::get_if<MeasurementAnswer>(&outcome->answer);
    if (const auto value = answer != nullptr ? quantityOf(*answer) : std::nullopt)
      rows.push_back(rowOf(step, *value, *answer, rows.size() + 1));
    else
      of->leftOut.push_back(say<"The answer to the step '%1' is no measurement with a value and a unit.">(step.title));
  }
  std::erase_if(made, [](const AttemptMeasurements& one) { return one.worksheet.sections.front().rows.empty() && one.leftOut.empty(); });
  return made;
}

Result<std::vector<fs::path>> writeAttemptMeasurements(const ReportAttempt& attempt, const ReportLesson& lesson, const Pseudonyms& codes,
                                                       bool names, const fs::path& library, const fs::path& folder) {
  std::vector<fs::path> files;
  ReportOptions who;
  who.names = names;
  for (const AttemptMeasurements& measured : measurementsOf(attempt, lesson)) {
    if (measured.worksheet.sections.front().rows.empty()) continue;
    const auto home = findCase(measured.caseId, library);
    if (!home)
      return failure(
          ErrorCode::notFound,
          say<"The case '%1' is not in the library; import it, for a report of measurements names its patient.">(measured.caseId),
          {{"case", measured.caseId}});
    const auto opened = loadCase(*home);
    if (!opened) return passOn(opened.error());
    DicomStudy study = beginStudy(*opened, attempt.attempt.startedAt);
    study.operators = calledIn(who, codes, attempt.attempt.person);
    MeasurementReportOptions options;
    options.instanceUid = newDicomUid();
    options.made = lastMoment(attempt.attempt);
    const fs::path file = folder / (reports::plainName(attempt.attempt.id) + "-" + reports::plainName(measured.caseId) + ".dcm");
    if (auto written = writeMeasurementReport(measured.worksheet, options, study, file); !written) return passOn(written.error());
    files.push_back(file);
  }
  return files;
}

}  // namespace ew
