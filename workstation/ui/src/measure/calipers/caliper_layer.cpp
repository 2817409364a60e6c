#include "measure/calipers/caliper_layer.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>

#include "ew/widgets/theme.h"
#include "measure/calipers/caliper_paint.h"
#include "measure/words/caliper_words.h"
#include "scan/dgc_column.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

using measurement::CaliperDrawing;

constexpr double kReach_px = 9.0;
constexpr double kStep_px = 4.0, kFarStep_px = 32.0, kFineStep_px = 1.0;

}  // namespace

CaliperLayer::CaliperLayer(Session& session, Calipers& calipers, ScanView& scan, Where where)
    : QWidget(&scan), session_(session), calipers_(calipers), scan_(scan), where_(where) {
  setObjectName(where == Where::strip ? QStringLiteral("stripCaliperLayer") : QStringLiteral("caliperLayer"));
  setFocusPolicy(Qt::ClickFocus);
  setMouseTracking(true);
  setAccessibleName(where == Where::strip ? tr("Calipers on the strip of the M-mode") : tr("Calipers on the image"));
  hide();
  scan.installEventFilter(this);
  connect(&session_, &Session::imageChanged, this, [this] {
    follow();
    if (where_ == Where::strip && isVisible()) update();  // it goes on
  });
  connect(&calipers_, &Calipers::changed, this, &CaliperLayer::showOrHide);
}

QRect CaliperLayer::place() const { return where_ == Where::strip ? scan_.stripRect() : scan_.imageRect(); }

/// With a tool for the image a click on the strip is answered as well, and the other way round.
bool CaliperLayer::isWanted() const {
  if (!calipers_.drawing().tool() && calipers_.drawingIn(where_).isEmpty()) return false;
  return where_ == Where::strip ? calipers_.hasStrip() : session_.imageKnobs().mode != DisplayMode::mMode;
}

void CaliperLayer::follow() {
  if (isWanted() == isHidden()) return showOrHide();
  if (!isHidden() && geometry() != place()) setGeometry(place());
  keepResultsClear();
}

void CaliperLayer::showOrHide() {
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  const bool hadFocus = hasFocus(), isShown = isWanted();
  if (isShown) setGeometry(place());
  setVisible(isShown);
  if (!isShown) {
    cross_.reset();
    snap_ = {};
    if (hadFocus) scan_.setFocus(Qt::OtherFocusReason);
  } else if (drawing.tool() && drawing.tool() != tool_) {
    raise();
    setFocus(Qt::OtherFocusReason);
  }
  tool_ = drawing.tool();
  if (!tool_ || !calipers_.snaps()) snap_ = {};
  if (isShown && !underMouse()) setCursor(calipers_.drawing().tool() ? Qt::CrossCursor : Qt::ArrowCursor);
  keepResultsClear();
  update();
}

/// Beside the sliders.
QRect CaliperLayer::roomOfResults() const {
  const int left = std::max(8, DgcColumn::wanted_px() + 8 - x());
  return {left, 8, width() - left, height() - 16};
}

void CaliperLayer::keepResultsClear() {
  if (where_ == Where::image)
    scan_.setResultsRect(isHidden() ? QRect() : rectOfResults(calipers_, where_, roomOfResults()).translated(pos()));
}

QPointF CaliperLayer::placeOf(const glm::dvec2& at) const {
  const double ratio = devicePixelRatioF(), half = 0.5 / ratio;
  if (where_ == Where::strip) {
    const auto pixel = calipers_.hasStrip() ? calipers_.stripPlane().pixelOf(at) : std::nullopt;
    if (!pixel) return {-1000.0, calipers_.hasStrip() ? at.y / calipers_.stripPlane().rowDepth_mm() / ratio : 0.0};
    return QPointF(pixel->x / ratio + half, pixel->y / ratio + half);
  }
  return scan_.positionOf(Point<frame::Probe>{{at.x, at.y, 0.0}}) - QPointF(geometry().topLeft()) + QPointF(half, half);
}

