#include "scan/zoom/scan_pan.h"

#include <QMouseEvent>

#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {

ScanPan::ScanPan(Session& session, ScanView& view)
    : QObject(&view), session_(session), view_(view), gate_(session, view), box_(session, view) {
  view_.installEventFilter(this);
  connect(&session_, &Session::imageChanged, this, &ScanPan::showCursor);
  connect(&session_, &Session::frozenChanged, this, &ScanPan::showCursor);
  connect(&session_, &Session::subjectReplaced, this, [this] {
    gate_.end();
    box_.end();
  });
  showCursor();
}

bool ScanPan::pans() const { return session_.subject() && !session_.isPlaying() && session_.imageKnobs().zoom > 1.0; }

void ScanPan::showCursor() {
  if (panning_) return;
  const auto ofGate = gate_.cursor(), ofBox = box_.cursor();
  const Qt::CursorShape shape = !session_.subject()   ? Qt::ArrowCursor
                                : ofGate              ? *ofGate
                                : ofBox               ? *ofBox
                                : pans()              ? Qt::OpenHandCursor
                                : session_.isFrozen() ? Qt::ArrowCursor
                                                      : Qt::SizeAllCursor;
  if (view_.cursor().shape() != Qt::CrossCursor && view_.cursor().shape() != shape) view_.setCursor(shape);
}

bool ScanPan::isForWhatLiesThere(const QEvent& event) {
  if (!box_.isDragging() && gate_.handle(event)) return true;
  return !gate_.cursor() && box_.handle(event);
}

bool ScanPan::eventFilter(QObject* watched, QEvent* event) {
  if (!panning_ && isForWhatLiesThere(*event)) {
    showCursor();
    return true;
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      if (mouse.button() != Qt::LeftButton || !pans()) break;
      panning_ = true;
      last_ = mouse.localPos();
      view_.setCursor(Qt::ClosedHandCursor);
      return true;
    }
    case QEvent::MouseMove: {
      if (!panning_) {
        showCursor();
        break;
      }
      const QPointF by = static_cast<QMouseEvent*>(event)->localPos() - last_;
      last_ = static_cast<QMouseEvent*>(event)->localPos();
      const DisplayGeometry& geometry = session_.geometry();
      const double perPixel_mm = view_.mmPerWidgetPixel();
      Detail detail = session_.console().detail();
      Pan& pan = detail.pan;
      pan.lateral_mm += (geometry.markerLeft ? 1.0 : -1.0) * perPixel_mm * by.x();
      pan.axial_mm += (geometry.upsideDown ? 1.0 : -1.0) * perPixel_mm * by.y();
      if (session_.wide() == nullptr) pan = panWithinFan(session_.imageProbe(), session_.imageKnobs(), pan);
      session_.console().setDetail(detail.zoom, pan);
      return true;
    }
    case QEvent::MouseButtonRelease:
      if (!panning_) break;
      panning_ = false;
      showCursor();
      return true;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace ew::ui
