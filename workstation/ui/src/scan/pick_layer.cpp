#include "scan/pick_layer.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/theme.h"
#include "scan/scan_view.h"

namespace ew::ui {
namespace {

constexpr int kStep_px = 4;
constexpr int kFarStep_px = 32;

}  // namespace

PickLayer::PickLayer(Session& session, ScanView& scan) : QWidget(&scan), session_(session), scan_(scan) {
  setFocusPolicy(Qt::ClickFocus);
  hide();
  scan.installEventFilter(this);
  connect(&session_, &Session::imageChanged, this, &PickLayer::follow);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, &PickLayer::follow);
  connect(&session_, &Session::subjectChanged, this, [this] {
    if (!session_.subject()) setPicking(false);
  });
}

void PickLayer::follow() {
  if (isHidden()) return;
  setGeometry(scan_.imageRect());
  imageMoved();
}

void PickLayer::setHint(const QString& hint) {
  hint_ = hint;
  setAccessibleDescription(hint);
  update();
}

void PickLayer::setStroke(std::optional<double> radius_mm) {
  strokeRadius_mm_ = radius_mm;
  isDrawing_ = false;
  setMouseTracking(radius_mm.has_value());
  update();
}

void PickLayer::setPicking(bool picking) {
  if (picking && !session_.subject()) picking = false;
  if (picking != picking_) {
    picking_ = picking;
    const DisplayImage& image = session_.image();
    cross_ = kept().value_or(QPoint(image.width() / 2, image.height() / 2));
    showOrHide();
    if (picking) {
      setFocus(Qt::OtherFocusReason);
    } else {
      scan_.setFocus(Qt::OtherFocusReason);
    }
  }
  Q_EMIT pickingChanged(picking_);
}

void PickLayer::showOrHide() {
  // A mark alone must not take the mouse from the probe.
  setAttribute(Qt::WA_TransparentForMouseEvents, !picking_);
  if (picking_) {
    setCursor(Qt::CrossCursor);
  } else {
    unsetCursor();
  }
  setGeometry(scan_.imageRect());
  setVisible(picking_ || kept());
  raise();
  update();
}

QPoint PickLayer::pixelAt(const QPointF& at) const {
  return {static_cast<int>(std::floor(at.x() * devicePixelRatioF())), static_cast<int>(std::floor(at.y() * devicePixelRatioF()))};
}

QPointF PickLayer::placeOf(const QPoint& pixel) const { return (QPointF(pixel) + QPointF(0.5, 0.5)) / devicePixelRatioF(); }

void PickLayer::pick(const QPoint& pixel) {
  cross_ = pixel;
  update();
  Q_EMIT picked(pixel);
}

bool PickLayer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) follow();
  return QWidget::eventFilter(watched, event);
}

void PickLayer::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  if (!strokeRadius_mm_) return pick(pixelAt(event->localPos()));
  isDrawing_ = true;
  cross_ = pixelAt(event->localPos());
  update();
  Q_EMIT strokeBegun(cross_);
}

void PickLayer::mouseMoveEvent(QMouseEvent* event) {
  if (!strokeRadius_mm_) return event->ignore();
  cross_ = pixelAt(event->localPos());
  update();
  if (isDrawing_) Q_EMIT strokeMoved(cross_);
}

void PickLayer::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(isDrawing_, false)) return event->ignore();
  Q_EMIT strokeEnded(pixelAt(event->localPos()));
}

void PickLayer::keyPressEvent(QKeyEvent* event) {
  const int step_px = (event->modifiers() & Qt::ShiftModifier) != 0 ? kFarStep_px : kStep_px;
  QPoint by;
  const std::string command = keys_->meant(*event, kWithTool);
  if (command == "escape") {
    setPicking(false);
    Q_EMIT escaped();
    return;
  }
  if (command == "cross.set" && strokeRadius_mm_) {
    Q_EMIT strokeBegun(cross_);
    Q_EMIT strokeEnded(cross_);
    return;
  }
  if (command == "cross.set") return pick(cross_);
  if (command == "cross.left")
    by = {-step_px, 0};
  else if (command == "cross.right")
    by = {step_px, 0};
  else if (command == "cross.up")
    by = {0, -step_px};
  else if (command == "cross.down")
    by = {0, step_px};
  else
    return event->ignore();
  const DisplayImage& image = session_.image();
  cross_ = {std::clamp(cross_.x() + by.x(), 0, std::max(0, image.width() - 1)),
            std::clamp(cross_.y() + by.y(), 0, std::max(0, image.height() - 1))};
  update();
}

void PickLayer::paintCross(QPainter& painter, const QPointF& at, bool ringed) {
  // A dark edge under the light line keeps the cross in sight on bright tissue.
  for (const auto& [colour, width] : {std::pair{QColor(Qt::black), 3.0}, std::pair{scanTheme().accent, 1.5}}) {
    painter.setPen(QPen(colour, width));
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      painter.drawLine(at + 4.0 * way, at + 12.0 * way);
    }
    if (ringed) painter.drawEllipse(at, 8.0, 8.0);
  }
}

void PickLayer::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto mark = kept();
  if (mark) paintCross(painter, placeOf(*mark), true);
  if (!picking_) return;
  if (cross_ != mark) paintCross(painter, placeOf(cross_), false);
  if (strokeRadius_mm_ && *strokeRadius_mm_ > 0.0 && session_.geometry().pixel_mm > 0.0) {
    const double radius_px = *strokeRadius_mm_ / session_.geometry().pixel_mm / devicePixelRatioF();
    for (const auto& [colour, width] : {std::pair{QColor(Qt::black), 3.0}, std::pair{scanTheme().accent, 1.5}}) {
      painter.setPen(QPen(colour, width));
      painter.drawEllipse(placeOf(cross_), radius_px, radius_px);
    }
  }
  if (hint_.isEmpty()) return;
  painter.setFont(smallFont());
  const QRect room = rect().adjusted(16, 16, -16, -16);
  const QRect words = painter.boundingRect(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint_);
  QColor veil(Qt::black);
  veil.setAlpha(200);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawRoundedRect(words.adjusted(-8, -4, 8, 4), 4.0, 4.0);
  painter.setPen(scanTheme().text);
  painter.drawText(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, hint_);
}

}  // namespace ew::ui
