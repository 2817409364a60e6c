#pragma once

#include <QFrame>
#include <QKeySequence>
#include <QPointer>
#include <vector>

namespace ew::ui {

/// All keys and what the mouse does, over the window; any key or click closes it.
class ShortcutsOverlay final : public QFrame {
  Q_OBJECT

 public:
  struct Line {
    QString keys, what;
  };
  struct Group {
    QString title;
    std::vector<Line> lines;
  };
  ShortcutsOverlay(const std::vector<Group>& groups, QWidget* parent);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QPointer<QWidget> before_;  ///< had the focus, and gets it back
};

}  // namespace ew::ui
