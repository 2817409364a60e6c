#include "body/hand_input.h"

#include <QEvent>
#include <QGestureEvent>
#include <QMouseEvent>
#include <QPointer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "body/view3d.h"
#include "keys/key_map.h"

namespace ew::ui {
namespace {

constexpr double kSlide_mm = 2.0;
constexpr double kFastSlide_mm = 10.0;
constexpr double kKeyRotation_rad = glm::radians(2.0);
constexpr double kNotchTip_rad = glm::radians(2.0);
constexpr double kNotchTurn_rad = glm::radians(4.0);
constexpr double kOrbitPerPixel_rad = glm::radians(0.4);
constexpr double kZoomPerPixel = 0.006;

/// Notches of a wheel, with the fractions of a touchpad; Alt swaps the axes on X11, so the other one counts too.
double notchesOf(const QWheelEvent& event) {
  const QPoint angle = event.angleDelta();
  return (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
}

}  // namespace

struct HandInput::State {
  enum class Drag { none, probe3d, probeScan, orbit, pan, zoom };

  QPointer<View3D> view;
  QPointer<QWidget> scan;
  std::function<double()> lateralPerPixel_mm;
  explicit State(const HandOnSkin& held) : hand(held), start(held.hold()) {}

  const HandOnSkin& hand;
  Hold start;
  const KeyMap* keys = &usualKeys();
  bool enabled = true;
  Drag drag = Drag::none;
  QPointF last;        ///< pointer at the last event of this drag
  QPointF grabOffset;  ///< from the pointer to the pixel of the contact, so that grabbing the housing does not move it
};

HandInput::HandInput(const HandOnSkin& hand, QObject* parent) : QObject(parent), state_(std::make_unique<State>(hand)) {
  qRegisterMetaType<ew::Hold>("ew::Hold");
}

HandInput::~HandInput() = default;

void HandInput::watch(View3D* view) {
  if (state_->view != nullptr) state_->view->canvas()->removeEventFilter(this);
  state_->view = view;
  if (view != nullptr) view->canvas()->installEventFilter(this);
}

void HandInput::watch(QWidget* scanView, std::function<double()> lateralPerPixel_mm) {
  if (state_->scan != nullptr) state_->scan->removeEventFilter(this);
  state_->scan = scanView;
  state_->lateralPerPixel_mm = std::move(lateralPerPixel_mm);
  if (scanView != nullptr) {
    scanView->installEventFilter(this);
    if (scanView->focusPolicy() == Qt::NoFocus) scanView->setFocusPolicy(Qt::StrongFocus);
  }
}

const Hold& HandInput::hold() const { return state_->hand.hold(); }

void HandInput::setStartHold(const Hold& hold) { state_->start = hold; }

bool HandInput::isEnabled() const { return state_->enabled; }

void HandInput::setEnabled(bool enabled) {
  state_->enabled = enabled;
  if (!enabled && (state_->drag == State::Drag::probe3d || state_->drag == State::Drag::probeScan)) state_->drag = State::Drag::none;
}

void HandInput::change(const Hold& hold) {
  if (hold == this->hold()) return;
  if (!state_->enabled) {
    Q_EMIT refused();
    return;
  }
  Q_EMIT moved(hold);
}

void HandInput::slide(double alongLateral_mm, double alongElevational_mm) {
  if (state_->view != nullptr) change(slid(hold(), *state_->view->skin(), alongLateral_mm, alongElevational_mm));
}

void HandInput::slideOnScreen(glm::dvec2 direction, double length_mm) {
  if (state_->view == nullptr) return;
  const bridge::Scene3D& scene = state_->view->scene();
  const glm::dmat4 upright = uprightPoseOf(hold()).probeToWorld.matrix;
  const glm::dvec3 wanted = direction.x * scene.cameraRight() + direction.y * scene.cameraUp();
  glm::dvec2 along(glm::dot(wanted, glm::dvec3(upright[0])), glm::dot(wanted, glm::dvec3(upright[2])));
  // Seen edge on, the skin has no such direction; then the keys act along the probe's own axes.
  if (glm::length(along) < 0.15) along = glm::dvec2(-direction.x, -direction.y);
  along *= length_mm / glm::length(along);
  slide(along.x, along.y);
}

void HandInput::dragInView(const QPointF& at) {
  View3D& view = *state_->view;
  const QPointF target = at + state_->grabOffset;
  const bridge::Ray ray = view.rayAt(target);
  const glm::dvec3 from_mm = hold().contact.point_mm;
  const auto skin = view.skin();
  const auto hit = skin->hit(ray.from_mm, ray.direction);
  const double moved_mm = std::hypot(at.x() - state_->last.x(), at.y() - state_->last.y()) * view.canvas()->devicePixelRatioF() *
                          view.scene().mmPerPixelAt(from_mm);
  // A hit far beyond what the pointer moved lies on another part of the body, seen past the edge of this one.
  if (hit && glm::distance(hit->point_mm, from_mm) < 40.0 + 4.0 * moved_mm) return change(movedTo(hold(), *hit));
  // Off the body: the skin nearest to the line of sight, where that passes the probe.
  const double along_mm = glm::dot(from_mm - ray.from_mm, ray.direction);
  const Skin::Contact rim = skin->nearest(ray.from_mm + along_mm * ray.direction);
  if (glm::distance(rim.point_mm, from_mm) < 40.0 + 4.0 * moved_mm) change(movedTo(hold(), rim));
}

bool HandInput::pressInView(const QMouseEvent& event) {
  View3D& view = *state_->view;
  state_->last = event.localPos();
  switch (event.button()) {
    case Qt::LeftButton: {
      if (!state_->enabled) {
        Q_EMIT refused();
        return true;
      }
      const QPointF contact = view.pixelOf(hold().contact.point_mm);
      const QPointF toContact = contact - event.localPos();
      constexpr double kNear_px = 24.0;
      if (view.isProbeAt(event.pos()) || std::hypot(toContact.x(), toContact.y()) < kNear_px) {
        state_->grabOffset = toContact;
        state_->drag = State::Drag::probe3d;
      } else if (const auto hit = view.contactAt(event.pos())) {
        state_->grabOffset = QPointF();
        state_->drag = State::Drag::probe3d;
        change(movedTo(hold(), *hit));
      }
      return true;
    }
    case Qt::RightButton:
      state_->drag = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0 ? State::Drag::zoom : State::Drag::orbit;
      return true;
    case Qt::MiddleButton:
      state_->drag = State::Drag::pan;
      return true;
    default:
      return false;
  }
}

bool HandInput::moveInView(const QMouseEvent& event) {
  View3D& view = *state_->view;
  const QPointF at = event.localPos();
  const QPointF by = at - state_->last;
  switch (state_->drag) {
    case State::Drag::probe3d:
      dragInView(at);
      break;
    case State::Drag::orbit:
      view.change([by](bridge::Scene3D& scene) { scene.orbit(-kOrbitPerPixel_rad * by.x(), kOrbitPerPixel_rad * by.y()); });
      break;
    case State::Drag::pan: {
      const double ratio = view.canvas()->devicePixelRatioF();
      view.change([=](bridge::Scene3D& scene) { scene.pan({by.x() * ratio, by.y() * ratio}); });
      break;
    }
    case State::Drag::zoom:
      view.change([by](bridge::Scene3D& scene) { scene.zoom(std::exp(-kZoomPerPixel * by.y())); });
      break;
    default: {
      const bool overProbe = state_->enabled && view.isProbeAt(event.pos());
      view.canvas()->setCursor(overProbe ? Qt::OpenHandCursor : Qt::ArrowCursor);
      return false;
    }
  }
  if (state_->drag == State::Drag::probe3d) view.canvas()->setCursor(Qt::ClosedHandCursor);
  state_->last = at;
  return true;
}

bool HandInput::scanEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      if (mouse.button() != Qt::LeftButton) return false;
      if (!state_->enabled) {
        Q_EMIT refused();
        return false;
      }
      state_->drag = State::Drag::probeScan;
      state_->last = mouse.localPos();
      return true;
    }
    case QEvent::MouseMove: {
      if (state_->drag != State::Drag::probeScan) return false;
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      const QPointF by = mouse.localPos() - state_->last;
      state_->last = mouse.localPos();
      const double perPixel_mm = state_->lateralPerPixel_mm ? state_->lateralPerPixel_mm() : 0.0;
      // Downwards is along the elevational axis: with the marker at the left that is how the skin looks from the probe's handle.
      if (std::isfinite(perPixel_mm)) slide(perPixel_mm * by.x(), std::abs(perPixel_mm) * by.y());
      return true;
    }
    case QEvent::MouseButtonRelease:
      if (state_->drag != State::Drag::probeScan) return false;
      state_->drag = State::Drag::none;
      return true;
    default:
      return false;
  }
}

