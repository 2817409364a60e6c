#pragma once

#include "ew/paper/paper_pages.h"
#include "ew/reports/report_document.h"

// How reports look on paper.

namespace ew::reports {

inline constexpr PaperFont kTitleFont{16.0, true}, kTextFont{9.5}, kStrongFont{9.5, true}, kTableFont{8.0, false, true},
    kTableHeadFont{8.0, true};
inline constexpr Rgb kInk(0x1d, 0x23, 0x29), kSoftInk(0x4d, 0x56, 0x5f);
inline constexpr double kGap = 2.5 * kPointsPerMm;

[[nodiscard]] Rgb inkOf(ReportTone tone);

/// Lines one under another, each where there is room for it.
void putLines(PaperPages& pages, const PaperText& text, const PaperFont& font, const Rgb& ink, double x, double width);

}  // namespace ew::reports
