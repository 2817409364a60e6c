#pragma once

#include <vector>

#include "ew/reports/class_report.h"

namespace ew::reports {

/// What the parts of a class's report are made of.
struct ClassOf {
  const std::vector<ReportAttempt>& attempts;
  const ReportLesson& lesson;
  const Pseudonyms& codes;
  const std::vector<std::string>& pages;
  const ReportOptions& options;
  ClassFigures figures;
};

void addClassSteps(const ClassOf& of, std::vector<ReportBlock>& blocks);    ///< metrics, step by step
void addAgreement(const ClassOf& of, std::vector<ReportBlock>& blocks);     ///< of raters, form by form
void addPassLevels(const ClassOf& of, std::vector<ReportBlock>& blocks);    ///< by contrasting groups
void addAttemptTable(const ClassOf& of, std::vector<ReportBlock>& blocks);  ///< a row for each

}  // namespace ew::reports
