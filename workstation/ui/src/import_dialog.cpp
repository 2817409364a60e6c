#include "import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>
#include <set>

#include "ew/acquisition/fill_holes.h"
#include "jobs.h"
#include "message_bar.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {

/// What reading the sweep with the present calibration and frame has shown.
struct ImportDialog::Seen {
  std::optional<ImportPlan> plan;
  std::vector<std::string> frames;  ///< that can be reached from the image
};

namespace {

/// A voxel's frame is kept in 16 bits, of which 0 says that there is none.
constexpr std::size_t kMostTracedFrames = 65534;

/// All frames the sweep and its calibration can bring the image to, without the image itself.
std::vector<std::string> framesOf(const Sequence& sequence, const std::vector<NamedTransform>& calibration) {
  std::vector<NamedTransform> all = calibration;
  std::set<std::pair<std::string, std::string>> known;
  for (const SequenceFrame& frame : sequence.frames) {
    for (const NamedTransform& one : frame.transforms) {
      if (known.emplace(one.from, one.to).second) all.push_back({one.from, one.to, glm::dmat4(1.0), PoseStatus::ok});
    }
  }
  std::vector<std::string> reachable = reachableFrom(all, "Image");
  std::erase(reachable, "Image");
  return reachable;
}

/// The grid of the plan at another spacing: the same box.
Grid respaced(const Grid& grid, double spacing_mm) {
  Grid other = grid;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent_mm = (grid.dims[axis] - 1) * grid.spacing_mm[axis];
    other.dims[axis] = static_cast<int>(std::min(2e9, std::round(extent_mm / spacing_mm))) + 1;
  }
  other.spacing_mm = glm::dvec3(spacing_mm);
  return other;
}

QString mebibytes(double bytes) {
  const double mib = bytes / (1024.0 * 1024.0);
  return mib < 10240.0 ? ImportDialog::tr("%1 MiB").arg(mib, 0, 'f', mib < 10.0 ? 1 : 0)
                       : ImportDialog::tr("%1 GiB").arg(mib / 1024.0, 0, 'f', 1);
}

QLabel* valueLabel(const char* name) {
  auto* label = new QLabel(QStringLiteral("–"));
  label->setObjectName(QLatin1String(name));
  return label;
}

}  // namespace

ImportDialog::ImportDialog(const QString& sweep, Jobs& jobs, MessageBar& messages, QWidget* parent)
    : QDialog(parent), sweep_(sweep), jobs_(jobs), messages_(messages), seen_(std::make_shared<Seen>()) {
  setObjectName(QStringLiteral("importDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Make a volume from a sweep"));
  setMinimumWidth(560);
  addRows();
  // A spin box changes with every key; one reading after the last change is enough.
  soon_.setSingleShot(true);
  soon_.setInterval(250);
  connect(&soon_, &QTimer::timeout, this, &ImportDialog::readAgain);
  readAgain();
}

ImportDialog::~ImportDialog() {
  if (reading_ != 0) jobs_.cancel(reading_);
}

