#include "body/body_tools.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <array>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "body/view3d.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

using bridge::Handle;

constexpr double kNearHandle_px = 9.0;
constexpr double kNudge_mm = 1.0;
constexpr double kNudge_rad = glm::radians(1.0);

double stepOf(const Handle& handle) { return handle.kind == Handle::Kind::move ? kNudge_mm : kNudge_rad; }

/// What a key does: along or about which axis as it is seen, and which way.
struct Nudge {
  const char* command;
  Handle::Kind kind;
  bridge::AxisSense bridge::ViewAxes::*along;
  double way;
};
// What faces the viewer turns to where the key's arrow points; a turn about the line of sight is clockwise with Page down.
constexpr std::array kNudges{Nudge{"handles.left", Handle::Kind::move, &bridge::ViewAxes::right, -1.0},
                             Nudge{"handles.right", Handle::Kind::move, &bridge::ViewAxes::right, 1.0},
                             Nudge{"handles.up", Handle::Kind::move, &bridge::ViewAxes::up, 1.0},
                             Nudge{"handles.down", Handle::Kind::move, &bridge::ViewAxes::up, -1.0},
                             Nudge{"handles.nearer", Handle::Kind::move, &bridge::ViewAxes::away, -1.0},
                             Nudge{"handles.farther", Handle::Kind::move, &bridge::ViewAxes::away, 1.0},
                             Nudge{"handles.turnLeft", Handle::Kind::turn, &bridge::ViewAxes::up, -1.0},
                             Nudge{"handles.turnRight", Handle::Kind::turn, &bridge::ViewAxes::up, 1.0},
                             Nudge{"handles.turnUp", Handle::Kind::turn, &bridge::ViewAxes::right, -1.0},
                             Nudge{"handles.turnDown", Handle::Kind::turn, &bridge::ViewAxes::right, 1.0},
                             Nudge{"handles.turnBack", Handle::Kind::turn, &bridge::ViewAxes::away, -1.0},
                             Nudge{"handles.turnOn", Handle::Kind::turn, &bridge::ViewAxes::away, 1.0}};

/// Words on a ground of their own, within `room`, centred about `middle`.
void paintWords(QPainter& painter, const QString& text, const QPointF& middle, const QRectF& room) {
  painter.setFont(smallFont());
  const QRectF most(0.0, 0.0, room.width(), room.height());
  QRectF box = QFontMetricsF(painter.font()).boundingRect(most, Qt::AlignHCenter | Qt::TextWordWrap, text);
  box.moveCenter(middle);
  if (box.left() < room.left()) box.moveLeft(room.left());
  if (box.right() > room.right()) box.moveRight(room.right());
  if (box.top() < room.top()) box.moveTop(room.top());
  if (box.bottom() > room.bottom()) box.moveBottom(room.bottom());
  QColor veil = currentTheme().panel;
  veil.setAlpha(225);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawRoundedRect(box.adjusted(-8.0, -4.0, 8.0, 4.0), 4.0, 4.0);
  painter.setPen(currentTheme().text);
  painter.drawText(box.adjusted(-1.0, 0.0, 1.0, 0.0), Qt::AlignCenter | Qt::TextWordWrap, text);
}

}  // namespace

BodyTools::BodyTools(HostOverlays& overlays, View3D& view, QObject* parent) : QObject(parent), overlays_(overlays), view_(view) {
  view_.canvas()->installEventFilter(this);
  connect(&overlays_, &HostOverlays::handlesChanged, this, &BodyTools::followHandles);
  connect(&overlays_, &HostOverlays::askingChanged, this, &BodyTools::followAsking);
}

void BodyTools::followHandles() {
  const auto next = overlays_.handles();
  if (next != handles_) {
    drag_.reset();
    used_.reset();
    isNudging_ = false;
    handles_ = next;
  }
  if (handles_ == nullptr) {
    view_.change([](bridge::Scene3D& scene) { scene.clearHandles(); });
  } else {
    show(*handles_);
  }
  use(used_);
}

void BodyTools::show(const HostOverlays::Handles& handles) {
  view_.change([toWorld = renamed<frame::World, bridge::HandlesFrame>(handles.shown.toWorld),
                halfSize_mm = handles.shown.halfSize_mm](bridge::Scene3D& scene) { scene.setHandles(toWorld, halfSize_mm); });
}

