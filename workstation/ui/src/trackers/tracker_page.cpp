#include "trackers/tracker_page.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "scan/tracking_look.h"
#include "trackers/control/tracker_control.h"
#include "trackers/control/tracker_figures.h"
#include "trackers/tracker_forms.h"
#include "trackers/wizard/tracker_print_step.h"

namespace ew::ui {
namespace {

constexpr int kRowsInSight = 5;
constexpr int kIcon_px = 24;
constexpr int kPageWidth_px = 520;
constexpr int kMostSharePort = 65535;

QString iconOfTracker(const TrackerSettings& settings) {
  if (std::holds_alternative<IgtlSettings>(settings.source)) return QStringLiteral("tracker-network");
  if (std::holds_alternative<CameraSource>(settings.source)) return QStringLiteral("tracker-camera");
  if (std::holds_alternative<SequenceSettings>(settings.source)) return QStringLiteral("tracker-film");
  return std::get<HandControllerSettings>(settings.source).kind == HandControllerKind::spaceMouse ? QStringLiteral("tracker-knob")
                                                                                                  : QStringLiteral("tracker-gamepad");
}

bool isController(const TrackerSettings* settings) {
  return settings != nullptr && std::holds_alternative<HandControllerSettings>(settings->source);
}

/// A tracker of each kind that can be added, as it is called at first.
std::vector<TrackerSettings> newTrackers() {
  const auto named = [](const QString& name, auto source) {
    TrackerSettings made;
    made.name = name.toStdString();
    made.source = std::move(source);
    return made;
  };
  HandControllerSettings pad;
  pad.kind = HandControllerKind::gameController;
  pad.hand = gameControllerOptions();
  CameraSource camera;
  camera.camera.device = "0";  // the first one
  return {named(TrackerPage::tr("Camera"), camera), named(TrackerPage::tr("OpenIGTLink"), IgtlSettings{}),
          named(TrackerPage::tr("SpaceMouse"), HandControllerSettings{}), named(TrackerPage::tr("Game controller"), pad),
          named(TrackerPage::tr("Recording"), SequenceSettings{})};
}

}  // namespace

TrackerPage::TrackerPage(Trackers& trackers, QWidget* parent)
    : FormDialog(tr("What moves the probe"),
                 tr("The mouse, or a tracker: a camera with printed paper, a device on the network, a controller"), parent),
      trackers_(trackers) {
  setObjectName(QStringLiteral("trackerPage"));
  setWindowTitle(tr("Tracker"));
  holdLeastWidth(*this, kPageWidth_px);
  addList();
  addState();
  addTabs();
  auto* close = new QPushButton(tr("Close"));
  close->setObjectName(QStringLiteral("trackerClose"));
  close->setAutoDefault(false);
  close->setToolTip(tr("Close (Escape); the tracker goes on"));
  buttons().addWidget(close);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(&trackers_, &Trackers::listChanged, this, [this] {
    showList();
    showNow();
  });
  connect(&trackers_, &Trackers::reported, this, &TrackerPage::showNow);
  connect(&trackers_, &Trackers::fitLost, this, [this](const QString& sentence) {
    fit_->setText(QStringLiteral("! ") + sentence);
    fit_->show();
  });
  connect(&trackers_, &Trackers::fitFound, fit_, &QWidget::hide);
  showList();
  choose(trackers_.used());
  list_->setFocus();
}

void TrackerPage::addList() {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("trackerList"));
  list_->setAccessibleName(tr("What can move the probe"));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setIconSize({scaled(kIcon_px), scaled(kIcon_px)});
  row->addWidget(list_, 1);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  addListButtons(*column);
  row->addLayout(column);
  rows().addLayout(row);
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr && !isFilling_) choose(item->data(Qt::UserRole).toString().toStdString());
  });
  connect(list_, &QListWidget::itemChanged, this, &TrackerPage::takeName);
}

void TrackerPage::addListButtons(QVBoxLayout& column) {
  auto* add = new QPushButton(tr("Add"));
  add->setObjectName(QStringLiteral("trackerAdd"));
  auto* kinds = new QMenu(add);
  const std::vector<TrackerSettings> offered = newTrackers();
  for (int n = 0; n < static_cast<int>(offered.size()); ++n) {
    QAction* action =
        kinds->addAction(icon(iconOfTracker(offered[static_cast<std::size_t>(n)])), words(offered[static_cast<std::size_t>(n)].name));
    connect(action, &QAction::triggered, this, [this, n] { addTracker(n); });
  }
  add->setMenu(kinds);
  rename_ = new QPushButton(tr("Rename"));
  rename_->setObjectName(QStringLiteral("trackerRename"));
  rename_->setToolTip(tr("Gives the chosen tracker another name (F2)"));
  remove_ = new QPushButton(tr("Remove"));
  remove_->setObjectName(QStringLiteral("trackerRemove"));
  for (QPushButton* each : {add, rename_, remove_}) {
    each->setAutoDefault(false);
    column.addWidget(each);
  }
  column.addStretch(1);
  connect(rename_, &QPushButton::clicked, this, [this] {
    if (list_->currentItem() != nullptr) list_->editItem(list_->currentItem());
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    const std::string gone = chosen_;
    choose({});
    trackers_.remove(gone);
  });
}

