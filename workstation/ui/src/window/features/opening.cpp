#include "window/features/opening.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMetaObject>
#include <QSettings>
#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "ew/library/case.h"
#include "ew/library/file_import.h"
#include "ew/library/folders.h"
#include "ew/library/lesson.h"
#include "ew/library/preparation.h"
#include "ew/scanning/recording.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "import/file_import_dialog.h"
#include "import/import_dialog.h"
#include "import/screen_dialog.h"
#include "start/recent_files.h"
#include "window/features/access_lock.h"
#include "window/features/case_library.h"
#include "window/features/case_saving.h"
#include "window/features/preparing.h"
#include "window/features/presets.h"
#include "window/features/recording.h"
#include "window/features/resuming.h"
#include "window/features/storing.h"
#include "window/features/unsaved_volumes.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"
#include "window/layout/window_layout.h"

namespace ew::ui {
namespace {

constexpr int kRecentFiles = 6;
const auto kOpenSetting = QStringLiteral("open/last");
const auto kOpeningSetting = QStringLiteral("open/opening");  ///< set while it is being opened: a crash there must not come again

/// On the first start the shipped case that is there soonest; empty: there is none.
std::filesystem::path soonestScannable() {
  const auto folder = shippedCasesFolder();
  const CaseList found = folder ? listCases(*folder) : CaseList{};
  if (found.cases.empty()) return {};
  const auto ready = std::find_if(found.cases.begin(), found.cases.end(), [](const Case& each) { return !caseNeedsPreparation(each); });
  return ready != found.cases.end() ? ready->folder : preparationOrder(found.cases).front().folder;
}

QStringList recentPaths() { return QSettings().value(QStringLiteral("recent")).toStringList(); }

}  // namespace

void Opening::addFileActions(QMenu& file) {
  first_ = parts_.commands->add(file, "open", [this] { choose(); });
  parts_.commands->add(file, "open.folder", [this] {
    const QString folder = QFileDialog::getExistingDirectory(&parts_.window, tr("Open case folder"));
    if (!folder.isEmpty()) open(folder);
  });
}

void Opening::addRecentMenu(QMenu& file) { recent_ = file.addMenu(tr("Open &recent")); }

void Opening::connectParts() {
  WindowParts& p = parts_;
  connect(&p.recent, &RecentFiles::changed, this, &Opening::showRecent);
  connect(p.startPage, &StartPage::openRequested, this, &Opening::choose);
  connect(p.startPage, &StartPage::caseChosen, this, [this](const QString& folder) {
    // What is open and on its way to be examined is not thrown away by looking for it on the page of cases.
    const auto& present = parts_.document.current();
    if (present && parts_.opener->showsCase() && present->folder == pathOf(folder)) return parts_.workspaces->backToWork();
    open(folder);
  });
  connect(p.startPage, &StartPage::fileChosen, this, &Opening::open);
  connect(p.startPage, &StartPage::lessonChosen, this, &Opening::openLesson);
  connect(&p.jobs, &Jobs::problem, this, [this](const Error& error) { parts_.messages->showError(error); });
  p.opener->askBeforeReplacing([this](const QString& next) { return mayReplaceShown(next); },
                               [this](const QString& next) { return mayReplaceScan(next); });
  new DisplaySources(p.window, [this] {
    std::vector<std::filesystem::path> all = parts_.opener->sources();
    for (const UnsavedVolume& made : parts_.volumes->all()) all.push_back(pathOf(made.path));
    if (!parts_.recording->file().empty()) all.push_back(parts_.recording->file());
    return all;
  });
  connect(p.opener, &Opener::opened, this, &Opening::opened);
  connect(p.opener, &Opener::preparing, this, [this](const QString& path, const QString& caseId) {
    preparing_ = path;
    preparingId_ = caseId.toStdString();
    parts_.preparation.pause();
    parts_.preparing->openingIsRead();
  });
  connect(p.opener, &Opener::failed, this, [this](const Error& error) {
    if (error.code == ErrorCode::cancelled && !preparing_.isEmpty()) parts_.preparation.stop(preparingId_);
    if (error.code != ErrorCode::cancelled) goBack([this, error] { parts_.messages->showError(error); });
  });
  connect(p.opener, &Opener::tooLong, this, [this](const QString& path, const CaseToMake& left) {
    isBehind_ = true;
    parts_.preparing->prepareBehind(path, left);
    goBack([this, left] { parts_.preparing->tellBehind(left); });
  });
  connect(p.opener, &Opener::ended, this, &Opening::ended);
  connectImports();
  // Whoever asks waits for the case to be there, however long it takes: it is not prepared behind what is open.
  p.host->setOpening([this](const std::filesystem::path& folder) -> Result<void> {
    const QString path = wordsOf(folder);
    if (parts_.accessLock->mayOpen(path)) parts_.opener->open(path);
    return {};
  });
}

void Opening::connectImports() {
  WindowParts& p = parts_;
  connect(p.opener, &Opener::sweepChosen, this, [this](const QString& path) {
    auto* dialog = new ImportDialog(path, std::exchange(calibrations_, {}), parts_.jobs, *parts_.messages, &parts_.window);
    connect(dialog, &ImportDialog::imported, this,
            [this, path](const ScanVoxels& voxels, const QString& title, const std::shared_ptr<const Provenance>& provenance) {
              parts_.volumes->take({path, title, voxels, provenance});
            });
    dialog->open();
    parts_.resuming->waitFor(*dialog, path);
  });
  connect(p.opener, &Opener::recordingOpened, this, &Opening::playRecording);
  connect(p.opener, &Opener::bundleChosen, p.caseLibrary, &CaseLibrary::importCase);
  const auto askAboutScreen = [this](const QString& path) {
    auto* dialog = new ScreenDialog(path, parts_.jobs, *parts_.messages, &parts_.window);
    dialog->open();
    parts_.resuming->waitFor(*dialog, path);
  };
  connect(p.opener, &Opener::answersNeeded, this, [this, askAboutScreen](const QString& path, FileKind kind, const QString& question) {
    if (kind == FileKind::film) return askAboutScreen(path);
    auto* dialog = new FileImportDialog(path, kind, question, parts_.jobs, *parts_.messages, &parts_.window);
    connect(dialog, &FileImportDialog::imported, this, [this, path](const ScanVoxels& voxels, const QString& title) {
      parts_.volumes->takeImported({path, title, voxels, nullptr});
    });
    connect(dialog, &FileImportDialog::screenChosen, this, [askAboutScreen, path] { askAboutScreen(path); });
    connect(dialog, &FileImportDialog::sequenceSaved, parts_.opener, &Opener::sweepChosen);
    dialog->open();
    parts_.resuming->waitFor(*dialog, path);
  });
}

void Opening::refresh() {
  if (!recentForAuthors_) readRecent();
  if (recentForAuthors_ != parts_.workspaces->isAuthor()) showRecent();
}

void Opening::holdUnsavedWork(UnsavedWork& list) {
  list.add({"recorded screen",
            {Loss::closing},
            [this] {
              const auto dialogs = parts_.window.findChildren<ScreenDialog*>();
              return std::any_of(dialogs.begin(), dialogs.end(), [](const ScreenDialog* each) { return each->isUnsaved(); });
            },
            [this](Loss, const std::string&) {
              for (ScreenDialog* each : parts_.window.findChildren<ScreenDialog*>())
                if (!each->mayLeave(true)) return false;
              return true;
            }});
}

void Opening::open(const QString& path) {
  if (!parts_.accessLock->mayOpen(path) || parts_.opener->isOpening(path)) return;
  // What is on its way and takes long goes on behind whatever is chosen now, and says when it is ready.
  const auto& made = parts_.opener->beingMade();
  const bool goesOn = made && made->takesLong() && pathOf(preparing_) != pathOf(path);
  if (goesOn) parts_.preparing->prepareBehind(preparing_, *made);
  const QString before = goesOn ? QString() : parts_.opener->openingPath();
  goesBack_ = {};
  interrupted_.clear();
  openHere(path);
  if (parts_.opener->isOpening(path)) interrupted_ = before;
}

void Opening::openHere(const QString& path) {
  // Where nothing is open it is shown as soon as it is there.
  parts_.opener->open(path, parts_.session.subject() ? Opener::LongCases::leave : Opener::LongCases::open);
}

void Opening::goBack(std::function<void()> tell) {
  if (interrupted_.isEmpty()) return;
  goesBack_ = {std::exchange(interrupted_, {}), std::move(tell)};
  // Once what did not come has ended.
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (!goesBack_.path.isEmpty() && !parts_.opener->isOpening()) openHere(goesBack_.path);
      },
      Qt::QueuedConnection);
}

