// How the parts of the window hear of each other.

#include "ew/ui/main_window.h"

#include <QLayout>

#include "ew/library/preparation.h"
#include "import/file_import_dialog.h"
#include "import/import_dialog.h"
#include "import/screen_dialog.h"
#include "plugins/host_scan.h"
#include "widgets/save_file.h"
#include "widgets/words.h"
#include "window/guarded_application.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kEditing = QStringLiteral("edit case");
const auto kKeepingWork = QStringLiteral("keep work");
constexpr int kHandRests_ms = 150;

}  // namespace

void MainWindow::connectParts() {
  connectSession();
  connectCalipers();
  connectAnnotations();
  connectZoomAndWide();
  connectPictures();
  connectDocument();
  connectPages();
  connectOpener();
  connectImports();
  connectPreparation();
  connectPlugins();
  connectTrackers();
}

void MainWindow::connectSession() {
  Parts& p = *parts_;
  connect(&p.session, &Session::pictureChanged, this, &MainWindow::showPicture);
  connect(&p.session, &Session::subjectChanged, this, [this] {
    if (const auto& subject = parts_->session.subject()) {
      parts_->view3d->setVolumeBox(subject->placedGrid);
    } else {
      parts_->view3d->clearVolumeBox();
      parts_->view3d->setProbeVisible(false);
    }
    showCoverageSoon();
    showTitle();
  });
  p.coverageSoon.setSingleShot(true);
  p.coverageSoon.setInterval(kHandRests_ms);
  connect(&p.coverageSoon, &QTimer::timeout, this, &MainWindow::showCoverage);
  connect(p.view3d, &View3D::mannequinChanged, this, &MainWindow::showCoverage);
  connect(&p.session, &Session::frozenChanged, this, [this](bool frozen) {
    parts_->freezeAction->setChecked(frozen);
    showRecordingState();
  });
  connect(&p.hand, &HandInput::refused, this, [this] {
    parts_->scanView->say(
        parts_->session.isPlaying()     ? tr("A recording is shown. Close it (Escape) to move the probe yourself.")
        : parts_->session.isFollowing() ? tr("The probe is moved for you. Escape takes it back.")
        : parts_->session.mover() == Session::Mover::tracker && !parts_->session.isFrozen()
            ? tr("The tracker has the probe. Choose the mouse on the page Tracker to move it here.")
            : tr("The image is frozen, and the probe with it. Let it run (%1): then both move again.").arg(parts_->keys.words("freeze")));
  });
  connect(&p.session, &Session::changeRefused, this, &MainWindow::sayWhyRefused);
  connect(p.cineBar, &CineBar::openChanged, this, &MainWindow::showCineState);
  connect(p.cineBar, &CineBar::saveAsked, this, &MainWindow::saveClip);
  connect(&p.session, &Session::probeChanged, this, &MainWindow::showRecordingState);
  connect(&p.session, &Session::holdChanged, this, [this] {
    if (parts_->hand.isEnabled() == parts_->session.handRests()) showRecordingState();
  });
  connect(&p.session, &Session::trackingChanged, this, [this] {
    if (parts_->hand.isEnabled() == parts_->session.handRests()) showRecordingState();
    showPicture();
  });
  connect(&p.recorder, &Recorder::changed, this, &MainWindow::showRecordingState);
  // A case whose volume was exchanged has its images again, and one whose own volume is scanned again its recordings. With changes that are
  // not saved its folder may hold another volume than what is scanned.
  connect(&p.session, &Session::patientReplaced, this, [this] { parts_->patientSoon = true; });
  connect(&p.session, &Session::subjectChanged, this, [this] {
    if (!std::exchange(parts_->patientSoon, false) || !parts_->opener->showsCase()) return;
    if (const auto& current = parts_->document.current(); current && !parts_->document.hasUnsavedChanges())
      parts_->autosave.setOpen(wordsOf(current->folder));
    followPatient();
  });
  connect(&p.stored, &StoredExamination::notKept, this, [this](const Error& error) { parts_->messages->showError(error, kKeepingWork); });
  connect(&p.autosave, &WorkAutosave::failed, this, [this](const Error& error) { parts_->messages->showError(error, kKeepingWork); });
  connect(p.replayBar, &ReplayBar::saveAsked, this, &MainWindow::saveRecording);
  connect(p.replayBar, &ReplayBar::closeAsked, this, [this] {
    if (mayLeaveRecording({})) closeRecording();
  });
  connect(p.console, &ConsolePanel::costAsked, this, &MainWindow::showCost);
  connect(p.sourcePicker, &SourcePicker::asked, this, &MainWindow::showSource);
  connect(p.sourcePicker, &PickLayer::pickingChanged, p.sourceAction, &QAction::setChecked);
}

