#include "panel/source_field.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <filesystem>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/until_told.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

constexpr int kImageEdge_px = 150;
constexpr int kRest_ms = 200;
constexpr double kSureEnough = 0.5;  // of a side to be proposed rather than chosen

SourceField::Kind kindOf(const CaseSource& source) {
  if (std::holds_alternative<VolumeFile>(source)) return SourceField::Kind::volume;
  if (std::holds_alternative<SweepFile>(source)) return SourceField::Kind::sweep;
  if (std::holds_alternative<StitchingResult>(source)) return SourceField::Kind::stitched;
  return SourceField::Kind::nothing;
}

void setShown(QFormLayout& form, QWidget* field, bool isShown) {
  field->setVisible(isShown);
  if (QWidget* label = form.labelForField(field)) label->setVisible(isShown);
}

}  // namespace

SourceField::SourceField(sdk::Host& host, bool offersNothing, QWidget* parent)
    : QWidget(parent), host_(host), shown_(host.volumes().shown()) {
  soon_.setSingleShot(true);
  soon_.setInterval(kRest_ms);
  connect(&soon_, &QTimer::timeout, this, &SourceField::lookInside);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  kinds_ = new QButtonGroup(this);
  if (shown_)
    addKind(Kind::shown, "sourceShown", tr("What is on screen"), tr("%1, as it was opened or reconstructed.").arg(words(shown_->title)));
  addKind(Kind::volume, "sourceVolume", tr("A volume"), tr("MetaImage, NRRD, NIfTI, DICOM or a Kretz file."));
  addKind(Kind::sweep, "sourceSweep", tr("A recorded sweep"), tr("Images with the probe's poses; the volume is made from them."));
  addKind(Kind::stitched, "sourceStitched", tr("A stitched result"),
          tr("A project of the Stitching panel, or the folder it was saved to."));
  if (offersNothing)
    addKind(Kind::nothing, "sourceNothing", tr("Nothing yet"), tr("Texts and lessons first; the volume can be given later."));
  kinds_->button(static_cast<int>(shown_ ? Kind::shown : Kind::volume))->setChecked(true);
  addFile();
  addSweep();
  addAsked();
  remark_ = problemLabel();
  remark_->setObjectName(QStringLiteral("sourceProblem"));
  column->addWidget(remark_);

  connect(choose_, &QPushButton::clicked, this, &SourceField::chooseFile);
  connect(file_, &QLineEdit::textChanged, this, &SourceField::look);
  connect(kinds_, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (on) look();
  });
  connect(spacing_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SourceField::changed);
  connect(fan_, &QCheckBox::toggled, this, &SourceField::changed);
  connect(images_, &QCheckBox::toggled, this, &SourceField::changed);
  connect(calibration_, &QLineEdit::textChanged, this, &SourceField::lookSoon);
  connect(timeStep_, QOverload<int>::of(&QSpinBox::valueChanged), this, &SourceField::lookSoon);
  connect(acceptsSmall_, &QCheckBox::toggled, this, &SourceField::lookSoon);
  for (NumberField* each : voxel_) connect(each, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SourceField::lookSoon);
  connect(side_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    showSide();
    Q_EMIT changed();
  });
  look();
}

SourceField::~SourceField() { giveUpLook(); }

void SourceField::addFile() {
  fileRow_ = new QWidget;
  auto* row = new QHBoxLayout(fileRow_);
  row->setContentsMargins(0, kGrid_px, 0, 0);
  row->setSpacing(kGrid_px);
  file_ = new QLineEdit;
  file_->setObjectName(QStringLiteral("sourceFile"));
  file_->setAccessibleName(tr("File"));
  file_->setPlaceholderText(tr("no file chosen"));
  row->addWidget(file_, 1);
  choose_ = new QPushButton(tr("Choose…"));
  choose_->setObjectName(QStringLiteral("chooseSource"));
  choose_->setAutoDefault(false);
  row->addWidget(choose_);
  layout()->addWidget(fileRow_);
}

