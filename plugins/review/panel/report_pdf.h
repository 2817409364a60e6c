#pragma once

#include <QByteArray>
#include <filesystem>

#include "ew/core/result.h"
#include "ew/reports/report_document.h"

namespace ew::review {

enum class Paper { a4, letter };
/// What people print on where the window's locale is at home.
[[nodiscard]] Paper usualPaper();

/// A report on paper: the same blocks as on its page, plots from the same SVG in the colours of paper. Lines, rows of tables, pictures and
/// plots are never cut by the end of a page, a heading stands with what follows it, a table's head stands on each of its pages; only a row
/// that is higher than a whole page goes on on the next one, between two lines. Every page has the title, its number of how many, and says
/// that it is a simulation. Any thread, while a QGuiApplication is there.
[[nodiscard]] QByteArray reportPdf(const ReportDocument& document, const ReportOptions& options, Paper paper = Paper::a4);

/// The same as a file, whole or not at all. @error notWritable
[[nodiscard]] Result<void> writeReportPdf(const ReportDocument& document, const ReportOptions& options, Paper paper,
                                          const std::filesystem::path& file);

}  // namespace ew::review
