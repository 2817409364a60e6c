#include "scan/doppler/colour_box_drag.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/widgets/theme.h"
#include "scan/colour_on_image.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

double distanceTo(const QPolygonF& line, const QPointF& at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int n = 0; n + 1 < line.size(); ++n) {
    const QPointF along = line[n + 1] - line[n], from = at - line[n];
    const double length2 = QPointF::dotProduct(along, along);
    const double share = length2 > 0.0 ? std::clamp(QPointF::dotProduct(from, along) / length2, 0.0, 1.0) : 0.0;
    const QPointF off = from - share * along;
    nearest = std::min(nearest, std::hypot(off.x(), off.y()));
  }
  return nearest;
}

/// Along the way an edge or a corner goes, as it lies on the screen.
Qt::CursorShape cursorOf(const ColourEdges& edges, const QPointF& fromMiddle) {
  const bool isAcross = edges.left || edges.right, isAlong = edges.top || edges.bottom;
  if (isAcross && isAlong) return fromMiddle.x() * fromMiddle.y() > 0.0 ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
  return isAcross ? Qt::SizeHorCursor : isAlong ? Qt::SizeVerCursor : Qt::OpenHandCursor;
}

// A grip's part names the edges that are held; none: all of the box is moved.
constexpr int kLeft = 1, kRight = 2, kTop = 4, kBottom = 8;
int partOf(const ColourEdges& edges) {
  return (edges.left ? kLeft : 0) | (edges.right ? kRight : 0) | (edges.top ? kTop : 0) | (edges.bottom ? kBottom : 0);
}
ColourEdges edgesOf(int part) { return {(part & kLeft) != 0, (part & kRight) != 0, (part & kTop) != 0, (part & kBottom) != 0}; }

}  // namespace

bool ColourBoxDrag::hasAny() const { return knobsWithBox(session_).has_value(); }

std::optional<DragOnImage::Grip> ColourBoxDrag::gripAt(const QPointF& at) const {
  const BoxOutline outline = outlineOfBox(scan_, session_.imageProbe(), session_.imageKnobs());
  const QPolygonF all = outline.all();
  const bool isInside = all.containsPoint(at, Qt::OddEvenFill);
  const QRectF around = all.boundingRect();
  // In a small box there is still something to move it by.
  const double reach_px = isInside ? std::min({scaled(kReach_px), around.width() / 4.0, around.height() / 4.0}) : scaled(kReach_px);
  const ColourEdges edges{distanceTo(outline.left, at) <= reach_px, distanceTo(outline.right, at) <= reach_px,
                          distanceTo(outline.top, at) <= reach_px, distanceTo(outline.bottom, at) <= reach_px};
  if (!isInside && edges == ColourEdges{}) return std::nullopt;
  return Grip{partOf(edges), cursorOf(edges, at - around.center()),
              edges == ColourEdges{} ? ScanView::tr("drag: move the colour box") : ScanView::tr("drag: resize the colour box")};
}

ColourPlace ColourBoxDrag::placeAt(const QPointF& at) const {
  const Point<frame::Probe> point = scan_.pointAt(at);
  return colourPlaceOf(session_.imageProbe(), session_.imageKnobs(), {point.at.x, point.at.y});
}

void ColourBoxDrag::begin(int part, const QPointF& at) {
  const ColourBox box = colourBoxOf(session_.imageProbe(), session_.imageKnobs());
  const ColourPlace place = placeAt(at);
  const ColourEdges edges = edgesOf(part);
  const double across = edges.left ? box.left : edges.right ? box.right : 0.5 * (box.left + box.right);
  const double depth_mm = edges.top ? box.top_mm : edges.bottom ? box.bottom_mm : 0.5 * (box.top_mm + box.bottom_mm);
  from_ = ColourPlace{across - place.across, depth_mm - place.depth_mm};
}

void ColourBoxDrag::moveTo(int part, const QPointF& at) {
  ColourPlace place = placeAt(at);
  place.across += from_.across;
  place.depth_mm += from_.depth_mm;
  const Knobs& knobs = session_.console().knobs();
  const Probe& probe = session_.console().probe();
  const ColourEdges edges = edgesOf(part);
  session_.console().setKnobs(edges == ColourEdges{} ? withColourBoxMiddle(probe, knobs, place)
                                                     : withColourEdgesAt(probe, knobs, edges, place));
}

}  // namespace ew::ui
