#include "scan/source/source_picker.h"

#include <QMouseEvent>

#include "scan/scan_view.h"

namespace ew::ui {

SourcePicker::SourcePicker(Session& session, ScanView& scan) : PickLayer(session, scan) {
  setObjectName(QStringLiteral("sourcePicker"));
  setAccessibleName(tr("Point whose source frame is asked for"));
  setHint(tr("Click a point to see the frame it came from. Arrows and Enter do the same, Escape ends."));
  connect(this, &PickLayer::picked, this, &SourcePicker::ask);
  connect(&session, &Session::subjectChanged, this, &SourcePicker::clearMark);
}

void SourcePicker::imageMoved() {
  if (mark_ && !(markGeometry_ == session().geometry() && markPose_ == session().imagePose())) clearMark();
}

void SourcePicker::clearMark() {
  mark_.reset();
  showOrHide();
}

void SourcePicker::ask(const QPoint& pixel) {
  setCross(pixel);
  mark_ = pixel;
  markPose_ = session().imagePose();
  markGeometry_ = session().geometry();
  showOrHide();
  Q_EMIT asked(pixel);
}

bool SourcePicker::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress && session().subject()) {
    const auto& mouse = *static_cast<QMouseEvent*>(event);
    const QRect box = scan().imageRect();
    if (mouse.button() == Qt::LeftButton && mouse.modifiers() == Qt::AltModifier && box.contains(mouse.pos())) {
      ask(pixelAt(mouse.localPos() - box.topLeft()));
      return true;
    }
  }
  return PickLayer::eventFilter(watched, event);
}

}  // namespace ew::ui
