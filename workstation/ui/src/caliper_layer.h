#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "calipers.h"
#include "key_map.h"

namespace ew::ui {

class ScanView;
class Session;

/// The calipers on the scan: lies over the image while a tool is at hand or something is measured. The mouse clicks, draws and drags; on
/// the keyboard arrows move a cross (Shift: far, Ctrl: a pixel), Enter sets a point, takes a handle and puts it down, and ends what has any
/// number of points; Backspace takes back, Escape puts down. What it does not use goes on to the scan view.
class CaliperLayer final : public QWidget {
  Q_OBJECT

 public:
  CaliperLayer(Session& session, Calipers& calipers, ScanView& scan);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }
  /// Where a point of the picture's plane is painted: in the middle of its pixel.
  [[nodiscard]] QPointF placeOf(const glm::dvec2& at_mm) const;

 Q_SIGNALS:
  void focusChanged();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void follow();
  void showOrHide();
  void showCursor(const QPointF& at);
  [[nodiscard]] glm::dvec2 pointAt(const QPointF& at) const;
  [[nodiscard]] double reach_mm() const;
  void moveCross(QPointF by);
  void enter();

  Session& session_;
  Calipers& calipers_;
  ScanView& scan_;
  const KeyMap* keys_ = &usualKeys();
  std::optional<QPointF> cross_;  ///< the keyboard's; empty: the mouse was used last
  std::optional<measurement::CaliperKind> tool_;
};

}  // namespace ew::ui
