#pragma once

#include <string>

#include "ew/reports/report_document.h"

namespace ew {

/// A text for an element or an attribute in quotes: markup becomes letters, control characters go.
[[nodiscard]] std::string htmlEscaped(std::string_view text);

/// The report as one page that needs nothing else: images in it, plots as SVG, no script, nothing loaded (its security policy forbids
/// both); light and dark, to print, headings and tables as such for whoever hears it. Links lead to pages of the same folder alone.
[[nodiscard]] std::string htmlOf(const ReportDocument& document, const ReportOptions& options);

}  // namespace ew
