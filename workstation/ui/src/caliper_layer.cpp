#include "caliper_layer.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "caliper_paint.h"
#include "caliper_words.h"
#include "dgc_column.h"
#include "scan_view.h"
#include "session.h"
#include "theme.h"

namespace ew::ui {
namespace {

using measurement::CaliperDrawing;

constexpr double kReach_px = 9.0;
constexpr double kStep_px = 4.0, kFarStep_px = 32.0, kFineStep_px = 1.0;

}  // namespace

CaliperLayer::CaliperLayer(Session& session, Calipers& calipers, ScanView& scan)
    : QWidget(&scan), session_(session), calipers_(calipers), scan_(scan) {
  setObjectName(QStringLiteral("caliperLayer"));
  setFocusPolicy(Qt::ClickFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Calipers on the image"));
  hide();
  scan.installEventFilter(this);
  connect(&session_, &Session::pictureChanged, this, &CaliperLayer::follow);
  connect(&calipers_, &Calipers::changed, this, &CaliperLayer::showOrHide);
}

void CaliperLayer::follow() {
  if (!isHidden() && geometry() != scan_.pictureRect()) setGeometry(scan_.pictureRect());
}

void CaliperLayer::showOrHide() {
  const CaliperDrawing& drawing = calipers_.drawing();
  const bool isWanted = drawing.tool() || !drawing.isEmpty();
  const bool hadFocus = hasFocus();
  if (isWanted) setGeometry(scan_.pictureRect());
  setVisible(isWanted);
  if (!isWanted) {
    cross_.reset();
    if (hadFocus) scan_.setFocus(Qt::OtherFocusReason);
  } else if (drawing.tool() && drawing.tool() != tool_) {
    raise();
    setFocus(Qt::OtherFocusReason);
  }
  tool_ = drawing.tool();
  if (isWanted && !underMouse()) setCursor(tool_ ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

QPointF CaliperLayer::placeOf(const glm::dvec2& at_mm) const {
  const double half = 0.5 / devicePixelRatioF();
  return scan_.positionOf(Point<frame::Probe>{{at_mm.x, at_mm.y, 0.0}}) - QPointF(geometry().topLeft()) + QPointF(half, half);
}

glm::dvec2 CaliperLayer::pointAt(const QPointF& at) const {
  const Point<frame::Probe> point = scan_.pointAt(at + QPointF(geometry().topLeft()));
  return {point.at.x, point.at.y};
}

double CaliperLayer::reach_mm() const { return kReach_px * scan_.mmPerWidgetPixel(); }

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
  const CaliperDrawing& drawing = calipers_.drawing();
  const bool isOnHandle = drawing.points().empty() && handleNear(drawing.shown(), 0, pointAt(at), reach_mm()).has_value();
  setCursor(drawing.isDragging() || isOnHandle ? Qt::SizeAllCursor : drawing.tool() ? Qt::CrossCursor : Qt::ArrowCursor);
}

void CaliperLayer::mousePressEvent(QMouseEvent* event) {
  // Alt asks for the source of a point: the scan view's.
  if (event->button() != Qt::LeftButton || (event->modifiers() & Qt::AltModifier) != 0) return event->ignore();
  cross_.reset();
  calipers_.hold();
  auto pressed = CaliperDrawing::Press::nothing;
  const bool hadSelection = calipers_.drawing().selected() != 0;
  calipers_.change([&](CaliperDrawing& drawing) { pressed = drawing.press(pointAt(event->localPos()), reach_mm()); });
  showCursor(event->localPos());
  if (pressed == CaliperDrawing::Press::nothing && !calipers_.drawing().tool() && !hadSelection) event->ignore();
}

void CaliperLayer::mouseMoveEvent(QMouseEvent* event) {
  const CaliperDrawing& drawing = calipers_.drawing();
  cross_.reset();
  if (drawing.isDragging() || !drawing.points().empty())
    calipers_.change([&](CaliperDrawing& each) { each.moveTo(pointAt(event->localPos()), reach_mm()); });
  showCursor(event->localPos());
}

void CaliperLayer::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  calipers_.change([&](CaliperDrawing& drawing) { drawing.release(pointAt(event->localPos()), reach_mm()); });
  showCursor(event->localPos());
}

void CaliperLayer::moveCross(QPointF by) {
  const QPointF from = cross_.value_or(QPointF(rect().center()));
  cross_ = QPointF(std::clamp(from.x() + by.x(), 0.0, width() - 1.0), std::clamp(from.y() + by.y(), 0.0, height() - 1.0));
  calipers_.change([&](CaliperDrawing& drawing) { drawing.moveTo(pointAt(*cross_), reach_mm()); });
}

void CaliperLayer::enter() {
  // After the mouse, Enter ends what the mouse has clicked.
  if (!cross_ && !calipers_.drawing().points().empty()) return calipers_.change([](CaliperDrawing& drawing) { drawing.finish(); });
  if (!cross_) return moveCross({});
  const glm::dvec2 at = pointAt(*cross_);
  calipers_.hold();
  calipers_.change([&](CaliperDrawing& drawing) {
    if (drawing.isDragging()) return drawing.release(at, reach_mm());
    if (drawing.press(at, reach_mm()) != CaliperDrawing::Press::handle) drawing.release(at, reach_mm());
  });
}

void CaliperLayer::keyPressEvent(QKeyEvent* event) {
  const std::string command = keys_->meant(*event, kWithTool);
  const double step_px = (event->modifiers() & Qt::ControlModifier) != 0 ? kFineStep_px
                         : (event->modifiers() & Qt::ShiftModifier) != 0 ? kFarStep_px
                                                                         : kStep_px;
  if (command == "cross.left") return moveCross({-step_px, 0.0});
  if (command == "cross.right") return moveCross({step_px, 0.0});
  if (command == "cross.up") return moveCross({0.0, -step_px});
  if (command == "cross.down") return moveCross({0.0, step_px});
  if (command == "cross.set") return enter();
  if (command == "cross.takeBack") return calipers_.change([](CaliperDrawing& drawing) { drawing.takeBack(); });
  bool wasUsed = false;
  if (command == "escape") calipers_.change([&](CaliperDrawing& drawing) { wasUsed = drawing.cancel(); });
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
      painter, calipers_, [this](const glm::dvec2& at) { return placeOf(at); }, colours);
  const int left = std::max(8, DgcColumn::kWidth_px + 8 - x());  // beside the sliders
  paintResults(painter, calipers_, QRect(left, 8, width() - left, height() - 16), colours);
  if (cross_ && hasFocus()) {
    for (const auto& [colour, thick] : {std::pair{QColor(Qt::black), 3.0}, std::pair{theme.accent, 1.5}}) {
      painter.setPen(QPen(colour, thick));
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(*cross_ + QPointF(0.5, 0.5) + 4.0 * way, *cross_ + QPointF(0.5, 0.5) + 12.0 * way);
    }
  }
  const CaliperDrawing& drawing = calipers_.drawing();
  if (!drawing.tool() || !drawing.points().empty() || drawing.isDragging() || drawing.selected() != 0) return;
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
