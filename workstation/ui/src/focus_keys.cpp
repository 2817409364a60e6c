#include "focus_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QScrollArea>
#include <QTabBar>

#include "focus_ring.h"

namespace ew::ui {
namespace {

/// Whether the key works the control.
bool worksWith(const QObject* control, int key) {
  const bool isList = qobject_cast<const QAbstractItemView*>(control) != nullptr;
  const bool isChoice = qobject_cast<const QComboBox*>(control) != nullptr;
  const bool isMoved = qobject_cast<const QAbstractSlider*>(control) != nullptr || qobject_cast<const QScrollArea*>(control) != nullptr;
  if (key == Qt::Key_Space) return isList || isChoice || qobject_cast<const QAbstractButton*>(control) != nullptr;
  const bool isFar = key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Home || key == Qt::Key_End;
  return isFar && (isList || isChoice || isMoved || qobject_cast<const QTabBar*>(control) != nullptr);
}

}  // namespace

bool FocusKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn && watched->isWidgetType())
    isByKeyboard_ = isReachedByKeys(static_cast<QFocusEvent*>(event)->reason());
  if (event->type() == QEvent::ShortcutOverride && isByKeyboard_) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if ((key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier && worksWith(watched, key->key())) {
      event->accept();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace ew::ui
