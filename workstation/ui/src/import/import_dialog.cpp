#include "import/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <set>
#include <utility>

#include "ew/acquisition/fill_holes.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/library/file_import.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/image_chooser.h"
#include "ew/widgets/look.h"
#include "ew/widgets/small_result_question.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "import/import_fields.h"
#include "jobs/jobs.h"
#include "jobs/message_bar.h"

namespace ew::ui {

/// What reading the sweep with the present calibration and frame has shown.
struct ImportDialog::Seen {
  std::optional<ImportPlan> plan;
  std::vector<std::string> frames;  ///< that can be reached from the image
  GreyImage image;                  ///< the first frame, turned as clips count it
};

/// The sweep as it was read, so that it is not read again for every change and once more to make the volume.
struct ImportDialog::Frames {
  std::mutex guard;  ///< a reading that was cancelled may still be at work when the next one starts
  std::optional<SweepInput> opened;

  /// Plans the sweep with `chosen`, and reads it when it has not been read. Scan lines become images by their calibration, so they are
  /// read anew.
  Result<void> plan(const std::filesystem::path& sweep, const SweepImportOptions& chosen, Progress& progress) {
    if (opened && !opened->sectorOfScanLines) return planAgain(*opened, chosen, progress);
    opened.reset();
    auto read = openSweep(sweep, chosen, progress);
    if (!read) return passOn(read.error());
    opened = std::move(*read);
    return {};
  }
};

namespace {

/// A voxel's frame is kept in 16 bits, of which 0 says that there is none.
constexpr std::size_t kMostTracedFrames = 65534;

/// All frames the sweep and its calibration can bring the image to, without the image itself.
std::vector<std::string> framesOf(const Sequence& sequence, const std::vector<FrameTransform>& calibration) {
  std::vector<FrameTransform> all = calibration;
  std::set<std::pair<std::string, std::string>> known;
  for (const SequenceFrame& frame : sequence.frames) {
    for (const FrameTransform& one : frame.transforms) {
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
  const auto [value, decimals, isGibibytes] = memoryFigure(bytes);
  return (isGibibytes ? ImportDialog::tr("%1 GiB") : ImportDialog::tr("%1 MiB")).arg(figure(value, decimals));
}

/// How the probe got from frame to frame.
enum class Moved { tracker, recordedMotor, motorFile, sideways, tilted, rotated, posesFile };

/// "1, 2 3" as numbers. @error badUsage (not `count` numbers)
Result<std::vector<double>> numbersIn(const QString& text, std::size_t count, const QString& what) {
  QString spaced = text;
  spaced.replace(QLatin1Char(','), QLatin1Char(' '));
  auto numbers = parseNumbers(spaced.simplified().toStdString());
  if (numbers && numbers->size() == count && std::all_of(numbers->begin(), numbers->end(), [](double one) { return std::isfinite(one); }))
    return *std::move(numbers);
  return failure(ErrorCode::badUsage, verbatim(ImportDialog::tr("'%1' is not %2.").arg(text, what).toStdString()));
}

}  // namespace

ImportDialog::ImportDialog(const QString& sweep, const QStringList& calibrations, Jobs& jobs, MessageBar& messages, QWidget* parent)
    : FormDialog(QFileInfo(sweep).fileName(), sweep, parent),
      sweep_(sweep),
      jobs_(jobs),
      messages_(messages),
      seen_(std::make_shared<Seen>()),
      kept_(std::make_shared<Frames>()) {
  setObjectName(QStringLiteral("importDialog"));
  setWindowTitle(tr("Reconstruct sweep"));
  addRows();
  calibration_->setText(calibrations.join(QStringLiteral("; ")));
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
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addPoseRows(*form);
  addMethodRows(*form);
  frames_ = valueLabel("importFrames");
  size_ = valueLabel("importSize");
  memory_ = valueLabel("importMemory");
  form->addRow(tr("Frames"), frames_);
  form->addRow(tr("Volume"), size_);
  form->addRow(tr("Memory"), memory_);
  rows().addLayout(form);
  notes_ = new QLabel;
  notes_->setObjectName(QStringLiteral("importNotes"));
  setLook(notes_, Look::small);
  notes_->setWordWrap(true);
  notes_->setMinimumHeight(notes_->fontMetrics().height() * 4);
  notes_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  rows().addWidget(notes_);
  rows().addStretch(1);
  addImage();

  make_ = new QPushButton(tr("Reconstruct"));
  make_->setObjectName(QStringLiteral("makeVolume"));
  setLook(make_, Look::primary);
  make_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"));
  buttons().addWidget(cancel);
  buttons().addWidget(make_);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, [this] { start(); });
}

void ImportDialog::addPoseRows(QFormLayout& form) {
  calibration_ = new QLineEdit;
  calibration_->setObjectName(QStringLiteral("calibration"));
  calibration_->setAccessibleName(tr("Calibration"));
  calibration_->setPlaceholderText(tr("none given"));
  calibration_->setToolTip(
      tr("Device set of the recording (.xml); several with ; between them, the earlier counts where two say the same"));
  auto* choose = new QPushButton(tr("Choose…"));
  moved_ = narrowChoice();
  moved_->setObjectName(QStringLiteral("moved"));
  moved_->addItem(tr("as a tracker recorded"), static_cast<int>(Moved::tracker));
  moved_->addItem(tr("as the recording says of its motor"), static_cast<int>(Moved::recordedMotor));
  moved_->addItem(tr("as a motor file says"), static_cast<int>(Moved::motorFile));
  moved_->addItem(tr("sideways, evenly"), static_cast<int>(Moved::sideways));
  moved_->addItem(tr("tilted, evenly"), static_cast<int>(Moved::tilted));
  moved_->addItem(tr("rotated about the beam, evenly"), static_cast<int>(Moved::rotated));
  moved_->addItem(tr("as a file of poses says"), static_cast<int>(Moved::posesFile));
  motorFile_ = new QLineEdit;
  motorFile_->setObjectName(QStringLiteral("motorFile"));
  motorFile_->setPlaceholderText(tr("motor file (.json)"));
  auto* chooseMotor = new QPushButton(tr("Choose…"));
  motorFileRow_ = new QWidget;
  motorFileRow_->setLayout(inOneRow({motorFile_, chooseMotor}));
  step_ = numberBox("motorStep", -100.0, 100.0, 0.1, 3, tr(" mm"));
  step_->setValue(0.5);
  axisBehindFace_ = numberBox("axisBehindFace", -500.0, 500.0, 1.0, 1, tr(" mm"));
  axisBehindFace_->setToolTip(tr("From the face back to the axis the probe was tilted about; 0: about its face"));
  axisBehindFace_->setPrefix(tr("axis "));
  stepRow_ = new QWidget;
  stepRow_->setLayout(inOneRow({step_, new QLabel(tr("from frame to frame")), axisBehindFace_}));
  frame_ = narrowChoice();
  frame_->setObjectName(QStringLiteral("frame"));
  frame_->addItem(tr("default"), QString());
  form.addRow(tr("Calibration"), inOneRow({calibration_, choose}));
  form.addRow(tr("The probe moved"), moved_);
  form.addRow(QString(), motorFileRow_);
  form.addRow(QString(), posesRow());
  form.addRow(QString(), stepRow_);
  form.addRow(tr("Reference frame"), frame_);
  showMotorRows();

  connect(choose, &QPushButton::clicked, this, [this] {
    const QStringList files =
        QFileDialog::getOpenFileNames(this, tr("Calibration of the sweep"), QFileInfo(sweep_).path(), tr("Device sets (*.xml)"));
    if (!files.isEmpty()) calibration_->setText(files.join(QStringLiteral("; ")));
  });
  connect(chooseMotor, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("How a motor moved the probe"), QFileInfo(sweep_).path(), tr("Motor files (*.json)"));
    if (!file.isEmpty()) motorFile_->setText(file);
  });
  connect(calibration_, &QLineEdit::textChanged, this, [this] { soon_.start(); });
  connect(moved_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    showMotorRows();
    soon_.start();
  });
  connect(motorFile_, &QLineEdit::textChanged, this, [this] { soon_.start(); });
  for (QDoubleSpinBox* box : {step_, axisBehindFace_})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { soon_.start(); });
  connect(frame_, qOverload<int>(&QComboBox::activated), this, [this] { soon_.start(); });
}