std::optional<glm::dvec2> CaliperLayer::pointAt(const QPointF& at) const {
  if (where_ == Where::strip) {
    if (!calipers_.hasStrip()) return std::nullopt;
    const double ratio = devicePixelRatioF();
    return calipers_.stripPlane().pointAt({at.x() * ratio, at.y() * ratio});
  }
  const Point<frame::Probe> point = scan_.pointAt(at + QPointF(geometry().topLeft()));
  return glm::dvec2(point.at.x, point.at.y);
}

double CaliperLayer::reach_mm() const {
  if (where_ == Where::strip) return calipers_.hasStrip() ? kReach_px * devicePixelRatioF() * calipers_.stripPlane().rowDepth_mm() : 0.0;
  return kReach_px * scan_.mmPerWidgetPixel();
}

std::optional<glm::dvec2> CaliperLayer::meantAt(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const auto point = pointAt(at);
  const bool isOnce = (modifiers & Qt::ControlModifier) != 0;
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  const bool isWanted = point && calipers_.snaps() != isOnce && (drawing.tool() || drawing.isDragging());
  measurement::SnapTarget now{measurement::SnapKind::none, point.value_or(glm::dvec2(0.0)), 0};
  if (isWanted) {
    measurement::SnapSearch search;
    search.reach_mm = reach_mm();
    if (where_ == Where::strip) search.scale = {calipers_.stripPlane().mmPerS(), 1.0};
    std::vector<glm::dvec2> before = drawing.points();
    if (drawing.isDragging()) {
      search.except = drawing.selected();
      before = drawing.fixedEnd() ? std::vector{*drawing.fixedEnd()} : std::vector<glm::dvec2>();
    }
    const bool looksForEdges = where_ == Where::image && drawing.tool() != measurement::CaliperKind::trace;
    if (looksForEdges && calipers_.uncertainty()) search.beam_rad = calipers_.uncertainty()(0, *point).beam_rad;
    now = measurement::snapTarget(*point, drawing.shown(), before, search,
                                  looksForEdges ? session_.image().grey : ImageView<const std::uint8_t>{}, session_.geometry());
  }
  const bool isOther = now.kind != snap_.kind || (now.kind != measurement::SnapKind::none && !(now == snap_));
  snap_ = now;
  if (isOther) update();
  return point ? std::optional(now.at) : std::nullopt;
}

bool CaliperLayer::event(QEvent* event) {
  // Keys that are the layer's own as long as it has the focus, whatever they do elsewhere.
  if (event->type() == QEvent::ShortcutOverride && !keys_->meant(*static_cast<QKeyEvent*>(event), kWithTool).empty()) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

bool CaliperLayer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) follow();
  return QWidget::eventFilter(watched, event);
}

void CaliperLayer::showCursor(const QPointF& at) {
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  const auto point = pointAt(at);
  const bool isOnHandle = drawing.points().empty() && point && drawing.isNearHandle(*point, reach_mm());
  setCursor(drawing.isDragging() || isOnHandle ? Qt::SizeAllCursor : calipers_.drawing().tool() ? Qt::CrossCursor : Qt::ArrowCursor);
}

/// The tool at hand may be one for the other place. False when it is and cannot be used here, which is said.
bool CaliperLayer::prepareTool() {
  const auto tool = calipers_.drawing().tool();
  if (!tool || calipers_.where() == where_) return true;
  if (where_ == Where::strip && *tool == measurement::CaliperKind::distance) {
    calipers_.take(measurement::CaliperKind::depthDistance);
    return true;
  }
  scan_.say(where_ == Where::strip ? tr("%1 is measured in the image; in the strip measure time, heart rate, slope or depth.", "a tool")
                                         .arg(CaliperWords::nameOf(*tool))
                                   : tr("%1 is measured in the strip: click there.", "a tool").arg(CaliperWords::nameOf(*tool)));
  return false;
}

