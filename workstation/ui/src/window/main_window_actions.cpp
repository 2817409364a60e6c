#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "ew/core/version.h"
#include "ew/library/new_case.h"
#include "keys/effect_words.h"
#include "plugins/plugins_dialog.h"
#include "start/thumbnails.h"
#include "widgets/icons.h"
#include "widgets/theme.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

bool isBelow(const QWidget* widget, const QWidget* above) {
  while (widget != nullptr && widget != above) widget = widget->parentWidget();
  return widget != nullptr;
}

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

QAction* MainWindow::addPlainAction(QMenu& menu, const QString& text, std::function<void()> run) {
  QAction* action = menu.addAction(text);
  connect(action, &QAction::triggered, this, [this, &menu, run = std::move(run)] {
    // A key of the scan does nothing while a panel's stage lies over it, whichever submenu it stands in.
    if (!parts_->staged || !isBelow(&menu, parts_->scanMenu)) run();
  });
  return action;
}

QAction* MainWindow::addMenuAction(QMenu& menu, const std::string& command, std::function<void()> run) {
  const KeyCommand* entry = parts_->keys.find(command);
  QAction* action = addPlainAction(menu, entry != nullptr ? entry->text() : QString(), std::move(run));
  parts_->keyedActions.push_back({action, command});
  return action;
}

QAction* MainWindow::addConsoleAction(QMenu& menu, const std::string& command, const QString& control, int steps) {
  return addMenuAction(menu, command, [this, control, steps] { parts_->console->step(control, steps); });
}

void MainWindow::addFileMenu(QMenu& file) {
  Parts& p = *parts_;
  p.fileMenu = &file;
  p.beforeOpening = addMenuAction(file, "open", [this] { chooseFile(); });
  addMenuAction(file, "open.folder", [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open case folder"));
    if (!folder.isEmpty()) open(folder);
  });
  addMenuAction(file, "import.case", [this] { chooseBundle(); });
  p.recentMenu = file.addMenu(tr("Open &recent"));
  p.startPageAction = addMenuAction(file, "start", [this] { showStartPage(); });
  addMenuAction(file, "search", [this] {
    if (parts_->pages->currentWidget() != parts_->startPage) showStartPage();
    parts_->startPage->focusSearch();
  });
  file.addSeparator();
  p.saveAction = addMenuAction(file, "save", [this] { save(false); });
  p.saveAsAction = addMenuAction(file, "save.as", [this] { save(true); });
  p.saveVolumeAction = addMenuAction(file, "save.volume", [this] { saveShownVolume(); });
  p.savePictureAction = addMenuAction(file, "save.picture", [this] { savePicture(); });
  addStoringMenu(file);
  file.addSeparator();
  addAccessMenu(file);
  file.addSeparator();
  addMenuAction(file, "quit", [this] { close(); });
}

