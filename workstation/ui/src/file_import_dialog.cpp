#include "file_import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/io/sequence.h"
#include "jobs.h"
#include "message_bar.h"
#include "save_file.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kSlice_px = 160;

/// Millimetres where 0 stands for "not said".
QDoubleSpinBox* lengthBox(const QString& name) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(0.0, 100.0);
  box->setDecimals(4);
  box->setSingleStep(0.1);
  box->setSuffix(FileImportDialog::tr(" mm"));
  box->setSpecialValueText(FileImportDialog::tr("not said"));
  return box;
}

template <class Boxes>
QHBoxLayout* inRow(const Boxes& boxes) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (auto* box : boxes) row->addWidget(box);
  row->addStretch(1);
  return row;
}

}  // namespace

FileImportDialog::FileImportDialog(const QString& file, FileKind kind, const QString& question, Jobs& jobs, MessageBar& messages,
                                   QWidget* parent)
    : QDialog(parent), file_(file), kind_(kind), jobs_(jobs), messages_(messages) {
  setObjectName(QStringLiteral("fileImportDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Import"));
  setMinimumWidth(640);
  addRows();
  question_->setText(question);
  if (kind_ == FileKind::dicomPictures || kind_ == FileKind::dicomVolume) inspect();
}

FileImportDialog::~FileImportDialog() {
  for (const int job : {job_, preview_})
    if (job != 0) jobs_.cancel(job);
}

void FileImportDialog::addRows() {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(24, 24, 24, 24);
  outer->setSpacing(16);
  auto* title = new QLabel(QFileInfo(file_).fileName());
  title->setProperty("heading", true);
  title->setToolTip(file_);
  outer->addWidget(title);
  question_ = new QLabel;
  question_->setObjectName(QStringLiteral("importQuestion"));
  question_->setWordWrap(true);
  outer->addWidget(question_);

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  if (kind_ == FileKind::dicomPictures) {
    region_ = new QComboBox;
    region_->setObjectName(QStringLiteral("region"));
    region_->addItem(tr("not chosen"), -1);
    pixel_ = {lengthBox(QStringLiteral("pixelX")), lengthBox(QStringLiteral("pixelY"))};
    keepText_ = new QCheckBox(tr("Text burned into the pictures may stay"));
    form->addRow(tr("Part of the picture"), region_);
    form->addRow(tr("Size of a pixel"), inRow(pixel_));
  }
  if (kind_ != FileKind::dicomPictures && kind_ != FileKind::dicomVolume) {
    spacing_ = {lengthBox(QStringLiteral("spacingX")), lengthBox(QStringLiteral("spacingY")), lengthBox(QStringLiteral("spacingZ"))};
    form->addRow(kind_ == FileKind::kretz ? tr("Spacing to convert to") : tr("Spacing x, y, z"),
                 kind_ == FileKind::kretz ? inRow(std::array{spacing_[0]}) : inRow(spacing_));
    if (kind_ == FileKind::kretz)
      for (std::size_t axis : {1u, 2u}) spacing_[axis]->setParent(this), spacing_[axis]->hide();
  }
  if (kind_ == FileKind::raw) addRawRows(*form);
  if (kind_ == FileKind::dicomPictures || kind_ == FileKind::pictures) {
    colour_ = new QComboBox;
    colour_->setObjectName(QStringLiteral("colour"));
    colour_->addItem(tr("not said"), static_cast<int>(ColourRule::ask));
    colour_->addItem(tr("keep as grey"), static_cast<int>(ColourRule::keepGrey));
    colour_->addItem(tr("drop (black)"), static_cast<int>(ColourRule::dropColour));
    blank_ = new QLineEdit;
    blank_->setObjectName(QStringLiteral("blank"));
    blank_->setPlaceholderText(tr("x,y,width,height; more with blanks between them"));
    form->addRow(tr("Coloured pixels"), colour_);
    form->addRow(tr("Make black"), blank_);
    if (keepText_ != nullptr) form->addRow(QString(), keepText_);
  }
  if (kind_ == FileKind::volume || kind_ == FileKind::kretz || kind_ == FileKind::dicomVolume) {
    timeStep_ = new QSpinBox;
    timeStep_->setObjectName(QStringLiteral("timeStep"));
    timeStep_->setRange(0, 100000);
    timeStep_->setSpecialValueText(tr("the only one"));
    form->addRow(tr("Volume number"), timeStep_);
  }
  if (kind_ == FileKind::kretz) {
    mirrored_ = new QCheckBox(tr("Turn the elevational axis over"));
    form->addRow(QString(), mirrored_);
  }
  outer->addLayout(form);
  if (kind_ == FileKind::raw) {
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    for (auto*& slice : slices_) {
      slice = new QLabel;
      slice->setFixedSize(kSlice_px, kSlice_px);
      slice->setAlignment(Qt::AlignCenter);
      row->addWidget(slice);
    }
    slices_[0]->setObjectName(QStringLiteral("rawPreview"));
    row->addStretch(1);
    outer->addLayout(row);
  }
  removed_ = new QLabel;
  removed_->setObjectName(QStringLiteral("importRemoved"));
  removed_->setProperty("small", true);
  removed_->setWordWrap(true);
  outer->addWidget(removed_);
  outer->addStretch(1);

  import_ = new QPushButton(tr("Import"));
  import_->setObjectName(QStringLiteral("importFile"));
  import_->setProperty("primary", true);
  import_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch(1);
  buttons->addWidget(cancel);
  buttons->addWidget(import_);
  outer->addLayout(buttons);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(import_, &QPushButton::clicked, this, &FileImportDialog::start);
}

