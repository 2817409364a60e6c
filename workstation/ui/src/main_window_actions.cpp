#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "effect_words.h"
#include "ew/core/version.h"
#include "icons.h"
#include "main_window_parts.h"
#include "plugins_dialog.h"
#include "theme.h"
#include "thumbnails.h"
#include "words.h"

namespace ew::ui {
namespace {

bool isBelow(const QWidget* widget, const QWidget* above) {
  while (widget != nullptr && widget != above) widget = widget->parentWidget();
  return widget != nullptr;
}

QKeySequence keys(const char* text) { return QKeySequence(QLatin1String(text)); }

}  // namespace

void MainWindow::makeActions() {
  QMenuBar& bar = parts_->topBar->menus();
  addFileMenu(*bar.addMenu(tr("&File")));
  addEditMenu(*bar.addMenu(tr("&Edit")));
  addViewMenu(*bar.addMenu(tr("&View")));
  addScanMenu(*bar.addMenu(tr("&Scan")));
  parts_->toolsMenu = bar.addMenu(tr("&Tools"));
  parts_->toolsMenu->menuAction()->setVisible(false);
  addHelpMenu(*bar.addMenu(tr("&Help")));
  showCineState();
}

QAction* MainWindow::addMenuAction(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, std::function<void()> run) {
  QAction* action = menu.addAction(text);
  action->setShortcuts(keys);
  connect(action, &QAction::triggered, this, [this, &menu, run = std::move(run)] {
    // A key of the scan does nothing while a panel's stage lies over it, whichever submenu it stands in.
    if (!parts_->staged || !isBelow(&menu, parts_->scanMenu)) run();
  });
  return action;
}

QAction* MainWindow::addConsoleAction(QMenu& menu, const QString& text, const char* key, const QString& control, int steps) {
  return addMenuAction(menu, text, *key != '\0' ? QList<QKeySequence>{keys(key)} : QList<QKeySequence>{},
                       [this, control, steps] { parts_->console->step(control, steps); });
}

void MainWindow::addFileMenu(QMenu& file) {
  Parts& p = *parts_;
  addMenuAction(file, tr("&Open…"), {QKeySequence::Open}, [this] { chooseFile(); });
  addMenuAction(file, tr("Open case &folder…"), {keys("Ctrl+Shift+O")}, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open case folder"));
    if (!folder.isEmpty()) open(folder);
  });
  p.recentMenu = file.addMenu(tr("Open &recent"));
  p.startPageAction = addMenuAction(file, tr("S&tart page"), {keys("Ctrl+H")}, [this] { showStartPage(); });
  file.addSeparator();
  p.saveAction = addMenuAction(file, tr("&Save case"), {QKeySequence::Save}, [this] { save(false); });
  p.saveAsAction = addMenuAction(file, tr("Save case &as…"), {keys("Ctrl+Shift+S")}, [this] { save(true); });
  p.saveVolumeAction = addMenuAction(file, tr("Save &volume as…"), {}, [this] { saveShownVolume(); });
  p.savePictureAction = addMenuAction(file, tr("Save &image as…"), {keys("Ctrl+P")}, [this] { savePicture(); });
  file.addSeparator();
  addMenuAction(file, tr("&Quit"), {keys("Ctrl+Q")}, [this] { close(); });
}

void MainWindow::addEditMenu(QMenu& edit) {
  Parts& p = *parts_;
  p.undoAction = addMenuAction(edit, tr("&Undo"), {keys("Ctrl+Z")}, [this] {
    if (parts_->editsAnnotations())
      parts_->annotated.change([](annotation::AnnotationList& list) { list.undo(); });
    else if (parts_->editsCalipers())
      parts_->calipers.change([](measurement::CaliperDrawing& drawing) { drawing.undo(); });
    else if (const auto document = panelDocument())
      document->undo();
    else
      parts_->document.history().undo();
  });
  p.redoAction = addMenuAction(edit, tr("&Redo"), {keys("Ctrl+Shift+Z"), keys("Ctrl+Y")}, [this] {
    if (parts_->editsAnnotations())
      parts_->annotated.change([](annotation::AnnotationList& list) { list.redo(); });
    else if (parts_->editsCalipers())
      parts_->calipers.change([](measurement::CaliperDrawing& drawing) { drawing.redo(); });
    else if (const auto document = panelDocument())
      document->redo();
    else
      parts_->document.history().redo();
  });
  p.undoAction->setEnabled(false);
  p.redoAction->setEnabled(false);
}