/// What is placed elsewhere by a hand is tinted when the hand rests: every corner of the skin is looked at for it.
void MainWindow::showCoverageSoon() {
  const auto& subject = parts_->session.subject();
  const auto voxels = subject ? subject->voxels.volume() : nullptr;
  if (voxels && voxels == parts_->coverageOf.lock()) return parts_->coverageSoon.start();
  parts_->coverageOf = voxels;
  showCoverage();
}

void MainWindow::showCoverage() {
  parts_->coverageSoon.stop();
  const auto mannequin = parts_->view3d->scene().mannequin();
  if (!mannequin) return;
  if (!parts_->session.subject()) return parts_->view3d->setCoverage({});
  const bridge::SkinVertices skin = bridge::skinVerticesOf(*mannequin);
  parts_->view3d->setCoverage(coverageOfSkin(parts_->session.recorded(), skin.points_mm, skin.outward));
}

void MainWindow::connectDocument() {
  Parts& p = *parts_;
  connect(&p.document, &CaseDocument::changed, this, &MainWindow::showTitle);
  connect(&p.document, &CaseDocument::changed, this, [this] {
    if (!parts_->keepSoon.isActive()) parts_->keepSoon.start();
  });
  connect(&p.document, &CaseDocument::leaseLost, this, [this](const Error& why) { parts_->messages->showError(why, kEditing); });
  connect(&p.keepSoon, &QTimer::timeout, this, &MainWindow::keepEdits);
  connect(&p.document.history(), &QUndoStack::indexChanged, this, &MainWindow::showHistory);
  connect(p.host, &WorkstationHost::panelDocumentChanged, this, [this] {
    showHistory();
    showTitle();
  });
  connect(p.panels, &WorkspacePanels::changed, this, &MainWindow::showStage);
  connect(p.panels, &WorkspacePanels::asked, this, [this] {
    if (parts_->askedColumn && *parts_->askedColumn != Column::panels) showColumn(Column::panels);
    parts_->askedColumn = Column::panels;
  });
  connect(p.panels, &WorkspacePanels::tabsChanged, this, [this] {
    showPanels();
    showStage();
  });
}

void MainWindow::connectPages() {
  Parts& p = *parts_;
  connect(p.messages, &MessageBar::rearranged, this, &MainWindow::placeOverlays);
  connect(p.topBar, &TopBar::workspaceChosen, this, [this](const QString& id) { showWorkspace(id.toStdString()); });
  connect(p.pages, &QStackedWidget::currentChanged, this, [this] {
    if (parts_->pages->currentWidget() == parts_->startPage) fillStartPage();
    parts_->status->setIdle(parts_->pages->currentWidget() == parts_->startPage);
    parts_->replayBar->setVisible(parts_->replayBar->recording() && parts_->pages->currentWidget() == parts_->workspacePage);
    showStage();
    placeOverlays();
    showTitle();
  });
  connect(p.startPage, &StartPage::openRequested, this, &MainWindow::chooseFile);
  connect(p.startPage, &StartPage::backRequested, this, &MainWindow::backToWork);
  connect(p.startPage, &StartPage::caseChosen, this, [this](const QString& folder) {
    // What is open and on its way to be examined is not thrown away by looking for it on the page of cases.
    const auto& present = parts_->document.current();
    if (present && parts_->opener->showsCase() && present->folder == pathOf(folder)) return backToWork();
    open(folder);
  });
  connect(p.startPage, &StartPage::fileChosen, this, &MainWindow::open);
  connect(&p.jobs, &Jobs::problem, this, [this](const Error& error) { parts_->messages->showError(error); });
  connectLibrary();
}