void TrackerPage::addTracker(int kind) {
  if (trackers_.all().size() >= TrackerList::kMost) {
    QMessageBox::information(
        this, tr("Add a tracker"),
        tr("The list holds %1 trackers, as many as it can; remove one that is not used any more.").arg(TrackerList::kMost));
    return;
  }
  TrackerSettings made = newTrackers()[static_cast<std::size_t>(kind)];
  if (auto* recording = std::get_if<SequenceSettings>(&made.source)) {
    const QString file = askRecordingFile(this);
    if (file.isEmpty()) return;
    recording->file = pathOf(file);
  }
  choose(trackers_.add(std::move(made)));
}

void TrackerPage::addState() {
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  stateIcon_ = new QLabel;
  stateIcon_->setAccessibleName(tr("State"));
  holdFixedWidth(*stateIcon_, kIcon_px);
  stateWord_ = new QLabel;
  stateWord_->setObjectName(QStringLiteral("trackerState"));
  setLook(stateWord_, Look::heading);
  use_ = new QPushButton;
  use_->setObjectName(QStringLiteral("trackerUse"));
  use_->setAutoDefault(false);
  head->addWidget(stateIcon_);
  head->addWidget(stateWord_, 1);
  head->addWidget(use_);
  rows().addLayout(head);
  stateSentence_ = new QLabel;
  stateSentence_->setObjectName(QStringLiteral("trackerSentence"));
  stateSentence_->setWordWrap(true);
  stateSentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  holdLeastHeight(*stateSentence_, 54);  // three lines: nothing below jumps
  rows().addWidget(stateSentence_);
  fit_ = new QLabel;
  fit_->setObjectName(QStringLiteral("trackerFit"));
  fit_->setWordWrap(true);
  fit_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().danger.name()));
  fit_->hide();
  rows().addWidget(fit_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  setUp_ = new QPushButton(tr("Set up…"));
  setUp_->setObjectName(QStringLiteral("trackerSetUp"));
  setUp_->setToolTip(tr("Leads from the printed paper to a camera that follows the probe, step by step"));
  align_ = new QPushButton(tr("Align…"));
  align_->setObjectName(QStringLiteral("trackerAlign"));
  align_->setToolTip(tr("Tells the tracker where the mannequin lies, by touching places of it"));
  print_ = new QPushButton(tr("Print sheets…"));
  print_->setObjectName(QStringLiteral("trackerPrint"));
  print_->setToolTip(tr("Saves the paper body, its board and the chess board as PDF"));
  for (QPushButton* each : {setUp_, align_, print_}) {
    each->setAutoDefault(false);
    row->addWidget(each);
  }
  row->addStretch(1);
  rows().addLayout(row);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (chosen_.empty() || trackers_.used() == chosen_)
      trackers_.useMouse();
    else
      trackers_.use(chosen_);
  });
  connect(setUp_, &QPushButton::clicked, this, [this] { Q_EMIT setUpAsked(words(chosen_)); });
  connect(align_, &QPushButton::clicked, this, [this] { Q_EMIT alignAsked(words(chosen_)); });
  connect(print_, &QPushButton::clicked, this, &TrackerPage::printSheet);
}

void TrackerPage::addTabs() {
  tabs_ = new QTabWidget;
  tabs_->setObjectName(QStringLiteral("trackerTabs"));
  tabs_->setDocumentMode(true);
  figures_ = new TrackerFigures;
  settingsPage_ = new QWidget;
  auto* settingsRows = new QVBoxLayout(settingsPage_);
  settingsRows->setContentsMargins(0, 0, 0, 0);
  tabs_->addTab(figures_, tr("Now"));
  tabs_->addTab(settingsPage_, tr("Settings"));
  tabs_->addTab(makeSharing(), tr("Sharing and sound"));
  rows().addWidget(tabs_, 1);
  const auto chooseTool = [this](const QString& tool, std::string TrackedProbeOptions::*which) {
    const TrackerSettings* present = trackers_.find(chosen_);
    if (present == nullptr) return;
    TrackerSettings changed = *present;
    changed.probe.*which = tool.toStdString();
    trackers_.change(changed);
  };
  connect(figures_, &TrackerFigures::probeChosen, this,
          [chooseTool](const QString& tool) { chooseTool(tool, &TrackedProbeOptions::tool); });
  connect(figures_, &TrackerFigures::referenceChosen, this,
          [chooseTool](const QString& tool) { chooseTool(tool, &TrackedProbeOptions::reference); });
}

