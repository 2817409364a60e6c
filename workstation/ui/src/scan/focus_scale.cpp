#include "scan/focus_scale.h"
#include "keys/key_tips.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

namespace ew::ui {

std::vector<double> fociOf(const Session& session) {
  const Knobs& knobs = session.isFrozen() ? session.imageKnobs() : session.console().knobs();
  std::vector<double> foci_mm{session.isFrozen() && knobs.focus_mm > 0.0 ? knobs.focus_mm : session.console().focus_mm()};
  for (const double more_mm : knobs.moreFoci_mm) {
    if (more_mm > 0.0) foci_mm.push_back(more_mm);
  }
  return foci_mm;
}

FocusScale::FocusScale(Session& session, std::function<double(double)> depthAt_mm, QWidget* parent)
    : QWidget(parent), session_(session), depthAt_mm_(std::move(depthAt_mm)) {
  setObjectName(QStringLiteral("focusScale"));
  const auto show = [this] {
    setCursor(isOn() ? Qt::SizeVerCursor : Qt::ArrowCursor);
    setToolTip(isOn() ? tipWithKeys(tr("Drag a mark to its focus depth (%1)"), "focus.shallower | focus.deeper")
                      : tipWithKeys(tr("Depth in cm; the focus is off (%1)"), "effect.FOCUS"));
  };
  connect(&session_.console(), &ScanConsole::sceneChanged, this, show);
  connect(&session_, &Session::frozenChanged, this, show);
  show();
}

void FocusScale::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !isOn()) return event->ignore();
  const double depth_mm = depthAt_mm_(y() + event->localPos().y());
  const std::vector<double> foci_mm = fociOf(session_);
  const auto nearest =
      std::min_element(foci_mm.begin(), foci_mm.end(), [&](double a, double b) { return std::abs(a - depth_mm) < std::abs(b - depth_mm); });
  // Marks and the further foci's places in the knobs go together, with unused places between them left out.
  dragged_ = 0;
  for (int left = static_cast<int>(nearest - foci_mm.begin()); left > 0; --left) {
    do ++dragged_;
    while (session_.console().knobs().moreFoci_mm[static_cast<std::size_t>(dragged_ - 1)] <= 0.0);
  }
  moveTo(event->localPos().y());
}

void FocusScale::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ < 0) return event->ignore();
  moveTo(event->localPos().y());
}

void FocusScale::mouseReleaseEvent(QMouseEvent* event) {
  if (dragged_ < 0) return event->ignore();
  dragged_ = -1;
}

void FocusScale::moveTo(double y_px) {
  constexpr double kNearest_mm = 5.0;
  const double depth_mm = std::round(std::clamp(depthAt_mm_(y() + y_px), kNearest_mm, session_.console().depth_mm()));
  Knobs knobs = session_.console().knobs();
  if (dragged_ == 0) {
    knobs.focus_mm = depth_mm;
  } else {
    knobs.moreFoci_mm[static_cast<std::size_t>(dragged_ - 1)] = depth_mm;
  }
  session_.console().setKnobs(knobs);
}

}  // namespace ew::ui
