#include "panel/files_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <memory>
#include <utility>

#include "ew/library/case.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

enum Column { kFile, kSize, kUsedBy };

QStringList namesOf(const std::vector<std::string>& paths) {
  QStringList names;
  for (const std::string& each : paths) names << words(each);
  return names;
}

}  // namespace

FilesDialog::FilesDialog(sdk::Host& host, QWidget* parent) : QDialog(parent), host_(host) {
  setObjectName(QStringLiteral("filesDialog"));
  setWindowTitle(tr("Files of this case"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px);
  column->setSpacing(2 * kGrid_px);
  column->addWidget(
      quietLabel(tr("Whatever lies in the case's folder is published and exported with it. What nothing uses can be taken out.")));
  list_ = new QTreeWidget;
  list_->setObjectName(QStringLiteral("caseFileList"));
  list_->setAccessibleName(windowTitle());
  list_->setHeaderLabels({tr("File"), tr("Size"), tr("Used by")});
  list_->setRootIsDecorated(false);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->header()->setSectionResizeMode(kFile, QHeaderView::ResizeToContents);
  column->addWidget(list_, 1);
  aside_ = quietLabel({});
  aside_->setObjectName(QStringLiteral("filesAside"));
  aside_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(aside_);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("filesProblem"));
  column->addWidget(problem_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  takeOut_ = new QPushButton(tr("Take out…"));
  takeOut_->setObjectName(QStringLiteral("takeFilesOut"));
  takeOut_->setAutoDefault(false);
  buttons->addWidget(takeOut_);
  putBack_ = new QPushButton(tr("Put back"));
  putBack_->setObjectName(QStringLiteral("putFilesBack"));
  putBack_->setToolTip(tr("The files that were taken out last"));
  putBack_->setAutoDefault(false);
  buttons->addWidget(putBack_);
  buttons->addStretch(1);
  auto* close = new QPushButton(tr("Close"));
  close->setDefault(true);
  buttons->addWidget(close);
  column->addLayout(buttons);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &FilesDialog::showChosen);
  connect(takeOut_, &QPushButton::clicked, this, &FilesDialog::takeOut);
  connect(putBack_, &QPushButton::clicked, this, &FilesDialog::putBackLatest);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  resize(80 * kGrid_px, 56 * kGrid_px);
  ticket_ = host_.cases().onChanged([this] { look(); });
  look();
}

void FilesDialog::look(const std::optional<Error>& said) {
  const auto present = host_.cases().current();
  if (!present) {
    close();
    return;
  }
  const int mine = ++looks_;
  auto found = std::make_shared<Found>();
  host_.jobs().start(
      tr("Looking at the files of the case").toStdString(),
      [found, present = *present](Progress&) -> Result<void> {
        found->withdrawn = withdrawnFilesOf(present.folder);
        auto uses = fileUsesOf(present);
        if (!uses) return passOn(uses.error());
        found->uses = std::move(*uses);
        return {};
      },
      [this, alive = QPointer<FilesDialog>(this), found, mine, said](const Result<void>& done) {
        if (!alive || looks_ != mine) return;
        showFiles(*found, said ? *said : done ? std::optional<Error>() : done.error());
      });
}

void FilesDialog::showFiles(const Found& found, const std::optional<Error>& problem) {
  list_->clear();
  for (const CaseFileUse& each : found.uses) {
    const bool isUsed = !each.usedBy.empty();
    auto* row = new QTreeWidgetItem(
        list_, {words(each.path), sizeWords(each.size_bytes), isUsed ? words(joined(each.usedBy, ", ")) : tr("nothing")});
    row->setTextAlignment(kSize, Qt::AlignRight | Qt::AlignVCenter);
    row->setData(kFile, Qt::UserRole, !isUsed);
  }
  withdrawn_ = found.withdrawn;
  aside_->setText(withdrawn_.empty()
                      ? QString()
                      : tr("Taken out before: %1. They lie in %2.")
                            .arg(namesOf(withdrawn_.front().paths).join(QStringLiteral(", ")), words(withdrawn_.front().folder.string())));
  aside_->setVisible(!withdrawn_.empty());
  putBack_->setEnabled(!withdrawn_.empty() && !isMoving_);
  setProblem(problem_, problem ? words(*problem) : QString());
  showChosen();
}

void FilesDialog::showChosen() {
  const auto chosen = list_->selectedItems();
  bool areFree = !chosen.isEmpty();
  for (const QTreeWidgetItem* each : chosen) areFree = areFree && each->data(kFile, Qt::UserRole).toBool();
  takeOut_->setEnabled(areFree && !isMoving_);
  takeOut_->setToolTip(areFree            ? tr("They are moved aside, and not handed on with the case")
                       : chosen.isEmpty() ? tr("Choose files that nothing uses")
                                          : tr("What is in use stays; choose files that nothing uses"));
}

void FilesDialog::takeOut() {
  std::vector<std::string> paths;
  for (const QTreeWidgetItem* each : list_->selectedItems()) paths.push_back(each->text(kFile).toStdString());
  if (paths.empty()) return;
  QMessageBox question(this);
  question.setObjectName(QStringLiteral("takeOutQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("Take these files out of the case?"));
  question.setInformativeText(tr("%1\n\nThey are moved aside in the case's folder and can be put back here. Undo in the form brings no "
                                 "file back: put it back before you go back to a step that needs it.")
                                  .arg(namesOf(paths).join(QLatin1Char('\n'))));
  auto* yes = question.addButton(tr("Take out"), QMessageBox::DestructiveRole);
  yes->setObjectName(QStringLiteral("takeOutNow"));
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  if (question.clickedButton() != yes) return;
  if (const auto own = host_.cases().makeOwn(); !own) {
    if (own.error().code != ErrorCode::cancelled) fail(own.error());
    return;
  }
  const auto present = host_.cases().current();
  if (!present) return;
  moveFiles(tr("Taking files out of the case"), [present = *present, paths]() -> Result<void> {
    const auto taken = withdrawFiles(present, paths, CaseEditor::caller);
    return taken ? Result<void>() : passOn(taken.error());
  });
}

void FilesDialog::moveFiles(const QString& title, std::function<Result<void>()> work) {
  isMoving_ = true;
  takeOut_->setEnabled(false);
  putBack_->setEnabled(false);
  host_.jobs().startSaving(
      title.toStdString(), [work = std::move(work)](Progress&) { return work(); },
      [this, alive = QPointer<FilesDialog>(this)](const Result<void>& done) {
        if (!alive) return;
        isMoving_ = false;
        if (!done) return fail(done.error());
        look();
        Q_EMIT filesChanged();
      });
}

void FilesDialog::putBackLatest() {
  if (withdrawn_.empty()) return;
  moveFiles(tr("Putting files back"), [latest = withdrawn_.front()] { return putBack(latest); });
}

void FilesDialog::fail(const Error& problem) {
  host_.log().warn(problem.sentence());
  look(problem);
}

}  // namespace ew::case_authoring
