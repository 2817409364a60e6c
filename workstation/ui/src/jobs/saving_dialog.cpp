#include "jobs/saving_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/look.h"
#include "jobs/jobs.h"

namespace ew::ui {

SavingDialog::SavingDialog(Jobs& jobs, bool closes, QWidget* parent) : QDialog(parent), jobs_(jobs) {
  setObjectName(QStringLiteral("savingDialog"));
  setWindowTitle(tr("Saving"));
  setMinimumWidth(480);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(24, 24, 24, 24);
  rows->setSpacing(16);
  auto* heading = new QLabel(tr("Not everything is saved yet"));
  setLook(heading, Look::heading);
  what_ = new QLabel;
  what_->setObjectName(QStringLiteral("savingWhat"));
  what_->setWordWrap(true);
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  auto* hint = new QLabel(closes ? tr("The window closes as soon as it is. Closing now loses it.") : tr("It goes on as soon as it is."));
  setLook(hint, Look::quiet);
  hint->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch(1);
  if (closes) {
    auto* lose = new QPushButton(tr("Close and lose it"));
    lose->setObjectName(QStringLiteral("closeAndLose"));
    lose->setAutoDefault(false);
    connect(lose, &QPushButton::clicked, this, [this] {
      outcome_ = Outcome::lose;
      accept();
    });
    buttons->addWidget(lose);
  }
  auto* stay = new QPushButton(closes ? tr("Do not close") : tr("Cancel"));
  stay->setObjectName(QStringLiteral("stay"));
  stay->setDefault(true);
  connect(stay, &QPushButton::clicked, this, &QDialog::reject);
  buttons->addWidget(stay);
  for (QWidget* row : std::initializer_list<QWidget*>{heading, what_, bar_, hint}) rows->addWidget(row);
  rows->addLayout(buttons);
  connect(&jobs_, &Jobs::notSaved, this, [this] {
    outcome_ = Outcome::notSaved;  // what is wrong stands in the window, which stays for it
    accept();
  });
  connect(&poll_, &QTimer::timeout, this, &SavingDialog::look);
  connect(this, &QDialog::finished, &poll_, &QTimer::stop);  // what is decided stays decided; the timer may already be due
}

SavingDialog::Outcome SavingDialog::wait() {
  if (!jobs_.isSaving()) return Outcome::saved;
  look();
  poll_.start(50);
  exec();
  return outcome_;
}

void SavingDialog::look() {
  QStringList titles;
  double fraction = 0.0;
  for (const Jobs::Seen& job : jobs_.seen()) {
    if (job.kind != Jobs::Kind::saving) continue;
    titles << job.title;
    fraction += job.fraction;
  }
  if (titles.isEmpty()) {
    outcome_ = Outcome::saved;
    accept();
    return;
  }
  what_->setText(titles.join(QLatin1Char('\n')));
  bar_->setValue(static_cast<int>(1000.0 * fraction / titles.size()));
}

}  // namespace ew::ui