QWidget* ImportDialog::posesRow() {
  posesFile_ = new QLineEdit;
  posesFile_->setObjectName(QStringLiteral("posesFile"));
  posesFile_->setAccessibleName(tr("Poses"));
  posesFile_->setPlaceholderText(tr("table or tracked sequence"));
  posesFile_->setToolTip(
      tr("The poses in a file of their own, joined with the images by time: a tracked sequence, or a table (.csv) with the columns time_s, "
         "x_mm, y_mm, z_mm, qw, qx, qy, qz"));
  auto* choose = new QPushButton(tr("Choose…"));
  timeOffset_ = numberBox("timeOffset", -1e10, 1e10, 0.01, 3, tr(" s"));
  timeOffset_->setPrefix(tr("offset "));
  timeOffset_->setToolTip(tr("An image takes the pose that lies so much later in the file of poses"));
  posesFileRow_ = new QWidget;
  posesFileRow_->setLayout(inOneRow({posesFile_, choose, timeOffset_}));
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Poses of the sweep"), QFileInfo(sweep_).path(),
                                                      tr("Poses (*.csv *.tsv *.txt *.mha *.mhd *.nrrd)"));
    if (!file.isEmpty()) posesFile_->setText(file);
  });
  connect(posesFile_, &QLineEdit::textChanged, this, [this] { soon_.start(); });
  connect(timeOffset_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { soon_.start(); });
  return posesFileRow_;
}