void ImportDialog::addRows() {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(24, 24, 24, 24);
  outer->setSpacing(16);
  auto* title = new QLabel(QFileInfo(sweep_).fileName());
  title->setProperty("heading", true);
  title->setToolTip(sweep_);
  outer->addWidget(title);

  calibration_ = new QLineEdit;
  calibration_->setObjectName(QStringLiteral("calibration"));
  calibration_->setPlaceholderText(tr("none: the sweep says everything itself"));
  auto* choose = new QPushButton(tr("Choose…"));
  auto* calibrationRow = new QHBoxLayout;
  calibrationRow->setSpacing(8);
  calibrationRow->addWidget(calibration_, 1);
  calibrationRow->addWidget(choose);
  frame_ = new QComboBox;
  frame_->setObjectName(QStringLiteral("frame"));
  frame_->addItem(tr("as the sweep suggests"), QString());
  spacing_ = new QDoubleSpinBox;
  spacing_->setObjectName(QStringLiteral("spacing"));
  spacing_->setRange(0.05, 10.0);
  spacing_->setSingleStep(0.1);
  spacing_->setDecimals(2);
  spacing_->setSuffix(tr(" mm"));
  spacing_->setValue(ReconstructOptions{}.spacing_mm);
  interpolation_ = new QComboBox;
  interpolation_->addItem(tr("linear: smoother, slower"), static_cast<int>(Interpolation::linear));
  interpolation_->addItem(tr("nearest: faster"), static_cast<int>(Interpolation::nearest));
  compounding_ = new QComboBox;
  compounding_->addItem(tr("mean of all views"), static_cast<int>(Compounding::mean));
  compounding_->addItem(tr("weighted by confidence: shadows count less"), static_cast<int>(Compounding::weighted));
  compounding_->addItem(tr("brightest view"), static_cast<int>(Compounding::maximum));
  compounding_->addItem(tr("latest view"), static_cast<int>(Compounding::latest));
  fill_ = new QDoubleSpinBox;
  fill_->setObjectName(QStringLiteral("fillReach"));
  fill_->setRange(0.0, 20.0);
  fill_->setSingleStep(0.5);
  fill_->setDecimals(1);
  fill_->setValue(FillOptions{}.reach_mm);
  fill_->setSuffix(tr(" mm"));
  fill_->setSpecialValueText(tr("leave holes"));
  fill_->setToolTip(tr("Holes at most this far between measured voxels are filled and marked as interpolated"));
  keepSource_ = new QCheckBox(tr("Keep which frame each voxel came from"));
  keepSource_->setObjectName(QStringLiteral("keepSource"));
  keepSource_->setChecked(true);
  keepSource_->setToolTip(tr("Then a point of the picture leads to its source frame; 2 bytes a voxel more"));
  frames_ = valueLabel("importFrames");
  size_ = valueLabel("importSize");
  memory_ = valueLabel("importMemory");

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->addRow(tr("Calibration"), calibrationRow);
  form->addRow(tr("Coordinates of"), frame_);
  form->addRow(tr("Voxel spacing"), spacing_);
  form->addRow(tr("Interpolation"), interpolation_);
  form->addRow(tr("Overlap"), compounding_);
  form->addRow(tr("Fill holes up to"), fill_);
  form->addRow(tr("Origin"), keepSource_);
  form->addRow(tr("Frames"), frames_);
  form->addRow(tr("Volume"), size_);
  form->addRow(tr("Memory"), memory_);
  outer->addLayout(form);

  notes_ = new QLabel;
  notes_->setObjectName(QStringLiteral("importNotes"));
  notes_->setProperty("small", true);
  notes_->setWordWrap(true);
  notes_->setMinimumHeight(notes_->fontMetrics().height() * 4);
  notes_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  outer->addWidget(notes_);
  outer->addStretch(1);

  make_ = new QPushButton(tr("Make the volume"));
  make_->setObjectName(QStringLiteral("makeVolume"));
  make_->setProperty("primary", true);
  make_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch(1);
  buttons->addWidget(cancel);
  buttons->addWidget(make_);
  outer->addLayout(buttons);

  connect(choose, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Calibration of the sweep"), QFileInfo(sweep_).path(), tr("Device sets (*.xml)"));
    if (!file.isEmpty()) calibration_->setText(file);
  });
  connect(calibration_, &QLineEdit::textChanged, this, [this] { soon_.start(); });
  connect(frame_, qOverload<int>(&QComboBox::activated), this, [this] { soon_.start(); });
  connect(spacing_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ImportDialog::showPlan);
  connect(interpolation_, qOverload<int>(&QComboBox::activated), this, &ImportDialog::showPlan);
  connect(compounding_, qOverload<int>(&QComboBox::activated), this, &ImportDialog::showPlan);
  connect(fill_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ImportDialog::showPlan);
  connect(keepSource_, &QCheckBox::toggled, this, &ImportDialog::showPlan);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, &ImportDialog::start);
}

SweepImportOptions ImportDialog::options() const {
  SweepImportOptions chosen;
  if (const auto file = pathOf(calibration_->text().trimmed()); !file.empty()) chosen.calibrations = {file};
  chosen.toFrame = frame_->currentData().toString().toStdString();
  chosen.reconstruct.spacing_mm = spacing_->value();
  chosen.reconstruct.interpolation = static_cast<Interpolation>(interpolation_->currentData().toInt());
  chosen.reconstruct.compounding = static_cast<Compounding>(compounding_->currentData().toInt());
  chosen.reconstruct.fillReach_mm = fill_->value();
  chosen.reconstruct.keepSource = keepSource_->isEnabled() && keepSource_->isChecked();
  return chosen;
}

void ImportDialog::readAgain() {
  if (reading_ != 0) jobs_.cancel(reading_);
  make_->setEnabled(false);
  notes_->setStyleSheet({});
  notes_->setText(tr("Reading the sweep…"));
  auto found = std::make_shared<Seen>();
  // The dialog may be gone before its job has stopped.
  const QPointer<ImportDialog> here(this);
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(
      tr("Reading %1").arg(QFileInfo(sweep_).fileName()),
      [found, sweep = pathOf(sweep_), chosen = options()](Progress& progress) -> Result<void> {
        std::vector<NamedTransform> calibration;
        if (!chosen.calibrations.empty()) {
          auto device = readDeviceSets(chosen.calibrations);
          if (!device) return passOn(device.error());
          calibration = std::move(device->transforms);
        }
        auto opened = openSweep(sweep, chosen, progress);
        if (!opened) return passOn(opened.error());
        found->frames = framesOf(opened->sequence, calibration);
        found->plan = std::move(opened->plan);
        return {};
      },
      [here, found, id](const Result<void>& outcome) {
        if (ImportDialog* dialog = here.data(); dialog != nullptr && dialog->reading_ == *id) dialog->take(found, outcome);
      });
  reading_ = *id;
}

