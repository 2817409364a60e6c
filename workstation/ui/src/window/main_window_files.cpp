// Opening, saving and leaving: what a person made is asked about when it would be lost.
#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <chrono>
#include <utility>

#include "case/case_folder_dialog.h"
#include "ew/core/ending.h"
#include "ew/core/foreign_json.h"
#include "ew/io/volume_file.h"
#include "ew/library/placing.h"
#include "ew/library/preparation.h"
#include "ew/library/voxel_source.h"
#include "images/saved_picture.h"
#include "jobs/saving_dialog.h"
#include "widgets/save_file.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

constexpr int kRecentFiles = 6;
constexpr int kKeepAfter_ms = 400;  // a crash takes no more than this; typing writes no file a letter

// Topics of messages: of two about saving the same thing only the later one is true.
const QString kSavingCase = QStringLiteral("save case");
const QString kSavingVolume = QStringLiteral("save volume");
const QString kSavingPicture = QStringLiteral("save picture");
const QString kKeeping = QStringLiteral("keep edits");

/// A case that another program or window has saved meanwhile.
enum class Keep { nothing, elsewhere, theirs, ours };

Keep askWhichToKeep(QWidget* parent, const QString& title) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("changedOnDiskQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(MainWindow::tr("The case '%1' was saved by another window or program since it was opened here.").arg(title));
  question.setInformativeText(
      MainWindow::tr("Save as keeps both, each in a folder of its own. Reload drops the changes made here. Overwrite drops the others'."));
  auto* elsewhere = question.addButton(MainWindow::tr("Save as…"), QMessageBox::AcceptRole);
  auto* theirs = question.addButton(MainWindow::tr("Reload"), QMessageBox::DestructiveRole);
  auto* ours = question.addButton(MainWindow::tr("Overwrite"), QMessageBox::DestructiveRole);
  elsewhere->setObjectName(QStringLiteral("keepBoth"));
  theirs->setObjectName(QStringLiteral("reload"));
  ours->setObjectName(QStringLiteral("overwrite"));
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(elsewhere);
  question.exec();
  if (question.clickedButton() == elsewhere) return Keep::elsewhere;
  if (question.clickedButton() == theirs) return Keep::theirs;
  return question.clickedButton() == ours ? Keep::ours : Keep::nothing;
}

std::filesystem::path ownDataFolder() {
  return pathOf(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)) / "echoweave";
}

QString whyPublishedIsCopied(const QString& title) {
  return MainWindow::tr("Published cases are not edited in place, for attempts of trainees refer to them. Save '%1' as a case of your own.")
      .arg(title);
}

}  // namespace

void MainWindow::open(const QString& path) {
  if (!mayOpenPath(path)) return;
  // What is on its way and takes long goes on behind whatever is chosen now, and says when it is ready.
  if (const QString before = parts_->preparing; !before.isEmpty() && pathOf(before) != pathOf(path)) prepareBehind(before, true);
  if (!prepareBehind(path, parts_->session.subject().has_value())) parts_->opener->open(path);
}

bool MainWindow::prepareBehind(const QString& path, bool isSomethingWorkedWith) {
  Parts& p = *parts_;
  constexpr double kWorthWaitingFor_s = 5.0;
  if (!isSomethingWorkedWith) return false;  // it is shown as soon as it is there
  const auto wanted = loadCase(pathOf(path));
  if (!wanted || !caseNeedsPreparation(*wanted) || mayBeDrafted(*wanted)) return false;
  const auto estimate = estimatePreparation(*wanted);
  if (!estimate || estimate->seconds < kWorthWaitingFor_s) return false;
  p.readyOffers[wanted->id] = path;
  p.preparation.ask(*wanted);
  p.messages->showNote(tr("'%1' is being prepared, which takes %2. What is open stays open; you are told when the case is ready.")
                           .arg(shownTitle(*wanted), aboutMinutes(estimate->seconds)),
                       readyTopic(wanted->id));
  return true;
}

