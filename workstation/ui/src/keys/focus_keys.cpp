#include "keys/focus_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QPointer>
#include <QScrollArea>
#include <QTabBar>

#include "ew/widgets/focus_ring.h"

namespace ew::ui {
namespace {

bool isReturn(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }
bool isPlainKey(const QKeyEvent& key) { return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier; }

/// Whether the key works the control.
bool worksWith(const QObject& control, int key) {
  const bool isList = qobject_cast<const QAbstractItemView*>(&control) != nullptr;
  const bool isChoice = qobject_cast<const QComboBox*>(&control) != nullptr;
  const bool isMoved = qobject_cast<const QAbstractSlider*>(&control) != nullptr || qobject_cast<const QScrollArea*>(&control) != nullptr;
  if (key == Qt::Key_Space) return isList || isChoice || qobject_cast<const QAbstractButton*>(&control) != nullptr;
  const bool isFar = key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Home || key == Qt::Key_End;
  return isFar && (isList || isChoice || isMoved || qobject_cast<const QTabBar*>(&control) != nullptr);
}

/// Whether what is typed is meant for it, however it came to have the focus.
bool isTypedInto(const QWidget& widget) {
  return widget.testAttribute(Qt::WA_InputMethodEnabled) || qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QAbstractItemView*>(&widget) != nullptr ||
         qobject_cast<const QMenuBar*>(&widget) != nullptr;
}

}  // namespace

bool FocusKeys::overrides(const QObject& watched, const QKeyEvent& key) const {
  if (!isPlainKey(key)) return false;
  if (way_ == Way::byTab && worksWith(watched, key.key())) return true;
  const bool isPressed = key.key() == Qt::Key_Space || isReturn(key.key());
  return way_ != Way::byMouse && isPressed && qobject_cast<const QAbstractButton*>(&watched) != nullptr;
}

bool FocusKeys::press(QWidget& watched, QKeyEvent& key) {
  auto* button = qobject_cast<QAbstractButton*>(&watched);
  // In a dialog Return has its own meaning: the button that is marked there.
  if (button != nullptr && way_ != Way::byMouse && isPlainKey(key) && isReturn(key.key()) &&
      qobject_cast<QDialog*>(watched.window()) == nullptr) {
    if (!key.isAutoRepeat()) button->click();
    return true;
  }
  return way_ != Way::byTab && watched.hasFocus() && !isTypedInto(watched) && isBesideScan(watched) && doInScan(key);
}

/// A clicked button that vanishes, at once or when the session answers, hands the focus to its neighbour as Tab would.
bool FocusKeys::wasHandedOn(const QWidget& widget, Qt::FocusReason reason) const {
  return isLastInputMouse_ && (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason) && isBesideScan(widget);
}

/// After the event that is being delivered.
void FocusKeys::backToScanFrom(QWidget& widget) {
  QMetaObject::invokeMethod(
      this,
      [this, left = QPointer<QWidget>(&widget)] {
        if (left != nullptr && left->hasFocus()) backToScan();
      },
      Qt::QueuedConnection);
}

bool FocusKeys::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return QObject::eventFilter(watched, event);
  auto& widget = *static_cast<QWidget*>(watched);
  switch (event->type()) {
    case QEvent::FocusIn: {
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      if (wasHandedOn(widget, reason)) {
        way_ = Way::byMouse;
        backToScanFrom(widget);
        break;
      }
      // Another window, or a menu, may have had the keys for a while.
      if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason && reason != Qt::MenuBarFocusReason)
        way_ = isReachedByKeys(reason) ? Way::byTab : reason == Qt::MouseFocusReason ? Way::byMouse : Way::byProgram;
      break;
    }
    case QEvent::MouseButtonPress:
      isLastInputMouse_ = true;
      break;
    case QEvent::MouseButtonRelease:
      if (way_ == Way::byMouse && widget.hasFocus() && qobject_cast<QAbstractButton*>(watched) != nullptr && isBesideScan(widget))
        backToScanFrom(widget);
      break;
    case QEvent::ShortcutOverride:
      if (overrides(*watched, *static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
      }
      break;
    case QEvent::KeyPress:
      isLastInputMouse_ = false;
      if (press(widget, *static_cast<QKeyEvent*>(event))) return true;
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace ew::ui