void ImportDialog::take(const std::shared_ptr<Seen>& found, const Result<void>& outcome) {
  reading_ = 0;
  if (!outcome) {
    seen_ = std::make_shared<Seen>();
    refuse(words(outcome.error().sentence));
    return;
  }
  seen_ = found;
  const QString chosen = frame_->currentData().toString();
  const QSignalBlocker quiet(frame_);
  while (frame_->count() > 1) frame_->removeItem(1);
  frame_->setItemText(0, tr("as the sweep suggests (%1)").arg(words(found->plan->toFrame)));
  for (const std::string& name : found->frames) frame_->addItem(words(name), words(name));
  const int index = frame_->findData(chosen);
  frame_->setCurrentIndex(index < 0 ? 0 : index);
  showPlan();
}

void ImportDialog::refuse(const QString& why) {
  make_->setEnabled(false);
  notes_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().danger.name()));
  notes_->setText(why);
  for (QLabel* label : {frames_, size_, memory_}) label->setText(QStringLiteral("–"));
}

void ImportDialog::showPlan() {
  if (!seen_->plan) return;
  const ImportPlan& plan = *seen_->plan;
  const SweepCounts& counts = plan.frames;
  frames_->setText(
      tr("%1 of %2 used (%3 invalid, %4 without a pose)").arg(counts.used).arg(counts.total).arg(counts.invalid).arg(counts.missing));
  keepSource_->setEnabled(counts.used <= kMostTracedFrames);
  ReconstructOptions chosen = options().reconstruct;
  chosen.clip = plan.reconstruct.clip;
  const Grid grid = respaced(plan.grid, spacing_->value());
  size_->setText(tr("%1 x %2 x %3 voxels, %4 x %5 x %6 mm")
                     .arg(grid.dims.x)
                     .arg(grid.dims.y)
                     .arg(grid.dims.z)
                     .arg(std::lround(grid.dims.x * grid.spacing_mm.x))
                     .arg(std::lround(grid.dims.y * grid.spacing_mm.y))
                     .arg(std::lround(grid.dims.z * grid.spacing_mm.z)));
  const bool countable = checkGrid(grid).has_value();
  const double bytes = countable ? static_cast<double>(importBytes(plan, grid, chosen)) : 1e18;
  if (!countable || bytes > static_cast<double>(chosen.maxBytes)) {
    refuse(tr("The volume would need more than the %1 allowed; choose a coarser spacing.")
               .arg(mebibytes(static_cast<double>(chosen.maxBytes))));
    return;
  }
  const double keptBytes = (chosen.keepSource ? 4.0 : 2.0) * static_cast<double>(grid.voxelCount());
  memory_->setText(tr("%1 while it is made, the volume itself %2").arg(mebibytes(bytes), mebibytes(keptBytes)));
  QStringList notes;
  if (!keepSource_->isEnabled()) {
    notes << tr("The sweep has more than %1 frames; which of them a voxel came from cannot be kept.").arg(kMostTracedFrames);
  }
  for (const std::string& note : plan.notes) notes << words(note);
  notes_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().quiet.name()));
  notes_->setText(notes.join(QLatin1Char('\n')));
  make_->setEnabled(true);
}

void ImportDialog::start() {
  struct Made {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Provenance> provenance;
  };
  auto made = std::make_shared<Made>();
  const QString title = QFileInfo(sweep_).fileName();
  hide();
  jobs_.start(
      tr("Making a volume from %1").arg(title),
      [made, sweep = pathOf(sweep_), chosen = options()](Progress& progress) -> Result<void> {
        if (chosen.reconstruct.keepSource) {
          auto traced = importTracedSweep(sweep, chosen, progress);
          if (!traced) return passOn(traced.error());
          made->volume = std::make_shared<const Volume>(std::move(traced->imported.reconstruction.volume));
          made->provenance = std::make_shared<const Provenance>(std::move(traced->provenance));
          return {};
        }
        auto result = importSweep(sweep, chosen, progress);
        if (!result) return passOn(result.error());
        made->volume = std::make_shared<const Volume>(std::move(result->reconstruction.volume));
        return {};
      },
      [here = QPointer<ImportDialog>(this), made, title, messages = QPointer<MessageBar>(&messages_)](const Result<void>& outcome) {
        const bool failed = !outcome && outcome.error().code != ErrorCode::cancelled;
        ImportDialog* dialog = here.data();
        if (dialog == nullptr) {
          if (failed && messages) messages->showError(outcome.error());
          return;
        }
        if (failed) {
          // Back with every choice as it was, so that one of them can be changed.
          dialog->open();
          dialog->refuse(words(outcome.error().sentence));
          dialog->make_->setEnabled(true);
          return;
        }
        if (outcome) Q_EMIT dialog->imported(made->volume, title, made->provenance);
        dialog->close();
      });
}

}  // namespace ew::ui