void MainWindow::offerReady(const QString& caseId) {
  Parts& p = *parts_;
  const auto offer = p.readyOffers.find(caseId.toStdString());
  if (offer == p.readyOffers.end()) return;
  const QString path = offer->second;
  p.readyOffers.erase(offer);
  const auto ready = loadCase(pathOf(path));
  if (!ready) return;
  p.messages->showOffer(
      tr("'%1' is ready.").arg(shownTitle(*ready)), tr("Open"), [this, path] { open(path); }, readyTopic(caseId.toStdString()));
}

void MainWindow::openDefaultCase() {
  auto folder = shippedCasesFolder();
  const CaseList found = folder ? listCases(*folder) : CaseList{};
  if (found.cases.empty()) {
    showStartPage();
    return;
  }
  // On the first start the one that is scannable soonest.
  const auto ready = std::find_if(found.cases.begin(), found.cases.end(), [](const Case& each) { return !caseNeedsPreparation(each); });
  parts_->opener->open(wordsOf(ready != found.cases.end() ? ready->folder : preparationOrder(found.cases).front().folder));
}

void MainWindow::chooseFile() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open a case, a volume or a sweep"), QString(),
      tr("All that EchoWeave reads (case.json *.ewcase *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw "
         "*.png *.jpg *.pgm *.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff);;"
         "Cases (case.json *.ewcase);;"
         "Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;"
         "Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;"
         "Films and recorded screens (*.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff *.dcm);;"
         "DICOM, Kretz, raw samples, images (*)"));
  if (!file.isEmpty()) open(file);
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList recent = settings.value(QStringLiteral("recent")).toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > kRecentFiles) recent.removeLast();
  settings.setValue(QStringLiteral("recent"), recent);
  showRecent();
}

void MainWindow::showRecent() {
  const QStringList recent = QSettings().value(QStringLiteral("recent")).toStringList();
  const bool forAuthors = parts_->isAuthor();
  QStringList onCards;
  for (const QString& folder : parts_->startPage->foldersAtAGlance()) onCards << QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
  parts_->startPage->showRecent(recentFilesOf(recent, forAuthors, onCards));
  parts_->recentMenu->clear();
  for (const RecentFile& file : recentFilesOf(recent, forAuthors)) {
    QAction* action = parts_->recentMenu->addAction(file.name, this, [this, path = file.path] { open(path); });
    action->setToolTip(file.tip);
  }
  parts_->recentMenu->setToolTipsVisible(true);
  parts_->recentMenu->menuAction()->setVisible(!recent.isEmpty());
}

const MadeVolume* MainWindow::shownMadeVolume() const {
  const auto& subject = parts_->session.subject();
  const auto found = std::find_if(parts_->made.begin(), parts_->made.end(),
                                  [&](const MadeVolume& made) { return subject && made.voxels.volume() == subject->voxels.volume(); });
  return found == parts_->made.end() ? nullptr : &*found;
}

std::optional<sdk::ShownVolume> MainWindow::shownVolume() const {
  const auto& subject = parts_->session.subject();
  if (!subject || parts_->opener->showsCase() || !subject->voxels.volume()) return std::nullopt;
  sdk::ShownVolume shown{subject->voxels.volume(), subject->title, {}};
  if (!subject->provenance) return shown;
  std::vector<PosedFrame> frames;
  for (const TracedFrame& each : subject->provenance->frames) frames.push_back({{}, each.imageToWorld, {}});
  if (const auto axes = sweepAxesOf(frames)) shown.depthAndLateral = {axes->depth, axes->lateral};
  return shown;
}

void MainWindow::forgetShownVolume() {
  if (const MadeVolume* made = shownMadeVolume()) parts_->made.erase(parts_->made.begin() + (made - parts_->made.data()));
  keepMadeVolumes();
}

void MainWindow::takeMade(const MadeVolume& made) {
  // Whatever is answered, a volume that took minutes is not lost by it.
  parts_->made.push_back(made);
  keepMadeVolumes();
  if (mayReplaceShown(made.title)) return showMade(made);
  parts_->messages->showNote(tr("The volume made from %1 is kept: View, Show the volume made from %1.").arg(made.title));
  showTitle();
}