void FileImportDialog::addRawRows(QFormLayout& form) {
  guess_ = new QComboBox;
  guess_->setObjectName(QStringLiteral("rawGuess"));
  guess_->addItem(tr("none"));
  const auto guesses = guessRawLayouts(static_cast<std::uint64_t>(QFileInfo(file_).size()));
  for (const RawLayout& layout : guesses)
    guess_->addItem(tr("%1 x %2 x %3, %4, after %5 bytes")
                        .arg(layout.dims.x)
                        .arg(layout.dims.y)
                        .arg(layout.dims.z)
                        .arg(QLatin1String(nameOf(layout.type)))
                        .arg(layout.offset));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    dims_[axis] = new QSpinBox;
    dims_[axis]->setObjectName(QStringLiteral("rawDim%1").arg(axis));
    dims_[axis]->setRange(1, 65536);
  }
  type_ = new QComboBox;
  for (const RawType type : {RawType::u8, RawType::i8, RawType::u16, RawType::i16, RawType::u32, RawType::i32, RawType::f32, RawType::f64})
    type_->addItem(QLatin1String(nameOf(type)), static_cast<int>(type));
  bigEndian_ = new QCheckBox(tr("big endian"));
  offset_ = new QSpinBox;
  offset_->setRange(0, 1 << 30);
  offset_->setSuffix(tr(" bytes"));
  form.addRow(tr("Layouts that fit the size"), guess_);
  form.addRow(tr("Samples x, y, z"), inRow(dims_));
  form.addRow(tr("Type"), inRow(std::array<QWidget*, 2>{type_, bigEndian_}));
  form.addRow(tr("Samples begin after"), offset_);
  connect(guess_, qOverload<int>(&QComboBox::activated), this, [this, guesses](int index) {
    if (index < 1 || static_cast<std::size_t>(index) > guesses.size()) return;
    const RawLayout& layout = guesses[static_cast<std::size_t>(index) - 1];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const QSignalBlocker quiet(dims_[axis]);
      dims_[axis]->setValue(layout.dims[static_cast<int>(axis)]);
    }
    type_->setCurrentIndex(type_->findData(static_cast<int>(layout.type)));
    const QSignalBlocker quiet(offset_);
    offset_->setValue(static_cast<int>(layout.offset));
    showPreview();
  });
  for (QSpinBox* box : {dims_[0], dims_[1], dims_[2], offset_})
    connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &FileImportDialog::showPreview);
  connect(type_, qOverload<int>(&QComboBox::activated), this, &FileImportDialog::showPreview);
  connect(bigEndian_, &QCheckBox::toggled, this, &FileImportDialog::showPreview);
}

