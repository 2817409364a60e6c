#include "ew/ui/main_window.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "body/body_aids.h"
#include "body/host_overlays.h"
#include "case/case_folder_dialog.h"
#include "ew/body/body_canvas.h"
#include "ew/core/ending.h"
#include "ew/library/new_case.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "images/image_buttons.h"
#include "jobs/saving_dialog.h"
#include "plugins/host_scan.h"
#include "scan/zoom/scan_pan.h"
#include "scan/zoom/wide_layer.h"
#include "scan/zoom/zoom_overview.h"
#include "window/features/annotating.h"
#include "window/features/body_and_probe.h"
#include "window/features/case_saving.h"
#include "window/features/help.h"
#include "window/features/opening.h"
#include "window/features/plugin_hosting.h"
#include "window/features/preparing.h"
#include "window/features/presets.h"
#include "window/features/recording.h"
#include "window/features/resuming.h"
#include "window/frame/appearance.h"
#include "window/frame/columns.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"
#include "window/layout/window_layout.h"
#include "window/menus.h"

namespace ew::ui {
namespace {

constexpr int kHandle_px = 7;  ///< wide enough to be seen and taken

/// The probes and the mannequins of the program.
sdk::Cases::Choices choicesForCases(const std::vector<Probe>& probes, const std::filesystem::path& mannequins) {
  sdk::Cases::Choices choices;
  for (const Probe& probe : probes) choices.probes.emplace_back(probe.id, probe.name);
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(mannequins, ignored))
    if (hasEnding(entry.path(), ".json")) choices.mannequins.emplace_back(entry.path().filename().string(), entry.path().stem().string());
  std::sort(choices.mannequins.begin(), choices.mannequins.end());
  return choices;
}

/// What the program's own mannequins are called; any other is called as its file.
QString mannequinName(const std::pair<std::string, std::string>& fileAndStem) {
  const std::array<std::pair<std::string_view, QString>, 4> own{{{"adult.json", MainWindow::tr("Adult")},
                                                                 {"adult-arms-up.json", MainWindow::tr("Adult, hands behind the head")},
                                                                 {"gravid.json", MainWindow::tr("Adult, 21st week of pregnancy")},
                                                                 {"neck-extended.json", MainWindow::tr("Adult, neck stretched")}}};
  for (const auto& [file, name] : own)
    if (file == fileAndStem.first) return name;
  return QString::fromStdString(fileAndStem.second);
}

/// ... with the presets, the user's own as well, the body marks, and where cases are kept, in the window's language.
sdk::Cases::Choices withConsole(sdk::Cases::Choices choices, const std::vector<Preset>& presets,
                                const std::vector<const annotation::BodyMark*>& marks) {
  for (auto& mannequin : choices.mannequins) mannequin.second = mannequinName(mannequin).toStdString();
  const OwnPresets own = readOwnPresets(ownPresetsFolder());
  for (const std::vector<Preset>* all : {&presets, &own.presets})
    for (const Preset& preset : *all) {
      const auto probe =
          std::find_if(choices.probes.begin(), choices.probes.end(), [&](const auto& each) { return each.first == preset.probe; });
      choices.presets.emplace_back(
          preset.id, words(preset.title).toStdString() + ", " + (probe != choices.probes.end() ? probe->second : preset.probe));
    }
  std::set<std::string> regions;
  for (const annotation::BodyMark* mark : marks) {
    choices.bodyMarks.emplace_back(mark->id, words(mark->title).toStdString());
    regions.insert(mark->regions.begin(), mark->regions.end());
  }
  choices.regions.assign(regions.begin(), regions.end());
  choices.ownCases = CaseFolderDialog::library();
  return choices;
}

/// What comes with the program: probes, measurements, words, presets, the mannequin.
void readResources(WindowParts& p) {
  const auto resources = resourceFolder();
  if (!resources) return p.messages->showError(resources.error());
  if (auto probes = readProbes(*resources / "probes")) {
    p.host->setChoices([&p, choices = choicesForCases(*probes, *resources / "mannequin")] {
      return withConsole(choices, p.presets->all(), p.bodyMark.offered());
    });
    p.session.console().setProbes(std::move(*probes));
  } else {
    p.messages->showError(probes.error());
  }
  if (auto packages = measurement::readPackages(*resources / "measurements"))
    p.worksheets.setPackages(std::move(*packages));
  else
    p.messages->showError(packages.error());
  p.annotating->readData(*resources);
  p.presets->readData(*resources);
  p.opener->loadDefaultMannequin();
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), parts_(std::make_unique<WindowParts>(*this)) {
  setWindowTitle(QStringLiteral("EchoWeave"));
  setAcceptDrops(true);
  setMinimumSize(1024, 640);
  qApp->installEventFilter(&parts_->focusKeys);
  Appearance::begin();
  makeViews();
  fillMenus(*parts_);
  parts_->connectFeatures();
  parts_->restyle();
  const QSize room = QGuiApplication::primaryScreen()->availableSize();
  const FirstSize first = firstSizeOn(room.width(), room.height());
  resize(first.width_px, first.height_px);
  if (first.isMaximised) setWindowState(Qt::WindowMaximized);
  restoreGeometry(QSettings().value(QStringLiteral("window")).toByteArray());
  readResources(*parts_);
  parts_->refresh();
}

MainWindow::~MainWindow() {
  WindowParts& p = *parts_;
  // Work first, then panels (their code lives in plugins), then the plugins, then what the host handed them: the features, and the views.
  p.preparation.disconnect();
  p.preparation.pause();
  p.library.disconnect();
  p.details.disconnect();
  p.recent.disconnect();
  p.startPage->disconnect();
  p.jobs.cancelAllAndWait();
  p.host->disconnect();
  p.stopHearing(*QCoreApplication::instance());
  p.stopHearing(*p.panels);
  p.document.disconnect();
  p.wide.disconnect();
  p.calipers.disconnect();
  p.worksheets.disconnect();
  p.annotated.disconnect();
  p.bodyMark.disconnect();
  p.trackers.disconnect();
  p.session.disconnect();
  p.keys.disconnect();
  p.surface.disconnect();
  delete p.stages;
  p.stages = nullptr;
  p.panels->clear();
  p.plugins.reset();
  p.deleteFeatures();
  delete takeCentralWidget();
}

void MainWindow::makeViews() {
  WindowParts& p = *parts_;
  p.central = new QWidget;
  setCentralWidget(p.central);
  auto* rows = new QVBoxLayout(p.central);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  p.topBar = new TopBar;
  p.startPage = new StartPage;
  p.view3d = new View3D;
  p.view3d->setMinimumWidth(200);
  p.caseInfo = new CaseInfo;
  p.body = new BodyColumn(p.view3d, p.caseInfo);
  p.scanView = new ScanView(p.session);
  p.imageGrid = new ImageGrid({p.session, p.calipers, p.annotated, p.bodyMark, p.jobs, *p.scanView});
  p.console = new ConsolePanel(p.session);
  holdFixedWidth(*p.console, kConsoleWidth_px);
  p.measurePage = new MeasurePage(p.session, p.calipers, p.worksheets);
  p.console->addPage(p.measurePage, tr("Measure"), tipWithKeys(tr("Calipers, and what they measured (%1)"), "console.nextPage"));
  p.console->addBelow(new ImageButtons(*p.imageGrid));
  p.replayBar = new ReplayBar(p.session);
  p.status = new StatusLine(p.session);
  p.cineBar = new CineBar(p.session);
  p.status->takeCine(p.cineBar);
  p.jobsLine = new JobsLine(p.jobs);
  p.status->takeJobs(p.jobsLine);
  makePanelColumn();
  makeColumns();
  p.workspacePage = new QWidget;
  p.work = new QHBoxLayout(p.workspacePage);
  p.work->setContentsMargins(0, 0, 0, 0);
  p.work->setSpacing(0);
  p.work->addWidget(p.columnSplitter, 1);
  p.work->addWidget(p.console);
  p.columns->makeHandles();
  p.pages = new QStackedWidget;
  p.pages->addWidget(p.workspacePage);
  p.pages->addWidget(p.startPage);
  rows->addWidget(p.topBar);
  rows->addWidget(p.pages, 1);
  rows->addWidget(p.replayBar);
  rows->addWidget(p.status);

  p.messages = new MessageBar(p.central);  // over the views, so that nothing moves under somebody's finger when it comes
  watchViews();
}

/// The panels of plugins.
void MainWindow::makePanelColumn() {
  WindowParts& p = *parts_;
  p.panels = new WorkspacePanels;
  p.panels->setTabsWidth(kPanelWidth_px);
  static_cast<void>(p.panels->of(kAuthor));  // there to be filled, and seen while nothing fills it
  p.panels->hide();
}

void MainWindow::makeColumns() {
  WindowParts& p = *parts_;
  p.columnSplitter = new QSplitter(Qt::Horizontal);
  p.columnSplitter->setHandleWidth(kHandle_px);
  p.columnSplitter->setChildrenCollapsible(false);
  p.columnSplitter->addWidget(p.panels);
  p.columnSplitter->addWidget(p.body);
  p.columnSplitter->addWidget(p.imageGrid);
  p.stages = new QStackedWidget;
  p.stages->setObjectName(QStringLiteral("stages"));
  p.stages->hide();
  p.columnSplitter->addWidget(p.stages);
  p.columnSplitter->setStretchFactor(0, 0);
  p.columnSplitter->setStretchFactor(1, 1);
  p.columnSplitter->setStretchFactor(2, 1);
  p.columnSplitter->setStretchFactor(3, 1);
}

/// What looks at the events of the views. The order counts: who comes later sees an event first.
void MainWindow::watchViews() {
  WindowParts& p = *parts_;
  p.hand.watch(p.view3d);
  p.hand.watch(p.scanView, [&p] {
    const double mm = p.scanView->mmPerWidgetPixel();
    return p.session.geometry().markerLeft ? -mm : mm;
  });
  p.cineBar->watch(p.scanView, p.view3d->canvas());  // after the hand: a frozen scan is stepped through, and the probe rests
  new ScanPan(p.session, *p.scanView);               // after the hand: in a zoomed image it takes the drag; the view owns it
  p.viewColumns = new ViewColumns(*p.columnSplitter, *p.panels, *p.body, *p.imageGrid, *p.view3d->canvas(), this);
  p.viewColumns->watch(*p.scanView);
  const auto beforePress = std::make_shared<Hold>();  // where the probe was before the last press in a view
  p.viewColumns->onPress = [&p, beforePress] { *beforePress = p.session.probeControl().hold(); };
  p.viewColumns->takeBackPress = [&p, beforePress] { p.session.probeControl().setHold(*beforePress); };
  p.caliperLayer = new CaliperLayer(p.session, p.calipers, *p.scanView);
  p.stripCaliperLayer = new CaliperLayer(p.session, p.calipers, *p.scanView, Where::strip);
  p.annotationLayer = new AnnotationLayer(p.session, p.annotated, *p.scanView);
  p.annotationLayer->watch(p.caliperLayer, [&p] { return p.calipers.drawing().tool().has_value(); });
  p.bodyMarkView = new BodyMarkView(p.bodyMark, *p.scanView);
  new WideLayer(p.session, p.wide, *p.scanView);
  new ZoomOverview(p.session, *p.scanView);
  p.boxZoom = new BoxZoom(p.session, *p.scanView);
  p.imageGrid->setMarkView(*p.bodyMarkView);
  p.sourcePicker = new SourcePicker(p.session, *p.scanView);  // after the hand: it looks at a click first
  p.opener = new Opener(p.session, p.document, p.jobs, *p.messages, *p.view3d, p.hand, this);
  p.host = new WorkstationHost(p.document, p.jobs, p.session, *p.panels, *p.messages, this);
  p.host->setAccess(p.access);
  HostOverlays& overlays = p.host->hostOverlays();
  new BodyAidsView(overlays, p.session, *p.view3d, p.jobs, this);
  p.pointing = new PickLayer(p.session, *p.scanView);
  p.pointing->setObjectName(QStringLiteral("pointing"));
  p.pointing->setAccessibleName(tr("Point at a structure"));
  p.host->hostScan().setPointing(*p.pointing);
  p.host->hostScan().setCalipers(p.calipers);
  p.scanView->paintOver = [&p, &overlays](QPainter& painter) {
    overlays.paintOverScan(painter, [&p](const Point<frame::Probe>& at) { return p.scanView->positionOf(at); });
  };
  connect(&overlays, &HostOverlays::scanChanged, p.scanView, QOverload<>::of(&QWidget::update));
  p.bodyTools = new BodyTools(overlays, *p.view3d, this);  // after the hand: it looks at a press first
}

void MainWindow::open(const QString& path) { parts_->opening->open(path); }
void MainWindow::openLesson(const QString& folder, const QString& lessonId) { parts_->opening->openLesson(folder, lessonId); }
void MainWindow::openDefaultCase() { parts_->opening->openDefaultCase(); }
void MainWindow::openWhereOneWas() { parts_->opening->openWhereOneWas(); }
void MainWindow::offerKeptEdits() { parts_->caseSaving->offerKeptEdits({}); }
void MainWindow::offerUnsavedWork() { parts_->resuming->offer(); }
void MainWindow::showStartPage() { parts_->workspaces->showStartPage(); }
void MainWindow::prepareCases() { parts_->preparing->begin(); }
void MainWindow::setWorkspace(Workspace workspace) { showWorkspace(workspace == Workspace::author ? kAuthor : kExplore); }
void MainWindow::showWorkspace(const std::string& id) { parts_->workspaces->show(id); }
void MainWindow::setDarkTheme(bool dark) { parts_->appearance->chooseTheme(dark ? QStringLiteral("dark") : QStringLiteral("light")); }
void MainWindow::openPlugins() { parts_->pluginHosting->open(); }
void MainWindow::offerTour() { parts_->help->offerTour(); }

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  parts_->columns->show();
  centralWidget()->layout()->activate();
  parts_->columns->placeMessages();
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  parts_->columns->placeMessages();
}

