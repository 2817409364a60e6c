#include "panel/publish_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/io/volume_file.h"
#include "ew/library/bundle.h"
#include "ew/library/instructor_log.h"
#include "ew/library/published.h"
#include "ew/library/sealed_answers.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::case_authoring {
namespace {

using State = CheckItem::State;

constexpr int kCheckAfter_ms = 500;

/// The volume of a case with a file; null when there is none, or when it cannot be read: then the list says so.
std::shared_ptr<const Volume> volumeOf(const Case& checked, Progress& progress) {
  if (checked.volume.file.empty()) return nullptr;
  const auto file = fileOfCase(checked.folder, checked.volume.file, "volume.file");
  if (!file) return nullptr;
  auto read = readVolume(*file, progress);
  return read ? std::make_shared<const Volume>(std::move(read->volume)) : nullptr;
}

/// Shape and word, not colour alone.
QString signOf(State state) {
  switch (state) {
    case State::missing:
      return QStringLiteral("✕");
    case State::warning:
      return QStringLiteral("!");
    case State::done:
      return QStringLiteral("✓");
  }
  return {};
}

}  // namespace

PublishDialog::PublishDialog(sdk::Host& host, QWidget* parent) : QDialog(parent), host_(host) {
  setObjectName(QStringLiteral("publishDialog"));
  setWindowTitle(tr("Publish the case"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px);
  column->setSpacing(2 * kGrid_px);
  summary_ = headingLabel({});
  summary_->setObjectName(QStringLiteral("publishSummary"));
  column->addWidget(summary_);
  column->addWidget(quietLabel(tr("A click on a line leads to where it is written.")));
  scroll_ = new QScrollArea;
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("publishProblem"));
  column->addWidget(problem_);
  result_ = new QLabel;
  result_->setObjectName(QStringLiteral("publishResult"));
  result_->setWordWrap(true);
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  result_->hide();
  column->addWidget(result_);
  auto* warning = quietLabel(
      tr("Export is for practice: whoever opens the file can read the answers in it. An examination carries them sealed, and is judged "
         "afterwards."));
  warning->setObjectName(QStringLiteral("exportWarning"));
  warning->setWordWrap(true);
  column->addWidget(warning);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  export_ = new QPushButton(tr("Export…"));
  export_->setObjectName(QStringLiteral("exportCase"));
  export_->setToolTip(tr("Write the case into one file, for another workstation"));
  export_->setAutoDefault(false);
  buttons->addWidget(export_);
  examination_ = new QPushButton(tr("Examination…"));
  examination_->setObjectName(QStringLiteral("exportExamination"));
  examination_->setToolTip(tr("Write what trainees may read into one file, and the answers so that an instructor's key alone opens them"));
  examination_->setAutoDefault(false);
  buttons->addWidget(examination_);
  buttons->addStretch(1);
  auto* close = new QPushButton(tr("Close"));
  close->setAutoDefault(false);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  buttons->addWidget(close);
  publish_ = new QPushButton(tr("Publish"));
  publish_->setObjectName(QStringLiteral("publishNow"));
  setLook(publish_, Look::primary);
  publish_->setDefault(true);
  buttons->addWidget(publish_);
  column->addLayout(buttons);
  connect(export_, &QPushButton::clicked, this, &PublishDialog::exportCase);
  connect(examination_, &QPushButton::clicked, this, &PublishDialog::exportExamination);
  connect(publish_, &QPushButton::clicked, this, &PublishDialog::publish);
  resize(70 * kGrid_px, 66 * kGrid_px);
  soon_.setSingleShot(true);
  soon_.setInterval(kCheckAfter_ms);
  connect(&soon_, &QTimer::timeout, this, &PublishDialog::check);
  ticket_ = host_.cases().onChanged([this] { soon_.start(); });
  check();
}

void PublishDialog::check() {
  if (checking_ != 0) {
    again_ = true;
    return;
  }
  const auto present = host_.cases().current();
  if (!present) {
    close();
    return;
  }
  static int number = 0;
  const int mine = checking_ = ++number;
  showButtons();
  if (scroll_->widget() == nullptr) summary_->setText(tr("The case is being checked."));
  struct Checked {
    std::vector<CheckItem> list;
    std::shared_ptr<const Volume> volume;
  };
  auto found = std::make_shared<Checked>();
  const std::string file = present->volume.file;
  if (file == volumeFile_) found->volume = volume_;  // volumes are named by their content
  CheckSources sources;
  if (const auto scanned = host_.scan().scanned(); scanned && host_.cases().scan()) sources.skin = scanned->skin;
  host_.jobs().start(
      tr("Checking the case").toStdString(),
      [found, present = *present, sources](Progress& progress) mutable -> Result<void> {
        if (!found->volume) found->volume = volumeOf(present, progress);
        sources.volume = found->volume;
        auto list = publishingList(present, sources, progress);
        if (!list) return passOn(list.error());
        found->list = std::move(*list);
        return {};
      },
      [this, alive = QPointer<PublishDialog>(this), found, file, mine](const Result<void>& outcome) {
        if (!alive || checking_ != mine) return;
        checking_ = 0;
        volume_ = found->volume;
        volumeFile_ = file;
        if (outcome)
          showList(found->list);
        else if (outcome.error().code != ErrorCode::cancelled)
          tell(words(outcome.error()), true);
        showButtons();
        if (std::exchange(again_, false)) check();
      });
}

