#pragma once

#include <QFrame>
#include <QKeySequence>
#include <QPointer>
#include <vector>

#include "keys/probe_motion.h"

class QScrollArea;

namespace ew::ui {

/// Keys and what the mouse does, over the window. Where the window is too small for all of it the page scrolls; Escape, its button, a click
/// beside it or any key that does not scroll closes it.
class ShortcutsOverlay final : public QFrame {
  Q_OBJECT

 public:
  struct Line {
    QString keys, what;
    ProbeMotion motion = ProbeMotion::none;  ///< drawn beside the line
  };
  struct Group {
    QString title;
    std::vector<Line> lines;
  };
  ShortcutsOverlay(const std::vector<Group>& groups, QWidget* parent);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QScrollArea* scroll_ = nullptr;
  QPointer<QWidget> before_;  ///< had the focus, and gets it back
};

}  // namespace ew::ui
