#pragma once

#include <QMessageBox>
#include <QString>

namespace ew {

/// "This is not saved": what is to become of it.
struct LeavingQuestion {
  const char* name;     ///< of the dialog, for tests
  QString what;         ///< the sentence
  QString more;         ///< what else has to be known; may be empty
  bool canSave = true;  ///< else it can only be given up
};

/// Asks with Save, Discard and Cancel. @param next what is ready to be shown in its place; may be empty
/// @return the button; Cancel when the question was closed
[[nodiscard]] QMessageBox::StandardButton askBeforeLeaving(QWidget* parent, const LeavingQuestion& question, const QString& next = {});

}  // namespace ew