QWidget* TrackerPage::makeSharing() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 12, 0, 0);
  form->setVerticalSpacing(8);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  serves_ = new QCheckBox(tr("Send my scan to others (OpenIGTLink server)"));
  serves_->setObjectName(QStringLiteral("trackerServes"));
  serves_->setChecked(trackers_.serves());
  serves_->setToolTip(tr("Image and pose of the probe, for 3D Slicer, PLUS or another window of this program"));
  form->addRow(serves_);
  servePort_ = new QSpinBox;
  servePort_->setObjectName(QStringLiteral("trackerServePort"));
  servePort_->setAccessibleName(tr("Port"));
  servePort_->setRange(1024, kMostSharePort);
  servePort_->setValue(trackers_.servePort());
  form->addRow(tr("Port"), servePort_);
  servesNetwork_ = new QCheckBox(tr("Other computers may connect too"));
  servesNetwork_->setObjectName(QStringLiteral("trackerServesNetwork"));
  servesNetwork_->setChecked(trackers_.servesNetwork());
  servesNetwork_->setToolTip(tr("Anybody in your network can then see the scan; otherwise only programs of this computer"));
  form->addRow(servesNetwork_);
  serverSentence_ = new QLabel;
  serverSentence_->setObjectName(QStringLiteral("trackerServer"));
  serverSentence_->setWordWrap(true);
  setLook(serverSentence_, Look::quiet);
  holdLeastHeight(*serverSentence_, 36);
  form->addRow(serverSentence_);
  sounds_ = new QCheckBox(tr("Sound when the probe is lost"));
  sounds_->setObjectName(QStringLiteral("trackerSounds"));
  sounds_->setChecked(trackers_.soundsLost());
  form->addRow(sounds_);
  const auto serve = [this] {
    trackers_.serve(serves_->isChecked(), servePort_->value(), servesNetwork_->isChecked());
    showNow();
  };
  connect(serves_, &QCheckBox::toggled, this, serve);
  connect(servesNetwork_, &QCheckBox::toggled, this, serve);
  connect(servePort_, &QSpinBox::editingFinished, this, [this, serve] {
    if (servePort_->value() != trackers_.servePort()) serve();
  });
  connect(sounds_, &QCheckBox::toggled, this, [this](bool on) { trackers_.setSoundsLost(on); });
  return page;
}

void TrackerPage::choose(const std::string& tracker) {
  chosen_ = trackers_.find(tracker) != nullptr ? tracker : std::string();
  const QSignalBlocker quietly(list_);
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString().toStdString() == chosen_) list_->setCurrentRow(row);
  showSettings();
  showNow();
}

/// The mouse first: it is always there.
void TrackerPage::showList() {
  isFilling_ = true;
  list_->clear();
  auto* mouse = new QListWidgetItem(icon(QStringLiteral("tracker-mouse")), tr("Mouse and keyboard"), list_);
  mouse->setData(Qt::UserRole, QString());
  for (const TrackerSettings& each : trackers_.all()) {
    auto* item = new QListWidgetItem(icon(iconOfTracker(each)), words(each.name), list_);
    item->setData(Qt::UserRole, words(each.id));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    const std::string id = item->data(Qt::UserRole).toString().toStdString();
    QFont font = item->font();
    font.setBold(id == trackers_.used());
    item->setFont(font);
    item->setToolTip(id == trackers_.used() ? tr("moves the probe now") : QString());
    if (id == chosen_) list_->setCurrentRow(row);
  }
  const int row_px = std::max(list_->sizeHintForRow(0), scaled(kIcon_px) + 8);
  list_->setMinimumHeight(kRowsInSight * row_px + 4);
  list_->setMaximumHeight(kRowsInSight * row_px + 4);
  isFilling_ = false;
}

void TrackerPage::takeName(QListWidgetItem* item) {
  if (isFilling_) return;
  const TrackerSettings* present = trackers_.find(item->data(Qt::UserRole).toString().toStdString());
  const QString name = item->text().trimmed();
  if (present == nullptr || name.isEmpty()) return showList();
  TrackerSettings changed = *present;
  changed.name = name.toStdString();
  trackers_.change(changed);
}

void TrackerPage::showSettings() {
  if (form_ != nullptr && form_->tracker() == chosen_) return;
  delete std::exchange(form_, nullptr);
  form_ = new TrackerForm(trackers_, chosen_);
  settingsPage_->layout()->addWidget(form_);
  tabs_->setTabEnabled(1, !chosen_.empty());
  if (isVisible()) grow();
}