void ImportDialog::showMotorRows() {
  const auto moved = static_cast<Moved>(moved_->currentData().toInt());
  posesFileRow_->setVisible(moved == Moved::posesFile);
  motorFileRow_->setVisible(moved == Moved::motorFile);
  stepRow_->setVisible(moved == Moved::sideways || moved == Moved::tilted || moved == Moved::rotated);
  step_->setSuffix(moved == Moved::sideways ? tr(" mm") : tr("°"));
  axisBehindFace_->setVisible(moved == Moved::tilted);
  frame_->setEnabled(moved == Moved::tracker || moved == Moved::posesFile);
}

void ImportDialog::addMethodRows(QFormLayout& form) {
  spacing_ = numberBox("spacing", 0.05, 10.0, 0.1, 2, tr(" mm"));
  spacing_->setValue(ReconstructOptions{}.spacing_mm);
  interpolation_ = narrowChoice();
  interpolation_->setObjectName(QStringLiteral("interpolation"));
  interpolation_->addItem(tr("linear: smoother, slower"), static_cast<int>(Interpolation::linear));
  interpolation_->addItem(tr("nearest: faster"), static_cast<int>(Interpolation::nearest));
  compounding_ = narrowChoice();
  compounding_->setObjectName(QStringLiteral("compounding"));
  compounding_->addItem(tr("mean of all views"), static_cast<int>(Compounding::mean));
  compounding_->addItem(tr("weighted by confidence: shadows count less"), static_cast<int>(Compounding::weighted));
  compounding_->addItem(tr("maximum"), static_cast<int>(Compounding::maximum));
  compounding_->addItem(tr("latest view"), static_cast<int>(Compounding::latest));
  fill_ = numberBox("fillReach", 0.0, 20.0, 0.5, 1, tr(" mm"));
  fill_->setValue(FillOptions{}.reach_mm);
  fill_->setSpecialValueText(tr("do not fill"));
  fill_->setToolTip(tr("Holes at most this far between measured voxels are filled and marked as interpolated"));
  clip_ = new QLineEdit;
  clip_->setObjectName(QStringLiteral("clip"));
  clip_->setPlaceholderText(tr("as the device set says, else all"));
  clip_->setToolTip(tr("Of each frame this rectangle alone is used: x,y,width,height in pixels. Drag it over the image."));
  fan_ = new QLineEdit;
  fan_->setObjectName(QStringLiteral("fan"));
  fan_->setPlaceholderText(tr("as the device set says, else none"));
  fan_->setToolTip(
      tr("Of each frame this fan alone is used: left and right angle in degrees from straight down, x and y of the apex, first and last "
         "radius in pixels"));
  keepSource_ = new QCheckBox(tr("Record source frame per voxel"));
  keepSource_->setObjectName(QStringLiteral("keepSource"));
  keepSource_->setChecked(true);
  keepSource_->setToolTip(tr("Then a point of the image leads to its source frame; 2 bytes a voxel more"));
  form.addRow(tr("Rectangle of frames"), clip_);
  form.addRow(tr("Fan of frames"), fan_);
  form.addRow(tr("Voxel spacing"), spacing_);
  form.addRow(tr("Interpolation"), interpolation_);
  form.addRow(tr("Compounding"), compounding_);
  form.addRow(tr("Fill holes up to"), fill_);
  form.addRow(tr("Origin"), keepSource_);
  for (QLineEdit* line : {clip_, fan_}) connect(line, &QLineEdit::textChanged, this, [this] { soon_.start(); });
  // What a person chooses the device set does not change any more; where it was what could not be used, it is read again.
  const auto choose = [this](bool& chosen) {
    const bool first = !std::exchange(chosen, true);
    if (first && !seen_->plan) return soon_.start();
    showPlan();
  };
  connect(spacing_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, choose] { choose(spacingChosen_); });
  connect(interpolation_, qOverload<int>(&QComboBox::activated), this, [this, choose] { choose(interpolationChosen_); });
  connect(compounding_, qOverload<int>(&QComboBox::activated), this, [this, choose] { choose(compoundingChosen_); });
  connect(fill_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [choose, this] { choose(fillChosen_); });
  connect(keepSource_, &QCheckBox::toggled, this, &ImportDialog::showPlan);
}