void Opening::openDropped(const QStringList& paths) {
  QStringList files, calibrations;
  for (const QString& path : paths) {
    if (path.isEmpty()) continue;
    (path.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive) ? calibrations : files) << path;
  }
  if (files.isEmpty()) files.swap(calibrations);
  if (files.isEmpty()) return;
  if (files.size() > 1) parts_.messages->showNote(tr("Several files were dropped; the first one is opened."));
  // After the drop has ended: a question must not keep the program the file came from waiting.
  QMetaObject::invokeMethod(
      this,
      [this, path = files.first(), calibrations] {
        open(path);
        // Afterwards: an opening that gives way to this one ends, and takes what was dropped with it along. A bundle, or a case that is
        // made behind what is open, is no opening, and its calibrations must not go to the next sweep.
        calibrations_ = parts_.opener->isOpening(path) ? calibrations : QStringList();
      },
      Qt::QueuedConnection);
}

void Opening::openLesson(const QString& folder, const QString& lessonId) {
  WindowParts& p = parts_;
  p.workspaces->show(kExplore);
  p.host->askFor(pathOf(folder), std::string(kLessonsPart), lessonId.toStdString());
  p.columns->show(Column::panels);  // where it is worked on; behind a tab it would not even begin
  const auto& present = p.document.current();
  if (present && p.opener->showsCase() && present->folder == pathOf(folder)) return p.workspaces->backToWork();
  open(folder);
}

