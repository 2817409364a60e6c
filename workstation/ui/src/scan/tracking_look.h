#pragma once

#include <QColor>
#include <QString>

#include "ew/tracking/tool_reading.h"
#include "ew/widgets/theme.h"

namespace ew::ui {

/// How a state of tracking is told from the others at a glance: by its word and its icon, and by a colour besides.
struct TrackingLook {
  QString word;
  QString icon;  ///< of resources/icons
  QColor colour;
};

[[nodiscard]] TrackingLook lookOf(TrackingState state, const Theme& theme = currentTheme());

}  // namespace ew::ui
