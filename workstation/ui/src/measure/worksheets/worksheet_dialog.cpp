#include "measure/worksheets/worksheet_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "measure/words/caliper_words.h"
#include "measure/words/worksheet_words.h"
#include "measure/worksheets/worksheets.h"

namespace ew::ui {

using measurement::Examination;
using measurement::ItemMeasure;
using measurement::Package;
using measurement::PackageItem;

WorksheetDialog::WorksheetDialog(Worksheets& worksheets, QWidget* parent) : QDialog(parent), worksheets_(worksheets) {
  setObjectName(QStringLiteral("worksheetDialog"));
  setWindowTitle(tr("Worksheet"));
  resize(560, 640);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 16, 16, 16);
  rows->setSpacing(8);
  heading_ = new QLabel;
  setLook(heading_, Look::heading);
  rows->addWidget(heading_);
  questions_ = new QWidget;
  rows->addWidget(questions_);
  sheet_ = new QTextBrowser;
  sheet_->setObjectName(QStringLiteral("worksheetText"));
  sheet_->setAccessibleName(tr("Worksheet"));
  sheet_->setOpenLinks(false);
  rows->addWidget(sheet_, 1);
  auto* caution = new QLabel(tr("Simulation, training only: not for diagnosis."));
  setLook(caution, Look::small);
  setLook(caution, Look::quiet);
  rows->addWidget(caution);
  auto* buttons = new QHBoxLayout;
  remove_ = new QPushButton(tr("Remove a value"));
  remove_->setObjectName(QStringLiteral("removeValue"));
  values_ = new QMenu(remove_);
  remove_->setMenu(values_);
  save_ = new QPushButton(tr("Save…"));
  save_->setObjectName(QStringLiteral("saveWorksheet"));
  save_->setToolTip(tr("As PDF to print, as CSV for tables, as JSON for programs"));
  auto* close = new QPushButton(tr("Close"));
  buttons->addWidget(remove_);
  buttons->addStretch(1);
  buttons->addWidget(save_);
  buttons->addWidget(close);
  rows->addLayout(buttons);
  connect(save_, &QPushButton::clicked, this, &WorksheetDialog::saveAsked);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(&worksheets_, &Worksheets::changed, this, &WorksheetDialog::showAll);
  showAll();
}

/// Made anew for another package.
void WorksheetDialog::build() {
  const Package& package = worksheets_.current()->package();
  shownPackage_ = &package;
  heading_->setText(words(package.title));
  auto* fresh = new QWidget;
  layout()->replaceWidget(questions_, fresh);
  questions_->hide();
  questions_->deleteLater();
  questions_ = fresh;
  asked_.clear();
  gestation_ = nullptr;
  auto* form = new QFormLayout(questions_);
  form->setContentsMargins(0, 0, 0, 0);
  if (!package.charts.empty() || package.redating) {
    gestation_ = new QLineEdit;
    gestation_->setObjectName(QStringLiteral("gestation"));
    gestation_->setPlaceholderText(tr("32w1d"));
    gestation_->setToolTip(tr("Weeks and days since the last period: 32w1d. Charts and redating need it."));
    gestationProblem_ = new QLabel;
    gestationProblem_->setObjectName(QStringLiteral("gestationProblem"));
    setLook(gestationProblem_, Look::small);
    gestationProblem_->setWordWrap(true);
    gestationProblem_->hide();
    form->addRow(tr("Gestational age by dates"), gestation_);
    form->addRow(gestationProblem_);
    connect(gestation_, &QLineEdit::textEdited, this, &WorksheetDialog::takeGestation);
  }
  for (const PackageItem& item : package.items) {
    if (item.measure != ItemMeasure::choice) continue;
    for (const char* side : item.isSided ? std::vector<const char*>{"right", "left"} : std::vector<const char*>{""}) {
      auto* answer = new QComboBox;
      answer->setObjectName(QStringLiteral("worksheetAnswer"));
      answer->addItem(tr("not answered"), QString());
      for (const auto& [word, title] : item.choices) answer->addItem(words(title), QString::fromStdString(word));
      const QString title = words(item.title);
      const QString named = *side == 0 ? title : tr("%1, %2", "an item and its side").arg(title, WorksheetWords::sideOf(side));
      answer->setAccessibleName(named);
      answer->setToolTip(words(item.convention));
      form->addRow(named, answer);
      connect(answer, qOverload<int>(&QComboBox::activated), this, [this, answer, label = item.label, of = std::string(side)] {
        worksheets_.change(
            [&](Examination& examination) { examination.answer(label, of, answer->currentData().toString().toStdString()); });
      });
      asked_.push_back({item.label, side, answer});
    }
  }
  questions_->setVisible(form->rowCount() > 0);
}

void WorksheetDialog::takeGestation() {
  const QString text = gestation_->text().trimmed();
  const auto weeks = text.isEmpty() ? std::nullopt : measurement::gestationOf(text.toStdString());
  const bool isRight = text.isEmpty() || weeks;
  gestationProblem_->setText(isRight ? QString() : tr("Write weeks and days, as 32w1d, from 0w to 45w."));
  gestationProblem_->setVisible(!isRight);
  worksheets_.change([&](Examination& examination) { examination.setGestation(weeks); });
}

void WorksheetDialog::showAll() {
  const Examination* examination = worksheets_.current();
  if (examination == nullptr) {
    shownPackage_ = nullptr;
    close();
    return;
  }
  if (shownPackage_ != &examination->package()) build();
  // What says the same stays as it is typed, and so does what is not yet an age.
  if (gestation_ != nullptr && measurement::gestationOf(gestation_->text().trimmed().toStdString()) != examination->gestation_weeks()) {
    const auto weeks = examination->gestation_weeks();
    gestation_->setText(weeks ? QString::fromStdString(measurement::gestationText(*weeks)) : QString());
    gestationProblem_->hide();
  }
  for (const Question& question : asked_) {
    int index = 0;
    for (const Examination::Answer& answer : examination->answers())
      if (answer.label == question.item && answer.side == question.side)
        index = question.answer->findData(QString::fromStdString(answer.choice));
    question.answer->setCurrentIndex(index);
  }
  const measurement::Worksheet sheet = examination->worksheet();
  const int scrolled = sheet_->verticalScrollBar()->value();
  sheet_->setHtml(sheet.sections.empty()
                      ? QStringLiteral("<p style='color:%1'>%2</p>")
                            .arg(currentTheme().quiet.name(),
                                 tr("Nothing is entered yet. Choose an item on the page of measurements and measure it in the image."))
                      : WorksheetWords::htmlOf(sheet, currentTheme().quiet.name()));
  sheet_->verticalScrollBar()->setValue(scrolled);
  values_->clear();
  for (const Examination::Found& found : examination->found()) {
    const PackageItem* item = examination->package().item(found.entry.label);
    const QString side = WorksheetWords::sideOf(found.entry.side), title = words(item->title);
    const QString value = CaliperWords::textOf(converted(found.entry.quantity, item->unit));
    values_->addAction(side.isEmpty() ? tr("%1: %2", "an item and its value").arg(title, value)
                                      : tr("%1, %2: %3", "an item, its side and its value").arg(title, side, value),
                       this, [this, image = found.image, number = found.number] {
                         worksheets_.change([&](Examination& each) { each.remove(image, number); });
                       });
  }
  remove_->setEnabled(!examination->found().empty());
  save_->setEnabled(!examination->isEmpty());
}

}  // namespace ew::ui