void Opening::openDefaultCase() {
  isChoosing_ = true;
  auto chosen = std::make_shared<std::filesystem::path>();
  parts_.jobs.start(
      tr("Looking for a case to begin with"),
      [chosen](Progress&) -> Result<void> {
        *chosen = soonestScannable();
        return {};
      },
      [this, chosen](const Result<void>&) {
        isChoosing_ = false;
        const bool isTaken = parts_.opener->isOpening() || parts_.session.subject() || parts_.document.current();
        if (!isTaken && !chosen->empty()) parts_.opener->open(wordsOf(*chosen));
        if (!isTaken && chosen->empty()) parts_.workspaces->showStartPage();
        if (!parts_.opener->isOpening()) parts_.preparing->openingIsRead();
      });
}

bool Opening::isUnderWay() const { return isChoosing_ || parts_.opener->isOpening(); }

void Opening::openWhereOneWas() {
  QSettings settings;
  const QString last = settings.value(kOpenSetting).toString();
  const bool isKnown = settings.contains(kOpenSetting);
  if (isKnown && (last.isEmpty() || settings.value(kOpeningSetting).toString() == last)) {
    settings.remove(kOpeningSetting);
    return parts_.workspaces->showStartPage();  // it stood there, or what was open could not be opened
  }
  if (!isKnown || !QFileInfo::exists(last) || !parts_.accessLock->mayOpen(last)) return openDefaultCase();
  settings.setValue(kOpeningSetting, last);
  settings.sync();
  parts_.opener->open(last);
}

void Opening::choose() {
  const QString file = QFileDialog::getOpenFileName(
      &parts_.window, tr("Open a case, a volume or a sweep"), QString(),
      tr("All that EchoWeave reads (case.json *.ewcase *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw "
         "*.png *.jpg *.pgm *.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.wmv *.ts *.webm *.tif *.tiff);;"
         "Cases (case.json *.ewcase);;"
         "Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;"
         "Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;"
         "Films and recorded screens (*.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.wmv *.ts *.webm *.tif *.tiff *.dcm);;"
         "DICOM, Kretz, raw samples, images (*)"));
  if (!file.isEmpty()) open(file);
}

