#pragma once

#include <filesystem>
#include <string>

#include "ew/core/result.h"
#include "ew/paper/paper_size.h"
#include "ew/reports/report_document.h"

namespace ew {

/// A report on paper, as the bytes of a PDF: the same blocks as on its page, without links. Plots are vectors and their words letters,
/// fonts are in the file. Lines, rows of tables, images and plots are never cut by the end of a page, a heading stands with what follows
/// it, a table's head stands on each of its pages; only a row that is higher than a whole page goes on on the next one, between two lines.
/// Every page has the title, its number of how many, and says that it is a simulation. Headings are the list of contents. The same document
/// is the same to the byte on one computer: the only date is the document's. Any thread.
/// @error unsupported (no font is installed), internal
[[nodiscard]] Result<std::string> pdfOf(const ReportDocument& document, const ReportOptions& options, PaperSize paper = PaperSize::a4);

/// The same as a file, whole or not at all. @error as pdfOf, notWritable
[[nodiscard]] Result<void> writeReportPdf(const ReportDocument& document, const ReportOptions& options, PaperSize paper,
                                          const std::filesystem::path& file);

}  // namespace ew
