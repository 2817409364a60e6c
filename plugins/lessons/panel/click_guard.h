#pragma once

#include <QApplication>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <vector>

namespace ew::lessons {

/// Keeps buttons from a click that was meant for the page before: they are disabled for as long as the second click of a double click may
/// take, and come back by themselves.
class ClickGuard {
 public:
  ClickGuard() {
    timer_.setSingleShot(true);
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      for (const auto& each : buttons_)
        if (each) each->setEnabled(true);
      if (focus_) focus_->setFocus();
    });
  }
  /// @param focus the one that has the focus then; may be null
  void begin(const std::vector<QPushButton*>& buttons, QPushButton* focus) {
    buttons_.assign(buttons.begin(), buttons.end());
    focus_ = focus;
    for (QPushButton* each : buttons) each->setEnabled(false);
    timer_.start(QApplication::doubleClickInterval());
  }
  [[nodiscard]] bool isActive() const { return timer_.isActive(); }

 private:
  std::vector<QPointer<QPushButton>> buttons_;
  QPointer<QPushButton> focus_;
  QTimer timer_;
};

}  // namespace ew::lessons
