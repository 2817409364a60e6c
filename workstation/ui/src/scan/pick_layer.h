#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "keys/key_map.h"

namespace ew::ui {

class ScanView;
class Session;

/// Takes clicks into the image in place of the probe, as long as somebody picks: the mouse clicks, on the keyboard the arrows move a
/// cross (Shift: far) and Enter picks, Escape ends. Lies over the image; what it does not use goes on to the scan view.
class PickLayer : public QWidget {
  Q_OBJECT

 public:
  PickLayer(Session& session, ScanView& scan);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }

  void setPicking(bool picking);
  [[nodiscard]] bool isPicking() const { return picking_; }
  /// A sentence over the image while somebody picks.
  void setHint(const QString& hint);
  /// With a radius (mm, 0: no circle) strokes are drawn: button down, held, up; Enter is a stroke of one point. Without, points are picked.
  void setStroke(std::optional<double> radius_mm);

 Q_SIGNALS:
  void pickingChanged(bool picking);
  void picked(const QPoint& pixel);  ///< of the image, device pixels
  void strokeBegun(const QPoint& pixel);
  void strokeMoved(const QPoint& pixel);
  void strokeEnded(const QPoint& pixel);
  void escaped();  ///< the user ended it

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

  [[nodiscard]] Session& session() const { return session_; }
  [[nodiscard]] ScanView& scan() const { return scan_; }
  void pick(const QPoint& pixel);
  void setCross(const QPoint& pixel) { cross_ = pixel; }
  void showOrHide();
  [[nodiscard]] QPoint pixelAt(const QPointF& at) const;
  /// Where a pixel is painted.
  [[nodiscard]] QPointF placeOf(const QPoint& pixel) const;
  static void paintCross(QPainter& painter, const QPointF& at, bool ringed);
  /// A pixel that stays marked when nobody picks; empty: none.
  [[nodiscard]] virtual std::optional<QPoint> kept() const { return std::nullopt; }
  virtual void imageMoved() {}  ///< another image is shown, or elsewhere

 private:
  void follow();

  Session& session_;
  ScanView& scan_;
  const KeyMap* keys_ = &usualKeys();
  bool picking_ = false;
  QPoint cross_;  ///< pixel under the keyboard's cross
  QString hint_;
  std::optional<double> strokeRadius_mm_;  ///< empty: points are picked
  bool isDrawing_ = false;                 ///< the button is held
};

}  // namespace ew::ui
