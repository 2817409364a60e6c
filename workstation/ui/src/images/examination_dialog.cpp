#include "images/examination_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

#include "ew/widgets/look.h"
#include "ew/widgets/words.h"
#include "images/examination_store.h"
#include "jobs/jobs.h"
#include "measure/worksheets/worksheets.h"

namespace ew::ui {
namespace {

const auto kHost = QStringLiteral("archive/host");
const auto kPort = QStringLiteral("archive/port");
const auto kTitle = QStringLiteral("archive/title");
const auto kOwnTitle = QStringLiteral("archive/ownTitle");
constexpr QSize kThumbnail_px(168, 126);
constexpr double kPatience_s = 10.0;  ///< with an archive that is silent, while a person waits

}  // namespace

ExaminationDialog::ExaminationDialog(ExaminationStore& stored, Worksheets& worksheets, Jobs& jobs, QWidget* parent)
    : QDialog(parent), stored_(stored), worksheets_(worksheets), jobs_(jobs) {
  setObjectName(QStringLiteral("examinationDialog"));
  setWindowTitle(tr("Examination"));
  resize(620, 620);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 16, 16, 16);
  rows->setSpacing(8);
  auto* heading = new QLabel(tr("Stored images"));
  setLook(heading, Look::heading);
  rows->addWidget(heading);
  noImages_ =
      new QLabel(tr("No image is stored yet. 'Store image' in the menu 'File' keeps what the scan shows, with all that is measured "
                    "and written on it."));
  noImages_->setObjectName(QStringLiteral("noStoredImages"));
  noImages_->setWordWrap(true);
  setLook(noImages_, Look::quiet);
  rows->addWidget(noImages_);
  images_ = new QListWidget;
  images_->setObjectName(QStringLiteral("storedImages"));
  images_->setAccessibleName(tr("Stored images"));
  images_->setViewMode(QListView::IconMode);
  images_->setResizeMode(QListView::Adjust);
  images_->setMovement(QListView::Static);
  images_->setIconSize(kThumbnail_px);
  images_->setGridSize(kThumbnail_px + QSize(16, 48));
  images_->setWordWrap(true);
  rows->addWidget(images_, 1);
  auto* below = new QHBoxLayout;
  sheets_ = new QLabel;
  sheets_->setObjectName(QStringLiteral("storedWorksheets"));
  sheets_->setWordWrap(true);
  remove_ = new QPushButton(tr("Remove image"));
  remove_->setObjectName(QStringLiteral("removeStored"));
  remove_->setAutoDefault(false);
  below->addWidget(sheets_, 1);
  below->addWidget(remove_);
  rows->addLayout(below);
  rows->addSpacing(8);
  addArchive(*rows);
  auto* caution = new QLabel(tr("Every image and report says that it is a simulation and not for diagnosis."));
  setLook(caution, Look::small);
  setLook(caution, Look::quiet);
  rows->addWidget(caution);
  auto* buttons = new QHBoxLayout;
  save_ = new QPushButton(tr("Save as DICOM files…"));
  save_->setObjectName(QStringLiteral("saveExamination"));
  send_ = new QPushButton(tr("Send to the archive"));
  send_->setObjectName(QStringLiteral("sendExamination"));
  setLook(send_, Look::primary);
  auto* close = new QPushButton(tr("Close"));
  buttons->addWidget(save_);
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(send_);
  for (QPushButton* each : {save_, send_, close}) each->setAutoDefault(false);
  rows->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(save_, &QPushButton::clicked, this, &ExaminationDialog::saveAsked);
  connect(send_, &QPushButton::clicked, this, &ExaminationDialog::sendAsked);
  connect(images_, &QListWidget::itemSelectionChanged, this, [this] { remove_->setEnabled(images_->currentRow() >= 0); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (images_->currentRow() >= 0) stored_.remove(static_cast<std::size_t>(images_->currentRow()));
  });
  connect(&stored_, &ExaminationStore::changed, this, &ExaminationDialog::showAll);
  setWaiting({});
  showAll();
}

