#pragma once

#include <QStringList>
#include <optional>
#include <vector>

#include "ew/measurement/caliper_drawing.h"
#include "import/screen_view.h"

namespace ew::ui {

/// The distances of a frame of a recording: what stands at each, and a line for each.
struct ScreenDistances {
  std::vector<ScreenView::Label> labels;
  QStringList lines;
};

/// @param drawn in pixels of the recording
/// @param pixel_mm size of one; none: not known yet, and lengths are counted in pixels
/// @param scale pixels of the screen for each of the recording
[[nodiscard]] ScreenDistances distancesOf(const measurement::CaliperDrawing& drawn, const std::optional<double>& pixel_mm, double scale);

}  // namespace ew::ui
