#include "scan/doppler/drag_on_image.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {

bool DragOnImage::isThere() const { return !session_.isFrozen() && !session_.isPlaying() && !session_.image().isEmpty() && hasAny(); }

std::optional<DragOnImage::Grip> DragOnImage::findGrip(const QPointF& at) const {
  return isThere() && QRectF(scan_.imageRect()).contains(at) ? gripAt(at) : std::nullopt;
}

std::optional<Qt::CursorShape> DragOnImage::cursor() const {
  if (!grip_ || !isThere()) return std::nullopt;
  return isDragging() && grip_->cursor == Qt::OpenHandCursor ? Qt::ClosedHandCursor : grip_->cursor;
}

void DragOnImage::end() {
  grip_.reset();
  isDragging_ = false;
  tellHint();
}

void DragOnImage::tellHint() { scan_.setDragHint(grip_ ? grip_->hint : QString()); }

bool DragOnImage::press(const QEvent& event) {
  const auto& mouse = static_cast<const QMouseEvent&>(event);
  if (isDragging()) return true;  // another button
  if (mouse.button() != Qt::LeftButton || (mouse.modifiers() & Qt::AltModifier) != 0) return false;
  grip_ = findGrip(mouse.localPos());
  isDragging_ = grip_.has_value();
  if (grip_) begin(grip_->part, mouse.localPos());
  return isDragging();
}

bool DragOnImage::move(const QEvent& event) {
  const auto& mouse = static_cast<const QMouseEvent&>(event);
  if (isDragging()) {
    isThere() ? moveTo(grip_->part, mouse.localPos()) : end();
    return true;
  }
  grip_ = mouse.buttons() == Qt::NoButton ? findGrip(mouse.localPos()) : std::nullopt;
  tellHint();
  return false;
}

bool DragOnImage::release(const QEvent& event) {
  const auto& mouse = static_cast<const QMouseEvent&>(event);
  if (!isDragging() || mouse.button() != Qt::LeftButton) return false;
  isDragging_ = false;
  grip_ = findGrip(mouse.localPos());
  tellHint();
  return true;
}

bool DragOnImage::wheel(const QEvent& event) {
  constexpr int kStep = 120;  // Qt's eighths of a degree for a notch
  const auto& wheel = static_cast<const QWheelEvent&>(event);
  if (!isThere() || !findGrip(wheel.position())) return false;
  turned_ += wheel.angleDelta().y();
  const int steps = turned_ / kStep;
  turned_ -= steps * kStep;
  return turn(steps);
}

bool DragOnImage::handle(const QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
      return press(event);
    case QEvent::MouseMove:
      return move(event);
    case QEvent::MouseButtonRelease:
      return release(event);
    case QEvent::Wheel:
      return wheel(event);
    case QEvent::Leave:
      if (!isDragging()) end();
      return false;
    default:
      return false;
  }
}

}  // namespace ew::ui