void MainWindow::connectOpener() {
  Parts& p = *parts_;
  holdUnsavedWork();
  p.opener->askBeforeReplacing([this](const QString& next) { return mayReplaceShown(next); },
                               [this](const QString& next) { return mayReplaceScan(next); });
  new ShownSources(*this, [this] {
    std::vector<std::filesystem::path> all = parts_->opener->sources();
    for (const MadeVolume& made : parts_->made) all.push_back(pathOf(made.path));
    if (!parts_->replayed.empty()) all.push_back(parts_->replayed);
    return all;
  });
  connect(p.opener, &Opener::opened, this, [this](const QString& path) {
    remember(path);
    parts_->pages->setCurrentWidget(parts_->workspacePage);
    parts_->scanView->setFocus();
    if (const auto waiting = std::exchange(parts_->waitingRecording, {}); waiting.recording) takeRecording(waiting.path, waiting.recording);
    parts_->imported.clear();
    beginScanOfCase();
    if (const auto& current = parts_->document.current()) parts_->messages->forget(readyTopic(current->id));
    rememberOpen(path);
    if (parts_->restoring)
      restoreKeptEdits();
    else if (const auto& current = parts_->document.current())
      offerKeptEditsOf(current->folder);
    resumeIfOpen();
  });
  connect(p.opener, &Opener::preparing, this, [this](const QString& path) {
    parts_->preparing = path;
    parts_->preparation.pause();
  });
  connect(p.opener, &Opener::failed, this, [this](const Error& error) {
    const auto stopped = loadCase(pathOf(parts_->preparing));
    if (error.code == ErrorCode::cancelled && stopped) parts_->preparation.stop(stopped->id);
  });
  connect(p.opener, &Opener::ended, this, [this] {
    parts_->calibrations.clear();
    parts_->dropsEdits = false;
    parts_->waitingRecording = {};
    parts_->restoring.reset();  // what could not be opened keeps its edits
    // What a dialog asks about may still be opened.
    const bool isAsked = !parts_->resumed.empty() && parts_->resumed.front().isAsked;
    if (!isAsked && std::exchange(parts_->isResuming, false)) leaveForLater();
    if (std::exchange(parts_->preparing, {}).isEmpty()) return;
    parts_->preparation.resume();
    showPreparation();
  });
}

void MainWindow::connectImports() {
  Parts& p = *parts_;
  connect(p.opener, &Opener::sweepChosen, this, [this](const QString& path) {
    auto* dialog = new ImportDialog(path, std::exchange(parts_->calibrations, {}), parts_->jobs, *parts_->messages, this);
    connect(dialog, &ImportDialog::imported, this,
            [this, path](const ScanVoxels& voxels, const QString& title, const std::shared_ptr<const Provenance>& provenance) {
              takeMade({path, title, voxels, provenance});
            });
    dialog->open();
    resumeWithAnswersOf(*dialog, path);
  });
  connect(p.opener, &Opener::recordingOpened, this, &MainWindow::takeRecording);
  connect(p.opener, &Opener::bundleChosen, this, &MainWindow::importCase);
  const auto askAboutScreen = [this](const QString& path) {
    auto* dialog = new ScreenDialog(path, parts_->jobs, *parts_->messages, this);
    dialog->open();
    resumeWithAnswersOf(*dialog, path);
  };
  connect(p.opener, &Opener::answersNeeded, this, [this, askAboutScreen](const QString& path, FileKind kind, const QString& question) {
    if (kind == FileKind::film) return askAboutScreen(path);
    auto* dialog = new FileImportDialog(path, kind, question, parts_->jobs, *parts_->messages, this);
    connect(dialog, &FileImportDialog::imported, this, [this, path](const ScanVoxels& voxels, const QString& title) {
      takeImported({path, title, voxels, nullptr});
    });
    connect(dialog, &FileImportDialog::screenChosen, this, [askAboutScreen, path] { askAboutScreen(path); });
    connect(dialog, &FileImportDialog::sequenceSaved, parts_->opener, &Opener::sweepChosen);
    dialog->open();
    resumeWithAnswersOf(*dialog, path);
  });
}