void SourceField::addSweep() {
  sweepRow_ = new QWidget;
  auto* form = new QFormLayout(sweepRow_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(2 * kGrid_px);
  form->setVerticalSpacing(kGrid_px);
  spacing_ = new NumberField(0.0, 10.0, 2, QStringLiteral("mm"));
  spacing_->setObjectName(QStringLiteral("sourceSpacing"));
  spacing_->setSpecialValueText(tr("as fine as the images"));
  spacing_->setSingleStep(0.1);
  spacing_->setMinimumWidth(22 * kGrid_px);
  form->addRow(tr("Spacing of the volume"), spacing_);
  auto* calibrationRow = new QWidget;
  auto* calibration = new QHBoxLayout(calibrationRow);
  calibration->setContentsMargins(0, 0, 0, 0);
  calibration->setSpacing(kGrid_px);
  calibration_ = new QLineEdit;
  calibration_->setObjectName(QStringLiteral("sourceCalibration"));
  calibration_->setAccessibleName(tr("Calibration"));
  calibration_->setPlaceholderText(tr("as the recording says"));
  calibration_->setToolTip(tr("Device set (.xml) with the calibration from Image to Probe"));
  calibration->addWidget(calibration_, 1);
  auto* chooseCalibration = new QPushButton(tr("Choose…"));
  chooseCalibration->setObjectName(QStringLiteral("chooseCalibration"));
  chooseCalibration->setAutoDefault(false);
  calibration->addWidget(chooseCalibration);
  form->addRow(tr("Calibration"), calibrationRow);
  connect(chooseCalibration, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getOpenFileName(this, tr("Calibration of the sweep"), QFileInfo(file()).path(),
                                                        tr("Device sets (*.xml);;All files (*)"));
    if (!chosen.isEmpty()) calibration_->setText(chosen);
  });
  layout()->addWidget(sweepRow_);
  fan_ = new QCheckBox(tr("Leave out what lies around the fan"));
  fan_->setObjectName(QStringLiteral("sourceFan"));
  fan_->setToolTip(
      tr("Where the recording does not say it, the fan is found in its images. Without this the black around it counts as tissue without "
         "echoes."));
  fan_->setChecked(true);
  layout()->addWidget(fan_);
  images_ = new QCheckBox(tr("Keep the recorded images"));
  images_->setObjectName(QStringLiteral("sourceImages"));
  images_->setToolTip(
      tr("Scans then read the images themselves, not the voxels made of them: as sharp as they were recorded. The case becomes larger by "
         "about a third of the recording."));
  layout()->addWidget(images_);
}

void SourceField::addAsked() {
  askedRows_ = new QWidget;
  asked_ = new QFormLayout(askedRows_);
  asked_->setContentsMargins(0, 0, 0, 0);
  asked_->setHorizontalSpacing(2 * kGrid_px);
  asked_->setVerticalSpacing(kGrid_px);
  timeStep_ = new QSpinBox;
  timeStep_->setObjectName(QStringLiteral("sourceTimeStep"));
  timeStep_->setRange(0, 1'000'000);
  timeStep_->setSpecialValueText(tr("not chosen"));
  asked_->addRow(tr("Which volume of the file"), timeStep_);
  voxelRow_ = new QWidget;
  auto* row = new QHBoxLayout(voxelRow_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid_px);
  const std::array names{tr("Size of a voxel along its rows"), tr("Size of a voxel along its columns"),
                         tr("Size of a voxel from slice to slice")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    voxel_[axis] = new NumberField(0.0, 1000.0, 3, QStringLiteral("mm"));
    voxel_[axis]->setObjectName(QStringLiteral("sourceVoxel%1").arg(axis));
    voxel_[axis]->setAccessibleName(names[axis]);
    voxel_[axis]->setToolTip(names[axis]);
    voxel_[axis]->setSpecialValueText(tr("not given"));
    row->addWidget(voxel_[axis], 1);
  }
  asked_->addRow(tr("Size of a voxel"), voxelRow_);
  side_ = new ChoiceField;
  side_->setObjectName(QStringLiteral("sourceSide"));
  side_->addItem(tr("not chosen"), -1);
  const std::array<std::pair<VolumeSide, QString>, 6> sides{{{VolumeSide::front, tr("the front of the file")},
                                                             {VolumeSide::back, tr("the back of the file")},
                                                             {VolumeSide::left, tr("the left of the file")},
                                                             {VolumeSide::right, tr("the right of the file")},
                                                             {VolumeSide::upper, tr("the upper side of the file")},
                                                             {VolumeSide::lower, tr("the lower side of the file")}}};
  for (const auto& [side, text] : sides) side_->addItem(text, static_cast<int>(side));
  asked_->addRow(tr("The probe was on"), side_);
  acceptsSmall_ = new QCheckBox(tr("Make it all the same"));
  acceptsSmall_->setObjectName(QStringLiteral("sourceAcceptsSmall"));
  asked_->addRow(tr("This is meant"), acceptsSmall_);
  auto* look = new QWidget;
  auto* seen = new QHBoxLayout(look);
  seen->setContentsMargins(0, 0, 0, 0);
  seen->setSpacing(2 * kGrid_px);
  sideImage_ = new QLabel;
  sideImage_->setObjectName(QStringLiteral("sourceSideImage"));
  sideImage_->setFixedSize(kImageEdge_px, kImageEdge_px);
  sideImage_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  seen->addWidget(sideImage_);
  sideText_ = quietLabel({});
  seen->addWidget(sideText_, 1);
  asked_->addRow(QString(), look);
  layout()->addWidget(askedRows_);
}

