#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "ew/measurement/snap_target.h"
#include "keys/key_map.h"
#include "measure/calipers/calipers.h"

namespace ew::ui {

class ScanView;
class Session;

/// The calipers on the scan or on the strip of the M-mode: lies over it while a tool is at hand or something is measured. The mouse clicks,
/// draws and drags; on the keyboard arrows move a cross (Shift: far, Ctrl: a pixel), Enter sets a point, takes a handle and puts it down,
/// and ends what has any number of points; Backspace takes back, Escape puts down. What it does not use goes on to the scan view. Where
/// points are drawn to something nearby, a mark and a word say so before the click; Ctrl does for once what is not set.
class CaliperLayer final : public QWidget {
  Q_OBJECT

 public:
  CaliperLayer(Session& session, Calipers& calipers, ScanView& scan, Where where = Where::image);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }
  /// Where a point is painted: in the middle of its pixel. Of a strip, one that has left lies beyond its left border.
  [[nodiscard]] QPointF placeOf(const glm::dvec2& at) const;
  /// What the next click is drawn to; of kind none: nothing.
  [[nodiscard]] const measurement::SnapTarget& snap() const { return snap_; }

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
  void leaveEvent(QEvent* event) override;

 private:
  void follow();
  void showOrHide();
  void showCursor(const QPointF& at);
  [[nodiscard]] QRect place() const;
  [[nodiscard]] bool isWanted() const;
  [[nodiscard]] std::optional<glm::dvec2> pointAt(const QPointF& at) const;
  /// The point that a click there means.
  std::optional<glm::dvec2> meantAt(const QPointF& at, Qt::KeyboardModifiers modifiers);
  bool prepareTool();
  [[nodiscard]] QRect roomOfResults() const;
  void keepResultsClear();  ///< of the body mark
  void paintSnap(QPainter& painter);
  void paintHint(QPainter& painter);
  [[nodiscard]] double reach_mm() const;
  void moveCross(QPointF by, Qt::KeyboardModifiers modifiers);
  void enter();

  Session& session_;
  Calipers& calipers_;
  ScanView& scan_;
  Where where_;
  measurement::SnapTarget snap_;
  const KeyMap* keys_ = &usualKeys();
  std::optional<QPointF> cross_;  ///< the keyboard's; empty: the mouse was used last
  std::optional<measurement::CaliperKind> tool_;
};

}  // namespace ew::ui