RawLayout FileImportDialog::rawLayout() const {
  RawLayout layout;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    layout.dims[static_cast<int>(axis)] = dims_[axis]->value();
    layout.spacing_mm[static_cast<int>(axis)] = spacing_[axis]->value();
  }
  layout.type = static_cast<RawType>(type_->currentData().toInt());
  layout.bigEndian = bigEndian_->isChecked();
  layout.offset = static_cast<std::uint64_t>(offset_->value());
  return layout;
}

void FileImportDialog::showPreview() {
  // Each key is another layout, and of a large file every one takes a while: the newest wins.
  if (preview_ != 0) jobs_.cancel(preview_);
  const RawLayout layout = rawLayout();
  auto slices = std::make_shared<RawPreview>();
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(
      tr("Reading the slices of %1").arg(QFileInfo(file_).fileName()),
      [slices, layout, file = pathOf(file_)](Progress& progress) -> Result<void> {
        auto read = previewRawVolume(file, layout, progress);
        if (!read) return passOn(read.error());
        *slices = std::move(*read);
        return {};
      },
      [here = QPointer<FileImportDialog>(this), slices, layout, id](const Result<void>& outcome) {
        FileImportDialog* const dialog = here.data();
        if (dialog == nullptr || dialog->preview_ != *id) return;
        dialog->preview_ = 0;
        dialog->takePreview(*slices, layout, outcome);
      });
  preview_ = *id;
}

