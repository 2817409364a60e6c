#pragma once

#include <QWidget>

#include "session.h"

namespace ew::ui {

/// The scan: the picture pixel for pixel on black, and around it what a machine shows: depth scale, marker, focus, DGC curve.
class ScanView final : public QWidget {
  Q_OBJECT

 public:
  explicit ScanView(Session& session, QWidget* parent = nullptr);

  /// Where the picture lies in the widget, in widget pixels.
  [[nodiscard]] QRect pictureRect() const;
  /// Millimetres of tissue that a widget pixel shows; what a drag of the mouse is worth.
  [[nodiscard]] double mmPerWidgetPixel() const;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void askForPicture();
  [[nodiscard]] bool isBesideVolume() const;
  void paintDepthScale(QPainter& painter);
  void paintMarker(QPainter& painter);
  void paintDgcCurve(QPainter& painter);
  void paintWords(QPainter& painter);
  /// Widget y of a depth below the middle of the probe's face.
  [[nodiscard]] double yOfDepth(double depth_mm) const;

  Session& session_;
};

}  // namespace ew::ui
