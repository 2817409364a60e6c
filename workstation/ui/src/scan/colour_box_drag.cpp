#include "scan/colour_box_drag.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/widgets/theme.h"
#include "scan/colour_on_image.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr double kReach_px = 6.0;

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

}  // namespace

bool ColourBoxDrag::isThere() const {
  return knobsWithBox(session_) && !session_.isFrozen() && !session_.isPlaying() && !session_.image().isEmpty();
}

std::optional<ColourBoxDrag::Grip> ColourBoxDrag::gripAt(const QPointF& at) const {
  if (!isThere() || !QRectF(scan_.imageRect()).contains(at)) return std::nullopt;
  const BoxOutline outline = outlineOfBox(scan_, session_.imageProbe(), session_.imageKnobs());
  const QPolygonF all = outline.all();
  const bool isInside = all.containsPoint(at, Qt::OddEvenFill);
  const QRectF around = all.boundingRect();
  // In a small box there is still something to move it by.
  const double reach_px = isInside ? std::min({scaled(kReach_px), around.width() / 4.0, around.height() / 4.0}) : scaled(kReach_px);
  Grip grip;
  grip.edges = {distanceTo(outline.left, at) <= reach_px, distanceTo(outline.right, at) <= reach_px,
                distanceTo(outline.top, at) <= reach_px, distanceTo(outline.bottom, at) <= reach_px};
  if (!isInside && grip.edges == ColourEdges{}) return std::nullopt;
  grip.cursor = cursorOf(grip.edges, at - around.center());
  return grip;
}

ColourPlace ColourBoxDrag::placeAt(const QPointF& at) const {
  const Point<frame::Probe> point = scan_.pointAt(at);
  return colourPlaceOf(session_.imageProbe(), session_.imageKnobs(), {point.at.x, point.at.y});
}

void ColourBoxDrag::begin(const QPointF& at) {
  const ColourBox box = colourBoxOf(session_.imageProbe(), session_.imageKnobs());
  const ColourPlace place = placeAt(at);
  const ColourEdges& edges = grip_->edges;
  const double across = edges.left ? box.left : edges.right ? box.right : 0.5 * (box.left + box.right);
  const double depth_mm = edges.top ? box.top_mm : edges.bottom ? box.bottom_mm : 0.5 * (box.top_mm + box.bottom_mm);
  from_ = ColourPlace{across - place.across, depth_mm - place.depth_mm};
}

void ColourBoxDrag::moveTo(const QPointF& at) {
  ColourPlace place = placeAt(at);
  place.across += from_->across;
  place.depth_mm += from_->depth_mm;
  const Knobs& knobs = session_.console().knobs();
  const Probe& probe = session_.console().probe();
  session_.console().setKnobs(grip_->edges == ColourEdges{} ? withColourBoxMiddle(probe, knobs, place)
                                                            : withColourEdgesAt(probe, knobs, grip_->edges, place));
}

std::optional<Qt::CursorShape> ColourBoxDrag::cursor() const {
  if (!grip_ || !isThere()) return std::nullopt;
  return isDragging() && grip_->cursor == Qt::OpenHandCursor ? Qt::ClosedHandCursor : grip_->cursor;
}

void ColourBoxDrag::end() {
  grip_.reset();
  from_.reset();
  tellHint();
}

void ColourBoxDrag::tellHint() {
  scan_.setDragHint(!grip_                          ? QString()
                    : grip_->edges == ColourEdges{} ? ScanView::tr("drag: move the colour box")
                                                    : ScanView::tr("drag: resize the colour box"));
}

bool ColourBoxDrag::handle(const QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress: {
      const auto& mouse = static_cast<const QMouseEvent&>(event);
      if (isDragging()) return true;  // another button
      if (mouse.button() != Qt::LeftButton || (mouse.modifiers() & Qt::AltModifier) != 0) return false;
      grip_ = gripAt(mouse.localPos());
      if (grip_) begin(mouse.localPos());
      return isDragging();
    }
    case QEvent::MouseMove: {
      const auto& mouse = static_cast<const QMouseEvent&>(event);
      if (isDragging()) {
        isThere() ? moveTo(mouse.localPos()) : end();
        return true;
      }
      grip_ = mouse.buttons() == Qt::NoButton ? gripAt(mouse.localPos()) : std::nullopt;
      tellHint();
      return false;
    }
    case QEvent::MouseButtonRelease: {
      const auto& mouse = static_cast<const QMouseEvent&>(event);
      if (!isDragging() || mouse.button() != Qt::LeftButton) return false;
      from_.reset();
      grip_ = gripAt(mouse.localPos());
      tellHint();
      return true;
    }
    case QEvent::Leave:
      if (!isDragging()) end();
      return false;
    default:
      return false;
  }
}

}  // namespace ew::ui