void FileImportDialog::takePreview(const RawPreview& slices, const RawLayout& layout, const Result<void>& outcome) {
  if (!outcome) {
    for (QLabel* slice : slices_) slice->clear();
    if (outcome.error().code != ErrorCode::cancelled) refuse(words(outcome.error().sentence));
    import_->setEnabled(true);
    return;
  }
  question_->clear();
  const auto show = [](QLabel* label, const std::vector<std::uint8_t>& levels, int width, int height) {
    const QImage image(levels.data(), width, height, width, QImage::Format_Grayscale8);
    label->setPixmap(QPixmap::fromImage(image).scaled(kSlice_px, kSlice_px, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  };
  show(slices_[0], slices.xy, layout.dims.x, layout.dims.y);
  show(slices_[1], slices.xz, layout.dims.x, layout.dims.z);
  show(slices_[2], slices.yz, layout.dims.y, layout.dims.z);
}

void FileImportDialog::inspect() {
  auto found = std::make_shared<std::optional<DicomSummary>>();
  const QPointer<FileImportDialog> here(this);
  job_ = jobs_.start(
      tr("Reading %1").arg(QFileInfo(file_).fileName()),
      [found, file = pathOf(file_)](Progress&) -> Result<void> {
        auto summary = inspectDicom(file);
        if (!summary) return passOn(summary.error());
        *found = std::move(*summary);
        return {};
      },
      [here, found](const Result<void>& outcome) {
        FileImportDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->job_ = 0;
        if (outcome && *found)
          dialog->takeSummary(**found);
        else if (!outcome)
          dialog->refuse(words(outcome.error().sentence));
      });
}

void FileImportDialog::takeSummary(const DicomSummary& summary) {
  if (region_ != nullptr) {
    for (std::size_t n = 0; n < summary.regions.size(); ++n)
      region_->addItem(words(summary.regions[n].describe(n + 1)), static_cast<int>(n) + 1);
    region_->addItem(tr("the whole picture, %1 x %2 pixels").arg(summary.columns).arg(summary.rows), 0);
  }
  QStringList lines;
  for (const std::string& sentence : sentencesOf(summary.identifying)) lines << words(sentence);
  removed_->setText(lines.join(QLatin1Char('\n')));
}

Result<ImportAnswers> FileImportDialog::answers() const {
  ImportAnswers answers;
  if (region_ != nullptr && region_->currentData().toInt() >= 0) answers.region = region_->currentData().toInt();
  if (pixel_[0] != nullptr && pixel_[0]->value() > 0.0 && pixel_[1]->value() > 0.0)
    answers.pixel_mm = glm::dvec2(pixel_[0]->value(), pixel_[1]->value());
  if (colour_ != nullptr) answers.colour = static_cast<ColourRule>(colour_->currentData().toInt());
  if (keepText_ != nullptr) answers.keepText = keepText_->isChecked();
  if (mirrored_ != nullptr) answers.mirrored = mirrored_->isChecked();
  if (timeStep_ != nullptr && timeStep_->value() > 0) answers.timeStep = timeStep_->value();
  if (blank_ != nullptr)
    for (const QString& text : blank_->text().split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts)) {
      const auto rect = parsePixelRect(text.toStdString());
      if (!rect) return passOn(rect.error());
      answers.blank.push_back(*rect);
    }
  if (kind_ == FileKind::raw) {
    answers.raw = rawLayout();
  } else if (kind_ == FileKind::kretz) {
    if (spacing_[0]->value() > 0.0) answers.spacing_mm = glm::dvec3(spacing_[0]->value());
  } else if (spacing_[0] != nullptr &&
             std::all_of(spacing_.begin(), spacing_.end(), [](const QDoubleSpinBox* box) { return box->value() > 0.0; })) {
    answers.spacing_mm = glm::dvec3(spacing_[0]->value(), spacing_[1]->value(), spacing_[2]->value());
  }
  return answers;
}

void FileImportDialog::refuse(const QString& why) {
  question_->setStyleSheet(QStringLiteral("color: %1;").arg(currentTheme().danger.name()));
  question_->setText(why);
}

void FileImportDialog::start() {
  const auto given = answers();
  if (!given) return refuse(words(given.error().sentence));
  if (job_ != 0) jobs_.cancel(job_);
  import_->setEnabled(false);
  auto made = std::make_shared<ImportedFile>();
  const QPointer<FileImportDialog> here(this);
  job_ = jobs_.start(
      tr("Importing %1").arg(QFileInfo(file_).fileName()),
      [made, file = pathOf(file_), chosen = *given](Progress& progress) -> Result<void> {
        auto read = importFile(file, chosen, progress);
        if (!read) return passOn(read.error());
        *made = std::move(*read);
        return {};
      },
      [here, made](const Result<void>& outcome) {
        FileImportDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->job_ = 0;
        dialog->import_->setEnabled(true);
        if (outcome)
          dialog->take(made);
        else if (outcome.error().code != ErrorCode::cancelled)
          dialog->refuse(words(outcome.error().sentence));
      });
}

void FileImportDialog::take(const std::shared_ptr<ImportedFile>& made) {
  for (const std::string& note : made->notes) messages_.showNote(words(note));
  for (const std::string& sentence : sentencesOf(made->removed)) messages_.showNote(words(sentence));
  if (!made->volume) return saveSequence(made);
  Q_EMIT imported(std::make_shared<const Volume>(std::move(*made->volume)), QFileInfo(file_).fileName());
  close();
}

void FileImportDialog::saveSequence(const std::shared_ptr<ImportedFile>& made) {
  // Pictures without a place are no volume: they are kept as a sequence, to be reconstructed with what a motor file says.
  const QFileInfo info(file_);
  const QString target = askSaveFile(this, {tr("Save the pictures as a sequence"),
                                            info.path() + QLatin1Char('/') + info.completeBaseName() + QStringLiteral(".igs.mha"),
                                            tr("Sequences (*.igs.mha)"),
                                            {QStringLiteral(".igs.mha"), QStringLiteral(".mha")}});
  if (target.isEmpty()) return;
  jobs_.start(
      tr("Writing %1").arg(QFileInfo(target).fileName()),
      [made, target](Progress& progress) { return writeSequence(made->pictures->sequence, pathOf(target), progress); },
      [messages = QPointer<MessageBar>(&messages_), target](const Result<void>& outcome) {
        if (!messages) return;
        if (!outcome) return messages->showError(outcome.error());
        messages->showNote(tr("Wrote %1; reconstruct it with a file that says how the probe moved.").arg(QFileInfo(target).fileName()));
      },
      Jobs::Kind::saving);
  close();
}

}  // namespace ew::ui