void ImportDialog::addImage() {
  auto* column = new QWidget;
  auto* below = new QVBoxLayout(column);
  below->setContentsMargins(0, 0, 0, 0);
  below->setSpacing(8);
  image_ = new ImageChooser;
  below->addWidget(image_, 1);
  auto* hint = new QLabel(tr("The first frame. Drag a rectangle over what is to be used of every frame."));
  setLook(hint, Look::quiet);
  hint->setWordWrap(true);
  below->addWidget(hint);
  putBeside(column, {960, 600});
  connect(image_, &ImageChooser::drawn, this, [this](const PixelRect& rect) {
    clip_->setText(QStringLiteral("%1,%2,%3,%4").arg(rect.x).arg(rect.y).arg(rect.width).arg(rect.height));
  });
}

Result<SweepImportOptions> ImportDialog::options() const {
  SweepImportOptions chosen;
  for (const QString& file : filesIn(calibration_->text())) chosen.calibrations.push_back(pathOf(file));
  const auto moved = static_cast<Moved>(moved_->currentData().toInt());
  const double radian = std::numbers::pi / 180.0;
  switch (moved) {
    case Moved::tracker:
      chosen.toFrame = frame_->currentData().toString().toStdString();
      break;
    case Moved::posesFile:
      if (posesFile_->text().trimmed().isEmpty())
        return failure(ErrorCode::badUsage, verbatim(tr("Choose the file with the poses of the images.").toStdString()));
      chosen.poses = pathOf(posesFile_->text().trimmed());
      if (timeOffset_->value() != 0.0) chosen.poseDelay_s = timeOffset_->value();
      chosen.toFrame = frame_->currentData().toString().toStdString();
      break;
    case Moved::recordedMotor:
      chosen.motor = kRecordedMotor;
      break;
    case Moved::motorFile:
      if (motorFile_->text().trimmed().isEmpty())
        return failure(ErrorCode::badUsage, verbatim(tr("Choose the motor file that says how the probe moved.").toStdString()));
      chosen.motor = motorFile_->text().trimmed().toStdString();
      break;
    case Moved::sideways:
      chosen.statedMotor = MotorSweep{.kind = MotorKind::parallel, .step = step_->value()};
      break;
    case Moved::tilted:
      chosen.statedMotor = MotorSweep{.kind = MotorKind::fan, .step = step_->value(), .axisBehindFace_mm = axisBehindFace_->value()};
      break;
    case Moved::rotated:
      chosen.statedMotor = MotorSweep{.kind = MotorKind::rotational, .step = step_->value()};
      break;
  }
  if (chosen.statedMotor && chosen.statedMotor->step == 0.0)
    return failure(ErrorCode::badUsage,
                   verbatim(tr("Say how far the probe moved from frame to frame; 0 would put all frames into one place.").toStdString()));
  if (!clip_->text().trimmed().isEmpty()) {
    const auto rect = parsePixelRect(clip_->text().trimmed().toStdString());
    if (!rect) return passOn(rect.error());
    chosen.reconstruct.clip.origin_px = {rect->x, rect->y};
    chosen.reconstruct.clip.size_px = glm::dvec2(rect->width, rect->height);
    chosen.clipFromCalibration = false;
  }
  if (!fan_->text().trimmed().isEmpty()) {
    const auto numbers = numbersIn(fan_->text(), 6, tr("a fan; give left and right angle, x and y of the apex, first and last radius"));
    if (!numbers) return passOn(numbers.error());
    const std::vector<double>& fan = *numbers;
    chosen.reconstruct.clip.fan = ClipFan{{fan[2], fan[3]}, fan[0] * radian, fan[1] * radian, fan[4], fan[5]};
    chosen.clipFromCalibration = false;
  }
  chosen.reconstruct.spacing_mm = spacing_->value();
  chosen.reconstruct.interpolation = static_cast<Interpolation>(interpolation_->currentData().toInt());
  chosen.reconstruct.compounding = static_cast<Compounding>(compounding_->currentData().toInt());
  chosen.reconstruct.fillReach_mm = fill_->value();
  chosen.reconstruct.keepSource = keepSource_->isEnabled() && keepSource_->isChecked();
  return chosen;
}

