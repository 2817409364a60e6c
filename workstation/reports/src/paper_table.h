#pragma once

#include "ew/paper/paper_pages.h"
#include "ew/reports/report_document.h"

namespace ew::reports {

/// Puts a table on pages: its head on each of them and never without a row, no row cut but one that is higher than a page.
void putTable(PaperPages& pages, const ReportTable& table, const ReportOptions& options);

}  // namespace ew::reports
