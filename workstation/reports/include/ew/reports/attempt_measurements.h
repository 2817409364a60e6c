#pragma once

#include <filesystem>
#include <vector>

#include "ew/assessment/pseudonym.h"
#include "ew/export/measurement_report.h"
#include "ew/measurement/worksheet.h"
#include "ew/reports/report_attempt.h"

namespace ew {

/// What was measured in one case.
struct AttemptMeasurements {
  std::string caseId;
  measurement::Worksheet worksheet;  ///< package "lesson": a row "M1" and on for each step, with its value and how it was taken
  std::vector<Message> leftOut;      ///< steps whose answer is no measurement, and why
};
/// The measurements that an attempt's measure steps handed in, by case, each case once: a lesson may measure in several patients. What was
/// expected is not among them. Empty: the attempt measured nothing.
[[nodiscard]] std::vector<AttemptMeasurements> measurementsOf(const ReportAttempt& attempt, const ReportLesson& lesson);

/// Writes them as DICOM structured reports (measurement_report.h): the simulated patient of the case, the trainee as operator under a code
/// unless names are asked for, "simulation, not for diagnosis" in the study and in the report.
/// @param folder where "ATTEMPT-CASE.dcm" come to lie
/// @return the files, none when nothing was measured @error as loadCase (the case is not in the library) and writeMeasurementReport
[[nodiscard]] Result<std::vector<std::filesystem::path>> writeAttemptMeasurements(const ReportAttempt& attempt, const ReportLesson& lesson,
                                                                                  const Pseudonyms& codes, bool names,
                                                                                  const std::filesystem::path& library,
                                                                                  const std::filesystem::path& folder);

}  // namespace ew
