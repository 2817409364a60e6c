#include "ew/widgets/question.h"

#include <QCoreApplication>
#include <QStringList>

namespace ew {

QMessageBox::StandardButton askBeforeLeaving(QWidget* parent, const LeavingQuestion& question, const QString& next) {
  QMessageBox box(parent);
  box.setObjectName(QLatin1String(question.name));
  box.setIcon(QMessageBox::NoIcon);
  box.setText(question.what);
  QStringList lines;
  if (!question.more.isEmpty()) lines << question.more;
  if (!next.isEmpty()) lines << QCoreApplication::translate("ew::LeavingQuestion", "'%1' is ready to be shown in its place.").arg(next);
  box.setInformativeText(lines.join(QLatin1Char('\n')));
  box.setStandardButtons(question.canSave ? QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel
                                          : QMessageBox::Discard | QMessageBox::Cancel);
  box.setDefaultButton(question.canSave ? QMessageBox::Save : QMessageBox::Cancel);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

}  // namespace ew
