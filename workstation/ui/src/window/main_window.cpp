#include "ew/ui/main_window.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "body/body_aids.h"
#include "body/host_overlays.h"
#include "case/case_folder_dialog.h"
#include "ew/core/ending.h"
#include "ew/library/new_case.h"
#include "images/picture_buttons.h"
#include "keys/key_tips.h"
#include "plugins/host_scan.h"
#include "widgets/theme.h"
#include "widgets/time_line_access.h"
#include "widgets/window_layout.h"
#include "widgets/words.h"
#include "window/column_tabs.h"
#include "window/main_window_parts.h"

/// A static library's resources are known to Qt once this has run; outside of any namespace, as the macro demands.
static void initResources() { Q_INIT_RESOURCE(icons); }

namespace ew::ui {
namespace {

constexpr int kHandle_px = 7;     ///< wide enough to be seen and taken
constexpr int kComeBack_px = 20;  ///< what leads from the scan alone to the other columns
constexpr int kPanelWidth_px = 400;
constexpr int kExplorePanelWidth_px = 304;  ///< beside a scan that is worked with, which wants the room
constexpr int kStagedPanelWidth_px = 296;   ///< beside a stage, which has columns of its own

/// The probes and the mannequins of the program.
sdk::Cases::Choices choicesForCases(const std::vector<Probe>& probes, const std::filesystem::path& mannequins) {
  sdk::Cases::Choices choices;
  for (const Probe& probe : probes) choices.probes.emplace_back(probe.id, probe.name);
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(mannequins, ignored))
    if (hasEnding(entry.path(), ".json")) choices.mannequins.push_back(entry.path().filename().string());
  std::sort(choices.mannequins.begin(), choices.mannequins.end());
  return choices;
}

/// ... with the presets, the user's own as well, the body marks, and where cases are kept, in the window's language.
sdk::Cases::Choices withConsole(sdk::Cases::Choices choices, const std::vector<Preset>& presets,
                                const std::vector<const annotation::BodyMark*>& marks) {
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

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), parts_(std::make_unique<Parts>()) {
  initResources();
  setWindowTitle(QStringLiteral("EchoWeave"));
  setAcceptDrops(true);
  setMinimumSize(1024, 640);
  rememberSystemTheme();
  const QSettings settings;
  describePaintedWidgets();
  qApp->installEventFilter(&parts_->focusKeys);
  setTextSize(keptTextSize_percent());
  applyTheme(themeCalled(settings.value(QStringLiteral("theme"), QStringLiteral("dark")).toString()));
  makeViews();
  makeActions();
  connectFocusKeys();
  connectParts();
  connectKeys();
  refreshTheme();
  const QSize room = QGuiApplication::primaryScreen()->availableSize();
  const FirstSize first = firstSizeOn(room.width(), room.height());
  resize(first.width_px, first.height_px);
  if (first.isMaximised) setWindowState(Qt::WindowMaximized);
  restoreGeometry(settings.value(QStringLiteral("window")).toByteArray());

  auto resources = resourceFolder();
  if (!resources) {
    parts_->messages->showError(resources.error());
  } else {
    auto probes = readProbes(*resources / "probes");
    if (probes) {
      parts_->host->setChoices([this, choices = choicesForCases(*probes, *resources / "mannequin")] {
        return withConsole(choices, parts_->presets, parts_->bodyMark.offered());
      });
      parts_->session.setProbes(std::move(*probes));
    } else {
      parts_->messages->showError(probes.error());
    }
    if (auto packages = measurement::readPackages(*resources / "measurements"))
      parts_->worksheets.setPackages(std::move(*packages));
    else
      parts_->messages->showError(packages.error());
    readAnnotationData(*resources);
    parts_->opener->loadDefaultMannequin();
  }
  showRecent();
  showTitle();
  showAccess();
}

MainWindow::~MainWindow() {
  // Work first, then panels (their code lives in plugins), then the plugins, then what the host handed them.
  parts_->preparation.disconnect();
  parts_->preparation.pause();
  parts_->library.disconnect();
  parts_->details.disconnect();
  parts_->startPage->disconnect();
  parts_->jobs.cancelAllAndWait();
  // An undo history that is destroyed says that it is empty; nobody is left to show it.
  parts_->document.history().disconnect();
  parts_->host->disconnect();
  QCoreApplication::instance()->disconnect(this);
  parts_->panels->disconnect(this);
  parts_->document.disconnect();
  parts_->wide.disconnect();
  parts_->calipers.disconnect();
  parts_->worksheets.disconnect();
  parts_->annotated.disconnect();
  parts_->bodyMark.disconnect();
  parts_->trackers.disconnect();
  parts_->session.disconnect();
  parts_->keys.disconnect();
  parts_->surface.disconnect();
  delete parts_->keysDialog;
  delete parts_->trackerWizard;
  delete parts_->trackerPage;
  delete parts_->cost;
  delete parts_->source;
  delete parts_->worksheet;
  delete parts_->stages;
  parts_->stages = nullptr;
  parts_->panels->clear();
  parts_->plugins.reset();
  delete takeCentralWidget();
}

void MainWindow::makeViews() {
  Parts& p = *parts_;
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
  p.pictures = new PictureGrid({p.session, p.calipers, p.annotated, p.bodyMark, p.jobs, *p.scanView});
  p.console = new ConsolePanel(p.session);
  holdFixedWidth(*p.console, kConsoleWidth_px);
  p.measurePage = new MeasurePage(p.session, p.calipers, p.worksheets);
  p.console->addPage(p.measurePage, tr("Measure"), tipWithKeys(tr("Calipers, and what they measured (%1)"), "console.nextPage"));
  p.console->addBelow(new PictureButtons(*p.pictures));
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
  p.work->addWidget(p.columns, 1);
  p.work->addWidget(p.console);
  makeColumnHandles();
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

/// What leads to columns that are not seen: tabs where they take turns, an edge to press where the scan is alone.
void MainWindow::makeColumnHandles() {
  Parts& p = *parts_;
  const std::pair<Column, QWidget*> columns[] = {{Column::panels, p.panels}, {Column::body, p.body}, {Column::console, p.console}};
  for (const auto& [column, widget] : columns) {
    auto* tabs = new ColumnTabs;
    static_cast<QVBoxLayout*>(widget->layout())->insertWidget(0, tabs);
    connect(tabs, &ColumnTabs::asked, this, [this](Column which) {
      // Later: the bar that was pressed is hidden by it.
      QMetaObject::invokeMethod(
          this, [this, which] { showColumn(which); }, Qt::QueuedConnection);
    });
    p.columnTabs.emplace_back(column, tabs);
  }
  p.comeBack = new QPushButton(QStringLiteral("\u25c2"));
  p.comeBack->setObjectName(QStringLiteral("showColumns"));
  p.comeBack->setAccessibleName(tr("Show the console and the other columns"));
  p.comeBack->setToolTip(tipWithKeys(tr("Show the console and the other columns (%1)"), "scanOnly"));
  p.comeBack->setFocusPolicy(Qt::TabFocus);
  p.comeBack->setProperty("edge", true);
  p.comeBack->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  holdFixedWidth(*p.comeBack, kComeBack_px);
  p.comeBack->hide();
  connect(p.comeBack, &QPushButton::clicked, this, [this] { setScanOnly(false); });
  p.work->addWidget(p.comeBack);
}

/// The panels of plugins.
void MainWindow::makePanelColumn() {
  Parts& p = *parts_;
  p.panels = new WorkspacePanels;
  p.panels->setTabsWidth(kPanelWidth_px);
  static_cast<void>(p.panels->of(kAuthor));  // there to be filled, and seen while nothing fills it
  p.panels->hide();
}

void MainWindow::makeColumns() {
  Parts& p = *parts_;
  p.columns = new QSplitter(Qt::Horizontal);
  p.columns->setHandleWidth(kHandle_px);
  p.columns->setChildrenCollapsible(false);
  p.columns->addWidget(p.panels);
  p.columns->addWidget(p.body);
  p.columns->addWidget(p.pictures);
  p.stages = new QStackedWidget;
  p.stages->setObjectName(QStringLiteral("stages"));
  p.stages->hide();
  p.columns->addWidget(p.stages);
  p.columns->setStretchFactor(0, 0);
  p.columns->setStretchFactor(1, 1);
  p.columns->setStretchFactor(2, 1);
  p.columns->setStretchFactor(3, 1);
}

/// What looks at the events of the views. The order counts: who comes later sees an event first.
void MainWindow::watchViews() {
  Parts& p = *parts_;
  p.hand.watch(p.view3d);
  p.hand.watch(p.scanView, [this] {
    const double mm = parts_->scanView->mmPerWidgetPixel();
    return parts_->session.geometry().markerLeft ? -mm : mm;
  });
  p.cineBar->watch(p.scanView, p.view3d->canvas());  // after the hand: a frozen scan is stepped through, and the probe rests
  new ScanPan(p.session, *p.scanView);               // after the hand: in a zoomed image it takes the drag; the view owns it
  p.viewColumns = new ViewColumns(*p.columns, *p.panels, *p.body, *p.pictures, *p.view3d->canvas(), this);
  p.viewColumns->watch(*p.scanView);
  p.viewColumns->onPress = [this] { parts_->beforePress = parts_->session.hold(); };
  p.viewColumns->takeBackPress = [this] { parts_->session.setHold(parts_->beforePress); };
  p.caliperLayer = new CaliperLayer(p.session, p.calipers, *p.scanView);
  p.stripCaliperLayer = new CaliperLayer(p.session, p.calipers, *p.scanView, Where::strip);
  p.annotationLayer = new AnnotationLayer(p.session, p.annotated, *p.scanView);
  p.annotationLayer->watch(p.caliperLayer, [this] { return parts_->calipers.drawing().tool().has_value(); });
  p.bodyMarkView = new BodyMarkView(p.bodyMark, *p.scanView);
  new WideLayer(p.session, p.wide, *p.scanView);
  new ZoomOverview(p.session, *p.scanView);
  p.boxZoom = new BoxZoom(p.session, *p.scanView);
  p.pictures->setMarkView(*p.bodyMarkView);
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
  p.scanView->paintOver = [this, &overlays](QPainter& painter) {
    overlays.paintOverScan(painter, [this](const Point<frame::Probe>& at) { return parts_->scanView->positionOf(at); });
  };
  connect(&overlays, &HostOverlays::scanChanged, p.scanView, QOverload<>::of(&QWidget::update));
  p.bodyTools = new BodyTools(overlays, *p.view3d, this);  // after the hand: it looks at a press first
  connect(&overlays, &HostOverlays::bodyChanged, this, &MainWindow::paintOverBody);
  connect(p.bodyTools, &BodyTools::overChanged, this, &MainWindow::paintOverBody);
}

void MainWindow::paintOverBody() {
  const HostOverlays& overlays = parts_->host->hostOverlays();
  if (!overlays.isBodyDrawnOver() && !parts_->bodyTools->isDrawnOver()) return parts_->view3d->setOver({});
  parts_->view3d->setOver([this, &overlays](QPainter& painter) {
    overlays.paintOverBody(painter, [this](const Point<frame::World>& at) { return parts_->view3d->pixelOf(at.at); });
    parts_->bodyTools->paintOver(painter);
  });
}

void MainWindow::showPicture() {
  Parts& p = *parts_;
  if (!p.session.subject() || p.session.picture().isEmpty()) return;
  const Knobs& knobs = p.session.wide() != nullptr ? p.session.shownState().knobs : p.session.pictureKnobs();
  p.view3d->setProbe(p.session.pictureProbe(), p.session.fanGeometry().depth_mm, knobs);
  p.view3d->setPose(p.session.picturePose());
  p.view3d->setFanImage(p.session.fanPicture(), p.session.fanGeometry());
  p.view3d->setProbeVisible(true);
}

void MainWindow::showStartPage() {
  if (parts_->pages->currentWidget() == parts_->startPage) return fillStartPage();
  parts_->pages->setCurrentWidget(parts_->startPage);
}

void MainWindow::backToWork() {
  parts_->pages->setCurrentWidget(parts_->workspacePage);
  parts_->scanView->setFocus();
}

void MainWindow::setWorkspace(Workspace workspace) { showWorkspace(workspace == Workspace::author ? kAuthor : kExplore); }

void MainWindow::showWorkspace(const std::string& id) {
  Parts& p = *parts_;
  const auto own = std::find_if(p.ownWorkspaces.begin(), p.ownWorkspaces.end(), [&](const auto& each) { return each.what.id == id; });
  if (id != kExplore && id != kAuthor && own == p.ownWorkspaces.end()) return;
  if (id != kExplore && !may(Permission::editCases)) return;
  p.workspace = id;
  const bool author = p.isAuthor();
  p.topBar->setWorkspace(words(id));
  (own != p.ownWorkspaces.end() ? own->action : author ? p.authorAction : p.exploreAction)->setChecked(true);
  for (const auto& tool : p.tools) tool.action->setEnabled(tool.workspace.empty() || tool.workspace == id);
  if (id != kExplore) setScanOnly(false);
  p.preparation.hold(author);  // nothing that nobody asked for beside an author's own work
  showPanels();
  p.status->setForAuthors(author);
  p.startPage->setForAuthors(author);
  showRecent();
  showStage();
  // Scanning needs something to scan; authoring may begin with nothing.
  const bool needsSubject = !author && p.keepsScan() && !(p.document.current() && p.opener->showsCase());
  p.pages->setCurrentWidget(needsSubject && !p.session.subject() ? static_cast<QWidget*>(p.startPage) : p.workspacePage);
  placeOverlays();
  showTitle();
}

void MainWindow::showPanels() {
  parts_->panels->show(parts_->workspace);
  showColumns();
}

bool MainWindow::Parts::hasPanels() const { return isAuthor() || panels->has(workspace); }

LayoutRequest MainWindow::layoutRequest() const {
  const Parts& p = *parts_;
  LayoutRequest asked;
  asked.width_px = width();
  asked.height_px = height() - p.topBar->height() - p.status->height();
  asked.textScale = textSize_percent() / 100.0;
  asked.hasPanels = p.hasPanels();
  asked.hasBody = p.keepsBody();
  asked.hasScan = p.keepsScan();
  asked.hasConsole = p.ownWorkspace() == nullptr || p.ownWorkspace()->keepsConsole;
  asked.panel_px = p.staged ? kStagedPanelWidth_px : p.workspace == kExplore ? kExplorePanelWidth_px : kPanelWidth_px;
  asked.isForScanning = p.workspace == kExplore;
  asked.isStaged = p.staged;
  asked.isScanOnly = p.viewColumns->isScanOnly();
  asked.front = p.askedColumn;
  return asked;
}

void MainWindow::showColumns() {
  Parts& p = *parts_;
  const WindowLayout layout = layoutOf(layoutRequest());
  const bool showsScan = !p.staged && p.keepsScan();
  const std::pair<QWidget*, bool> columns[] = {
      {p.panels, layout.showsPanels}, {p.body, layout.showsBody}, {p.console, layout.showsConsole}, {p.pictures, showsScan}};
  // What goes goes first: the window must not be asked for more room than it has.
  for (const auto& [column, isShown] : columns)
    if (!isShown) column->hide();
  p.panels->setTabsWidth(layout.panel_px);
  p.console->setFixedWidth(layout.console_px);
  p.console->setShort(layout.isConsoleShort);
  const int side = layout.isConsoleAtLeft ? 0 : 1;
  if (p.work->indexOf(p.console) != side) {
    p.work->removeWidget(p.console);
    p.work->insertWidget(side, p.console);
    p.console->setProperty("atLeft", layout.isConsoleAtLeft);
    p.console->style()->unpolish(p.console);
    p.console->style()->polish(p.console);
  }
  for (const auto& [column, isShown] : columns)
    if (isShown) column->show();
  p.comeBack->setVisible(p.viewColumns->isScanOnly() && !p.staged);
  showColumnTabs(layout);
  p.viewColumns->follow(layout, showsScan, p.staged);
  placeOverlays();
}

void MainWindow::showColumnTabs(const WindowLayout& layout) {
  Parts& p = *parts_;
  p.panels->setSharesColumn(layout.tabs.size() > 1);
  const QString only = p.panels->titleOfOnly();
  std::vector<ColumnTabs::Tab> tabs;
  for (const Column each : layout.tabs) {
    switch (each) {
      case Column::panels:
        tabs.push_back({each,
                        !only.isEmpty() ? only
                        : p.isAuthor()  ? p.authorAction->text().remove(QLatin1Char('&'))
                                        : tr("Panels"),
                        tr("What is worked through or edited")});
        break;
      case Column::body:
        tabs.push_back({each, tr("Body"), tr("The probe on the body, and what is known of the case")});
        break;
      case Column::console:
        tabs.push_back({each, tr("Console"), tr("Gain, depth, transducer, freeze, measure")});
        break;
    }
  }
  // A column that takes no turns has nothing to lead to.
  for (const auto& [column, bar] : p.columnTabs) {
    const bool takesTurns = std::find(layout.tabs.begin(), layout.tabs.end(), column) != layout.tabs.end();
    bar->showTabs(takesTurns ? tabs : std::vector<ColumnTabs::Tab>(), layout.front);
  }
}

void MainWindow::showColumn(Column column) {
  Parts& p = *parts_;
  p.askedColumn = column;
  p.viewColumns->setScanOnly(false);
  p.scanOnlyAction->setChecked(false);
  showColumns();
}

void MainWindow::showNextColumn() {
  const WindowLayout layout = layoutOf(layoutRequest());
  if (layout.tabs.size() < 2) return;
  const auto at = std::find(layout.tabs.begin(), layout.tabs.end(), layout.front);
  showColumn(at + 1 != layout.tabs.end() ? *(at + 1) : layout.tabs.front());
}

const sdk::Workspace* MainWindow::Parts::ownWorkspace() const {
  const auto own = std::find_if(ownWorkspaces.begin(), ownWorkspaces.end(), [this](const auto& each) { return each.what.id == workspace; });
  return own != ownWorkspaces.end() ? &own->what : nullptr;
}

void MainWindow::showStage() {
  Parts& p = *parts_;
  const bool staged = p.hasPanels() && p.pages->currentWidget() == p.workspacePage && p.host->hasStageInFront();
  QWidget* stage = staged ? p.host->stageInFront(p.stages) : nullptr;
  if (stage != nullptr) {
    if (p.stages->indexOf(stage) < 0) p.stages->addWidget(stage);
    p.stages->setCurrentWidget(stage);
  }
  const bool was = std::exchange(p.staged, stage != nullptr);
  if (p.scanMenu != nullptr) p.scanMenu->menuAction()->setEnabled(!p.staged);  // its keys are those of a scan that is not seen
  if (was != p.staged) {
    p.stages->setVisible(p.staged);
    p.status->setStaged(p.staged);
  }
  showColumns();
  showHistory();
  showTitle();
}

void MainWindow::setScanOnly(bool scanOnly) {
  Parts& p = *parts_;
  p.scanOnlyAction->setChecked(scanOnly);
  if (scanOnly == p.viewColumns->isScanOnly()) return;
  p.viewColumns->setScanOnly(scanOnly);
  showColumns();
}

std::shared_ptr<sdk::PanelDocument> MainWindow::panelDocument() const {
  return parts_->staged && parts_->host != nullptr ? parts_->host->documentInFront() : nullptr;
}

void MainWindow::showHistory() {
  Parts& p = *parts_;
  const QUndoStack& history = p.document.history();
  const auto document = panelDocument();
  QString undo = document != nullptr ? words(document->undoText()) : history.canUndo() ? history.undoText() : QString();
  QString redo = document != nullptr ? words(document->redoText()) : history.canRedo() ? history.redoText() : QString();
  bool canUndo = document != nullptr ? !undo.isEmpty() : history.canUndo();
  bool canRedo = document != nullptr ? !redo.isEmpty() : history.canRedo();
  if (p.editsAnnotations()) {
    canUndo = p.annotated.list().canUndo();
    canRedo = p.annotated.list().canRedo();
    undo = canUndo ? tr("writing on the image") : QString();
    redo = canRedo ? tr("writing on the image") : QString();
  } else if (p.editsCalipers()) {
    canUndo = p.calipers.drawing().canUndo();
    canRedo = p.calipers.drawing().canRedo();
    undo = canUndo ? tr("measuring") : QString();
    redo = canRedo ? tr("measuring") : QString();
  }
  p.undoAction->setEnabled(canUndo);
  p.redoAction->setEnabled(canRedo);
  p.undoAction->setText(undo.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undo));
  p.redoAction->setText(redo.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redo));
  p.status->setEdit(undo.isEmpty() ? QString() : tr("Undo: %1 (%2)").arg(undo, p.keys.words("undo")));
  p.status->setNote(document != nullptr ? words(document->note()) : QString());
}