void CaliperLayer::mousePressEvent(QMouseEvent* event) {
  // Alt asks for the source of a point: the scan view's.
  if (event->button() != Qt::LeftButton || (event->modifiers() & Qt::AltModifier) != 0) return event->ignore();
  cross_.reset();
  const auto bare = pointAt(event->localPos());
  const CaliperDrawing& here = calipers_.drawingIn(where_);
  const bool takesHandle = bare && here.points().empty() && here.isNearHandle(*bare, reach_mm());
  if (!takesHandle && !prepareTool()) return;
  if (!bare) return scan_.say(tr("Nothing is drawn there yet; click where the strip shows echoes."));
  if (where_ == Where::image) calipers_.hold();
  // A cross is taken where it is clicked; a new point is set where it is drawn to.
  const glm::dvec2 at = takesHandle ? *bare : meantAt(event->localPos(), event->modifiers()).value_or(*bare);
  auto pressed = CaliperDrawing::Press::nothing;
  const bool hadSelection = here.selected() != 0;
  calipers_.changeIn(where_, [&](CaliperDrawing& drawing) { pressed = drawing.press(at, reach_mm()); });
  showCursor(event->localPos());
  if (pressed == CaliperDrawing::Press::nothing && !calipers_.drawing().tool() && !hadSelection) event->ignore();
}

void CaliperLayer::mouseMoveEvent(QMouseEvent* event) {
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  cross_.reset();
  const auto at = meantAt(event->localPos(), event->modifiers());
  if (at && (drawing.isDragging() || !drawing.points().empty()))
    calipers_.changeIn(where_, [&](CaliperDrawing& each) { each.moveTo(*at, reach_mm()); });
  showCursor(event->localPos());
}

void CaliperLayer::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  const auto at = meantAt(event->localPos(), event->modifiers());
  if (drawing.isDragging() || drawing.isPressed())
    calipers_.changeIn(where_, [&](CaliperDrawing& each) {
      if (at)
        each.release(*at, reach_mm());
      else
        each.letGo();
    });
  showCursor(event->localPos());
}

void CaliperLayer::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  snap_ = {};
  update();
}

void CaliperLayer::moveCross(QPointF by, Qt::KeyboardModifiers modifiers) {
  const QPointF from = cross_.value_or(QPointF(rect().center()));
  cross_ = QPointF(std::clamp(from.x() + by.x(), 0.0, width() - 1.0), std::clamp(from.y() + by.y(), 0.0, height() - 1.0));
  const auto at = meantAt(*cross_, calipers_.snaps() ? modifiers : Qt::NoModifier);  // Ctrl is a fine step as well
  if (at) calipers_.changeIn(where_, [&](CaliperDrawing& drawing) { drawing.moveTo(*at, reach_mm()); });
  update();
}

void CaliperLayer::enter() {
  // After the mouse, Enter ends what the mouse has clicked.
  if (!cross_ && !calipers_.drawingIn(where_).points().empty())
    return calipers_.changeIn(where_, [](CaliperDrawing& drawing) { drawing.finish(); });
  if (!cross_) return moveCross({}, Qt::NoModifier);
  // What was last shown, also where Ctrl made a fine step.
  const auto bare = pointAt(*cross_);
  if (!bare) return scan_.say(tr("Nothing is drawn there yet; click where the strip shows echoes."));
  const glm::dvec2 at = snap_.kind != measurement::SnapKind::none ? snap_.at : *bare;
  if (where_ == Where::image) calipers_.hold();
  calipers_.changeIn(where_, [&](CaliperDrawing& drawing) {
    if (drawing.isDragging()) return drawing.release(at, reach_mm());
    if (drawing.press(at, reach_mm()) != CaliperDrawing::Press::handle) drawing.release(at, reach_mm());
  });
}

void CaliperLayer::keyPressEvent(QKeyEvent* event) {
  const std::string command = keys_->meant(*event, kWithTool);
  const double step_px = (event->modifiers() & Qt::ControlModifier) != 0 ? kFineStep_px
                         : (event->modifiers() & Qt::ShiftModifier) != 0 ? kFarStep_px
                                                                         : kStep_px;
  if (command == "cross.left") return moveCross({-step_px, 0.0}, event->modifiers());
  if (command == "cross.right") return moveCross({step_px, 0.0}, event->modifiers());
  if (command == "cross.up") return moveCross({0.0, -step_px}, event->modifiers());
  if (command == "cross.down") return moveCross({0.0, step_px}, event->modifiers());
  if (command == "cross.set") return enter();
  if (command == "cross.takeBack") return calipers_.changeIn(where_, [](CaliperDrawing& drawing) { drawing.takeBack(); });
  bool wasUsed = false;
  if (command == "escape") calipers_.changeIn(where_, [&](CaliperDrawing& drawing) { wasUsed = drawing.cancel(); });
  event->setAccepted(wasUsed);
}