bool MainWindow::mayClose() {
  if (!parts_->unsaved.mayLose(Loss::closing, {})) return false;
  const auto outcome = SavingDialog(parts_->jobs, true, this).wait();
  return outcome == SavingDialog::Outcome::saved || outcome == SavingDialog::Outcome::lose;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose()) {
    event->ignore();
    return;
  }
  QSettings().setValue(QStringLiteral("window"), saveGeometry());
  parts_->opening->rememberClosing();
  parts_->preparation.pause();  // what it has made is kept; the next start goes on from there
  parts_->jobs.cancelAllAndWait();
  parts_->caseSaving->forgetEdits();  // the user has decided
  parts_->autosave.forget();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (std::none_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) return;
  event->acceptProposedAction();
  QStringList paths;
  for (const QUrl& each : urls) paths << each.toLocalFile();
  parts_->opening->openDropped(paths);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const WindowParts& p = *parts_;
  const bool isEscape = event->key() == Qt::Key_Escape;
  if (isEscape && p.help->leaveTour()) return;
  if (isEscape && p.wide.state() == WideScan::State::growing) return parts_->wide.cancel();
  // Before any message goes: the one that tells to press it is a message itself.
  if (isEscape && p.session.probeControl().isFollowing() && p.workspaces->isAtWork()) return p.host->hostScan().takeProbeBack();
  if (isEscape && p.messages->count() > 0) {
    p.messages->dismiss();
    return;
  }
  if (isEscape && p.workspaces->isAtStart() && p.session.subject()) {
    p.workspaces->backToWork();
    return;
  }
  if (isEscape && p.replayBar->recording() && p.workspaces->isAtWork()) {
    if (p.recording->mayLeave({})) p.recording->close();
    return;
  }
  if (isEscape && p.columns->isScanOnly()) {
    p.columns->setScanOnly(false);
    return;
  }
  // The keys that move the probe work wherever the focus is, unless a field wants them.
  if (p.bodyAndProbe->doKey(*event)) return;
  QMainWindow::keyPressEvent(event);
}

