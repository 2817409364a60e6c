#pragma once

#include <QWidget>

#include "session.h"

namespace ew::ui {

class DgcColumn;
class FocusScale;

/// The scan: the picture pixel for pixel on black, and around it what a machine shows: depth scale, marker, focus marks, DGC sliders at
/// their depths, and in M-mode the strip of one beam over time, below the picture or instead of it.
class ScanView final : public QWidget {
  Q_OBJECT

 public:
  explicit ScanView(Session& session, QWidget* parent = nullptr);

  /// Where the picture lies in the widget, in widget pixels. In M-mode alone nothing is drawn there but the strip.
  [[nodiscard]] QRect pictureRect() const;
  /// Where the M-mode strip lies; empty in B-mode.
  [[nodiscard]] QRect stripRect() const;
  /// Millimetres of tissue that a widget pixel shows; what a drag of the mouse is worth.
  [[nodiscard]] double mmPerWidgetPixel() const;
  /// Widget y of a depth below the middle of the probe's face, on the picture or, in M-mode alone, on the strip.
  [[nodiscard]] double yOfDepth(double depth_mm) const;
  [[nodiscard]] double depthAt_mm(double y) const;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 320}; }
  void refreshIcons();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void arrange();
  [[nodiscard]] DisplayMode mode() const { return session_.pictureKnobs().mode; }
  [[nodiscard]] bool isBesideVolume() const;
  void paintDepthScale(QPainter& painter);
  void paintFoci(QPainter& painter);
  void paintMarker(QPainter& painter);
  void paintMLine(QPainter& painter);
  void paintStrip(QPainter& painter);
  void paintWords(QPainter& painter);

  Session& session_;
  DgcColumn* dgc_ = nullptr;
  FocusScale* scale_ = nullptr;
};

}  // namespace ew::ui