void MainWindow::takeImported(const MadeVolume& made) {
  // Shown it is as good as in its file; what waits took answers that nobody wants to give again.
  if (mayReplaceShown(made.title)) return showMade(made);
  parts_->made.push_back(made);
  keepMadeVolumes();
  parts_->messages->showNote(tr("The volume made from %1 is kept: View, Show the volume made from %1.").arg(made.title));
  showTitle();
}

void MainWindow::showMade(const MadeVolume& made) {
  parts_->document.close();
  parts_->opener->showVolume(made.voxels, made.title, false, made.provenance, {pathOf(made.path)});
  keepMadeVolumes();
  Q_EMIT parts_->opener->opened(made.path);
}

const MadeVolume* MainWindow::waitingMadeVolume() const {
  const MadeVolume* shown = shownMadeVolume();
  for (const MadeVolume& made : parts_->made)
    if (&made != shown) return &made;
  return nullptr;
}

void MainWindow::showWaitingVolume() {
  const MadeVolume* waiting = waitingMadeVolume();
  if (waiting == nullptr) return;
  const MadeVolume made = *waiting;
  if (mayReplaceShown(made.title)) showMade(made);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose()) {
    event->ignore();
    return;
  }
  QSettings().setValue(QStringLiteral("window"), saveGeometry());
  rememberClosing();
  parts_->preparation.pause();  // what it has made is kept; the next start goes on from there
  parts_->jobs.cancelAllAndWait();
  parts_->keepSoon.stop();
  parts_->keptEdits.forget();  // the user has decided
  parts_->autosave.forget();
  event->accept();
}

MainWindow::Parts::Parts()
    : keptEdits(ownDataFolder() / "unsaved-cases"), autosave(ownDataFolder() / "unsaved-work", session, recorder, calipers, worksheets) {
  keepSoon.setSingleShot(true);
  keepSoon.setInterval(kKeepAfter_ms);
}

void MainWindow::keepEdits() {
  Parts& p = *parts_;
  if (!p.document.hasUnsavedChanges()) return p.keptEdits.forget();
  const auto kept = p.keptEdits.keep(*p.document.current(), p.document.asRead().value_or(Fingerprint{}));
  if (kept) return p.messages->forget(kKeeping);
  p.messages->showError(kept.error(), kKeeping);
}

void MainWindow::offerKeptEdits() { offerKeptEditsOf({}); }