void MainWindow::connectPreparation() {
  Parts& p = *parts_;
  connect(&p.preparation, &CasePreparation::changed, this, &MainWindow::showPreparation);
  connect(&p.preparation, &CasePreparation::prepared, this, [this](const QString& caseId) {
    parts_->details.forget();
    parts_->preparation.forget();
    readDetails();
    offerReady(caseId);
    if (const auto& shown = parts_->document.current(); shown && words(shown->id) == caseId) parts_->opener->refine();
  });
  connect(p.opener, &Opener::draftShown, this, [this] {
    const auto& shown = parts_->document.current();
    parts_->preparation.askForShown(*shown);
    if (const auto estimate = estimatePreparation(*shown))
      parts_->messages->showNote(
          tr("'%1' is shown coarsely at first and gets finer by itself, in %2.").arg(shownTitle(*shown), aboutMinutes(estimate->seconds)),
          draftTopic(shown->id));
  });
  connect(p.opener, &Opener::refined, this, [this] {
    if (const auto& shown = parts_->document.current()) parts_->messages->forget(draftTopic(shown->id));
  });
  connect(&p.preparation, &CasePreparation::failed, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(&p.preparation, &CasePreparation::noted, this, [this](const QString& note) { parts_->messages->showNote(note); });
}

void MainWindow::connectPlugins() {
  Parts& p = *parts_;
  p.host->setShownVolume([this] { return shownVolume(); });
  connect(p.host, &WorkstationHost::volumeKept, this, [this](const std::shared_ptr<const Volume>& volume) {
    auto& made = parts_->made;
    made.erase(std::remove_if(made.begin(), made.end(), [&](const MadeVolume& each) { return each.voxels.volume() == volume; }),
               made.end());
    showTitle();
  });
  p.host->setCaseSaving({[this](const std::filesystem::path& folder) { return saveCaseFor(folder); }, [this] { return makeCaseOwn(); },
                         [this] { return saveCaseCopy({}); }});
  connect(p.host, &WorkstationHost::volumeShown, this,
          [this](const std::shared_ptr<const Volume>& volume, const QString& title, const std::vector<std::filesystem::path>& madeFrom) {
            const auto mayShow = [this, title] {
              if (!mayReplaceScan(title)) return false;
              parts_->pages->setCurrentWidget(parts_->workspacePage);
              return true;
            };
            parts_->opener->openVolume(volume, title, mayShow, madeFrom);
          });
  if (const auto* application = qobject_cast<GuardedApplication*>(QCoreApplication::instance()))
    connect(application, &GuardedApplication::thrown, this, &MainWindow::showThrown);
  // Whoever asks waits for the case to be there, however long it takes: it is not prepared behind what is open.
  p.host->setOpening([this](const std::filesystem::path& folder) -> Result<void> {
    const QString path = wordsOf(folder);
    if (mayOpenPath(path)) parts_->opener->open(path);
    return {};
  });
  p.host->setScan([this]() -> std::optional<sdk::Cases::Scan> {
    const Session& session = parts_->session;
    if (!parts_->opener->showsCase() || !session.subject()) return std::nullopt;
    const Probe& probe = session.probe();
    return sdk::Cases::Scan{probe.id,
                            session.pose().probeToWorld,
                            session.depth_mm(),
                            isSector(probe.kind) ? probe.halfAngle_rad : 0.0,
                            faceHalfWidth_mm(probe),
                            session.subject()->placedGrid};
  });
}

}  // namespace ew::ui
