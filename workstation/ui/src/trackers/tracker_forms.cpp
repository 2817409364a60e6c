#include "trackers/tracker_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/ellipsis_label.h"
#include "ew/widgets/look.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/control/tracker_figures.h"

namespace ew::ui {
namespace {

constexpr int kMostPort = 65535;
/// How fast a controller pushed all the way moves the probe, against its usual speed.
constexpr double kSlowest = 0.2;
constexpr double kFastest = 3.0;

QComboBox* addChoice(QFormLayout& form, const QString& name, const char* objectName) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(objectName));
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(14);
  form.addRow(name, box);
  return box;
}

/// A film by its name, a camera that is not there by its number, the first is 1.
QString shownDevice(const QString& device) {
  bool isNumber = false;
  const int number = device.toInt(&isNumber);
  return isNumber ? TrackerForm::tr("Camera %1").arg(number + 1) : QFileInfo(device).fileName();
}

/// A line with the name of a file and a button that asks for another one.
QPushButton* addFile(QFormLayout& form, const QString& name, const QString& shown, const QString& none, const char* objectName) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* label = new EllipsisLabel;
  label->setText(shown.isEmpty() ? none : shown);
  label->setToolTip(shown);
  auto* choose = new QPushButton(TrackerForm::tr("Choose…"));
  choose->setObjectName(QLatin1String(objectName));
  choose->setAccessibleName(TrackerForm::tr("Choose: %1").arg(name));
  choose->setAutoDefault(false);
  row->addWidget(label, 1);
  row->addWidget(choose);
  form.addRow(name, row);
  return choose;
}

}  // namespace

QString askRecordingFile(QWidget* parent) {
  return QFileDialog::getOpenFileName(parent, TrackerForm::tr("Recording of a tracker"), {},
                                      TrackerForm::tr("Sequences of PLUS (*.mha *.mhd *.nrrd);;All files (*)"));
}

TrackerForm::TrackerForm(Trackers& trackers, std::string tracker, QWidget* parent)
    : QWidget(parent), trackers_(trackers), tracker_(std::move(tracker)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 12, 0, 0);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(8);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  const TrackerSettings* settings = trackers_.find(tracker_);
  if (settings == nullptr) return;
  if (const auto* network = std::get_if<IgtlSettings>(&settings->source)) addNetwork(*form, *network);
  if (const auto* camera = std::get_if<CameraSource>(&settings->source)) addCamera(*form, *camera);
  if (const auto* recording = std::get_if<SequenceSettings>(&settings->source)) addRecording(*form, *recording);
  if (const auto* controller = std::get_if<HandControllerSettings>(&settings->source))
    addController(*form, *controller);
  else
    addFollowing(*form, settings->probe);
}

template <class Source>
void TrackerForm::changeSource(const std::function<void(Source&)>& apply) {
  const TrackerSettings* present = trackers_.find(tracker_);
  if (present == nullptr || !std::holds_alternative<Source>(present->source)) return;
  TrackerSettings changed = *present;
  apply(std::get<Source>(changed.source));
  trackers_.change(changed);
}

void TrackerForm::addNetwork(QFormLayout& form, const IgtlSettings& settings) {
  auto* host = new QLineEdit(words(settings.host));
  host->setObjectName(QStringLiteral("trackerHost"));
  host->setAccessibleName(tr("Computer"));
  host->setPlaceholderText(tr("name or address, such as localhost"));
  form.addRow(tr("Computer"), host);
  auto* port = new QSpinBox;
  port->setObjectName(QStringLiteral("trackerPort"));
  port->setAccessibleName(tr("Port"));
  port->setRange(1, kMostPort);
  port->setValue(settings.port);
  port->setToolTip(tr("18944 unless the other program says otherwise"));
  form.addRow(tr("Port"), port);
  auto* sums = new QCheckBox(tr("Refuse messages whose check sum is wrong"));
  sums->setObjectName(QStringLiteral("trackerSums"));
  sums->setChecked(settings.checksSums);
  form.addRow(sums);
  connect(host, &QLineEdit::editingFinished, this, [this, host] {
    const QString wanted = host->text().trimmed();
    if (!wanted.isEmpty()) changeSource<IgtlSettings>([&](IgtlSettings& s) { s.host = wanted.toStdString(); });
  });
  connect(port, &QSpinBox::editingFinished, this,
          [this, port] { changeSource<IgtlSettings>([port](IgtlSettings& s) { s.port = port->value(); }); });
  connect(sums, &QCheckBox::toggled, this, [this](bool on) { changeSource<IgtlSettings>([on](IgtlSettings& s) { s.checksSums = on; }); });
}

