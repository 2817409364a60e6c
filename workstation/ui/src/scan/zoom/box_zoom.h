#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

namespace ew::ui {

class ScanView;
class Session;

/// Over the image while a box is drawn, which then fills the image. A live image is formed anew with all its pixels in the box, a
/// frozen one from the echoes it has.
class BoxZoom final : public QWidget {
  Q_OBJECT

 public:
  BoxZoom(Session& session, ScanView& scan);

  /// Waits for a box, or no longer. @return whether it does now
  bool toggle();
  [[nodiscard]] bool isDrawing() const { return !isHidden(); }

 Q_SIGNALS:
  void changed();
  void said(const QString& sentence);

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void end();
  void zoomTo(const QRectF& box);
  Session& session_;
  ScanView& scan_;
  std::optional<QPointF> from_;
  QPointF to_;
};

}  // namespace ew::ui
