#include "ew/widgets/small_result_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace ew {

bool askAcceptsSmall(QWidget* parent, const QString& sentence) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("smallResultQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(sentence);
  QPushButton* const accept =
      question.addButton(QCoreApplication::translate("ew::SmallResult", "Make it all the same"), QMessageBox::AcceptRole);
  accept->setObjectName(QStringLiteral("acceptSmall"));
  question.setDefaultButton(question.addButton(QCoreApplication::translate("ew::SmallResult", "Back"), QMessageBox::RejectRole));
  question.exec();
  return question.clickedButton() == accept;
}

}  // namespace ew