void Opening::opened(const QString& path) {
  remember(path);
  parts_.pages->setCurrentWidget(parts_.workspacePage);
  parts_.scanView->setFocus();
  // Of another case than the one that was opened it waits no longer.
  if (const auto waiting = std::exchange(waiting_, {}); waiting.recording)
    static_cast<void>(parts_.recording->play(waiting.path, waiting.recording));
  parts_.caseLibrary->forgetImported();
  parts_.presets->beginScanOfCase();
  if (const auto& current = parts_.document.current()) parts_.preparing->forgetOffer(current->id);
  rememberOpen(path);
  // What stood in the message bar went with what was open.
  if (const auto back = std::exchange(goesBack_, {}); back.path == path && back.tell) back.tell();
  parts_.caseSaving->caseOpened();
  parts_.resuming->opened();
}

void Opening::ended() {
  calibrations_.clear();
  interrupted_.clear();
  // A recording plays once its case is ready and taken; that one is being opened when the opening of the recording itself ends.
  if (!std::exchange(isBehind_, false) && !parts_.opener->isOpening()) waiting_ = {};
  parts_.caseSaving->openingEnded();
  parts_.resuming->openingEnded();
  parts_.preparing->openingIsRead();
  if (std::exchange(preparing_, {}).isEmpty()) return;
  parts_.preparation.resume();
  parts_.preparing->show();
}

void Opening::playRecording(const QString& path, const std::shared_ptr<const ScanRecording>& recording) {
  WindowParts& p = parts_;
  if (p.recording->play(path, recording)) return;
  if (const auto folder = p.library.folderOf(recording->caseId); !folder.empty()) {
    waiting_ = {path, recording};
    return open(wordsOf(folder));
  }
  p.messages->showError({ErrorCode::badUsage,
                         verbatim(tr("%1 is a recording of '%2'. Open what was scanned first, then the recording.")
                                      .arg(QFileInfo(path).fileName(), words(recording->title))
                                      .toStdString()),
                         {}},
                        kRecordingTopic);
}

void Opening::remember(const QString& path) {
  QSettings settings;
  QStringList recent = recentPaths();
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > kRecentFiles) recent.removeLast();
  settings.setValue(QStringLiteral("recent"), recent);
  readRecent();
  showRecent();
}

void Opening::readRecent() { parts_.recent.read(recentPaths()); }

void Opening::showRecent() {
  const QStringList recent = recentPaths();
  const bool forAuthors = parts_.workspaces->isAuthor();
  recentForAuthors_ = forAuthors;
  QStringList onCards;
  for (const QString& folder : parts_.startPage->foldersAtAGlance()) onCards << QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
  parts_.startPage->showRecent(parts_.recent.of(recent, forAuthors, onCards));
  recent_->clear();
  for (const RecentFile& file : parts_.recent.of(recent, forAuthors)) {
    QAction* action = recent_->addAction(file.name, this, [this, path = file.path] { open(path); });
    action->setToolTip(file.tip);
  }
  recent_->setToolTipsVisible(true);
  recent_->menuAction()->setVisible(!recent_->isEmpty());
}

void Opening::rememberOpen(const QString& path) {
  const auto& current = parts_.document.current();
  // A volume that was made here lies in no file; its sweep would ask again how it is to be made.
  const QString again = current ? wordsOf(current->folder) : parts_.volumes->shown() != nullptr ? QString() : path;
  QSettings settings;
  settings.remove(kOpeningSetting);
  if (current || !again.isEmpty()) settings.setValue(kOpenSetting, again);
  settings.sync();  // a kill must not take it
  // A volume that belongs to no case may be scanned beside an open one, and is nobody of that.
  parts_.autosave.setOpen(current && !parts_.opener->showsCase() ? QString() : again);
  parts_.storing->followPatient();
}

void Opening::rememberClosing() {
  QSettings settings;
  settings.remove(kOpeningSetting);  // it was not the end of the program
  if (parts_.workspaces->isAtStart()) settings.setValue(kOpenSetting, QString());
}

bool Opening::mayReplaceShown(const QString& next) {
  if (!parts_.unsaved.mayLose(Loss::opening, next.toStdString())) return false;
  parts_.volumes->forgetShown();
  parts_.recording->close();
  return true;
}

bool Opening::mayReplaceScan(const QString& next) {
  if (!parts_.unsaved.mayLose(Loss::scan, next.toStdString())) return false;
  parts_.volumes->forgetShown();
  parts_.recording->close();
  return true;
}

}  // namespace ew::ui