void ImportDialog::readAgain() {
  if (reading_ != 0) jobs_.cancel(reading_);
  reading_ = 0;
  auto asked = options();
  if (asked) {
    asked->usual = {
        .spacing = !spacingChosen_, .interpolation = !interpolationChosen_, .compounding = !compoundingChosen_, .fillReach = !fillChosen_};
  }
  if (!asked) {
    seen_ = std::make_shared<Seen>();
    refuse(words(asked.error().message));
    return;
  }
  make_->setEnabled(false);
  notes_->setStyleSheet({});
  notes_->setText(tr("Reading the sweep…"));
  auto found = std::make_shared<Seen>();
  // The dialog may be gone before its job has stopped.
  const QPointer<ImportDialog> here(this);
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(
      tr("Reading %1").arg(QFileInfo(sweep_).fileName()),
      [found, kept = kept_, sweep = pathOf(sweep_), chosen = *asked](Progress& progress) -> Result<void> {
        std::vector<FrameTransform> calibration;
        if (!chosen.calibrations.empty()) {
          auto device = readDeviceSets(chosen.calibrations);
          if (!device) return passOn(device.error());
          calibration = std::move(device->transforms);
        }
        const std::lock_guard alone(kept->guard);
        if (auto planned = kept->plan(sweep, chosen, progress); !planned) return planned;
        const Sequence& sequence = kept->opened->sequence;
        found->frames = framesOf(sequence, calibration);
        const auto first = sequence.framePixels(0);
        found->image.width = sequence.width;
        found->image.height = sequence.height;
        found->image.pixels.assign(first.begin(), first.end());
        found->plan = kept->opened->plan;
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
    // What can be reached without the missing piece may be what is wanted.
    const auto reachable = std::find_if(outcome.error().context.begin(), outcome.error().context.end(),
                                        [](const auto& fact) { return fact.first == "reachable"; });
    if (reachable != outcome.error().context.end()) {
      std::vector<std::string> names;
      for (const QString& name : words(reachable->second).split(QLatin1Char(','), Qt::SkipEmptyParts)) names.push_back(name.toStdString());
      offerFrames(names, tr("default"));
    }
    refuse(words(outcome.error().message));
    if (askedFor(outcome.error()) == "motor") moved_->setFocus();
    return;
  }
  seen_ = found;
  {
    const ReconstructOptions& planned = found->plan->reconstruct;
    const QSignalBlocker quiet(spacing_), quietToo(fill_);
    spacing_->setValue(planned.spacing_mm);
    fill_->setValue(planned.fillReach_mm);
    interpolation_->setCurrentIndex(interpolation_->findData(static_cast<int>(planned.interpolation)));
    compounding_->setCurrentIndex(compounding_->findData(static_cast<int>(planned.compounding)));
  }
  offerFrames(found->frames, tr("default (%1)").arg(words(found->plan->toFrame)));
  image_->setImage(found->image, {});
  const Clip& clip = found->plan->reconstruct.clip;
  const glm::dvec2 size_px = clip.size_px.value_or(glm::dvec2(found->image.width, found->image.height));
  image_->setParts(
      {{static_cast<int>(clip.origin_px.x), static_cast<int>(clip.origin_px.y), static_cast<int>(size_px.x), static_cast<int>(size_px.y)}});
  image_->setChosenPart(0);
  showPlan();
}

void ImportDialog::offerFrames(const std::vector<std::string>& names, const QString& suggested) {
  const QString chosen = frame_->currentData().toString();
  const QSignalBlocker quiet(frame_);
  while (frame_->count() > 1) frame_->removeItem(1);
  frame_->setItemText(0, suggested);
  for (const std::string& name : names) frame_->addItem(words(name), words(name));
  const int index = frame_->findData(chosen);
  frame_->setCurrentIndex(index < 0 ? 0 : index);
}

void ImportDialog::refuse(const QString& why) {
  make_->setEnabled(false);
  notes_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().danger.name()));
  notes_->setText(why);
  grow();
  for (QLabel* label : {frames_, size_, memory_}) label->setText(QStringLiteral("–"));
}

