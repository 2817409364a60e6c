#include "case/case_folder_dialog.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "ew/library/case.h"
#include "ew/library/published.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {

namespace fs = std::filesystem;

fs::path CaseFolderDialog::library() {
  const QString chosen = QSettings().value(QStringLiteral("ownCases")).toString();
  return chosen.isEmpty() ? ownCasesFolder() : pathOf(chosen);
}

CaseFolderDialog::CaseFolderDialog(const QString& why, const QString& name, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("caseFolderDialog"));
  setWindowTitle(tr("Save the case as a folder of its own"));
  setMinimumWidth(600);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(24, 24, 24, 24);
  rows->setSpacing(16);
  if (!why.isEmpty()) {
    auto* reason = new QLabel(why);
    reason->setWordWrap(true);
    rows->addWidget(reason);
  }
  library_ = new QLineEdit(wordsOf(library()));
  library_->setObjectName(QStringLiteral("caseLibrary"));
  auto* choose = new QPushButton(tr("Choose…"));
  choose->setAutoDefault(false);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of your own cases"), library_->text());
    if (!folder.isEmpty()) library_->setText(folder);
  });
  QString free = name;
  for (int number = 2; isTaken(pathOf(library_->text()) / free.toStdString()); ++number)
    free = name + QLatin1Char('-') + QString::number(number);
  name_ = new QLineEdit(free);
  name_->setObjectName(QStringLiteral("caseFolderName"));
  auto* place = new QHBoxLayout;
  place->setSpacing(8);
  place->addWidget(library_, 1);
  place->addWidget(choose);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->addRow(tr("Folder of your own cases"), place);
  form->addRow(tr("Name of the new folder"), name_);
  rows->addLayout(form);
  result_ = new QLabel;
  result_->setObjectName(QStringLiteral("caseFolderResult"));
  result_->setWordWrap(true);
  rows->addWidget(result_);
  rows->addStretch(1);
  save_ = new QPushButton(tr("Save"));
  save_->setObjectName(QStringLiteral("saveCaseFolder"));
  setLook(save_, Look::primary);
  save_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch(1);
  buttons->addWidget(cancel);
  buttons->addWidget(save_);
  rows->addLayout(buttons);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &QDialog::accept);
  for (QLineEdit* field : {library_, name_}) connect(field, &QLineEdit::textChanged, this, &CaseFolderDialog::look);
  name_->setFocus();
  name_->selectAll();
  look();
}

fs::path CaseFolderDialog::folder() const { return pathOf(library_->text().trimmed()) / pathOf(name_->text().trimmed()); }

void CaseFolderDialog::look() {
  const QString name = name_->text().trimmed();
  QString problem;
  if (library_->text().trimmed().isEmpty() || pathOf(library_->text().trimmed()).is_relative()) {
    problem = tr("Choose the folder of your own cases.");
  } else if (name.isEmpty() || name.contains(QLatin1Char('/')) || name.startsWith(QLatin1Char('.'))) {
    problem = tr("Type a name for the new folder, without '/' and not beginning with '.'.");
  } else if (isPublished(folder())) {
    problem = tr("Cases in this folder are published and stay as they are; choose the folder of your own cases.");
  } else if (isShipped(folder())) {
    problem = tr("This folder belongs to the program, and the next version replaces it; choose one of your own.");
  } else if (isTaken(folder())) {
    problem = tr("'%1' is there already, and nothing in it is replaced; type another name.").arg(name);
  }
  save_->setEnabled(problem.isEmpty());
  result_->setStyleSheet(QStringLiteral("color: %1;").arg((problem.isEmpty() ? currentTheme().quiet : currentTheme().danger).name()));
  result_->setText(problem.isEmpty() ? tr("The case will be saved in %1.").arg(wordsOf(folder())) : problem);
}

void CaseFolderDialog::done(int result) {
  if (result == QDialog::Accepted) QSettings().setValue(QStringLiteral("ownCases"), library_->text().trimmed());
  QDialog::done(result);
}

}  // namespace ew::ui
