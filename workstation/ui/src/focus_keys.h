#pragma once

#include <QObject>

namespace ew::ui {

/// Lets a control that was reached with the keyboard have the keys that work it: Space presses the button in place of freezing the scan,
/// Page Down moves the slider in place of the depth. Whoever clicks a control keeps the keys of the scan.
class FocusKeys final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isByKeyboard_ = false;  ///< how the widget with the focus came to have it
};

}  // namespace ew::ui