void MainWindow::addViewMenu(QMenu& view) {
  Parts& p = *parts_;
  p.viewMenu = &view;
  p.workspaceActions = new QActionGroup(this);
  p.exploreAction = addMenuAction(view, tr("&Explore"), {keys("Ctrl+1")}, [this] { setWorkspace(Workspace::explore); });
  p.authorAction = addMenuAction(view, tr("&Author"), {keys("Ctrl+2")}, [this] { setWorkspace(Workspace::author); });
  for (QAction* action : {p.exploreAction, p.authorAction}) {
    action->setCheckable(true);
    p.workspaceActions->addAction(action);
  }
  p.exploreAction->setChecked(true);
  p.beforeLooks = view.addSeparator();
  const auto look = [&](const QString& text, const char* key, bridge::CameraPreset preset) {
    addMenuAction(view, text, {keys(key)}, [this, preset] { parts_->view3d->showFrom(preset); });
  };
  look(tr("From the &front"), "Alt+1", bridge::CameraPreset::front);
  look(tr("From the &back"), "Alt+2", bridge::CameraPreset::back);
  look(tr("From the patient's &right"), "Alt+3", bridge::CameraPreset::right);
  look(tr("From the patient's &left"), "Alt+4", bridge::CameraPreset::left);
  look(tr("From the &head"), "Alt+5", bridge::CameraPreset::top);
  addMenuAction(view, tr("Look at the &volume"), {keys("Alt+0")}, [this] { parts_->view3d->fitToVolume(); });
  p.caseVolumeAction = addMenuAction(view, tr("Scan the &case's volume"), {}, [this] { parts_->opener->showCaseVolume(); });
  p.madeVolumeAction = addMenuAction(view, QString(), {}, [this] { showWaitingVolume(); });
  view.addSeparator();
  addThemeMenu(*view.addMenu(tr("&Theme")));
  addLanguageMenu(*view.addMenu(tr("La&nguage")));
  p.scanOnlyAction = addMenuAction(view, tr("Scan &only"), {QKeySequence(Qt::Key_F12)}, [this] {
    const bool isThere = parts_->pages->currentWidget() == parts_->workspacePage && parts_->workspace == kExplore;
    setScanOnly(isThere && !parts_->viewColumns->isScanOnly());
  });
  p.scanOnlyAction->setCheckable(true);
  addMenuAction(view, tr("F&ull screen"), {QKeySequence(Qt::Key_F11)}, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void MainWindow::addThemeMenu(QMenu& theme) {
  Parts& p = *parts_;
  auto* themes = new QActionGroup(this);
  p.systemThemeAction = addMenuAction(theme, tr("System default"), {}, [this] { chooseTheme(QStringLiteral("system")); });
  p.darkAction = addMenuAction(theme, tr("&Dark"), {}, [this] { chooseTheme(QStringLiteral("dark")); });
  p.lightAction = addMenuAction(theme, tr("L&ight"), {}, [this] { chooseTheme(QStringLiteral("light")); });
  for (QAction* action : {p.systemThemeAction, p.darkAction, p.lightAction}) {
    action->setCheckable(true);
    themes->addAction(action);
  }
}

void MainWindow::addLanguageMenu(QMenu& language) {
  auto* languages = new QActionGroup(this);
  const QString chosen = QSettings().value(QStringLiteral("language")).toString();
  const std::pair<QString, QString> offered[] = {{QString(), tr("System language")}, {"en", "English"}, {"de", "Deutsch"}};
  for (const auto& [code, name] : offered) {
    QAction* action = addMenuAction(language, name, {}, [this, code = code] {
      QSettings().setValue(QStringLiteral("language"), code);
      parts_->messages->showNote(tr("The window speaks the chosen language from the next start on. Close EchoWeave and open it again."),
                                 QStringLiteral("language"));
    });
    action->setCheckable(true);
    action->setChecked(code == chosen);
    languages->addAction(action);
  }
}

void MainWindow::addScanMenu(QMenu& scan) {
  Parts& p = *parts_;
  p.scanMenu = &scan;
  scan.setToolTipsVisible(true);
  p.freezeAction = addMenuAction(scan, tr("&Freeze"), {QKeySequence(Qt::Key_Space), QKeySequence(Qt::Key_F)}, [this] {
    ReplayBar& replay = *parts_->replayBar;
    if (!replay.recording()) return parts_->session.setFrozen(!parts_->session.isFrozen());
    replay.setPlaying(!replay.isPlaying());
    parts_->freezeAction->setChecked(false);
  });
  p.freezeAction->setCheckable(true);
  addCineMenu(*scan.addMenu(tr("&Cine loop")));
  p.recordAction = addMenuAction(scan, tr("&Record"), {keys("Ctrl+R")}, [this] { toggleRecording(); });
  p.recordAction->setCheckable(true);
  p.markAction = addMenuAction(scan, tr("Mark this moment"), {keys("K")}, [this] { parts_->recorder.addNote("mark", nullptr); });
  p.saveRecordingAction = addMenuAction(scan, tr("Save recording as…"), {keys("Ctrl+Shift+R")}, [this] { saveRecording(); });
  p.sourceAction = addMenuAction(scan, tr("Show source &frame"), {keys("I")}, [this] {
    if (parts_->pages->currentWidget() == parts_->workspacePage) {
      parts_->sourcePicker->setAsking(!parts_->sourcePicker->isAsking());
    } else {
      parts_->sourceAction->setChecked(false);
    }
  });
  p.sourceAction->setCheckable(true);
  scan.addSeparator();
  addConsoleAction(scan, tr("Deeper"), "PgDown", "depth", 1);
  addConsoleAction(scan, tr("Shallower"), "PgUp", "depth", -1);
  addConsoleAction(scan, tr("More gain"), "Ctrl+Up", "gain", 1);
  addConsoleAction(scan, tr("Less gain"), "Ctrl+Down", "gain", -1);
  addConsoleAction(scan, tr("Zoom in"), "Z", "zoom", 1);
  addConsoleAction(scan, tr("Zoom out"), "Shift+Z", "zoom", -1);
  addMenuAction(scan, tr("Reset TGC"), {keys("Ctrl+0")}, [this] { parts_->session.resetTgc(); });
  addBreathingMenu(*scan.addMenu(tr("&Breathing")));
  addMeasureMenu(*scan.addMenu(tr("Mea&sure")));
  addAnnotateMenu(*scan.addMenu(tr("&Annotate")));
  addBodyMarkMenu(*scan.addMenu(tr("Body mar&k")));
  addPresetMenu(*scan.addMenu(tr("Prese&ts")));
  scan.addSeparator();

  addImageMenu(*scan.addMenu(tr("&Image")));
  addEffectsMenu(*scan.addMenu(tr("&Effects")));
  addProbeMenu(*scan.addMenu(tr("&Probe")));
  addTimeMenu(*scan.addMenu(tr("&M-mode")));
  addQualityMenu(*scan.addMenu(tr("&Quality")));
  addMenuAction(scan, tr("Next page of the console"), {QKeySequence(Qt::Key_F10)}, [this] { parts_->console->showNextPage(); });
  scan.addSeparator();
  addMenuAction(scan, tr("&Performance…"), {keys("Ctrl+K")}, [this] { showCost(); });
}

void MainWindow::addCineMenu(QMenu& cine) {
  CineBar& bar = *parts_->cineBar;
  parts_->cineActions = {
      addMenuAction(cine, tr("Play or stop"), {keys("C")}, [&bar] { bar.setPlaying(!bar.isPlaying()); }),
      addMenuAction(cine, tr("An image back"), {keys(",")}, [&bar] { bar.step(-1); }),
      addMenuAction(cine, tr("An image on"), {keys(".")}, [&bar] { bar.step(1); }),
      addMenuAction(cine, tr("Loop from this image"), {keys("Shift+I")}, [&bar] { bar.markIn(); }),
      addMenuAction(cine, tr("Loop to this image"), {keys("Shift+O")}, [&bar] { bar.markOut(); }),
      addMenuAction(cine, tr("Save clip as…"), {}, [this] { saveClip(); }),
  };
}

void MainWindow::addBreathingMenu(QMenu& breathing) {
  auto* requests = new QActionGroup(this);
  const auto add = [&](const QString& text, const char* key, BreathingRequest request) {
    QAction* action = addMenuAction(breathing, text, {keys(key)}, [this, request] { askBreathing(request); });
    action->setCheckable(true);
    requests->addAction(action);
    if (request == BreathingRequest::free) parts_->ofRunningScan.push_back(action);
    connect(&parts_->session, &Session::breathingChanged, action,
            [this, action, request] { action->setChecked(parts_->session.breathing() == request); });
    action->setChecked(request == BreathingRequest::free);
  };
  add(tr("Breathe freely"), "C", BreathingRequest::free);
  add(tr("Breathe in and hold"), "Shift+C", BreathingRequest::breatheInAndHold);
  add(tr("Breathe out and hold"), "Ctrl+Shift+C", BreathingRequest::breatheOutAndHold);
}

void MainWindow::askBreathing(BreathingRequest request) {
  Session& session = parts_->session;
  session.askBreathing(request);
  // An action of a group checks itself, whatever came of it.
  Q_EMIT session.breathingChanged();
  if (session.subject() && !session.isPlaying())
    if (const char* why = session.whyBreathingIsNotSeen()) parts_->messages->showNote(Session::tr(why), QStringLiteral("breathing"));
}

void MainWindow::addImageMenu(QMenu& image) {
  parts_->ofRunningScan.push_back(addConsoleAction(image, tr("Focus shallower"), ",", "focus", -1));
  parts_->ofRunningScan.push_back(addConsoleAction(image, tr("Focus deeper"), ".", "focus", 1));
  addConsoleAction(image, tr("Number of focal zones"), "N", "foci", 1);
  addConsoleAction(image, tr("Next focus model"), "Shift+N", "focusMethod", 1);
  image.addSeparator();
  addConsoleAction(image, tr("Wider dynamic range"), "R", "dynamicRange", 1);
  addConsoleAction(image, tr("Narrower dynamic range"), "Shift+R", "dynamicRange", -1);
  addConsoleAction(image, tr("Next grey map"), "G", "greyMap", 1);
  addConsoleAction(image, tr("More edge enhancement"), "B", "edges", 1);
  addConsoleAction(image, tr("Less edge enhancement"), "Shift+B", "edges", -1);
  addConsoleAction(image, tr("More persistence"), "P", "persistence", 1);
  addConsoleAction(image, tr("Less persistence"), "Shift+P", "persistence", -1);
  image.addSeparator();
  addConsoleAction(image, tr("Invert left/right"), "X", "flip", 1);
  addConsoleAction(image, tr("Invert up/down"), "U", "upsideDown", 1);
}

void MainWindow::addEffectsMenu(QMenu& effects) {
  for (const EffectInfo& effect : sceneEffects()) {
    addConsoleAction(effects, effectText(effect.name), effect.keyStroke, ConsolePanel::switchOf(effect.key), 1);
    if (effect.option)
      addConsoleAction(effects, effectText(effect.option->name), effect.option->keyStroke, ConsolePanel::switchOf(effect.option->key), 1);
  }
  effects.addSeparator();
  addConsoleAction(effects, tr("Planes of the slice thickness"), "Shift+F3", "planes", 1);
}

void MainWindow::addProbeMenu(QMenu& transducer) {
  parts_->transducerAction = addConsoleAction(transducer, tr("Next transducer"), "T", "probe", 1);
  addConsoleAction(transducer, tr("Next frequency"), "H", "frequency", 1);
  addConsoleAction(transducer, tr("Steer to one side"), "J", "steering", -1);
  addConsoleAction(transducer, tr("Steer to the other side"), "L", "steering", 1);
  addConsoleAction(transducer, tr("Trapezoid"), "V", "trapezoid", 1);
}

void MainWindow::addTimeMenu(QMenu& time) {
  addConsoleAction(time, tr("B, B + M, M"), "M", "mode", 1);
  addConsoleAction(time, tr("M line to the left"), "Ctrl+Left", "mLine", -1);
  addConsoleAction(time, tr("M line to the right"), "Ctrl+Right", "mLine", 1);
  addConsoleAction(time, tr("Slower sweep"), "Y", "sweep", 1);
  addConsoleAction(time, tr("Faster sweep"), "Shift+Y", "sweep", -1);
}

void MainWindow::addQualityMenu(QMenu& quality) {
  const auto choose = [&](const QString& text, Qt::Key key, Quality chosenQuality) {
    addMenuAction(quality, text, {QKeySequence(key)}, [this, chosenQuality] { parts_->console->chooseQuality(chosenQuality); });
  };
  choose(tr("Fast: nearest voxels"), Qt::Key_1, Quality::weave);
  choose(tr("Fine: interpolated"), Qt::Key_2, Quality::linear);
  choose(tr("Cubic: sharpest"), Qt::Key_3, Quality::cubic);
  addConsoleAction(quality, tr("Adaptive: falls while the probe moves fast"), "F9", "adaptive", 1);
}

void MainWindow::addHelpMenu(QMenu& help) {
  addMenuAction(help, tr("&Keys and mouse"), {QKeySequence(Qt::Key_F1)}, [this] { showKeys(); });
  addMenuAction(help, tr("&Plugins…"), {},
                [this] { PluginsDialog(parts_->plugins ? parts_->plugins->states() : std::vector<door::PluginStatus>{}, this).exec(); });
  addMenuAction(help, tr("&About EchoWeave"), {}, [this] {
    QMessageBox about(this);
    about.setWindowTitle(tr("About EchoWeave"));
    about.setText(
        tr("EchoWeave %1\n\nA workstation for building and using ultrasound training cases. A simulation, not for diagnosis.\n\n"
           "Apache License 2.0. Slicing and console follow D. Aiger and D. Cohen-Or, Real-Time Ultrasound Imaging Simulation, 1998.")
            .arg(QLatin1String(kVersion)));
    about.exec();
  });
}

void MainWindow::showCost() {
  CostPanel* panel = parts_->cost.data();
  if (panel == nullptr) {
    panel = new CostPanel(parts_->session, parts_->jobs, this);
    panel->setAttribute(Qt::WA_DeleteOnClose);
    parts_->cost = panel;
  }
  panel->show();
  panel->raise();
  panel->activateWindow();
  if (!panel->measured()) panel->measure();
}

void MainWindow::showSource(const QPoint& pixel) {
  Parts& p = *parts_;
  const auto& subject = p.session.subject();
  if (!subject || p.session.picture().isEmpty()) return;
  SourceDialog* dialog = p.source.data();
  if (dialog == nullptr) {
    dialog = new SourceDialog(p.jobs, this);
    p.source = dialog;
    connect(dialog, &QDialog::finished, this, [this] {
      parts_->sourcePicker->clearMark();
      parts_->sourcePicker->setAsking(false);
    });
    // Beside the scan, over the 3D view, where there is room for it.
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    dialog->move(std::max(mapToGlobal(QPoint(8, 0)).x(), corner.x() - dialog->width() - 8), corner.y() + 8);
  }
  const Spans& fan = p.session.spans();
  const auto row = static_cast<std::size_t>(pixel.y());
  const bool isInFan = pixel.y() >= 0 && row < fan.size() && std::any_of(fan[row].begin(), fan[row].end(), [&](const RowSpan& run) {
                         return run.begin <= pixel.x() && pixel.x() < run.end;
                       });
  if (p.session.pictureKnobs().mode == DisplayMode::mMode) {
    dialog->showNone(
        tr("The strip of the M-mode shows one beam over time, no place in an image. Switch to B or B + M (M), then click a point of the "
           "image."));
  } else if (!isInFan) {
    dialog->showNone(tr("This point lies outside the image. Click a point inside the fan."));
  } else if (subject->provenance) {
    const Point<frame::World> at_world =
        pointShownAt(p.session.geometry(), p.session.picturePose(), {static_cast<double>(pixel.x()), static_cast<double>(pixel.y())});
    dialog->showSource(subject->provenance, voxelSourceAt(*subject->provenance, *subject->voxels.volume(), subject->placedGrid, at_world));
  } else {
    dialog->showNone(
        tr("This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open "
           "the sweep (Ctrl+O), leave 'Record source frame per voxel' switched on, and reconstruct it."));
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MainWindow::showTitle() {
  Parts& p = *parts_;
  const bool isStart = p.pages->currentWidget() == p.startPage;
  const auto& opened = p.document.current();
  const auto& subject = p.session.subject();
  const bool showsCase = opened && p.opener->showsCase();
  QString title = subject ? words(subject->title) : QString();
  QString remark;
  if (subject && !p.opener->showsCase()) remark = tr("a volume without a case");
  if (showsCase) {
    title = words(p.isAuthor() ? opened->title : titleForTrainees(*opened));
    remark = words(opened->patient.name);
    const auto add = [&remark](const QString& more) { remark += (remark.isEmpty() ? QString() : QStringLiteral("   ")) + more; };
    // Who explores need not know whose folder a case lies in.
    if (p.document.isShippedCase() && p.isAuthor()) add(tr("shipped case"));
    if (p.document.hasUnsavedChanges()) add(tr("● unsaved changes"));
  }
  p.caseInfo->showCase(showsCase ? &*opened : nullptr);
  const auto document = panelDocument();
  if (document != nullptr) {
    title = words(document->title());
    remark = words(document->remark());
  }
  p.topBar->setTitle(isStart ? QString() : title, isStart ? QString() : remark);
  p.saveAction->setText(document != nullptr ? tr("&Save project") : tr("&Save case"));
  p.saveAsAction->setText(document != nullptr ? tr("Save project &as…") : tr("Save case &as…"));
  p.saveAction->setEnabled(document != nullptr || opened.has_value());
  p.saveAsAction->setEnabled(document != nullptr || opened.has_value());
  p.saveVolumeAction->setEnabled(subject.has_value());
  p.savePictureAction->setEnabled(subject.has_value());
  p.recordAction->setEnabled(subject.has_value());
  const MadeVolume* waiting = waitingMadeVolume();
  p.madeVolumeAction->setVisible(waiting != nullptr);
  if (waiting != nullptr) p.madeVolumeAction->setText(tr("Show the volume made from %1").arg(waiting->title));
  const bool knowsSource = subject && subject->provenance;
  p.sourceAction->setEnabled(knowsSource);
  p.sourceAction->setToolTip(knowsSource ? tr("Click a point to see the recorded frame it came from")
                                         : tr("Only a volume made here from a recorded sweep knows which frame a point came from"));
  showRegion();
  p.caseVolumeAction->setVisible(opened && !p.opener->showsCase() && p.opener->hasCaseVolume());
  setWindowTitle(title.isEmpty() ? QStringLiteral("EchoWeave") : QStringLiteral("%1 - EchoWeave").arg(title));
}

void MainWindow::setDarkTheme(bool dark) { chooseTheme(dark ? QStringLiteral("dark") : QStringLiteral("light")); }

void MainWindow::chooseTheme(const QString& choice) {
  applyTheme(themeCalled(choice));
  QSettings().setValue(QStringLiteral("theme"), choice);
  refreshTheme();
}

void MainWindow::refreshTheme() {
  const bool dark = currentTheme().dark;
  const QString choice = QSettings().value(QStringLiteral("theme")).toString();
  (choice == QLatin1String("system") ? parts_->systemThemeAction : dark ? parts_->darkAction : parts_->lightAction)->setChecked(true);
  parts_->view3d->setDarkTheme(dark);
  parts_->topBar->refreshIcons();
  parts_->caseInfo->refreshIcons();
  parts_->console->refreshIcons();
  parts_->scanView->refreshIcons();
  parts_->replayBar->refreshIcons();
  parts_->cineBar->refreshIcons();
  parts_->messages->refreshIcons();
}

void MainWindow::prepareThumbnails() {
  const QSize size(544, 320);
  std::vector<Case> missing;
  for (const Case& shown : parts_->shownCases) {
    const QImage kept = keptThumbnail(shown, size);
    if (!kept.isNull()) {
      parts_->startPage->setThumbnail(shown.id, kept);
    } else if (!caseNeedsPreparation(shown)) {  // the others keep their drawn card: a start page is no reason to compute for minutes
      missing.push_back(shown);
    }
  }
  if (missing.empty()) return;
  auto pictures = std::make_shared<std::vector<std::pair<std::string, QImage>>>();
  parts_->jobs.start(
      tr("Loading thumbnails"),
      [missing, pictures, size](Progress& progress) -> Result<void> {
        const auto resources = resourceFolder();
        if (!resources) return passOn(resources.error());
        const auto probes = readProbes(*resources / "probes");
        if (!probes) return passOn(probes.error());
        for (const Case& shown : missing) {
          if (progress.cancelRequested()) break;
          auto contents = readContents(shown, progress);
          if (!contents) continue;
          pictures->emplace_back(shown.id, thumbnailOf(subjectOf(shown, *contents), *probes, size));
          keepThumbnail(shown, pictures->back().second);
        }
        return {};
      },
      [this, pictures](const Result<void>&) {
        for (const auto& [id, picture] : *pictures) parts_->startPage->setThumbnail(id, picture);
      });
}

}  // namespace ew::ui