void BodyTools::followAsking() {
  const bool asks = overlays_.asking() != nullptr;
  cross_.reset();
  if (asks) {
    view_.canvas()->setCursor(Qt::CrossCursor);
    view_.canvas()->setFocus(Qt::OtherFocusReason);  // so that Escape is heard
  } else {
    view_.canvas()->unsetCursor();
  }
  Q_EMIT overChanged();
}

bool BodyTools::eventFilter(QObject* watched, QEvent* event) {
  if (watched != view_.canvas()) return QObject::eventFilter(watched, event);
  if (overlays_.asking() != nullptr) return askingEvent(*event);
  return handles_ != nullptr && handlesEvent(*event);
}

bool BodyTools::askingEvent(QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      const auto& mouse = static_cast<QMouseEvent&>(event);
      if (mouse.button() != Qt::LeftButton) return false;
      const auto asking = overlays_.asking();  // it may give its ticket back meanwhile
      if (const auto hit = view_.contactAt(mouse.pos()); hit && asking->pointed) asking->pointed({hit->point_mm});
      return true;
    }
    case QEvent::MouseButtonRelease:
      return static_cast<QMouseEvent&>(event).button() == Qt::LeftButton;
    case QEvent::MouseMove: {
      const auto& mouse = static_cast<QMouseEvent&>(event);
      cross_ = mouse.localPos();
      Q_EMIT overChanged();
      return (mouse.buttons() & ~Qt::LeftButton) == 0;
    }
    case QEvent::Leave:
      cross_.reset();
      Q_EMIT overChanged();
      return false;
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent&>(event).key() != Qt::Key_Escape) return false;
      overlays_.stopAsking();
      return true;
    default:
      return false;
  }
}

bool BodyTools::handlesEvent(QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return press(static_cast<QMouseEvent&>(event));
    case QEvent::MouseMove:
      return move(static_cast<QMouseEvent&>(event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent&>(event));
    case QEvent::Leave:
      if (!drag_) use(std::nullopt);
      return false;
    case QEvent::FocusOut:
      endNudge();
      return false;
    case QEvent::ShortcutOverride: {
      const auto& pressed = static_cast<QKeyEvent&>(event);
      const bool isOurs = !keys_->meant(pressed, kWithHandles).empty() || (drag_ && pressed.key() == Qt::Key_Escape);
      if (isOurs) event.accept();
      return isOurs;
    }
    case QEvent::KeyPress:
      return key(static_cast<QKeyEvent&>(event));
    case QEvent::KeyRelease:
      if (!isNudging_ || static_cast<QKeyEvent&>(event).isAutoRepeat()) return false;
      endNudge();
      return true;
    default:
      return false;
  }
}

bridge::Ray BodyTools::rayAt(const QPointF& at) const { return view_.rayAt(at); }

bool BodyTools::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return drag_.has_value();
  const double ratio = view_.canvas()->devicePixelRatioF();
  const auto handle = view_.scene().handleAt(ratio * glm::dvec2(event.localPos().x(), event.localPos().y()), ratio * kNearHandle_px);
  const auto place = view_.scene().handles();
  if (!handle || !place) return false;
  view_.canvas()->setFocus(Qt::MouseFocusReason);
  endNudge();
  drag_.emplace(*place, *handle, rayAt(event.localPos()));
  step_ = 0.0;
  use(handle);
  view_.canvas()->setCursor(Qt::ClosedHandCursor);
  return true;
}