void ExaminationDialog::addArchive(QVBoxLayout& rows) {
  auto* heading = new QLabel(tr("Archive"));
  setLook(heading, Look::heading);
  rows.addWidget(heading);
  const QSettings kept;
  host_ = new QLineEdit(kept.value(kHost).toString());
  host_->setObjectName(QStringLiteral("archiveHost"));
  host_->setPlaceholderText(tr("name or address of its machine"));
  port_ = new QSpinBox;
  port_->setObjectName(QStringLiteral("archivePort"));
  port_->setRange(1, 65535);
  port_->setValue(kept.value(kPort, 104).toInt());
  port_->setAccessibleName(tr("Port"));
  title_ = new QLineEdit(kept.value(kTitle).toString());
  title_->setObjectName(QStringLiteral("archiveTitle"));
  title_->setPlaceholderText(tr("as its administrator calls it"));
  ownTitle_ = new QLineEdit(kept.value(kOwnTitle, QStringLiteral("ECHOWEAVE")).toString());
  ownTitle_->setObjectName(QStringLiteral("archiveOwnTitle"));
  for (QLineEdit* each : {title_, ownTitle_}) {
    each->setMaxLength(16);
    each->setToolTip(tr("Application entity title: 1 to 16 letters without blanks"));
  }
  // In a row of several a form names none of them.
  host_->setAccessibleName(tr("Host"));
  title_->setAccessibleName(tr("AE title"));
  ownTitle_->setAccessibleName(tr("knows this program as"));
  auto* place = new QHBoxLayout;
  place->addWidget(host_, 1);
  place->addWidget(new QLabel(tr("Port")));
  place->addWidget(port_);
  auto* titles = new QHBoxLayout;
  titles->addWidget(title_, 1);
  titles->addWidget(new QLabel(tr("knows this program as")));
  titles->addWidget(ownTitle_, 1);
  auto* form = new QFormLayout;
  form->addRow(tr("Host"), place);
  form->addRow(tr("AE title"), titles);
  rows.addLayout(form);
  auto* tests = new QHBoxLayout;
  test_ = new QPushButton(tr("Test the connection"));
  test_->setObjectName(QStringLiteral("testArchive"));
  test_->setAutoDefault(false);
  answer_ = new QLabel;
  answer_->setObjectName(QStringLiteral("archiveAnswer"));
  answer_->setWordWrap(true);
  tests->addWidget(test_);
  tests->addWidget(answer_, 1);
  rows.addLayout(tests);
  waiting_ = new QLabel;
  waiting_->setObjectName(QStringLiteral("outboxState"));
  waiting_->setWordWrap(true);
  rows.addWidget(waiting_);
  connect(test_, &QPushButton::clicked, this, &ExaminationDialog::testArchive);
  for (QLineEdit* each : {host_, title_, ownTitle_})
    connect(each, &QLineEdit::textChanged, this, [this] {
      answer_->clear();
      showAll();
    });
}

DicomArchive ExaminationDialog::archive() const {
  DicomArchive archive;
  archive.host = host_->text().trimmed().toStdString();
  archive.port = port_->value();
  archive.aeTitle = title_->text().trimmed().toStdString();
  archive.ownAeTitle = ownTitle_->text().trimmed().toStdString();
  archive.timeout_s = kPatience_s;
  QSettings kept;
  kept.setValue(kHost, host_->text().trimmed());
  kept.setValue(kPort, port_->value());
  kept.setValue(kTitle, title_->text().trimmed());
  kept.setValue(kOwnTitle, ownTitle_->text().trimmed());
  return archive;
}

void ExaminationDialog::testArchive() {
  answer_->setText(tr("Asking…"));
  test_->setEnabled(false);
  jobs_.start(
      tr("Asking the archive"), [archive = archive()](Progress& progress) { return askArchive(archive, progress); },
      [dialog = QPointer<ExaminationDialog>(this)](const Result<void>& outcome) {
        if (dialog.isNull()) return;
        dialog->test_->setEnabled(true);
        dialog->answer_->setText(outcome ? tr("The archive answers.") : words(outcome.error().message));
      },
      Jobs::Kind::background);
}

void ExaminationDialog::setWaiting(const QString& sentence) {
  hasWaiting_ = !sentence.isEmpty();
  waiting_->setText(sentence);
  waiting_->setVisible(hasWaiting_);
  showAll();
}

void ExaminationDialog::setSending(bool isSending) {
  isSending_ = isSending;
  showAll();
}

void ExaminationDialog::showAll() {
  const auto& items = stored_.items();
  std::vector<std::string> now;
  for (const auto& item : items) now.push_back(item.still.options.instanceUid);
  if (std::exchange(shown_, now) != now) {
    images_->clear();
    for (std::size_t n = 0; n < items.size(); ++n) {
      const auto& item = items[n];
      const QString when = item.caption.section(QStringLiteral(", "), -1);  // all of it is in the tip
      auto* shown =
          new QListWidgetItem(QIcon(QPixmap::fromImage(item.image.scaled(kThumbnail_px, Qt::KeepAspectRatio, Qt::SmoothTransformation))),
                              QStringLiteral("%1.  %2").arg(n + 1).arg(when));
      shown->setToolTip(item.caption);
      images_->addItem(shown);
    }
  }
  noImages_->setVisible(items.empty());
  images_->setVisible(!items.empty());
  remove_->setVisible(!items.empty());
  remove_->setEnabled(images_->currentRow() >= 0);
  QStringList titles;
  for (const measurement::Examination* each : worksheets_.filled()) titles << words(each->package().title);
  sheets_->setText(titles.isEmpty() ? tr("No worksheet is filled.") : tr("Worksheets: %1").arg(titles.join(QStringLiteral(", "))));
  save_->setEnabled(!stored_.isEmpty());
  const bool hasArchive =
      !host_->text().trimmed().isEmpty() && !title_->text().trimmed().isEmpty() && !ownTitle_->text().trimmed().isEmpty();
  send_->setEnabled(!isSending_ && hasArchive && (!stored_.isEmpty() || hasWaiting_));
  send_->setText(isSending_ ? tr("Sending…") : tr("Send to the archive"));
  send_->setToolTip(hasArchive ? tr("Stored images and a report of each worksheet; copies wait in the outbox until the archive has them")
                               : tr("Name the archive first: host and AE title"));
}

}  // namespace ew::ui