void PublishDialog::showList(const std::vector<CheckItem>& list) {
  missing_ = countOf(list, State::missing);
  const std::size_t warnings = countOf(list, State::warning);
  summary_->setText(missing_ > 0   ? tr("Missing: %1   To look at: %2").arg(missing_).arg(warnings)
                    : warnings > 0 ? tr("Can be published. To look at: %1").arg(warnings)
                                   : tr("Ready to be published"));
  auto* page = new QWidget;
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid_px / 2);
  int number = 0;
  for (const State state : {State::missing, State::warning, State::done})
    for (const CheckItem& item : list)
      if (item.state == state) addItem(*rows, item, number++);
  rows->addStretch(1);
  const int at = scroll_->verticalScrollBar() != nullptr ? scroll_->verticalScrollBar()->value() : 0;
  scroll_->setWidget(page);
  scroll_->verticalScrollBar()->setValue(at);
}

void PublishDialog::addItem(QVBoxLayout& rows, const CheckItem& item, int number) {
  auto* row = new QToolButton;
  row->setObjectName(QStringLiteral("checkItem_%1").arg(number));
  row->setProperty("field", words(item.field));
  row->setProperty("checkState", static_cast<int>(item.state));
  row->setAutoRaise(true);
  row->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  row->setEnabled(!item.field.empty());
  row->setAccessibleName(words(item.what));
  auto* inside = new QHBoxLayout(row);
  inside->setContentsMargins(kGrid_px, kGrid_px / 2, kGrid_px, kGrid_px / 2);
  inside->setSpacing(kGrid_px);
  auto* sign = new QLabel(signOf(item.state));
  sign->setFixedWidth(2 * kGrid_px);
  sign->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
  setLook(sign, Look::heading);
  if (item.state == State::missing) sign->setForegroundRole(QPalette::BrightText);
  if (item.state == State::done) setLook(sign, Look::quiet);
  inside->addWidget(sign);
  auto* what = new QLabel(words(item.what));
  what->setWordWrap(true);
  what->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  if (item.state == State::done) setLook(what, Look::quiet);
  inside->addWidget(what, 1);
  for (QLabel* label : {sign, what}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
  row->setMinimumHeight(inside->sizeHint().height());
  connect(row, &QToolButton::clicked, this, [this, field = words(item.field)] { Q_EMIT fieldAsked(field); });
  rows.addWidget(row);
}

void PublishDialog::showButtons() {
  const bool isIdle = checking_ == 0 && !working_;
  publish_->setEnabled(isIdle && missing_ == 0);
  publish_->setToolTip(missing_ == 0 ? tr("Trainees see the case as it is now; later edits wait for the next revision")
                                     : tr("Something is still missing, see the list"));
  export_->setEnabled(!working_);
  examination_->setEnabled(!working_);
}

bool PublishDialog::saved() {
  if (!host_.cases().hasUnsavedChanges()) return true;
  const auto done = host_.cases().save();
  if (!done && done.error().code != ErrorCode::cancelled) tell(words(done.error()), true);
  return done.has_value();
}

void PublishDialog::publish() {
  if (!saved()) return;
  auto published = std::make_shared<CaseRevision>();
  working_ = true;
  showButtons();
  host_.jobs().startSaving(
      tr("Publishing the case").toStdString(),
      [published, folder = host_.cases().currentFolder()](Progress& progress) -> Result<void> {
        auto done = publishCase(folder, libraryFolder(), progress);
        if (!done) return passOn(done.error());
        *published = std::move(*done);
        return {};
      },
      [this, alive = QPointer<PublishDialog>(this), published](const Result<void>& outcome) {
        if (!alive) return;
        working_ = false;
        showButtons();
        if (outcome)
          tell(published->wasThere
                   ? tr("Nothing has changed since revision %1; it stays the one that trainees see.").arg(published->revision)
                   : tr("Published as revision %1. Trainees find it on the start page.").arg(published->revision),
               false);
        else if (outcome.error().code != ErrorCode::cancelled)
          tell(words(outcome.error()), true);
      });
}

std::optional<std::filesystem::path> PublishDialog::askForBundle(const QString& title, const QString& name) {
  sdk::SaveFile asked{
      title.toStdString(), name.toStdString() + kBundleEnding, tr("Case bundles (*.ewcase)").toStdString(), {kBundleEnding}};
  asked.whyKept = [](const std::filesystem::path& there) {
    if (!holdsExamination(there)) return std::string();
    return tr("'%1' is the file of an examination and is never replaced: attempts at it are judged with it alone.")
        .arg(words(there.filename().string()))
        .toStdString();
  };
  return host_.window().askSaveFile(asked);
}

void PublishDialog::exportCase() {
  if (!saved()) return;
  const auto present = host_.cases().current();
  if (!present) return;
  const auto target = askForBundle(tr("Export the case"), words(present->id));
  if (!target) return;
  const QString file = words(target->string());
  working_ = true;
  showButtons();
  auto header = std::make_shared<BundleHeader>();
  host_.jobs().startSaving(
      tr("Exporting the case").toStdString(),
      [header, folder = host_.cases().currentFolder(), file](Progress& progress) -> Result<void> {
        PartOfProgress comparing(progress, 0.0, 0.3), writing(progress, 0.3, 1.0);
        // As trainees have it, where it is what they have: it then bears its revision.
        const auto published = publishedAsItIs(folder, libraryFolder(), comparing);
        if (!published) return passOn(published.error());
        auto done = exportBundle(*published ? (*published)->folder : folder, std::filesystem::path(file.toStdString()), writing);
        if (!done) return passOn(done.error());
        *header = std::move(*done);
        return {};
      },
      [this, alive = QPointer<PublishDialog>(this), header, file](const Result<void>& outcome) {
        if (!alive) return;
        working_ = false;
        showButtons();
        if (outcome)
          tell((header->revision > 0 ? tr("Revision %1 was exported to %2. Another workstation takes it with File, Import a case bundle.")
                                           .arg(header->revision)
                                           .arg(file)
                                     : tr("Exported to %1, as it is now; trainees here see another revision, or none. Another workstation "
                                          "takes it with File, "
                                          "Import a case bundle.")
                                           .arg(file)),
               false);
        else if (outcome.error().code != ErrorCode::cancelled)
          tell(words(outcome.error()), true);
      });
}

/// The key of this account, else one from a file.
std::optional<PublicKey> PublishDialog::instructorsKey() {
  if (auto own = publicKeyKeptIn(instructorKeyFile())) return *own;
  const QString file = QFileDialog::getOpenFileName(this, tr("The public key of whoever judges the examination"), QString(),
                                                    tr("Public keys (*.pub);;All files (*)"));
  if (file.isEmpty()) return std::nullopt;
  const auto key = readPublicKey(file.toStdString());
  if (key) return *key;
  tell(words(key.error()), true);
  return std::nullopt;
}

void PublishDialog::exportExamination() {
  if (!saved()) return;
  const auto key = instructorsKey();
  if (!key) return;
  const auto target = askForBundle(tr("Export an examination"), tr("examination"));
  if (!target) return;
  const QString file = words(target->string());
  working_ = true;
  showButtons();
  auto made = std::make_shared<Examination>();
  host_.jobs().startSaving(
      tr("Exporting an examination").toStdString(),
      [made, key = *key, folder = host_.cases().currentFolder(), file](Progress& progress) -> Result<void> {
        auto done = ew::exportExamination(folder, file.toStdString(), {.instructors = {key}}, progress);
        if (!done) return passOn(done.error());
        *made = std::move(*done);
        return logChange(libraryFolder(), "examination made", made->id, {}, made->sealedSha256);
      },
      [this, alive = QPointer<PublishDialog>(this), made, key = *key, file](const Result<void>& outcome) {
        if (!alive) return;
        working_ = false;
        showButtons();
        if (outcome)
          tell(tr("Exported to %1, the answers sealed for the key %2. Keep this file: attempts at it are judged with it alone.")
                   .arg(file, words(shortNameOf(key))),
               false);
        else if (outcome.error().code != ErrorCode::cancelled)
          tell(words(outcome.error()), true);
      });
}

void PublishDialog::tell(const QString& sentence, bool isProblem) {
  setProblem(problem_, isProblem ? sentence : QString());
  result_->setText(isProblem ? QString() : sentence);
  result_->setVisible(!isProblem);
}

}  // namespace ew::case_authoring