bool BodyTools::move(const QMouseEvent& event) {
  if (drag_) {
    drag_->follow(rayAt(event.localPos()));
    step_ = (event.modifiers() & Qt::ShiftModifier) != 0 ? stepOf(drag_->handle()) : 0.0;
    take(drag_->toWorld(step_), false);
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  const double ratio = view_.canvas()->devicePixelRatioF();
  use(view_.scene().handleAt(ratio * glm::dvec2(event.localPos().x(), event.localPos().y()), ratio * kNearHandle_px));
  if (!used_) return false;
  view_.canvas()->setCursor(Qt::OpenHandCursor);
  return true;
}

bool BodyTools::release(const QMouseEvent& event) {
  if (!drag_ || event.button() != Qt::LeftButton) return false;
  endDrag(false);
  view_.canvas()->setCursor(Qt::OpenHandCursor);
  return true;
}

void BodyTools::endDrag(bool givesBack) {
  const auto drag = std::exchange(drag_, std::nullopt);
  if (!drag) return;
  if (givesBack) use(std::nullopt);
  take(givesBack ? drag->from() : drag->toWorld(step_), true);
}

bool BodyTools::key(const QKeyEvent& event) {
  if (drag_ && event.key() == Qt::Key_Escape) {
    view_.canvas()->unsetCursor();
    endDrag(true);
    return true;
  }
  const std::string command = keys_->meant(event, kWithHandles);
  if (command.empty() || drag_) return drag_.has_value();
  nudge(command);
  return true;
}

void BodyTools::nudge(const std::string& command) {
  const auto from = renamed<frame::World, bridge::HandlesFrame>(handles_->shown.toWorld);
  const bridge::Scene3D& scene = view_.scene();
  const glm::dvec3 right = scene.cameraRight(), up = scene.cameraUp();
  const bridge::ViewAxes seen = bridge::axesAsSeen(from, right, up, glm::cross(up, right));
  for (const Nudge& each : kNudges) {
    if (command != each.command) continue;
    const bridge::AxisSense& sense = seen.*each.along;
    const Handle handle{each.kind, sense.axis};
    isNudging_ = true;
    take(bridge::moved(from, handle, each.way * sense.sign * stepOf(handle)), false);
  }
}

void BodyTools::endNudge() {
  if (!std::exchange(isNudging_, false) || handles_ == nullptr) return;
  take(renamed<frame::World, bridge::HandlesFrame>(handles_->shown.toWorld), true);
}

void BodyTools::take(const bridge::HandlesToWorld& toWorld, bool isOver) {
  const auto handles = handles_;  // whoever is told may give it back
  if (handles == nullptr) return;
  handles->shown.toWorld = renamed<frame::World, sdk::BodyHandles::Frame>(toWorld);
  show(*handles);
  Q_EMIT overChanged();
  if (handles->moved) handles->moved(handles->shown.toWorld, isOver);
}

void BodyTools::use(const std::optional<Handle>& handle) {
  if (used_ && !handle && overlays_.asking() == nullptr) view_.canvas()->unsetCursor();
  if (used_ == handle) return;
  used_ = handle;
  view_.change([handle](bridge::Scene3D& scene) { scene.setUsedHandle(handle ? &*handle : nullptr); });
  Q_EMIT overChanged();
}

bool BodyTools::isDrawnOver() const { return overlays_.asking() != nullptr || (handles_ != nullptr && used_); }

QString BodyTools::wordsOfUse() const {
  const QString axis = words(handles_->shown.axes[static_cast<std::size_t>(used_->axis)]);
  const bool isMove = used_->kind == Handle::Kind::move;
  if (!drag_) return isMove ? tr("Move: %1").arg(axis) : tr("Turn about: %1").arg(axis);
  const double amount = drag_->stepped(step_);
  return isMove ? tr("%1: %2 mm").arg(axis, signedFigure(amount, 1)) : tr("about %1: %2°").arg(axis, signedFigure(glm::degrees(amount), 1));
}

void BodyTools::paintOver(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF room = QRectF(view_.canvas()->rect()).adjusted(16.0, 16.0, -16.0, -16.0);
  if (const auto asking = overlays_.asking()) {
    paintWords(painter, asking->hint, {room.center().x(), room.top() + 16.0}, room);
    if (!cross_) return;
    const bool isOnSkin = view_.contactAt(cross_->toPoint()).has_value();
    for (const auto& [colour, width] :
         {std::pair{QColor(0, 0, 0, 150), 3.0}, std::pair{isOnSkin ? currentTheme().accent : currentTheme().quiet, 1.5}}) {
      painter.setPen(QPen(colour, width));
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(*cross_ + 4.0 * way, *cross_ + 14.0 * way);
      if (isOnSkin) painter.drawEllipse(*cross_, 8.0, 8.0);
    }
    return;
  }
  const auto place = view_.scene().handles();
  if (!used_ || !place) return;
  const glm::dvec3 middle_mm(place->toWorld.matrix[3]);
  const bridge::Sight sight = view_.sight();
  const glm::dvec2 middle = sight.pixelOf(middle_mm);
  const double below_px = place->reach_mm / sight.mmPerPixelAt(middle_mm);
  paintWords(painter, wordsOfUse(), {middle.x, middle.y + below_px + 20.0}, room);
}

}  // namespace ew::ui
