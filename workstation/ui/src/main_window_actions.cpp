#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

#include "ew/core/version.h"
#include "icons.h"
#include "main_window_parts.h"
#include "plugins_dialog.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

QString keysOf(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys << key.toString(QKeySequence::NativeText);
  return keys.join(QStringLiteral(", "));
}

QKeySequence keys(const char* text) { return QKeySequence(QLatin1String(text)); }

}  // namespace

void MainWindow::makeActions() {
  Parts& p = *parts_;
  QMenuBar& bar = p.topBar->menus();
  const auto add = [this](QMenu* menu, const QString& text, const QList<QKeySequence>& keys, auto&& run) {
    QAction* action = menu->addAction(text);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, run);
    return action;
  };

  QMenu* file = bar.addMenu(tr("&File"));
  add(file, tr("&Open…"), {QKeySequence::Open}, [this] { chooseFile(); });
  add(file, tr("Open case &folder…"), {keys("Ctrl+Shift+O")}, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open case folder"));
    if (!folder.isEmpty()) open(folder);
  });
  p.recentMenu = file->addMenu(tr("Open &recent"));
  p.startPageAction = add(file, tr("S&tart page"), {keys("Ctrl+H")}, [this] { showStartPage(); });
  file->addSeparator();
  p.saveAction = add(file, tr("&Save case"), {QKeySequence::Save}, [this] { save(false); });
  p.saveAsAction = add(file, tr("Save case &as…"), {keys("Ctrl+Shift+S")}, [this] { save(true); });
  p.saveVolumeAction = add(file, tr("Save &volume as…"), {}, [this] { saveShownVolume(); });
  p.savePictureAction = add(file, tr("Save &picture as…"), {keys("Ctrl+P")}, [this] { savePicture(); });
  file->addSeparator();
  add(file, tr("&Quit"), {keys("Ctrl+Q")}, [this] { close(); });

  QMenu* edit = bar.addMenu(tr("&Edit"));
  p.undoAction = add(edit, tr("&Undo"), {keys("Ctrl+Z")}, [this] {
    if (auto* document = panelDocument())
      document->undo();
    else
      parts_->document.history().undo();
  });
  p.redoAction = add(edit, tr("&Redo"), {keys("Ctrl+Shift+Z"), keys("Ctrl+Y")}, [this] {
    if (auto* document = panelDocument())
      document->redo();
    else
      parts_->document.history().redo();
  });
  p.undoAction->setEnabled(false);
  p.redoAction->setEnabled(false);

  QMenu* view = bar.addMenu(tr("&View"));
  auto* workspaces = new QActionGroup(this);
  p.exploreAction = add(view, tr("&Explore"), {keys("Ctrl+1")}, [this] { setWorkspace(Workspace::explore); });
  p.authorAction = add(view, tr("&Author"), {keys("Ctrl+2")}, [this] { setWorkspace(Workspace::author); });
  for (QAction* action : {p.exploreAction, p.authorAction}) {
    action->setCheckable(true);
    workspaces->addAction(action);
  }
  p.exploreAction->setChecked(true);
  view->addSeparator();
  const auto look = [&](const QString& text, const char* key, bridge::CameraPreset preset) {
    add(view, text, {keys(key)}, [this, preset] { parts_->view3d->showFrom(preset); });
  };
  look(tr("From the &front"), "Alt+1", bridge::CameraPreset::front);
  look(tr("From the &back"), "Alt+2", bridge::CameraPreset::back);
  look(tr("From the patient's &right"), "Alt+3", bridge::CameraPreset::right);
  look(tr("From the patient's &left"), "Alt+4", bridge::CameraPreset::left);
  look(tr("From the &head"), "Alt+5", bridge::CameraPreset::top);
  add(view, tr("Look at the &volume"), {keys("Alt+0")}, [this] { parts_->view3d->fitToVolume(); });
  p.caseVolumeAction = add(view, tr("Scan the &case's volume"), {}, [this] { parts_->opener->showCaseVolume(); });
  p.madeVolumeAction = add(view, QString(), {}, [this] { showWaitingVolume(); });
  view->addSeparator();
  auto* themes = new QActionGroup(this);
  p.darkAction = add(view, tr("&Dark"), {}, [this] { setDarkTheme(true); });
  p.lightAction = add(view, tr("L&ight"), {}, [this] { setDarkTheme(false); });
  for (QAction* action : {p.darkAction, p.lightAction}) {
    action->setCheckable(true);
    themes->addAction(action);
  }
  QMenu* language = view->addMenu(tr("La&nguage"));
  auto* languages = new QActionGroup(this);
  const QString chosen = QSettings().value(QStringLiteral("language")).toString();
  const std::pair<QString, QString> offered[] = {{QString(), tr("As the system")}, {"en", "English"}, {"de", "Deutsch"}};
  for (const auto& [code, name] : offered) {
    QAction* action = add(language, name, {}, [this, code = code] {
      QSettings().setValue(QStringLiteral("language"), code);
      parts_->messages->showNote(tr("The language changes at the next start."));
    });
    action->setCheckable(true);
    action->setChecked(code == chosen);
    languages->addAction(action);
  }
  QAction* full =
      add(view, tr("F&ull screen"), {QKeySequence(Qt::Key_F11)}, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });

  QMenu* scan = p.scanMenu = bar.addMenu(tr("&Scan"));
  p.freezeAction = add(scan, tr("&Freeze"), {QKeySequence(Qt::Key_Space), QKeySequence(Qt::Key_F)},
                       [this] { parts_->session.setFrozen(!parts_->session.isFrozen()); });
  p.freezeAction->setCheckable(true);
  p.sourceAction = add(scan, tr("Where does this &come from?"), {keys("I")}, [this] {
    if (parts_->pages->currentWidget() == parts_->workspacePage) {
      parts_->sourcePicker->setAsking(!parts_->sourcePicker->isAsking());
    } else {
      parts_->sourceAction->setChecked(false);
    }
  });
  p.sourceAction->setCheckable(true);
  scan->addSeparator();
  // Here and not on the console's controls: the console may be hidden beside an author's panels.
  const auto onConsole = [&](QMenu* menu, const QString& text, const char* key, const char* control, int steps) {
    return add(menu, text, key != nullptr ? QList<QKeySequence>{keys(key)} : QList<QKeySequence>{},
               [this, control = QString::fromLatin1(control), steps] { parts_->console->step(control, steps); });
  };
  QAction* deeper = onConsole(scan, tr("Deeper"), "PgDown", "depth", 1);
  QAction* shallower = onConsole(scan, tr("Shallower"), "PgUp", "depth", -1);
  QAction* louder = onConsole(scan, tr("More gain"), "Ctrl+Up", "gain", 1);
  QAction* quieter = onConsole(scan, tr("Less gain"), "Ctrl+Down", "gain", -1);
  QAction* closer = onConsole(scan, tr("Zoom in"), "Z", "zoom", 1);
  QAction* farther = onConsole(scan, tr("Zoom out"), "Shift+Z", "zoom", -1);
  QAction* reset = add(scan, tr("Reset DGC"), {keys("Ctrl+0")}, [this] { parts_->console->resetDgc(); });
  scan->addSeparator();

  QMenu* image = scan->addMenu(tr("&Image"));
  onConsole(image, tr("Focus shallower"), ",", "focus", -1);
  onConsole(image, tr("Focus deeper"), ".", "focus", 1);
  onConsole(image, tr("Number of foci"), "N", "foci", 1);
  onConsole(image, tr("Focus by kernel or stretch"), "Shift+N", "focusMethod", 1);
  image->addSeparator();
  onConsole(image, tr("Wider dynamic range"), "R", "dynamicRange", 1);
  onConsole(image, tr("Narrower dynamic range"), "Shift+R", "dynamicRange", -1);
  onConsole(image, tr("Next grey map"), "G", "greyMap", 1);
  onConsole(image, tr("Stronger edges"), "B", "edges", 1);
  onConsole(image, tr("Weaker edges"), "Shift+B", "edges", -1);
  onConsole(image, tr("More persistence"), "P", "persistence", 1);
  onConsole(image, tr("Less persistence"), "Shift+P", "persistence", -1);
  image->addSeparator();
  onConsole(image, tr("Swap left and right"), "X", "flip", 1);
  onConsole(image, tr("Swap top and bottom"), "U", "upsideDown", 1);

  QMenu* effects = scan->addMenu(tr("&Effects"));
  onConsole(effects, tr("Beam width and focus"), "F2", "focusStrengthEffect", 1);
  onConsole(effects, tr("Slice thickness"), "F3", "sliceThicknessEffect", 1);
  onConsole(effects, tr("Planes of the slice thickness"), "Shift+F3", "planes", 1);
  onConsole(effects, tr("Shadow and enhancement"), "F4", "attenuationEffect", 1);
  onConsole(effects, tr("Reverberation"), "F5", "reverberationEffect", 1);
  onConsole(effects, tr("Mirror images"), "F6", "mirror", 1);
  onConsole(effects, tr("Electronic noise"), "F7", "noiseEffect", 1);
  onConsole(effects, tr("Skin contact"), "F8", "contactGelEffect", 1);

  QMenu* transducer = scan->addMenu(tr("&Probe"));
  onConsole(transducer, tr("Next transducer"), "T", "probe", 1);
  onConsole(transducer, tr("Next frequency"), "H", "frequency", 1);
  onConsole(transducer, tr("Steer to one side"), "J", "steering", -1);
  onConsole(transducer, tr("Steer to the other side"), "L", "steering", 1);
  onConsole(transducer, tr("Trapezoid"), "V", "trapezoid", 1);

  QMenu* time = scan->addMenu(tr("&M-mode"));
  onConsole(time, tr("B, B + M, M"), "M", "mode", 1);
  onConsole(time, tr("M line to the left"), "Ctrl+Left", "mLine", -1);
  onConsole(time, tr("M line to the right"), "Ctrl+Right", "mLine", 1);
  onConsole(time, tr("Slower sweep"), "Y", "sweep", 1);
  onConsole(time, tr("Faster sweep"), "Shift+Y", "sweep", -1);

  QMenu* quality = scan->addMenu(tr("&Quality"));
  const auto choose = [&](const QString& text, Qt::Key key, Quality chosenQuality) {
    add(quality, text, {QKeySequence(key)}, [this, chosenQuality] { parts_->console->chooseQuality(chosenQuality); });
  };
  choose(tr("Weave: nearest voxels, fastest"), Qt::Key_1, Quality::weave);
  choose(tr("Linear: interpolated"), Qt::Key_2, Quality::linear);
  choose(tr("Cubic: sharpest"), Qt::Key_3, Quality::cubic);
  onConsole(quality, tr("Adaptive: falls while the probe moves fast"), "F9", "adaptive", 1);
  add(scan, tr("Next page of the console"), {QKeySequence(Qt::Key_F10)}, [this] { parts_->console->showNextPage(); });
  scan->addSeparator();
  add(scan, tr("&Cost of accuracy…"), {keys("Ctrl+K")}, [this] { showCost(); });

  QMenu* help = bar.addMenu(tr("&Help"));
  QAction* shortcuts = add(help, tr("&Keys and mouse"), {QKeySequence(Qt::Key_F1)}, [this] {
    if (parts_->shortcuts) {
      parts_->shortcuts->close();
    } else {
      auto groups = parts_->keys;
      for (const sdk::StagedPanel* panel : parts_->host->panelsAdded()) {
        if (panel->keys.empty()) continue;
        ShortcutsOverlay::Group group{words(panel->title), {}};
        for (const auto& [key, what] : panel->keys) group.lines.push_back({words(key), words(what)});
        // Of a stage the panel's own keys come first, the probe's are of no use.
        if (parts_->staged) {
          groups = {group, groups.back()};
          break;
        }
        groups.push_back(std::move(group));
      }
      parts_->shortcuts = new ShortcutsOverlay(groups, parts_->central);
    }
  });
  add(help, tr("&Plugins…"), {},
      [this] { PluginsDialog(parts_->plugins ? parts_->plugins->states() : std::vector<door::PluginStatus>{}, this).exec(); });
  add(help, tr("&About EchoWeave"), {}, [this] {
    QMessageBox about(this);
    about.setWindowTitle(tr("About EchoWeave"));
    about.setText(
        tr("EchoWeave %1\n\nA workstation for building and using ultrasound training cases. A simulation, not for diagnosis.\n\n"
           "Apache License 2.0. Slicing and console follow D. Aiger and D. Cohen-Or, Real-Time Ultrasound Imaging Simulation, 1998.")
            .arg(QLatin1String(kVersion)));
    about.exec();
  });

  p.keys = {{tr("Probe"),
             {{tr("Drag"), tr("slide over the skin")},
              {tr("Wheel"), tr("tilt")},
              {tr("Shift + wheel"), tr("rock")},
              {tr("Ctrl + wheel"), tr("rotate")},
              {tr("Arrows"), tr("slide by 2 mm, with Shift 10 mm")},
              {QStringLiteral("Q, E"), tr("rotate")},
              {QStringLiteral("A, D"), tr("rock")},
              {QStringLiteral("W, S"), tr("tilt")},
              {tr("Home"), tr("back to the start")}}},
            {tr("3D view"),
             {{tr("Right drag"), tr("turn the body")},
              {tr("Middle drag"), tr("move the body")},
              {tr("Ctrl + right drag"), tr("closer, farther")},
              {QStringLiteral("Alt+1 … Alt+5"), tr("front, back, right, left, head")},
              {QStringLiteral("Alt+0"), tr("look at the volume")}}},
            {tr("Console"),
             {{keysOf(*p.freezeAction), tr("freeze")},
              {keysOf(*shallower) + QStringLiteral(", ") + keysOf(*deeper), tr("depth")},
              {keysOf(*louder) + QStringLiteral(", ") + keysOf(*quieter), tr("gain")},
              {keysOf(*closer) + QStringLiteral(", ") + keysOf(*farther), tr("zoom")},
              {keysOf(*reset), tr("reset DGC")},
              {QStringLiteral("1, 2, 3"), tr("weave, linear, cubic")},
              {QStringLiteral("F9"), tr("adaptive quality")},
              {QStringLiteral("F10"), tr("next page of the console")},
              {QStringLiteral("Ctrl+K"), tr("cost of accuracy")}}},
            {tr("Image"),
             {{QStringLiteral(", ."), tr("focus depth")},
              {QStringLiteral("N, Shift+N"), tr("number of foci, kernel or stretch")},
              {QStringLiteral("R, Shift+R"), tr("dynamic range")},
              {QStringLiteral("G"), tr("grey map")},
              {QStringLiteral("B, Shift+B"), tr("edges")},
              {QStringLiteral("P, Shift+P"), tr("persistence")},
              {QStringLiteral("X, U"), tr("swap left and right, top and bottom")},
              {tr("I, Alt + click"), tr("which frame a point came from")},
              {QStringLiteral("M"), tr("B, B + M, M")},
              {QStringLiteral("Ctrl+Left, Ctrl+Right"), tr("M line")},
              {QStringLiteral("Y, Shift+Y"), tr("sweep of the M-mode")}}},
            {tr("Effects and probe"),
             {{QStringLiteral("F2, F3"), tr("beam width, slice thickness")},
              {QStringLiteral("F4"), tr("shadow and enhancement")},
              {QStringLiteral("F5, F6"), tr("reverberation, mirror images")},
              {QStringLiteral("F7, F8"), tr("noise, skin contact")},
              {QStringLiteral("T, H"), tr("next transducer, next frequency")},
              {QStringLiteral("J, L, V"), tr("steer a linear array, trapezoid")}}},
            {tr("Window"),
             {{QStringLiteral("Ctrl+O"), tr("open a case, a volume or a sweep")},
              {QStringLiteral("Ctrl+S, Ctrl+Shift+S"), tr("save the case, save it elsewhere")},
              {QStringLiteral("Ctrl+Z, Ctrl+Shift+Z"), tr("undo, redo")},
              {QStringLiteral("Ctrl+1, Ctrl+2"), tr("Explore, Author")},
              {keysOf(*full), tr("full screen")},
              {keysOf(*shortcuts), tr("this page")}}}};
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
  if (!subject || p.session.picture().width == 0) return;
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
        tr("The strip of the M-mode shows one beam over time, no place in a picture. Switch to B or B + M (M), then click a "
           "point of the picture."));
  } else if (!isInFan) {
    dialog->showNone(tr("This point lies beside the image. Click a point inside the fan."));
  } else if (subject->provenance) {
    const Point<frame::World> at_world =
        pointShownAt(p.session.geometry(), p.session.picturePose(), {static_cast<double>(pixel.x()), static_cast<double>(pixel.y())});
    dialog->showSource(subject->provenance, voxelSourceAt(*subject->provenance, *subject->volume, subject->placedGrid, at_world));
  } else {
    dialog->showNone(
        tr("This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open "
           "the sweep (Ctrl+O), leave 'Keep which frame each voxel came from' switched on, and make the volume."));
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
  QString title = subject ? subject->title : QString();
  QString remark;
  if (subject && !p.opener->showsCase()) remark = tr("a volume without a case");
  if (opened && p.opener->showsCase()) {
    if (!opened->patient.name.empty()) remark = words(opened->patient.name);
    // Who explores need not know whose folder a case lies in.
    const bool isShipped = p.document.isShippedCase() && p.workspace == Workspace::author;
    if (isShipped) remark = tr("shipped case");
    if (p.document.hasUnsavedChanges()) remark = isShipped ? tr("shipped case, not saved") : tr("not saved");
  }
  const sdk::PanelDocument* document = panelDocument();
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
  const MadeVolume* waiting = waitingMadeVolume();
  p.madeVolumeAction->setVisible(waiting != nullptr);
  if (waiting != nullptr) p.madeVolumeAction->setText(tr("Show the volume made from %1").arg(waiting->title));
  p.caseVolumeAction->setVisible(opened && !p.opener->showsCase() && p.opener->hasCaseVolume());
  setWindowTitle(title.isEmpty() ? QStringLiteral("EchoWeave") : QStringLiteral("%1 - EchoWeave").arg(title));
}

