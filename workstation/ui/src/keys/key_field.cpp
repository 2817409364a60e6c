#include "keys/key_field.h"

#include <QKeyEvent>

#include "keys/key_map.h"

namespace ew::ui {

KeyField::KeyField(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setContextMenuPolicy(Qt::NoContextMenu);
}

bool KeyField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::KeyPress) return QLineEdit::event(event);
  const auto& key = *static_cast<QKeyEvent*>(event);
  event->accept();
  if (key.isAutoRepeat()) return true;
  if (key.key() == Qt::Key_Escape) {
    Q_EMIT left();
    return true;
  }
  const QKeySequence stroke(KeyMap::strokeOf(key));
  if (KeyMap::isKey(stroke)) Q_EMIT pressed(stroke);
  if (key.key() == Qt::Key_unknown || key.key() == 0) Q_EMIT nameless();
  return true;
}

}  // namespace ew::ui