bool HandInput::viewEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      state_->view->canvas()->setFocus(Qt::MouseFocusReason);
      return pressInView(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return moveInView(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      state_->drag = State::Drag::none;
      state_->view->canvas()->setCursor(Qt::ArrowCursor);
      return true;
    case QEvent::Gesture:
      if (auto* pinch = static_cast<QPinchGesture*>(static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture))) {
        if ((pinch->changeFlags() & QPinchGesture::ScaleFactorChanged) != 0) {
          state_->view->change([factor = pinch->scaleFactor()](bridge::Scene3D& scene) { scene.zoom(factor); });
        }
        return true;
      }
      return false;
    case QEvent::ContextMenu:
      return true;  // the right button orbits
    default:
      return false;
  }
}

bool HandInput::turnByWheel(const QWheelEvent& event) {
  const double notches = notchesOf(event);
  if (notches == 0.0) return false;
  if (event.modifiers() & Qt::ControlModifier)
    change(turned(hold(), notches * kNotchTurn_rad, 0.0, 0.0));
  else if (event.modifiers() & Qt::ShiftModifier)
    change(turned(hold(), 0.0, notches * kNotchTip_rad, 0.0));
  else
    change(turned(hold(), 0.0, 0.0, notches * kNotchTip_rad));
  return true;
}