void MainWindow::setDarkTheme(bool dark) {
  applyTheme(dark ? darkTheme() : lightTheme());
  QSettings().setValue(QStringLiteral("theme"), dark ? QStringLiteral("dark") : QStringLiteral("light"));
  refreshTheme();
}

void MainWindow::refreshTheme() {
  const bool dark = currentTheme().dark;
  parts_->darkAction->setChecked(dark);
  parts_->lightAction->setChecked(!dark);
  parts_->view3d->setDarkTheme(dark);
  parts_->console->refreshIcons();
  parts_->scanView->refreshIcons();
  parts_->messages->refreshIcons();
}

void MainWindow::openPlugins() {
  Parts& p = *parts_;
  if (p.plugins) return;
  p.plugins.emplace();
  p.plugins->openAll(*p.host, [this](const door::PluginFault& fault) {
    const QString pattern = QCoreApplication::translate("ew::door::PluginFault", door::patternOf(fault));
    parts_->messages->showError(words(door::filled(pattern.toStdString(), fault)));
  });
  for (const door::PluginStatus& plugin : p.plugins->states()) {
    if (plugin.state != door::PluginState::loaded && plugin.state != door::PluginState::replaced)
      p.messages->showError(words(plugin.sentence));
  }
}

void MainWindow::showThrown(const QObject* receiver, const Thrown& thrown) {
  Parts& p = *parts_;
  if (p.plugins && p.plugins->tellOfPanel(WorkstationHost::panelOf(receiver), thrown)) return;
  p.messages->showError(
      thrown.noMemory ? tr("There is not enough memory for this; close other programs and try again.")
                      : tr("The program met a problem that it did not foresee (%1). Your work is still there: save it, and please report "
                           "this with what you did.")
                            .arg(words(thrown.reason)));
}

void MainWindow::prepareThumbnails() {
  auto pictures = std::make_shared<std::vector<std::pair<std::string, QImage>>>();
  parts_->jobs.start(
      tr("Preparing the cards"),
      [cases = parts_->shownCases, pictures](Progress& progress) -> Result<void> {
        const auto resources = resourceFolder();
        if (!resources) return passOn(resources.error());
        const auto probes = readProbes(*resources / "probes");
        if (!probes) return passOn(probes.error());
        for (const Case& shown : cases) {
          // A case that is not prepared yet keeps its drawn card: a start page is no reason to compute for minutes.
          if (progress.cancelRequested() || caseNeedsPreparation(shown)) continue;
          auto echo = loadCaseVolume(shown, progress);
          if (echo) pictures->emplace_back(shown.id, thumbnailOf(shown, echo->volume, *probes, QSize(544, 320)));
        }
        return {};
      },
      [this, pictures](const Result<void>&) {
        for (const auto& [id, picture] : *pictures) parts_->startPage->setThumbnail(id, picture);
      });
}

}  // namespace ew::ui
