#pragma once

#include <QPoint>
#include <QRect>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew::ui {

/// The rectangles that a fan covers, a band of rows each: never less than it does.
/// @param spans      of the image, one entry a row, in pixels of the screen
/// @param at         upper left corner of the image in the widget
/// @param pixelRatio pixels of the screen to one of the widget, > 0
[[nodiscard]] std::vector<QRect> rectsOfFan(const Spans& spans, const QPoint& at, double pixelRatio);

}  // namespace ew::ui