/// A message lies over the scan's line of words, which is no image, or at the foot of what is shown in place of the scan.
void MainWindow::placeOverlays() {
  Parts& p = *parts_;
  const bool isOverScan = p.pages->currentWidget() == p.workspacePage && p.pictures->isVisibleTo(p.pages);
  QWidget* below = isOverScan                                   ? static_cast<QWidget*>(p.pictures)
                   : p.staged && p.stages->isVisibleTo(p.pages) ? static_cast<QWidget*>(p.stages)
                                                                : p.pages;
  QRect room(below->mapTo(p.central, QPoint(0, 0)), below->size());
  // Of more than one line it would lie on the button above the sliders.
  if (isOverScan)
    for (const auto* reset : p.pictures->findChildren<QPushButton*>(QStringLiteral("dgcReset")))
      if (reset->isVisible()) room.setLeft(std::max(room.left(), reset->mapTo(p.central, QPoint(reset->width(), 0)).x() + 8));
  const int height_px = std::min(p.messages->heightFor(room.width()), room.height());
  p.messages->setGeometry(room.left(), isOverScan ? room.top() : room.bottom() + 1 - height_px, room.width(), height_px);
  p.messages->raise();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  showColumns();
  centralWidget()->layout()->activate();
  placeOverlays();
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  placeOverlays();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  const auto file = std::find_if(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
  if (file == urls.end()) return;
  event->acceptProposedAction();
  QStringList files, calibrations;
  for (const QUrl& each : urls) {
    const QString path = each.toLocalFile();
    if (path.isEmpty()) continue;
    (path.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive) ? calibrations : files) << path;
  }
  if (files.isEmpty()) files.swap(calibrations);
  if (files.size() > 1) parts_->messages->showNote(tr("Several files were dropped; the first one is opened."));
  // After the drop has ended: a question must not keep the program the file came from waiting.
  QMetaObject::invokeMethod(
      this,
      [this, path = files.first(), calibrations] {
        open(path);
        // Afterwards: an opening that gives way to this one ends, and takes what was dropped with it along. A bundle, or a case that is
        // made behind what is open, is no opening, and its calibrations must not go to the next sweep.
        parts_->calibrations = parts_->opener->isOpening(path) ? calibrations : QStringList();
      },
      Qt::QueuedConnection);
}