bool MainWindow::isSettled() const {
  const WindowParts& p = *parts_;
  if (p.jobs.isRunning() || p.opener->isBusy()) return false;
  if (p.workspaces->isAtStart()) return !p.library.isRefreshing() && !p.details.isBusy() && !p.learning.isBusy() && !p.recent.isBusy();
  if (p.workspaces->isStaged()) return !BodyCanvas::isAnyDrawing(*this);
  if (p.document.current() && p.opener->showsCase() && hasNoVolume(*p.document.current())) return true;
  return p.session.subject() && !p.session.image().isEmpty();
}

Session& MainWindow::session() { return parts_->session; }
CaseDocument& MainWindow::document() { return parts_->document; }
Jobs& MainWindow::jobs() { return parts_->jobs; }
MessageBar& MainWindow::messages() { return *parts_->messages; }
ScanView& MainWindow::scanView() { return *parts_->scanView; }
View3D& MainWindow::view3d() { return *parts_->view3d; }
HandInput& MainWindow::hand() { return parts_->hand; }
ConsolePanel& MainWindow::console() { return *parts_->console; }
Recorder& MainWindow::recorder() { return parts_->recorder; }
WideScan& MainWindow::wideScan() { return parts_->wide; }
Calipers& MainWindow::calipers() { return parts_->calipers; }
Worksheets& MainWindow::worksheets() { return parts_->worksheets; }
ExaminationStore& MainWindow::stored() { return parts_->stored; }
ImageAnnotations& MainWindow::annotated() { return parts_->annotated; }
ImageBodyMark& MainWindow::bodyMark() { return parts_->bodyMark; }
ImageGrid& MainWindow::images() { return *parts_->imageGrid; }
ReplayBar& MainWindow::replayBar() { return *parts_->replayBar; }
CineBar& MainWindow::cineBar() { return *parts_->cineBar; }
KeyMap& MainWindow::keys() { return parts_->keys; }
ControlSurface& MainWindow::surface() { return parts_->surface; }
Trackers& MainWindow::trackers() { return parts_->trackers; }

}  // namespace ew::ui
