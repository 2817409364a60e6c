#pragma once

#include <QObject>
#include <QPointF>

#include "scan/doppler/colour_box_drag.h"
#include "scan/doppler/gate_drag.h"

namespace ew::ui {

class ScanView;
class Session;

/// What a drag in the scan does: at the sample volume or the colour box it is theirs, in a zoomed image it moves the detail that is shown,
/// otherwise the hand takes it and slides the probe. The pointer shows which of them it will be. Made after the hand, so that it sees the
/// mouse first.
class ScanPan final : public QObject {
  Q_OBJECT

 public:
  ScanPan(Session& session, ScanView& view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showCursor();
  [[nodiscard]] bool isForWhatLiesThere(const QEvent& event);
  [[nodiscard]] bool pans() const;
  Session& session_;
  ScanView& view_;
  GateDrag gate_;  ///< lies on the box
  ColourBoxDrag box_;
  bool panning_ = false;
  QPointF last_;
};

}  // namespace ew::ui