void TrackerForm::addCamera(QFormLayout& form, const CameraSource& source) {
  auto* cameras = addChoice(form, tr("Camera"), "trackerCamera");
  for (const CameraHere& each : camerasHere())
    cameras->addItem(tr("%1 (%2)").arg(words(each.name), words(each.device)), words(each.device));
  const QString device = words(source.camera.device);
  if (!device.isEmpty() && cameras->findData(device) < 0) cameras->addItem(shownDevice(device), device);
  cameras->setCurrentIndex(cameras->findData(device));
  auto* film = new QPushButton(tr("Video file…"));
  film->setObjectName(QStringLiteral("trackerChooseFilm"));
  film->setAutoDefault(false);
  form.addRow(QString(), film);
  auto* sizes = addChoice(form, tr("Size of the image"), "trackerSize");
  for (const QSize size : {QSize(640, 480), QSize(1280, 720), QSize(1920, 1080)})
    sizes->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
  const QSize present(source.camera.width, source.camera.height);
  if (sizes->findData(present) < 0) sizes->addItem(QStringLiteral("%1 × %2").arg(present.width()).arg(present.height()), present);
  sizes->setCurrentIndex(sizes->findData(present));
  auto* bodies = addChoice(form, tr("Paper body"), "trackerBody");
  auto* boards = addChoice(form, tr("Board at the mannequin"), "trackerBoard");
  boards->addItem(tr("none: the camera stands still"), QString());
  for (const PaperBody& each : trackers_.papers().all()) {
    if (each.kind == PaperKind::held) bodies->addItem(words(each.name), QString::fromStdString(each.id));
    if (each.kind == PaperKind::board) boards->addItem(words(each.name), QString::fromStdString(each.id));
  }
  bodies->setCurrentIndex(bodies->findData(words(source.probeBody)));
  boards->setCurrentIndex(boards->findData(words(source.boardBody)));
  const auto lens =
      new QLabel(source.camera.model && source.camera.model->views > 0 ? tr("measured") : tr("not measured: set the camera up first"));
  setLook(lens, Look::quiet);
  form.addRow(tr("Lens"), lens);
  connect(cameras, qOverload<int>(&QComboBox::activated), this,
          [this, cameras] { trackers_.chooseCamera(tracker_, cameras->currentData().toString().toStdString()); });
  connect(film, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Film of a camera"), {}, tr("Films (*.avi *.mp4 *.mkv *.mov *.webm);;All files (*)"));
    if (!file.isEmpty()) trackers_.chooseCamera(tracker_, file.toStdString());
  });
  connect(sizes, qOverload<int>(&QComboBox::activated), this, [this, sizes] {
    const QSize size = sizes->currentData().toSize();
    trackers_.changeCamera(tracker_, [size](CameraSettings& c) {
      c.width = size.width();
      c.height = size.height();
      if (!c.model) return;
      auto other = scaledTo(*c.model, size.width(), size.height());
      c.model = other ? std::optional(*other) : std::nullopt;
    });
  });
  connect(bodies, qOverload<int>(&QComboBox::activated), this,
          [this, bodies] { trackers_.chooseBody(tracker_, bodies->currentData().toString().toStdString()); });
  connect(boards, qOverload<int>(&QComboBox::activated), this, [this, boards] {
    changeSource<CameraSource>([boards](CameraSource& s) { s.boardBody = boards->currentData().toString().toStdString(); });
  });
}

void TrackerForm::addRecording(QFormLayout& form, const SequenceSettings& settings) {
  QPushButton* file =
      addFile(form, tr("Recording"), wordsOf(settings.file.filename()), tr("none yet: choose a sequence of PLUS"), "trackerSequence");
  auto* speed = new QDoubleSpinBox;
  speed->setObjectName(QStringLiteral("trackerSpeed"));
  speed->setAccessibleName(tr("Speed"));
  speed->setRange(0.1, 10.0);
  speed->setSingleStep(0.1);
  speed->setDecimals(1);
  speed->setValue(settings.speed);
  speed->setPrefix(QStringLiteral("× "));
  form.addRow(tr("Speed"), speed);
  auto* loops = new QCheckBox(tr("Begins again at its end"));
  loops->setObjectName(QStringLiteral("trackerLoops"));
  loops->setChecked(settings.loops);
  form.addRow(loops);
  connect(file, &QPushButton::clicked, this, [this] {
    const QString chosen = askRecordingFile(this);
    if (!chosen.isEmpty()) changeSource<SequenceSettings>([&](SequenceSettings& s) { s.file = pathOf(chosen); });
  });
  connect(speed, &QDoubleSpinBox::editingFinished, this,
          [this, speed] { changeSource<SequenceSettings>([speed](SequenceSettings& s) { s.speed = speed->value(); }); });
  connect(loops, &QCheckBox::toggled, this,
          [this](bool on) { changeSource<SequenceSettings>([on](SequenceSettings& s) { s.loops = on; }); });
}

