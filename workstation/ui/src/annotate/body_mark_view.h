#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "annotate/image_body_mark.h"

namespace ew::ui {

class ScanView;

/// The body mark in a corner of the scan, beside the fan: in the corner that was chosen as long as the fan leaves it free, otherwise in one
/// that is, smaller where there is little black. Dragged, it goes to the corner that is nearest; on an image that stands still the probe
/// on it is dragged and, with the wheel, turned. A double click lets it follow the probe again.
class BodyMarkView final : public QWidget {
  Q_OBJECT

 public:
  BodyMarkView(ImageBodyMark& mark, ScanView& scan);
  /// That was chosen: 0 upper left, 1 upper right, 2 lower left, 3 lower right.
  [[nodiscard]] int corner() const { return corner_; }
  void setCorner(int corner);  ///< kept for the next start
  void placeIn(int corner);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void showOrHide();
  void followScan();  ///< shown where there is black, in its corner
  void arrange();
  [[nodiscard]] bool isOnGlyph(const QPointF& at) const;

  ImageBodyMark& mark_;
  ScanView& scan_;
  int corner_ = 2;
  bool movesGlyph_ = false;
  std::optional<QPoint> movedFrom_;  ///< where the pointer holds the whole mark
};

}  // namespace ew::ui
