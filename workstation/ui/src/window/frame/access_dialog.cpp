#include "window/frame/access_dialog.h"

#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kAccessWidth_px = 440;

}  // namespace

AccessDialog::AccessDialog(Asks asks, const QString& heading, const QString& sentence, std::function<Result<void>(const Passphrase&)> take,
                           QWidget* parent)
    : FormDialog(heading, sentence, parent), take_(std::move(take)) {
  setObjectName(QStringLiteral("accessDialog"));
  setWindowTitle(heading);
  say(sentence, false);
  fields_ = new QGridLayout;
  fields_->setColumnStretch(1, 1);
  rows().addLayout(fields_);
  words_ = addField(tr("Passphrase"), QStringLiteral("passphrase"));
  if (asks == Asks::fresh) again_ = addField(tr("Once more"), QStringLiteral("passphraseAgain"));
  rows().addStretch(1);
  setMinimumWidth(scaled(kAccessWidth_px));
  words_->setFocus();
  auto* cancel = new QPushButton(tr("Cancel"));
  accept_ = new QPushButton(asks == Asks::fresh ? tr("Lock") : tr("Unlock"));
  accept_->setObjectName(QStringLiteral("accept"));
  setLook(accept_, Look::primary);
  accept_->setDefault(true);
  buttons().addWidget(cancel);
  buttons().addWidget(accept_);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(accept_, &QPushButton::clicked, this, &AccessDialog::tryIt);
  refresh();
}

AccessDialog::~AccessDialog() {
  for (QLineEdit* field : {words_, again_})
    if (field != nullptr) field->setText(QString(field->text().size(), QLatin1Char('x')));
}

QLineEdit* AccessDialog::addField(const QString& label, const QString& name) {
  auto* field = new QLineEdit;
  field->setObjectName(name);
  field->setAccessibleName(label);
  field->setEchoMode(QLineEdit::Password);
  auto* title = new QLabel(label);
  title->setBuddy(field);
  const int row = fields_->rowCount();
  fields_->addWidget(title, row, 0);
  fields_->addWidget(field, row, 1);  // below each other, as wide as each other
  connect(field, &QLineEdit::textChanged, this, &AccessDialog::refresh);
  return field;
}

void AccessDialog::refresh() { accept_->setEnabled(!words_->text().isEmpty() && (again_ == nullptr || !again_->text().isEmpty())); }

void AccessDialog::tryIt() {
  if (again_ != nullptr && again_->text() != words_->text()) return say(tr("The two passphrases differ; type them again."), true);
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);  // a passphrase is slow to try on purpose
  const auto taken = take_(Passphrase(words_->text().toStdString()));
  QGuiApplication::restoreOverrideCursor();
  if (taken) return accept();
  say(words(taken.error().message), true);
  words_->clear();
  if (again_ != nullptr) again_->clear();
  words_->setFocus();
}

}  // namespace ew::ui
