#include "panel/source_field.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <filesystem>

#include "ew/sdk/panel.h"

namespace ew::case_authoring {
namespace {

using sdk::kGap_px;

SourceField::Kind kindOf(const CaseSource& source) {
  if (std::holds_alternative<VolumeFile>(source)) return SourceField::Kind::volume;
  if (std::holds_alternative<SweepFile>(source)) return SourceField::Kind::sweep;
  if (std::holds_alternative<StitchingResult>(source)) return SourceField::Kind::stitched;
  return SourceField::Kind::nothing;
}

}  // namespace

SourceField::SourceField(bool offersNothing, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  kinds_ = new QButtonGroup(this);
  addKind(Kind::volume, "sourceVolume", tr("A volume"), tr("MetaImage, NRRD, NIfTI, DICOM or a Kretz file."));
  addKind(Kind::sweep, "sourceSweep", tr("A recorded sweep"), tr("Images with the probe's poses; the volume is made from them."));
  addKind(Kind::stitched, "sourceStitched", tr("A stitched result"),
          tr("A project of the Stitching panel, or the folder it was saved to."));
  if (offersNothing)
    addKind(Kind::nothing, "sourceNothing", tr("Nothing yet"), tr("Texts and lessons first; the volume can be given later."));
  kinds_->button(static_cast<int>(Kind::volume))->setChecked(true);

  fileRow_ = new QWidget;
  auto* row = new QHBoxLayout(fileRow_);
  row->setContentsMargins(0, kGap_px, 0, 0);
  row->setSpacing(kGap_px);
  file_ = new QLineEdit;
  file_->setObjectName(QStringLiteral("sourceFile"));
  file_->setAccessibleName(tr("File"));
  file_->setPlaceholderText(tr("no file chosen"));
  row->addWidget(file_, 1);
  choose_ = new QPushButton(tr("Choose…"));
  choose_->setObjectName(QStringLiteral("chooseSource"));
  choose_->setAutoDefault(false);
  row->addWidget(choose_);
  column->addWidget(fileRow_);

  sweepRow_ = new QWidget;
  auto* spacing = new QHBoxLayout(sweepRow_);
  spacing->setContentsMargins(0, 0, 0, 0);
  spacing->setSpacing(kGap_px);
  auto* name = sdk::quietLabel(tr("Spacing of the volume"));
  name->setWordWrap(false);
  spacing->addWidget(name);
  spacing_ = new sdk::NumberField(0.0, 10.0, 2, QStringLiteral("mm"));
  spacing_->setObjectName(QStringLiteral("sourceSpacing"));
  spacing_->setSpecialValueText(tr("as fine as the images"));
  spacing_->setSingleStep(0.1);
  spacing_->setMinimumWidth(22 * kGap_px);
  name->setBuddy(spacing_);
  spacing->addWidget(spacing_);
  spacing->addStretch(1);
  column->addWidget(sweepRow_);
  fan_ = new QCheckBox(tr("Leave out what lies around the fan"));
  fan_->setObjectName(QStringLiteral("sourceFan"));
  fan_->setToolTip(
      tr("Where the recording does not say it, the fan is found in its images. Without this the black around it counts as tissue without "
         "echoes."));
  fan_->setChecked(true);
  column->addWidget(fan_);
  remark_ = sdk::problemLabel();
  remark_->setObjectName(QStringLiteral("sourceProblem"));
  column->addWidget(remark_);

  connect(choose_, &QPushButton::clicked, this, &SourceField::chooseFile);
  connect(file_, &QLineEdit::textChanged, this, &SourceField::look);
  connect(kinds_, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (on) look();
  });
  connect(spacing_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SourceField::changed);
  connect(fan_, &QCheckBox::toggled, this, &SourceField::changed);
  look();
}

void SourceField::addKind(Kind kind, const char* name, const QString& title, const QString& text) {
  auto* button = new QRadioButton(title);
  button->setObjectName(QLatin1String(name));
  kinds_->addButton(button, static_cast<int>(kind));
  layout()->addWidget(button);
  auto* what = sdk::quietLabel(text);
  what->setContentsMargins(3 * kGap_px, 0, 0, 0);
  layout()->addWidget(what);
}

SourceField::Kind SourceField::kind() const { return static_cast<Kind>(kinds_->checkedId()); }

QString SourceField::file() const { return kind() == Kind::nothing ? QString() : file_->text().trimmed(); }

Result<CaseSource> SourceField::source() const {
  if (kind() == Kind::nothing) return CaseSource(std::monostate());
  if (file().isEmpty()) return failure(ErrorCode::badUsage, say<"Choose a file.">());
  auto found = sourceOf(std::filesystem::path(file().toStdString()));
  if (!found) return found;
  if (auto* sweep = std::get_if<SweepFile>(&*found)) {
    if (spacing_->value() > 0.0) sweep->spacing_mm = spacing_->value();
    sweep->looksForFan = fan_->isChecked();
  }
  return found;
}

void SourceField::setFile(const QString& file) { file_->setText(file); }

void SourceField::chooseFile() {
  const QString start = QFileInfo(file_->text()).path();
  const QString chosen = kind() == Kind::stitched
                             ? QFileDialog::getOpenFileName(this, tr("Choose a stitched result"), start,
                                                            tr("Stitch projects and results (*.json volume.mha);;All files (*)"))
                             : QFileDialog::getOpenFileName(this, tr("Choose a volume or a sweep"), start, tr("All files (*)"));
  if (!chosen.isEmpty()) file_->setText(chosen);
}

void SourceField::look() {
  sdk::setProblem(remark_, {});
  const bool isFile = kind() != Kind::nothing;
  fileRow_->setVisible(isFile);
  if (isFile && !file().isEmpty()) {
    const auto found = sourceOf(std::filesystem::path(file().toStdString()));
    if (!found) {
      sdk::setProblem(remark_, sdk::words(found.error()));
    } else if (kindOf(*found) != kind()) {
      // The file knows better than the button.
      const QSignalBlocker quiet(kinds_);
      kinds_->button(static_cast<int>(kindOf(*found)))->setChecked(true);
    }
  }
  sweepRow_->setVisible(kind() == Kind::sweep);
  fan_->setVisible(kind() == Kind::sweep);
  Q_EMIT changed();
}

}  // namespace ew::case_authoring