void MainWindow::offerKeptEditsOf(const std::filesystem::path& caseFolder) {
  if (parts_->access.isLocked()) return;  // they are an author's, and wait
  Parts& p = *parts_;
  if (p.asksAboutKept) return;  // a case that came while somebody thinks about its edits
  const QScopedValueRollback<bool> asks(p.asksAboutKept, true);
  for (const KeptEdits::Left& left : p.keptEdits.left()) {
    const bool isLater = std::find(p.decideLater.begin(), p.decideLater.end(), left.kept) != p.decideLater.end();
    if (isLater || p.restoring || (!caseFolder.empty() && left.caseFolder != caseFolder)) continue;
    QMessageBox question(this);
    question.setObjectName(QStringLiteral("keptEditsQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    const auto at = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(left.at));
    question.setText(tr("The case '%1' has changes of %2 that were not saved when the program ended.")
                         .arg(words(textAt(left.manifest, "title")), QLocale().toString(at, QLocale::ShortFormat)));
    question.setInformativeText(tr("Folder: %1").arg(wordsOf(left.caseFolder)));
    auto* open = question.addButton(tr("Open with these changes"), QMessageBox::AcceptRole);
    auto* discard = question.addButton(tr("Throw them away"), QMessageBox::DestructiveRole);
    auto* later = question.addButton(tr("Decide later"), QMessageBox::RejectRole);
    open->setObjectName(QStringLiteral("openKept"));
    discard->setObjectName(QStringLiteral("discardKept"));
    question.setDefaultButton(open);
    question.setEscapeButton(later);
    question.exec();
    if (question.clickedButton() == discard) {
      KeptEdits::remove(left);
    } else if (question.clickedButton() == open) {
      const auto& current = p.document.current();
      const bool isOpen = current && current->folder == left.caseFolder;
      if (!isOpen) p.opener->open(wordsOf(left.caseFolder));
      p.restoring = left;  // once it is open; what was being opened before has been given up
      if (isOpen) restoreKeptEdits();
    } else {
      p.decideLater.push_back(left.kept);
    }
  }
}

void MainWindow::restoreKeptEdits() {
  Parts& p = *parts_;
  const auto left = std::exchange(p.restoring, std::nullopt);
  if (!left || !p.document.current() || p.document.current()->folder != left->caseFolder) return;
  const auto restored = p.document.restore(
      left->manifest,
      tr("Take over the changes of %1")
          .arg(QLocale().toString(QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(left->at)), QLocale::ShortFormat))
          .toStdString(),
      left->asRead);
  if (!restored) {
    p.decideLater.push_back(left->kept);
    p.messages->showError(restored.error());
    return;
  }
  keepEdits();  // here, before they are gone there
  KeptEdits::remove(*left);
}

void MainWindow::save(bool elsewhere) {
  if (const auto document = panelDocument())
    document->save(elsewhere);
  else
    saveCase(elsewhere);
}

bool MainWindow::saveCase(bool elsewhere) {
  const auto saved = elsewhere ? saveCaseCopy({}) : saveCaseInPlace();
  if (saved && !elsewhere) parts_->messages->forget(kSavingCase);
  if (!saved && saved.error().code != ErrorCode::cancelled) parts_->messages->showError(saved.error(), kSavingCase);
  return saved.has_value();
}

Result<void> MainWindow::saveCaseInPlace() {
  if (auto allowed = parts_->access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_->document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  const auto unsaved = failure(ErrorCode::cancelled, say<"The case is not saved.">());
  const QString title = words(document.current()->title);
  CaseOverwrite decided;
  if (document.isPublishedCase()) return saveCaseCopy(whyPublishedIsCopied(title));
  document.refreshLease();
  if (document.lost()) return saveCaseCopy(words(document.lost()->message));
  if (document.isShippedCase()) {
    QMessageBox question(this);
    question.setObjectName(QStringLiteral("shippedQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    question.setText(tr("The case '%1' belongs to the program.").arg(title));
    question.setInformativeText(tr("Save a copy of your own: the next version of the program replaces what is changed in its own cases."));
    auto* copy = question.addButton(tr("Save a copy…"), QMessageBox::AcceptRole);
    auto* shipped = question.addButton(tr("Change the program's case"), QMessageBox::DestructiveRole);
    copy->setObjectName(QStringLiteral("saveCopy"));
    shipped->setObjectName(QStringLiteral("changeShipped"));
    question.addButton(QMessageBox::Cancel);
    question.setDefaultButton(copy);
    question.exec();
    if (question.clickedButton() == copy) return saveCaseCopy({});
    if (question.clickedButton() != shipped) return unsaved;
    decided.shipped = true;
  }
  if (document.isChangedOnDisk()) {
    switch (askWhichToKeep(this, title)) {
      case Keep::elsewhere:
        return saveCaseCopy({});
      case Keep::theirs:
        reloadCase();
        return unsaved;
      case Keep::nothing:
        return unsaved;
      case Keep::ours:
        decided.changedOnDisk = true;
    }
  }
  return document.save({}, decided);
}

Result<void> MainWindow::saveCaseCopy(const QString& why) {
  if (auto allowed = parts_->access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_->document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  std::filesystem::path present = document.current()->folder;
  if (!present.has_filename()) present = present.parent_path();
  CaseFolderDialog dialog(why, wordsOf(present.filename()), this);
  if (dialog.exec() != QDialog::Accepted) return failure(ErrorCode::cancelled, say<"The case is not saved.">());
  const std::filesystem::path folder = dialog.folder();
  if (auto saved = document.save(folder); !saved) return saved;
  remember(wordsOf(folder));
  rememberOpen(wordsOf(folder));
  parts_->messages->showNote(tr("Saved in %1.").arg(wordsOf(folder)), kSavingCase);
  return {};
}

Result<void> MainWindow::saveCaseFor(const std::filesystem::path& folder) {
  if (auto allowed = parts_->access.require(Permission::editCases); !allowed) return allowed;
  if (folder.empty()) return saveCaseInPlace();
  if (auto saved = parts_->document.save(folder); !saved) return saved;
  remember(wordsOf(folder));
  rememberOpen(wordsOf(folder));
  return {};
}

Result<void> MainWindow::makeCaseOwn() {
  if (auto allowed = parts_->access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_->document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  const QString title = words(document.current()->title);
  if (document.isPublishedCase()) return saveCaseCopy(whyPublishedIsCopied(title));
  if (document.isShippedCase())
    return saveCaseCopy(
        tr("The case '%1' belongs to the program. It is copied to a folder of your own first, and changed there.").arg(title));
  if (const auto taken = document.reserve(); !taken) return saveCaseCopy(words(taken.error().message));
  return {};
}

void MainWindow::reloadCase() {
  parts_->opener->open(wordsOf(parts_->document.current()->folder));
  parts_->dropsEdits = true;  // decided; a case that cannot be opened keeps them all the same
}

namespace {

/// Coverage has a file of its own; without it a reopened volume would count every voxel as measured.
QString coverageBeside(const QString& file) {
  return QFileInfo(file).path() + QLatin1Char('/') + QFileInfo(file).completeBaseName() + QStringLiteral("-coverage.mha");
}

/// Never the name of a file it was made from: "sweep.igs.mha" gives "sweep-volume.mha". A title that is no file's name stays.
QString nameForVolumeOf(const QString& title) {
  QString stem = QFileInfo(title).fileName();
  for (const char* ending : {".gz",  ".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".igs", ".seq", ".dcm", ".vol", ".v00", ".raw",
                             ".png", ".jpg", ".pgm", ".tif",  ".tiff", ".avi", ".mp4", ".mov", ".mkv", ".mpg", ".mpeg"})
    if (const QLatin1String known(ending); stem.size() > known.size() && stem.endsWith(known, Qt::CaseInsensitive)) stem.chop(known.size());
  return stem + (stem == QFileInfo(title).fileName() ? QStringLiteral(".mha") : QStringLiteral("-volume.mha"));
}

/// Writes a volume and which voxels of it were measured, both or neither.
Result<void> writeWithCoverage(const Volume& volume, const QString& file, Progress& progress) {
  const bool covered = !volume.coverage.empty();
  const std::filesystem::path target = pathOf(file), beside = pathOf(coverageBeside(file));
  std::vector<std::filesystem::path> files{target};
  if (covered) files.push_back(beside);
  return saveTogether(files, [&](const OutputSet& outputs) -> Result<void> {
    PartOfProgress first(progress, 0.0, covered ? 0.5 : 1.0);
    if (auto written = writeVolume(volume, outputs.staged(target), first); !written || !covered) return written;
    PartOfProgress second(progress, 0.5, 1.0);
    return writeCoverage(volume, outputs.staged(beside), second);
  });
}

/// Where a file has a volume that was placed elsewhere in the body. @return empty: not saved
std::optional<bool> askWhetherPlaced(QWidget* parent) {
  // Either answer surprises someone: a volume moved here for looking must not lose its place beside others of its recording, and one
  // placed with care must not jump back.
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("volumePlace"));
  question.setWindowTitle(MainWindow::tr("Save the volume"));
  question.setText(MainWindow::tr("The volume lies elsewhere in the body than its own coordinates say. Which place should the file hold?"));
  question.setInformativeText(MainWindow::tr("Its own coordinates keep it in place beside other volumes of the same recording."));
  QPushButton* own = question.addButton(MainWindow::tr("Its own coordinates"), QMessageBox::AcceptRole);
  QPushButton* body = question.addButton(MainWindow::tr("Its place in the body"), QMessageBox::AcceptRole);
  own->setObjectName(QStringLiteral("ownPlace"));
  body->setObjectName(QStringLiteral("bodyPlace"));
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(own);
  question.exec();
  if (question.clickedButton() != own && question.clickedButton() != body) return std::nullopt;
  return question.clickedButton() == body;
}

}  // namespace

void MainWindow::saveShownVolume() {
  const auto& subject = parts_->session.subject();
  if (subject) saveVolume({{}, words(subject->title), subject->voxels, nullptr});
}

bool MainWindow::saveVolume(const MadeVolume& made) {
  std::optional<Grid> there;
  const auto& subject = parts_->session.subject();
  const std::shared_ptr<const Volume> volume = made.voxels.volume();
  if (subject && subject->voxels.volume() == volume && !(subject->placedGrid == volume->grid)) {
    const auto isPlaced = askWhetherPlaced(this);
    if (!isPlaced) return false;
    if (*isPlaced) there = subject->placedGrid;
  }
  const bool covered = !volume->coverage.empty();
  const QString file = askSaveFile(this, {tr("Save the volume"),
                                          nameForVolumeOf(made.title),
                                          tr("MetaImage (*.mha *.mhd)"),
                                          {QStringLiteral(".mha"), QStringLiteral(".mhd")},
                                          [covered](const QString& chosen) {
                                            return covered ? QStringList{chosen, coverageBeside(chosen)} : QStringList{chosen};
                                          }});
  if (file.isEmpty()) return false;
  const QString beside = coverageBeside(file);
  parts_->jobs.start(
      tr("Saving %1").arg(QFileInfo(file).fileName()),
      [volume, there, file](Progress& progress) -> Result<void> {
        if (!there) return writeWithCoverage(*volume, file, progress);
        Volume moved = *volume;
        moved.grid = *there;
        return writeWithCoverage(moved, file, progress);
      },
      [this, volume, file, beside, covered](const Result<void>& outcome) {
        if (outcome) {
          auto& unsaved = parts_->made;
          unsaved.erase(
              std::remove_if(unsaved.begin(), unsaved.end(), [&](const MadeVolume& each) { return each.voxels.volume() == volume; }),
              unsaved.end());
          keepMadeVolumes();
          parts_->messages->showNote(
              covered ? tr("Saved to %1, and which voxels were measured to %2.").arg(file, beside) : tr("Saved to %1.").arg(file),
              kSavingVolume);
          showTitle();
        } else if (outcome.error().code != ErrorCode::cancelled) {
          parts_->messages->showError(outcome.error(), kSavingVolume);
        }
      },
      Jobs::Kind::saving);
  return true;
}

void MainWindow::savePicture() {
  if (parts_->session.picture().isEmpty()) return;
  const QString file = askSaveFile(this, {tr("Save the image"),
                                          tr("scan") + QStringLiteral(".png"),
                                          tr("Images (*.png *.mha);;DICOM images (*.dcm)"),
                                          {QStringLiteral(".png"), QStringLiteral(".mha"), QStringLiteral(".dcm")}});
  if (file.isEmpty()) return;
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    const QDateTime now = QDateTime::currentDateTime();
    const std::vector<SavedPart> parts = shownParts();
    if (!hasEnding(pathOf(file), ".dcm")) return writeShownPictures(parts, pictureColumns(), now, outputs.staged(pathOf(file)));
    const auto still = storedStill(parts, savedPictures(parts, pictureColumns(), now), 1, now);
    auto object = writeDicomPicture(still.still, still.options, studyNow(), outputs.staged(pathOf(file)));
    return object ? Result<void>() : passOn(object.error());
  });
  if (written) {
    parts_->messages->showNote(tr("Saved to %1.").arg(file), kSavingPicture);
  } else {
    parts_->messages->showError(written.error(), kSavingPicture);
  }
}

}  // namespace ew::ui