bool HandInput::handleKey(const QKeyEvent& key, const QWidget* where) {
  return run(state_->keys->meant(key, kWhileRunning), (key.modifiers() & Qt::ShiftModifier) != 0, where);
}

bool HandInput::run(const std::string& command, bool far, const QWidget* where) {
  const double length_mm = far ? kFastSlide_mm : kSlide_mm;
  const bool inScan = where != nullptr && where == state_->scan;
  const auto arrow = [&](double right, double up) {
    if (!inScan) return slideOnScreen({right, up}, length_mm);
    const double side = state_->lateralPerPixel_mm && state_->lateralPerPixel_mm() < 0.0 ? -1.0 : 1.0;
    slide(side * right * length_mm, -up * length_mm);
  };
  if (command == "hand.left") {
    arrow(-1.0, 0.0);
  } else if (command == "hand.right") {
    arrow(1.0, 0.0);
  } else if (command == "hand.up") {
    arrow(0.0, 1.0);
  } else if (command == "hand.down") {
    arrow(0.0, -1.0);
  } else if (command == "hand.rotateLeft") {
    turn(Turn::rotation, -1.0);
  } else if (command == "hand.rotateRight") {
    turn(Turn::rotation, 1.0);
  } else if (command == "hand.rockLeft") {
    turn(Turn::rock, -1.0);
  } else if (command == "hand.rockRight") {
    turn(Turn::rock, 1.0);
  } else if (command == "hand.tiltForward") {
    turn(Turn::tilt, 1.0);
  } else if (command == "hand.tiltBack") {
    turn(Turn::tilt, -1.0);
  } else if (command == "hand.home") {
    Hold home = state_->start;
    home.press_mm = hold().press_mm;  // the probe may have been changed since
    change(home);
  } else {
    return false;
  }
  return true;
}

void HandInput::turn(Turn axis, double steps) {
  const double by_rad = steps * kKeyRotation_rad;
  change(turned(hold(), axis == Turn::rotation ? by_rad : 0.0, axis == Turn::rock ? by_rad : 0.0, axis == Turn::tilt ? by_rad : 0.0));
}

void HandInput::setKeys(const KeyMap& keys) { state_->keys = &keys; }

bool HandInput::eventFilter(QObject* watched, QEvent* event) {
  const bool inView = state_->view != nullptr && watched == state_->view->canvas();
  const bool inScan = state_->scan != nullptr && watched == state_->scan;
  if (!inView && !inScan) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::Wheel) {
    const bool used = turnByWheel(*static_cast<QWheelEvent*>(event));
    if (used) event->accept();
    return used;
  }
  if (event->type() == QEvent::KeyPress) {
    const bool used = handleKey(*static_cast<QKeyEvent*>(event), static_cast<QWidget*>(watched));
    if (used) event->accept();
    return used;
  }
  return inView ? viewEvent(event) : scanEvent(event);
}

}  // namespace ew::ui
