#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ew/assessment/pseudonym.h"
#include "ew/reports/report_attempt.h"

namespace ew {

/// A field of a table (RFC 4180): in quotes where it holds a quote, a comma or a line's end. A text that a spreadsheet would take for a
/// formula (it begins with = + - @, a tab or a carriage return) gets an apostrophe before it.
[[nodiscard]] std::string csvText(std::string_view text);

/// A line of names, then one for each attempt and step: UTF-8, commas, CRLF, decimal points, moments in UTC. Every metric that any of the
/// attempts has in any step has a column "id v1 [mm]"; what was not worked out is empty, never 0. An attempt that was not scored
/// has what its lesson said ("scored" says no); of a lesson that is not in the library a line for each step that it ended, and no score.
/// @param codes of the library, for `person`, unless names are asked for
[[nodiscard]] std::string csvOf(const std::vector<ReportAttempt>& attempts, const Pseudonyms& codes, bool names = false);

}  // namespace ew
