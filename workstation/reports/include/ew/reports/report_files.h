#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/reports/report_document.h"

namespace ew {

/// What is to be written about attempts.
struct ReportRequest {
  std::vector<std::filesystem::path> attempts = {};  ///< folders, of any lessons
  std::filesystem::path library = {};
  std::filesystem::path html = {};  ///< folder of pages; empty: none
  std::filesystem::path pdf = {};   ///< folder of the same to print, A4; empty: none
  std::filesystem::path csv = {};   ///< file; empty: none
  ReportOptions options = {};
  int threads = 0;  ///< 0: one per processor
};

/// The files that writeReports will write, to be announced beforehand: HTML/index.html, HTML/lesson-N.html where attempts are of several
/// lessons (index.html then lists these, else it is the class page itself), HTML/attempt-ID.html for each attempt; PDF/index.pdf and so on,
/// by the same names; CSV.
/// @error badUsage (no attempt); as readReportedAttempt, when none can be read
[[nodiscard]] Result<std::vector<std::filesystem::path>> reportFiles(const ReportRequest& request);

/// Writes the pages of attempts and of each lesson's class, which link each other by relative names, the same on paper, and the table.
/// Scores are read as they are kept: assess() comes first. An attempt that cannot be read is left out, and index.html says so. Names are
/// left out unless options.names.
/// @param staged where to write one of reportFiles() now (OutputSet::staged); empty: where it shall lie
/// @error as reportFiles, Pseudonyms::ofLibrary and pdfOf; notWritable, cancelled
[[nodiscard]] Result<void> writeReports(const ReportRequest& request,
                                        const std::function<std::filesystem::path(const std::filesystem::path&)>& staged = {},
                                        Progress& progress = noProgress());

}  // namespace ew