void TrackerForm::addController(QFormLayout& form, const HandControllerSettings& settings) {
  auto* mode = addChoice(form, tr("When it is let go"), "trackerMode");
  mode->addItem(tr("the probe stays where it is"), static_cast<int>(RateMode::rate));
  mode->addItem(tr("the probe springs back"), static_cast<int>(RateMode::springBack));
  mode->setCurrentIndex(mode->findData(static_cast<int>(settings.hand.mode)));
  const auto optionsFor = [kind = settings.kind](RateMode of) {
    return kind == HandControllerKind::spaceMouse ? spaceMouseOptions(of) : gameControllerOptions(of);
  };
  const RateHandOptions usual = optionsFor(settings.hand.mode);
  double speedNow = 1.0;
  for (std::size_t n = 0; n < usual.axes.size(); ++n)
    if (usual.axes[n].full > 0.0 && settings.hand.axes[n].full > 0.0) speedNow = settings.hand.axes[n].full / usual.axes[n].full;
  auto* speed = new QDoubleSpinBox;
  speed->setObjectName(QStringLiteral("trackerHandSpeed"));
  speed->setAccessibleName(tr("Speed"));
  speed->setRange(kSlowest, kFastest);
  speed->setSingleStep(0.1);
  speed->setDecimals(1);
  speed->setPrefix(QStringLiteral("× "));
  speed->setValue(std::clamp(speedNow, kSlowest, kFastest));
  form.addRow(tr("Speed"), speed);
  auto* dead = new QSpinBox;
  dead->setObjectName(QStringLiteral("trackerDeadZone"));
  dead->setAccessibleName(tr("Rest around the middle"));
  dead->setRange(0, 50);
  dead->setSuffix(tr(" %"));
  dead->setValue(static_cast<int>(settings.hand.deadZone * 100.0 + 0.5));
  dead->setToolTip(tr("How far a stick or the puck may be pushed before the probe moves"));
  form.addRow(tr("Rest around the middle"), dead);
  const auto take = [this, mode, speed, dead, optionsFor] {
    changeSource<HandControllerSettings>([&](HandControllerSettings& s) {
      RateHandOptions made = optionsFor(static_cast<RateMode>(mode->currentData().toInt()));
      for (std::size_t n = 0; n < made.axes.size(); ++n) {
        made.axes[n].full *= speed->value();
        made.axes[n].reversed = s.hand.axes[n].reversed;
      }
      made.deadZone = dead->value() / 100.0;
      made.curve = s.hand.curve;
      s.hand = made;
    });
  };
  connect(mode, qOverload<int>(&QComboBox::activated), this, take);
  connect(speed, &QDoubleSpinBox::editingFinished, this, take);
  connect(dead, &QSpinBox::editingFinished, this, take);
}

void TrackerForm::addFollowing(QFormLayout& form, const TrackedProbeOptions& options) {
  auto* filter = addChoice(form, tr("Smoothing"), "trackerFilter");
  for (const FilterKind kind : {FilterKind::automatic, FilterKind::none, FilterKind::kalman, FilterKind::oneEuro})
    filter->addItem(nameOf(kind), static_cast<int>(kind));
  filter->setCurrentIndex(filter->findData(static_cast<int>(options.filter)));
  filter->setToolTip(tr("Takes the trembling out of the poses, and lags a little for it"));
  auto* predict = new QCheckBox(tr("Look ahead by at most one pose"));
  predict->setObjectName(QStringLiteral("trackerPredict"));
  predict->setChecked(options.predict);
  predict->setToolTip(tr("Makes up for the delay while the probe moves evenly"));
  form.addRow(predict);
  const auto changeOptions = [this](const std::function<void(TrackedProbeOptions&)>& apply) {
    const TrackerSettings* present = trackers_.find(tracker_);
    if (present == nullptr) return;
    TrackerSettings changed = *present;
    apply(changed.probe);
    trackers_.change(changed);
  };
  connect(filter, qOverload<int>(&QComboBox::activated), this, [filter, changeOptions] {
    changeOptions([filter](TrackedProbeOptions& o) { o.filter = static_cast<FilterKind>(filter->currentData().toInt()); });
  });
  connect(predict, &QCheckBox::toggled, this,
          [changeOptions](bool on) { changeOptions([on](TrackedProbeOptions& o) { o.predict = on; }); });
}

}  // namespace ew::ui