bool MainWindow::doKeyInScan(QKeyEvent& event) {
  Parts& p = *parts_;
  if (p.staged || p.pages->currentWidget() != p.workspacePage) return false;
  return p.cineBar->handleKey(event) || (p.session.subject() && p.hand.handleKey(event));
}

/// Whoever clicks beside the scan goes on scanning: keys of the probe are not lost to a panel, a slider or a tab.
void MainWindow::connectFocusKeys() {
  Parts& p = *parts_;
  p.focusKeys.isBesideScan = [this](const QWidget& widget) {
    const Parts& parts = *parts_;
    const QWidget* places[] = {parts.panels, parts.console, parts.caseInfo, parts.topBar, parts.messages};
    return !parts.staged && parts.workspace == kExplore && parts.pages->currentWidget() == parts.workspacePage &&
           std::any_of(std::begin(places), std::end(places),
                       [&](const QWidget* place) { return place == &widget || place->isAncestorOf(&widget); });
  };
  p.focusKeys.doInScan = [this](QKeyEvent& key) { return doKeyInScan(key); };
  p.focusKeys.backToScan = [this] { parts_->scanView->setFocus(Qt::MouseFocusReason); };
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && parts_->tour != nullptr) return parts_->tour->leave();
  if (event->key() == Qt::Key_Escape && parts_->wide.state() == WideScan::State::growing) return parts_->wide.cancel();
  // Before any message goes: the one that tells to press it is a message itself.
  if (event->key() == Qt::Key_Escape && parts_->session.isFollowing() && parts_->pages->currentWidget() == parts_->workspacePage)
    return parts_->host->hostScan().takeProbeBack();
  if (event->key() == Qt::Key_Escape && parts_->messages->count() > 0) {
    parts_->messages->dismiss();
    return;
  }
  if (event->key() == Qt::Key_Escape && parts_->pages->currentWidget() == parts_->startPage && parts_->session.subject()) {
    backToWork();
    return;
  }
  if (event->key() == Qt::Key_Escape && parts_->replayBar->recording() && parts_->pages->currentWidget() == parts_->workspacePage) {
    if (mayLeaveRecording({})) closeRecording();
    return;
  }
  if (event->key() == Qt::Key_Escape && parts_->viewColumns->isScanOnly()) {
    setScanOnly(false);
    return;
  }
  // The keys that move the probe work wherever the focus is, unless a field wants them.
  if (doKeyInScan(*event)) return;
  QMainWindow::keyPressEvent(event);
}

bool MainWindow::isSettled() const {
  const Parts& p = *parts_;
  if (p.jobs.isRunning() || p.opener->isBusy()) return false;
  if (p.pages->currentWidget() == p.startPage) return !p.library.isRefreshing() && !p.details.isBusy() && !p.learning.isBusy();
  if (p.staged) return true;
  if (p.document.current() && p.opener->showsCase() && hasNoVolume(*p.document.current())) return true;
  return p.session.subject() && !p.session.picture().isEmpty();
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
StoredExamination& MainWindow::stored() { return parts_->stored; }
AnnotatedPictures& MainWindow::annotated() { return parts_->annotated; }
ShownMark& MainWindow::bodyMark() { return parts_->bodyMark; }
PictureGrid& MainWindow::pictures() { return *parts_->pictures; }
ReplayBar& MainWindow::replayBar() { return *parts_->replayBar; }
CineBar& MainWindow::cineBar() { return *parts_->cineBar; }

}  // namespace ew::ui
