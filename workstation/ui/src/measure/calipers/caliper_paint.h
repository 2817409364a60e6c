#pragma once

#include <QColor>
#include <QPointF>
#include <QRect>
#include <functional>

#include "measure/calipers/calipers.h"

class QPainter;

namespace ew::ui {

/// What calipers are painted with. A dark edge lies below every line, so that they are read on bright tissue too.
struct CaliperColours {
  QColor line;
  QColor chosen;  ///< what is selected or being drawn
};

/// Lines, crosses at the points that can be taken, and numbers, of the image or of the strip.
/// @param pixelOf where a point lies; left of 0: it is not in the strip
void paintCalipers(QPainter& painter, const Calipers& calipers, Where where, const std::function<QPointF(const glm::dvec2&)>& pixelOf,
                   const CaliperColours& colours);

/// One caliper with a label, of whatever list.
void paintCaliper(QPainter& painter, const Calipers::Line& line, const QString& label,
                  const std::function<QPointF(const glm::dvec2&)>& pixelOf, const QColor& colour);

/// Numbers and results in a column, on a veil, in the upper left corner of `room`; the newest ones where it is too low for all.
void paintResults(QPainter& painter, const Calipers& calipers, Where where, const QRect& room, const CaliperColours& colours);
/// What they cover of `room`; empty where nothing is measured.
[[nodiscard]] QRect rectOfResults(const Calipers& calipers, Where where, const QRect& room);

}  // namespace ew::ui
