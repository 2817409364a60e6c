#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace ew::ui {

/// A field that takes the next key that is pressed, whatever it is. Escape leaves it.
class KeyField final : public QLineEdit {
  Q_OBJECT

 public:
  explicit KeyField(QWidget* parent = nullptr);

 Q_SIGNALS:
  void pressed(const QKeySequence& key);
  void nameless();  ///< a key that the system does not name
  void left();      ///< by Escape

 protected:
  bool event(QEvent* event) override;
};

}  // namespace ew::ui
