#pragma once

#include <optional>

#include "scan/pick_layer.h"
#include "scan/session.h"

namespace ew::ui {

/// Asks where a point of the image came from: whatever is picked, and Alt + click at any time. The point that was asked for stays marked
/// while the image shows the same plane.
class SourcePicker final : public PickLayer {
  Q_OBJECT

 public:
  SourcePicker(Session& session, ScanView& scan);

  /// The marked pixel of the image; empty when there is none.
  [[nodiscard]] const std::optional<QPoint>& mark() const { return mark_; }
  void clearMark();

 Q_SIGNALS:
  void asked(const QPoint& pixel);  ///< of the image, device pixels

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  [[nodiscard]] std::optional<QPoint> kept() const override { return mark_; }
  void imageMoved() override;

 private:
  void ask(const QPoint& pixel);

  std::optional<QPoint> mark_;
  Pose markPose_;
  DisplayGeometry markGeometry_;
};

}  // namespace ew::ui