void MainWindow::addEditMenu(QMenu& edit) {
  Parts& p = *parts_;
  p.undoAction = addMenuAction(edit, "undo", [this] {
    if (parts_->editsAnnotations())
      parts_->annotated.change([](annotation::AnnotationList& list) { list.undo(); });
    else if (parts_->editsCalipers())
      parts_->calipers.change([](measurement::CaliperDrawing& drawing) { drawing.undo(); });
    else if (const auto document = panelDocument())
      document->undo();
    else
      parts_->document.history().undo();
  });
  p.redoAction = addMenuAction(edit, "redo", [this] {
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
  p.exploreAction = addMenuAction(view, "workspace.explore", [this] { setWorkspace(Workspace::explore); });
  p.authorAction = addMenuAction(view, "workspace.author", [this] { setWorkspace(Workspace::author); });
  for (QAction* action : {p.exploreAction, p.authorAction}) {
    action->setCheckable(true);
    p.workspaceActions->addAction(action);
  }
  p.exploreAction->setChecked(true);
  p.beforeLooks = view.addSeparator();
  const auto look = [&](const char* command, bridge::CameraPreset preset) {
    addMenuAction(view, command, [this, preset] { parts_->view3d->showFrom(preset); });
  };
  look("look.front", bridge::CameraPreset::front);
  look("look.back", bridge::CameraPreset::back);
  look("look.right", bridge::CameraPreset::right);
  look("look.left", bridge::CameraPreset::left);
  look("look.head", bridge::CameraPreset::top);
  addMenuAction(view, "look.volume", [this] { parts_->view3d->fitToVolume(); });
  p.caseVolumeAction = addMenuAction(view, "volume.ofCase", [this] { parts_->opener->showCaseVolume(); });
  p.madeVolumeAction = addMenuAction(view, "volume.made", [this] { showWaitingVolume(); });
  view.addSeparator();
  addThemeMenu(*view.addMenu(tr("&Theme")));
  addTextSizeMenu(*view.addMenu(tr("Te&xt size")));
  addLanguageMenu(*view.addMenu(tr("La&nguage")));
  const auto column = [&](const char* command, Column which) {
    addMenuAction(view, command, [this, which] {
      if (parts_->pages->currentWidget() != parts_->workspacePage) backToWork();
      showColumn(which);
    });
  };
  column("column.panels", Column::panels);
  column("column.body", Column::body);
  column("column.console", Column::console);
  addMenuAction(view, "column.next", [this] { showNextColumn(); });
  p.scanOnlyAction = addMenuAction(view, "scanOnly", [this] {
    const bool isThere = parts_->pages->currentWidget() == parts_->workspacePage && parts_->workspace == kExplore;
    setScanOnly(isThere && !parts_->viewColumns->isScanOnly());
  });
  p.scanOnlyAction->setCheckable(true);
  addMenuAction(view, "fullScreen", [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void MainWindow::addThemeMenu(QMenu& theme) {
  Parts& p = *parts_;
  auto* themes = new QActionGroup(this);
  p.systemThemeAction = addMenuAction(theme, "theme.system", [this] { chooseTheme(QStringLiteral("system")); });
  p.darkAction = addMenuAction(theme, "theme.dark", [this] { chooseTheme(QStringLiteral("dark")); });
  p.lightAction = addMenuAction(theme, "theme.light", [this] { chooseTheme(QStringLiteral("light")); });
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
    QAction* action = addPlainAction(language, name, [this, code = code] {
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
  p.freezeAction = addMenuAction(scan, "freeze", [this] {
    ReplayBar& replay = *parts_->replayBar;
    if (!replay.recording()) return parts_->session.setFrozen(!parts_->session.isFrozen());
    replay.setPlaying(!replay.isPlaying());
    parts_->freezeAction->setChecked(false);
  });
  p.freezeAction->setCheckable(true);
  addCineMenu(*scan.addMenu(tr("&Cine loop")));
  addRecordingMenu(*scan.addMenu(tr("&Recording")));
  p.sourceAction = addMenuAction(scan, "source", [this] {
    if (parts_->pages->currentWidget() == parts_->workspacePage) {
      parts_->sourcePicker->setPicking(!parts_->sourcePicker->isPicking());
    } else {
      parts_->sourceAction->setChecked(false);
    }
  });
  p.sourceAction->setCheckable(true);
  scan.addSeparator();
  addPresetMenu(*scan.addMenu(tr("Prese&ts")));
  addConsoleMenu(*scan.addMenu(tr("C&onsole")));
  addBreathingMenu(*scan.addMenu(tr("&Breathing")));
  addMeasureMenu(*scan.addMenu(tr("Mea&sure")));
  addAnnotateMenu(*scan.addMenu(tr("&Annotate")));
  addBodyMarkMenu(*scan.addMenu(tr("Body mar&k")));
  addPicturesMenu(*scan.addMenu(tr("P&ictures")));
  scan.addSeparator();
  addMenuAction(scan, "tracker", [this] { showTracker(); });
  addMenuAction(scan, "cost", [this] { showCost(); });
}

void MainWindow::addRecordingMenu(QMenu& recording) {
  Parts& p = *parts_;
  p.recordAction = addMenuAction(recording, "record", [this] { toggleRecording(); });
  p.recordAction->setCheckable(true);
  p.markAction = addMenuAction(recording, "record.mark", [this] { parts_->recorder.addNote("mark", nullptr); });
  p.saveRecordingAction = addMenuAction(recording, "record.save", [this] { saveRecording(); });
}

/// What the console sets, for keys and for who prefers menus.
void MainWindow::addConsoleMenu(QMenu& console) {
  addConsoleAction(console, "gain.more", "gain", 1);
  addConsoleAction(console, "gain.less", "gain", -1);
  addMenuAction(console, "tgc.reset", [this] { parts_->session.resetTgc(); });
  addConsoleAction(console, "depth.more", "depth", 1);
  addConsoleAction(console, "depth.less", "depth", -1);
  addConsoleAction(console, "zoom.in", "zoom", 1);
  addConsoleAction(console, "zoom.out", "zoom", -1);
  addZoomAndWideActions(console);
  console.addSeparator();
  addImageMenu(*console.addMenu(tr("&Image")));
  addEffectsMenu(*console.addMenu(tr("&Effects")));
  addProbeMenu(*console.addMenu(tr("&Probe")));
  addTimeMenu(*console.addMenu(tr("&M-mode")));
  addQualityMenu(*console.addMenu(tr("&Quality")));
  addMenuAction(console, "console.nextPage", [this] {
    // A console that is not in front comes there first.
    if (!parts_->console->isVisible()) return showColumn(Column::console);
    parts_->console->showNextPage();
  });
}

void MainWindow::addCineMenu(QMenu& cine) {
  CineBar& bar = *parts_->cineBar;
  parts_->cineActions = {
      addMenuAction(cine, "cine.play", [&bar] { bar.setPlaying(!bar.isPlaying()); }),
      addMenuAction(cine, "cine.back", [&bar] { bar.step(-1); }),
      addMenuAction(cine, "cine.on", [&bar] { bar.step(1); }),
      addMenuAction(cine, "cine.in", [&bar] { bar.markIn(); }),
      addMenuAction(cine, "cine.out", [&bar] { bar.markOut(); }),
      addMenuAction(cine, "cine.save", [this] { saveClip(); }),
  };
}

void MainWindow::addBreathingMenu(QMenu& breathing) {
  auto* requests = new QActionGroup(this);
  const auto add = [&](const char* command, BreathingRequest request) {
    QAction* action = addMenuAction(breathing, command, [this, request] { askBreathing(request); });
    action->setCheckable(true);
    requests->addAction(action);
    if (request == BreathingRequest::free) parts_->ofRunningScan.push_back(action);
    connect(&parts_->session, &Session::breathingChanged, action,
            [this, action, request] { action->setChecked(parts_->session.breathing() == request); });
    action->setChecked(request == BreathingRequest::free);
  };
  add("breathing.free", BreathingRequest::free);
  add("breathing.in", BreathingRequest::breatheInAndHold);
  add("breathing.out", BreathingRequest::breatheOutAndHold);
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
  parts_->ofRunningScan.push_back(addConsoleAction(image, "focus.shallower", "focus", -1));
  parts_->ofRunningScan.push_back(addConsoleAction(image, "focus.deeper", "focus", 1));
  addConsoleAction(image, "focus.zones", "foci", 1);
  addConsoleAction(image, "focus.model", "focusMethod", 1);
  image.addSeparator();
  addConsoleAction(image, "range.wider", "dynamicRange", 1);
  addConsoleAction(image, "range.narrower", "dynamicRange", -1);
  addConsoleAction(image, "greyMap.next", "greyMap", 1);
  addConsoleAction(image, "edges.more", "edges", 1);
  addConsoleAction(image, "edges.less", "edges", -1);
  addConsoleAction(image, "persistence.more", "persistence", 1);
  addConsoleAction(image, "persistence.less", "persistence", -1);
  addConsoleAction(image, "compound.next", "compound", 1);
  image.addSeparator();
  addConsoleAction(image, "flip.sides", "flip", 1);
  addConsoleAction(image, "flip.upsideDown", "upsideDown", 1);
}

void MainWindow::addEffectsMenu(QMenu& effects) {
  for (const EffectInfo& effect : sceneEffects()) {
    addConsoleAction(effects, effectCommand(effect.key), ConsolePanel::switchOf(effect.key), 1);
    if (effect.option) addConsoleAction(effects, effectCommand(effect.option->key), ConsolePanel::switchOf(effect.option->key), 1);
  }
  effects.addSeparator();
  addConsoleAction(effects, "effect.planes", "planes", 1);
}

void MainWindow::addProbeMenu(QMenu& transducer) {
  parts_->transducerAction = addConsoleAction(transducer, "probe.next", "probe", 1);
  addConsoleAction(transducer, "frequency.next", "frequency", 1);
  addConsoleAction(transducer, "harmonic", "harmonic", 1);
  addConsoleAction(transducer, "steering.less", "steering", -1);
  addConsoleAction(transducer, "steering.more", "steering", 1);
  addConsoleAction(transducer, "trapezoid", "trapezoid", 1);
}

void MainWindow::addTimeMenu(QMenu& time) {
  addConsoleAction(time, "mode.next", "mode", 1);
  addConsoleAction(time, "mode.lineLeft", "mLine", -1);
  addConsoleAction(time, "mode.lineRight", "mLine", 1);
  addConsoleAction(time, "mode.slower", "sweep", 1);
  addConsoleAction(time, "mode.faster", "sweep", -1);
}

void MainWindow::addQualityMenu(QMenu& quality) {
  const auto choose = [&](const char* command, Quality chosenQuality) {
    addMenuAction(quality, command, [this, chosenQuality] { parts_->console->chooseQuality(chosenQuality); });
  };
  choose("quality.fast", Quality::weave);
  choose("quality.fine", Quality::linear);
  choose("quality.cubic", Quality::cubic);
  addConsoleAction(quality, "quality.adaptive", "adaptive", 1);
}

void MainWindow::addHelpMenu(QMenu& help) {
  addMenuAction(help, "tour", [this] { beginTour(); });
  addMenuAction(help, "keys", [this] { showKeys(); });
  addMenuAction(help, "keys.edit", [this] { editKeys(); });
  addMenuAction(help, "plugins",
                [this] { PluginsDialog(parts_->plugins ? parts_->plugins->states() : std::vector<door::PluginStatus>{}, this).exec(); });
  addMenuAction(help, "about", [this] {
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
      parts_->sourcePicker->setPicking(false);
    });
    // Beside the scan, over the 3D view, where there is room for it.
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    dialog->move(std::max(mapToGlobal(QPoint(8, 0)).x(), corner.x() - dialog->width() - 8), corner.y() + 8);
  }
  if (p.session.wide() != nullptr) {
    dialog->showNone(
        tr("A place in a wide image was seen by many images. Close it (%1), then click a point of one image.").arg(p.keys.words("wide")));
    dialog->show();
    return;
  }
  const Spans& fan = p.session.spans();
  const auto row = static_cast<std::size_t>(pixel.y());
  const bool isInFan = pixel.y() >= 0 && row < fan.size() && std::any_of(fan[row].begin(), fan[row].end(), [&](const RowSpan& run) {
                         return run.begin <= pixel.x() && pixel.x() < run.end;
                       });
  if (p.session.pictureKnobs().mode == DisplayMode::mMode) {
    dialog->showNone(
        tr("The strip of the M-mode shows one beam over time, no place in an image. Switch to B or B + M, then click a point of the "
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
           "the sweep (%1), leave 'Record source frame per voxel' switched on, and reconstruct it.")
            .arg(p.keys.words("open")));
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
  const std::optional<Case> seen = showsCase ? std::optional(shownCase(*opened, p.access)) : std::nullopt;
  p.caseInfo->showCase(seen ? &*seen : nullptr);
  if (showsCase) {
    title = words(p.isAuthor() ? opened->title : p.caseInfo->caseWords().of(titleForTrainees(*opened)));
    remark = words(opened->patient.name);
    const auto add = [&remark](const QString& more) { remark += (remark.isEmpty() ? QString() : QStringLiteral("   ")) + more; };
    // Who explores need not know whose folder a case lies in.
    if (p.document.isShippedCase() && p.isAuthor()) add(tr("shipped case"));
    if (p.document.isPublishedCase() && p.isAuthor()) add(tr("published case"));
    if (p.document.lost() && p.isAuthor()) add(tr("edited by somebody else"));
    if (p.document.hasUnsavedChanges()) add(tr("● unsaved changes"));
  }
  p.scanView->setNothing(!showsCase || !hasNoVolume(*opened) ? QString()
                         : p.isAuthor()
                             ? tr("This case has no volume yet. Choose 'Give the case a volume…' in the Case panel.")
                             : tr("This case has no volume yet, so there is nothing to scan. An author gives it one in Author."));
  const auto document = panelDocument();
  if (document != nullptr) {
    title = words(document->title());
    remark = words(document->remark());
  }
  p.topBar->setTitle(isStart ? QString() : title, isStart ? QString() : remark);
  p.saveAction->setText(document != nullptr ? tr("&Save project") : tr("&Save case"));
  p.saveAsAction->setText(document != nullptr ? tr("Save project &as…") : tr("Save case &as…"));
  const bool canSave = (document != nullptr || opened.has_value()) && p.access.may(Permission::editCases);
  p.saveAction->setEnabled(canSave);
  p.saveAsAction->setEnabled(canSave);
  p.saveVolumeAction->setEnabled(subject.has_value());
  p.savePictureAction->setEnabled(subject.has_value());
  p.storeAction->setEnabled(subject.has_value());
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
  parts_->pictures->refreshIcons();
  parts_->replayBar->refreshIcons();
  parts_->cineBar->refreshIcons();
  parts_->messages->refreshIcons();
}

}  // namespace ew::ui
