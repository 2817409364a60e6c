#pragma once

#include <QColor>
#include <QPainter>
#include <QPen>
#include <utility>

namespace ew::ui {

/// Of lines that say where something is measured.
inline const QColor kLineOnImage(235, 235, 235);

/// Draws twice: a dark edge under the line keeps it in sight on bright tissue.
template <class Draw>
void drawOnImage(QPainter& painter, const QColor& colour, double width_px, const Draw& draw) {
  for (const auto& [each, wide_px] : {std::pair{QColor(0, 0, 0, 130), width_px + 2.0}, std::pair{colour, width_px}}) {
    painter.setPen(QPen(each, wide_px));
    draw();
  }
}

}  // namespace ew::ui