void SourceField::addKind(Kind kind, const char* name, const QString& title, const QString& text) {
  auto* button = new QRadioButton(title);
  button->setObjectName(QLatin1String(name));
  kinds_->addButton(button, static_cast<int>(kind));
  layout()->addWidget(button);
  auto* what = quietLabel(text);
  what->setContentsMargins(3 * kGrid_px, 0, 0, 0);
  layout()->addWidget(what);
}

SourceField::Kind SourceField::kind() const { return static_cast<Kind>(kinds_->checkedId()); }

QString SourceField::file() const { return kind() == Kind::nothing || kind() == Kind::shown ? QString() : file_->text().trimmed(); }

std::optional<VolumeSide> SourceField::side() const {
  const int chosen = side_->currentData().toInt();
  return asksSide_ && chosen >= 0 ? std::optional(static_cast<VolumeSide>(chosen)) : std::nullopt;
}

Result<CaseSource> SourceField::source() const {
  if (kind() == Kind::nothing) return CaseSource(std::monostate());
  if (kind() == Kind::shown) {
    VolumeAtHand at{shown_->volume, {}, side()};
    if (shown_->depthAndLateral) at.axes = SweepAxes{shown_->depthAndLateral->first, shown_->depthAndLateral->second};
    return CaseSource(at);
  }
  if (file().isEmpty()) return failure(ErrorCode::badUsage, say<"Choose a file.">());
  auto found = sourceOf(std::filesystem::path(file().toStdString()));
  if (!found) return found;
  if (auto* sweep = std::get_if<SweepFile>(&*found)) {
    if (spacing_->value() > 0.0) sweep->spacing_mm = spacing_->value();
    sweep->looksForFan = fan_->isChecked();
    sweep->framesEvery = images_->isChecked() ? 1 : 0;
    sweep->acceptsSmall = asksSmall_ && acceptsSmall_->isChecked();
    sweep->calibration = std::filesystem::path(calibration_->text().trimmed().toStdString());
  } else if (auto* volume = std::get_if<VolumeFile>(&*found)) {
    if (asksStep_ && timeStep_->value() > 0) volume->answers.timeStep = timeStep_->value();
    volume->answers.acceptsSmall = asksSmall_ && acceptsSmall_->isChecked();
    const glm::dvec3 voxel_mm(voxel_[0]->value(), voxel_[1]->value(), voxel_[2]->value());
    if (asksSpacing_ && glm::all(glm::greaterThan(voxel_mm, glm::dvec3(0.0)))) volume->answers.spacing_mm = voxel_mm;
    volume->probeSide = side();
  } else if (auto* stitched = std::get_if<StitchingResult>(&*found)) {
    stitched->probeSide = side();
  }
  return found;
}

void SourceField::chooseFile() {
  const QString start = QFileInfo(file_->text()).path();
  const QString chosen =
      kind() == Kind::stitched
          ? QFileDialog::getOpenFileName(this, tr("Choose a stitched result"), start,
                                         tr("Stitch projects and results (*.json volume.mha);;All files (*)"))
          : QFileDialog::getOpenFileName(this, tr("Choose a volume or a sweep"), start,
                                         tr("Volumes and sweeps (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol);;All files (*)"));
  if (!chosen.isEmpty()) file_->setText(chosen);
}

void SourceField::giveUpLook() {
  ++look_;
  isLooking_ = false;
  if (looking_) looking_->store(true);
  looking_.reset();
}

void SourceField::lookSoon() {
  setProblem(remark_, {});
  isRefused_ = false;
  giveUpLook();
  isLooking_ = true;
  soon_.start();
  Q_EMIT changed();
}

void SourceField::lookInside() {
  const auto source = this->source();
  const int mine = look_;
  const auto end = [this] {
    isLooking_ = false;
    looking_.reset();
    Q_EMIT changed();
  };
  if (!source || std::holds_alternative<std::monostate>(*source)) return end();
  auto found = std::make_shared<NewCasePlan>();
  looking_ = std::make_shared<std::atomic<bool>>(false);
  host_.jobs().start(
      tr("Looking at the file").toStdString(),
      [found, source = *source, stop = looking_](Progress& progress) -> Result<void> {
        UntilTold told(progress, *stop);
        auto planned = planOfSource(source, told);
        if (!planned) return passOn(planned.error());
        *found = std::move(*planned);
        return {};
      },
      [this, alive = QPointer<SourceField>(this), found, mine, end](const Result<void>& outcome) {
        if (!alive || look_ != mine) return;
        if (outcome)
          askForSide(*found);
        else
          ask(outcome.error());
        end();
      });
}