void CaliperLayer::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  Q_EMIT focusChanged();
}

void CaliperLayer::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
  Q_EMIT focusChanged();
}

void CaliperLayer::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = scanTheme();
  const CaliperColours colours{theme.text, theme.accent};
  painter.setClipRect(rect());
  paintCalipers(
      painter, calipers_, where_, [this](const glm::dvec2& at) { return placeOf(at); }, colours);
  paintResults(painter, calipers_, where_, roomOfResults(), colours);
  if (cross_ && hasFocus()) {
    for (const auto& [colour, thick] : {std::pair{QColor(Qt::black), 3.0}, std::pair{theme.accent, 1.5}}) {
      painter.setPen(QPen(colour, thick));
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(*cross_ + QPointF(0.5, 0.5) + 4.0 * way, *cross_ + QPointF(0.5, 0.5) + 12.0 * way);
    }
  }
  paintSnap(painter);
  paintHint(painter);
}

/// A mark where the point will be set, and beside it a word what that is.
void CaliperLayer::paintSnap(QPainter& painter) {
  if (snap_.kind == measurement::SnapKind::none) return;
  const Theme theme = scanTheme();
  const QPointF at = placeOf(snap_.at);
  constexpr double kHalf_px = 7.0;
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, thick] : {std::pair{QColor(Qt::black), 3.5}, std::pair{theme.accent, 1.5}}) {
    painter.setPen(QPen(colour, thick));
    if (snap_.kind == measurement::SnapKind::point) painter.drawEllipse(at, kHalf_px, kHalf_px);
    if (snap_.kind == measurement::SnapKind::edge)
      painter.drawPolygon(QPolygonF(
          QVector<QPointF>{at - QPointF(0, kHalf_px), at + QPointF(kHalf_px, 0), at + QPointF(0, kHalf_px), at - QPointF(kHalf_px, 0)}));
    if (snap_.kind == measurement::SnapKind::horizontal) painter.drawLine(at - QPointF(3.0 * kHalf_px, 0), at + QPointF(3.0 * kHalf_px, 0));
    if (snap_.kind == measurement::SnapKind::vertical) painter.drawLine(at - QPointF(0, 3.0 * kHalf_px), at + QPointF(0, 3.0 * kHalf_px));
  }
  const QString word = CaliperWords::snapWord(snap_, where_ == Where::strip);
  painter.setFont(smallFont());
  QRectF room = QRectF(painter.fontMetrics().boundingRect(word)).adjusted(-4, -2, 4, 2);
  room.moveTopLeft(at + QPointF(14.0, 10.0));
  if (room.right() > width() - 4) room.moveRight(at.x() - 14.0);
  if (room.bottom() > height() - 4) room.moveBottom(at.y() - 10.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 200));
  painter.drawRoundedRect(room, 3.0, 3.0);
  painter.setPen(theme.accent);
  painter.drawText(room, Qt::AlignCenter, word);
}

void CaliperLayer::paintHint(QPainter& painter) {
  const CaliperDrawing& drawing = calipers_.drawingIn(where_);
  if (!drawing.tool() || !drawing.points().empty() || drawing.isDragging() || drawing.selected() != 0) return;
  const Theme theme = scanTheme();
  const QString hint = CaliperWords::hintOf(*drawing.tool());
  painter.setFont(smallFont());
  const QRect room = rect().adjusted(16, 16, -16, -16);
  const QRect words = painter.boundingRect(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 200));
  painter.drawRoundedRect(words.adjusted(-8, -4, 8, 4), 4.0, 4.0);
  painter.setPen(theme.text);
  painter.drawText(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint);
}

}  // namespace ew::ui
