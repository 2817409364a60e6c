#pragma once

#include <QWidget>
#include <optional>

#include "key_map.h"
#include "session.h"

namespace ew::ui {

class ScanView;

/// Asks where a point of the picture came from. Alt + click asks at once; while asking is on, every click does, and on the keyboard the
/// arrows move a cross (Shift: far) and Enter asks. The point that was asked for stays marked while the picture shows the same plane.
/// Lies over the picture; what it does not use goes on to the scan view.
class SourcePicker final : public QWidget {
  Q_OBJECT

 public:
  SourcePicker(Session& session, ScanView& scan);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }

  void setAsking(bool asking);
  [[nodiscard]] bool isAsking() const { return asking_; }
  /// The marked pixel of the picture; empty when there is none.
  [[nodiscard]] const std::optional<QPoint>& mark() const { return mark_; }
  void clearMark();

 Q_SIGNALS:
  void askingChanged(bool asking);
  void asked(const QPoint& pixel);  ///< of the picture, device pixels

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow();
  void showOrHide();
  void ask(const QPoint& pixel);
  [[nodiscard]] QPoint pixelAt(const QPointF& at) const;
  [[nodiscard]] QPointF placeOf(const QPoint& pixel) const;

  Session& session_;
  ScanView& scan_;
  const KeyMap* keys_ = &usualKeys();
  bool asking_ = false;
  QPoint cross_;  ///< pixel under the keyboard's cross
  std::optional<QPoint> mark_;
  Pose markPose_;
  DisplayGeometry markGeometry_;
};

}  // namespace ew::ui