void TrackerPage::showNow() {
  showState();
  showButtons();
  const TrackerSettings* settings = trackers_.find(chosen_);
  const bool isTracker = settings != nullptr && !isController(settings);
  tabs_->setTabEnabled(0, isTracker);
  if (isTracker && trackers_.used() == chosen_)
    figures_->show(trackers_.report(), trackers_.deviceStatus(), settings->probe);
  else
    figures_->showNone(settings != nullptr ? settings->probe : TrackedProbeOptions{});
  serverSentence_->setText(trackers_.serverSentence());
}

void TrackerPage::showState() {
  const TrackerSettings* settings = trackers_.find(chosen_);
  const bool isUsed = trackers_.used() == chosen_;
  TrackingState state = TrackingState::off;
  QString word;
  QString sentence;
  if (chosen_.empty()) {
    if (isUsed) state = TrackingState::live;
    word = isUsed ? tr("moves the probe") : tr("rests");
    sentence =
        tr("Drag in the views, turn the wheel, or use the arrow keys. With a webcam and printed paper the probe can be held in the hand: "
           "choose a camera in the list and set it up.");
  } else if (!isUsed) {
    word = tr("not in use");
    sentence = isController(settings) ? tr("Use it, and it moves the probe over the skin.")
               : std::holds_alternative<CameraSource>(settings->source) && !trackers_.cameraOf(chosen_)->model
                   ? tr("This camera is not set up yet. 'Set up…' leads through it: print, fold, measure the lens, touch the mannequin.")
               : !trackers_.isAligned(chosen_) ? tr("Use it to see what it sends; then align it with the mannequin.")
                                               : tr("It is aligned with the mannequin and can be used.");
  } else if (isController(settings)) {
    const DeviceStatus status = trackers_.deviceStatus();
    state = status.link == LinkState::connected ? TrackingState::live : TrackingState::lost;
    word = status.link == LinkState::connected ? tr("connected") : tr("not found");
    sentence = words(status.sentence);
  } else {
    const TrackingReport report = trackers_.report();
    state = report.state;
    word = lookOf(state).word;
    if (state != TrackingState::live && report.since_s >= 1.0) word += tr(", for %1 s").arg(figure(report.since_s, 0));
    sentence = words(report.sentence);
    const DeviceStatus status = trackers_.deviceStatus();
    // What the link says may be what the probe was lost for.
    const QString ofLink = words(status.sentence);
    if (state != TrackingState::live && !sentence.contains(ofLink)) sentence = ofLink + QLatin1Char(' ') + sentence;
    if (state == TrackingState::live && !trackers_.isAligned(chosen_))
      sentence = tr("It is seen, and not yet aligned with the mannequin: 'Align…' tells it where that lies.");
  }
  const TrackingLook look = lookOf(state);
  stateIcon_->setPixmap(
      icon(chosen_.empty() ? QStringLiteral("tracker-mouse") : look.icon, look.colour).pixmap(scaled(kIcon_px), scaled(kIcon_px)));
  stateWord_->setStyleSheet(QStringLiteral("color: %1;").arg(look.colour.name()));
  if (stateWord_->text() != word) stateWord_->setText(word);
  if (stateSentence_->text() != sentence) stateSentence_->setText(sentence);
}

void TrackerPage::showButtons() {
  const TrackerSettings* settings = trackers_.find(chosen_);
  const bool isCamera = settings != nullptr && std::holds_alternative<CameraSource>(settings->source);
  const bool isUsed = trackers_.used() == chosen_;
  const bool isReady = settings != nullptr && (!isCamera || trackers_.cameraOf(chosen_)->model.has_value());
  use_->setText(isUsed && !chosen_.empty() ? tr("Stop") : tr("Use"));
  use_->setEnabled(!(chosen_.empty() && isUsed));
  use_->setToolTip(isUsed ? tr("The mouse moves the probe again") : tr("The probe follows it from now on; the scan goes on"));
  setLook(use_, Look::primary, !isUsed && (chosen_.empty() || isReady));
  setLook(setUp_, Look::primary, isCamera && !isReady);
  setUp_->setEnabled(isCamera);
  print_->setEnabled(isCamera);
  align_->setEnabled(settings != nullptr && !isController(settings));
  rename_->setEnabled(settings != nullptr);
  remove_->setEnabled(settings != nullptr);
}

void TrackerPage::printSheet() {
  bool isProblem = false;
  const QString answer =
      saveTrackerSheet(trackers_, trackers_.bodyOf(chosen_), QLocale().measurementSystem() == QLocale::ImperialUSSystem, this, &isProblem);
  if (!answer.isEmpty()) say(answer, isProblem);
}

}  // namespace ew::ui