void ImportDialog::showPlan() {
  if (!seen_->plan) return;
  const ImportPlan& plan = *seen_->plan;
  const SweepCounts& counts = plan.frames;
  frames_->setText(
      tr("%1 of %2 used (%3 invalid, %4 without a pose)").arg(counts.used).arg(counts.total).arg(counts.invalid).arg(counts.missing));
  keepSource_->setEnabled(counts.used <= kMostTracedFrames);
  const auto asked = options();
  if (!asked) return refuse(words(asked.error().message));
  ReconstructOptions chosen = asked->reconstruct;
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
  for (const Message& note : plan.notes) notes << words(note);
  notes_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().quiet.name()));
  notes_->setText(notes.join(QLatin1Char('\n')));
  make_->setEnabled(true);
  grow();
}

void ImportDialog::start(bool acceptsSmall) {
  auto asked = options();
  if (!asked) return refuse(words(asked.error().message));
  asked->acceptsSmall = acceptsSmall;
  if (!acceptsSmall && seen_->plan && !seen_->plan->smallQuestion.empty()) {
    if (!askAcceptsSmall(this, words(seen_->plan->smallQuestion))) return;
    asked->acceptsSmall = true;
  }
  struct Made {
    ScanVoxels voxels;
    std::shared_ptr<const Provenance> provenance;
  };
  auto made = std::make_shared<Made>();
  const QString title = QFileInfo(sweep_).fileName();
  hide();
  jobs_.start(
      tr("Making a volume from %1").arg(title),
      [made, kept = kept_, sweep = pathOf(sweep_), chosen = *asked](Progress& progress) -> Result<void> {
        PartOfProgress planning(progress, 0.0, 0.1), most(progress, 0.1, 0.95), rest(progress, 0.95, 1.0);
        std::optional<SweepInput> opened;
        {
          const std::lock_guard alone(kept->guard);
          if (auto planned = kept->plan(sweep, chosen, planning); !planned) return planned;
          opened.swap(kept->opened);  // its frames are freed while the volume is finished
        }
        const auto take = [&](Volume& volume) -> Result<void> {
          auto voxels = ScanVoxels::of(std::make_shared<const Volume>(std::move(volume)), rest);
          if (!voxels) return passOn(voxels.error());
          made->voxels = std::move(*voxels);
          return {};
        };
        if (chosen.reconstruct.keepSource) {
          auto traced = importTracedSweep(std::move(*opened), sweep, chosen, most);
          if (!traced) return passOn(traced.error());
          made->provenance = std::make_shared<const Provenance>(std::move(traced->provenance));
          return take(traced->imported.reconstruction.volume);
        }
        auto result = importSweep(std::move(*opened), most);
        if (!result) return passOn(result.error());
        return take(result->reconstruction.volume);
      },
      [here = QPointer<ImportDialog>(this), made, title, messages = QPointer<MessageBar>(&messages_)](const Result<void>& outcome) {
        const bool failed = !outcome && outcome.error().code != ErrorCode::cancelled;
        ImportDialog* dialog = here.data();
        if (dialog == nullptr) {
          if (failed && messages) messages->showError(outcome.error(), QStringLiteral("open"));
          return;
        }
        if (failed) {
          // Back with every choice as it was, so that one of them can be changed.
          dialog->open();
          dialog->refuse(words(outcome.error().message));
          dialog->make_->setEnabled(true);
          // What was chosen since the plan was shown can be what there is to ask about.
          if (askedFor(outcome.error()) == "accept-small" && askAcceptsSmall(dialog, words(outcome.error().message))) dialog->start(true);
          return;
        }
        if (outcome) {
          dialog->messages_.forgetWhatIsPast();
          Q_EMIT dialog->imported(made->voxels, title, made->provenance);
        }
        dialog->close();
      });
}

}  // namespace ew::ui
