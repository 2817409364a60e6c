#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/measurement/worksheet.h"
#include "ew/reports/report_document.h"

namespace ew {

/// What a worksheet's report tells beside what was measured.
struct WorksheetAbout {
  std::string patient = {};                         ///< title of the case; may be empty
  Message moment = {};                              ///< of `at`, as people write it; may be empty
  std::optional<std::chrono::sys_seconds> at = {};  ///< when it was made, the date of a file
  std::string examiner = {};                        ///< as they call themselves; may be empty
  std::vector<ReportImage> images = {};             ///< that follow the worksheet, numbered
};

/// A worksheet as a report: a table for each of its sections, what its answers say together, its source, its images.
/// @param language of titles: "en", "de"
[[nodiscard]] ReportDocument worksheetReport(const measurement::Worksheet& sheet, WorksheetAbout about, std::string_view language = "en");

}  // namespace ew