void SourceField::ask(const Error& question) {
  const std::string asked = askedFor(question);
  asksStep_ = asksStep_ || asked == "time-step";
  asksSpacing_ = asksSpacing_ || asked == "spacing";
  asksSmall_ = asksSmall_ || asked == "accept-small";
  setShown(*asked_, acceptsSmall_, asksSmall_);
  setShown(*asked_, timeStep_, asksStep_);
  setShown(*asked_, voxelRow_, asksSpacing_);
  askedRows_->setVisible(asksStep_ || asksSpacing_ || asksSide_ || asksSmall_);
  isRefused_ = true;
  QString sentence = words(question);
  const bool hasField = asked.empty() || asked == "time-step" || asked == "spacing" || asked == "calibration" || asked == "accept-small";
  if (!hasField) sentence += QLatin1Char(' ') + tr("File, Open asks for it; then begin the case anew, with what is on screen.");
  setProblem(remark_, sentence);
}

void SourceField::askForSide(const NewCasePlan& found) {
  if (found.asksForSide && !asksSide_) {
    asksSide_ = true;
    seen_ = found.seen;
    const bool isSure = found.proposedSide && found.proposedSide->certainty >= kSureEnough;
    const QSignalBlocker quiet(side_);
    side_->setCurrentIndex(isSure ? side_->findData(static_cast<int>(volumeSideOf(found.proposedSide->axes))) : 0);
  }
  askedRows_->setVisible(asksStep_ || asksSpacing_ || asksSide_ || asksSmall_);
  showSide();
}

void SourceField::showSide() {
  setShown(*asked_, side_, asksSide_);
  sideImage_->parentWidget()->setVisible(asksSide_);
  if (!asksSide_) return;
  const auto chosen = side();
  sideText_->setText(chosen
                         ? tr("So it would be seen. The side where the probe was belongs at the top; if it is not there, choose another.")
                         : tr("The file does not say where the probe was, and its voxels do not tell. Choose a side and look whether it "
                              "comes to lie at the top."));
  sideImage_->clear();
  if (!chosen || seen_.echo.empty()) return;
  const QImage image = imageOf(viewOf(middleImage(seen_, axesFrom(seen_.grid, *chosen), kImageEdge_px))).copy();
  sideImage_->setPixmap(QPixmap::fromImage(image));
}

QString SourceField::openQuestion() const {
  const auto found = source();
  if (!found) return file().isEmpty() ? words(found.error()) : tr("This file cannot become a case.");
  if (isLooking_) return tr("The file is being looked at.");
  if (asksStep_ && timeStep_->value() == 0) return tr("Choose which volume of the file is meant.");
  if (asksSpacing_ && (voxel_[0]->value() <= 0.0 || voxel_[1]->value() <= 0.0 || voxel_[2]->value() <= 0.0))
    return tr("Give the size of a voxel along all three axes.");
  if (isRefused_) return tr("This file cannot become a case as it is; what is missing stands beside it.");
  if (asksSide_ && !side()) return tr("Choose on which side the probe was.");
  return {};
}

void SourceField::forget() {
  asksStep_ = asksSpacing_ = asksSide_ = asksSmall_ = isRefused_ = false;
  seen_ = {};
  {
    const QSignalBlocker quiet(acceptsSmall_);
    acceptsSmall_->setChecked(false);
  }
  setShown(*asked_, acceptsSmall_, false);
  setShown(*asked_, timeStep_, false);
  setShown(*asked_, voxelRow_, false);
  showSide();
  askedRows_->hide();
}

void SourceField::look() {
  setProblem(remark_, {});
  forget();
  const bool isFile = kind() != Kind::nothing && kind() != Kind::shown;
  fileRow_->setVisible(isFile);
  if (isFile && !file().isEmpty()) {
    const auto found = sourceOf(std::filesystem::path(file().toStdString()));
    if (!found) {
      setProblem(remark_, words(found.error()));
    } else if (kindOf(*found) != kind()) {
      // The file knows better than the button.
      const QSignalBlocker quiet(kinds_);
      kinds_->button(static_cast<int>(kindOf(*found)))->setChecked(true);
    }
  }
  sweepRow_->setVisible(kind() == Kind::sweep);
  fan_->setVisible(kind() == Kind::sweep);
  images_->setVisible(kind() == Kind::sweep);
  giveUpLook();
  if (!source() || kind() == Kind::nothing) {
    soon_.stop();
    Q_EMIT changed();
    return;
  }
  isRefused_ = false;
  isLooking_ = true;
  soon_.start();
  Q_EMIT changed();
}

}  // namespace ew::case_authoring
