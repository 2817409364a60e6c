#include "import/file_import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPixmap>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/io/sequence.h"
#include "ew/widgets/image_chooser.h"
#include "ew/widgets/look.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/small_result_question.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "import/import_fields.h"
#include "jobs/jobs.h"
#include "jobs/message_bar.h"

namespace ew::ui {
namespace {

constexpr int kSlice_px = 160;

/// Millimetres where 0 stands for "not said".
QDoubleSpinBox* lengthBox(const char* name) {
  auto* box = numberBox(name, 0.0, 100.0, 0.1, 4, FileImportDialog::tr(" mm"));
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
    : FormDialog(QFileInfo(file).fileName(), file, parent), file_(file), kind_(kind), jobs_(jobs), messages_(messages) {
  setObjectName(QStringLiteral("fileImportDialog"));
  setWindowTitle(tr("Import"));
  sentence().setObjectName(QStringLiteral("importQuestion"));
  addRows();
  say(question, false);
  if (kind_ != FileKind::raw) look();
}

FileImportDialog::~FileImportDialog() {
  for (const int job : {job_, preview_})
    if (job != 0) jobs_.cancel(job);
}

void FileImportDialog::addRows() {
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  if (kind_ == FileKind::dicomImages || kind_ == FileKind::dicomStack || kind_ == FileKind::images) addImageRows(*form);
  if (kind_ != FileKind::dicomImages && kind_ != FileKind::dicomVolume && kind_ != FileKind::dicomStack) {
    spacing_ = {lengthBox("spacingX"), lengthBox("spacingY"), lengthBox("spacingZ")};
    form->addRow(kind_ == FileKind::kretz ? tr("Spacing to convert to") : tr("Spacing x, y, z"),
                 kind_ == FileKind::kretz ? inRow(std::array{spacing_[0]}) : inRow(spacing_));
    if (kind_ == FileKind::kretz)
      for (std::size_t axis : {1u, 2u}) spacing_[axis]->setParent(this), spacing_[axis]->hide();
  }
  if (kind_ == FileKind::raw) addRawRows(*form);
  if (kind_ == FileKind::volume || kind_ == FileKind::kretz || kind_ == FileKind::dicomVolume) {
    timeStep_ = new QSpinBox;
    timeStep_->setObjectName(QStringLiteral("timeStep"));
    timeStep_->setRange(0, 100000);
    timeStep_->setSpecialValueText(tr("not chosen"));
    form->addRow(tr("Volume number"), timeStep_);
  }
  if (kind_ == FileKind::kretz) {
    mirrored_ = new QCheckBox(tr("Turn the elevational axis over"));
    form->addRow(QString(), mirrored_);
  }
  rows().addLayout(form);
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
    rows().addLayout(row);
  }
  removed_ = new QLabel;
  removed_->setObjectName(QStringLiteral("importRemoved"));
  setLook(removed_, Look::small);
  removed_->setWordWrap(true);
  rows().addWidget(removed_);
  rows().addStretch(1);

  import_ = new QPushButton(tr("Import"));
  import_->setObjectName(QStringLiteral("importFile"));
  setLook(import_, Look::primary);
  import_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"));
  if (image_ != nullptr && kind_ != FileKind::dicomStack) {
    auto* screen = new QPushButton(tr("Clean as a recorded screen…"));
    screen->setObjectName(QStringLiteral("cleanScreen"));
    screen->setAutoDefault(false);
    screen->setToolTip(tr("Finds the outline of the scan, its scale and text over it; the images are shown, played and measured"));
    buttons().insertWidget(0, screen);
    connect(screen, &QPushButton::clicked, this, [this] {
      close();
      Q_EMIT screenChosen();
    });
  }
  buttons().addWidget(cancel);
  buttons().addWidget(import_);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(import_, &QPushButton::clicked, this, &FileImportDialog::start);
}

void FileImportDialog::addImageRows(QFormLayout& form) {
  image_ = new ImageChooser;
  auto* column = new QWidget;
  auto* below = new QVBoxLayout(column);
  below->setContentsMargins(0, 0, 0, 0);
  below->setSpacing(8);
  below->addWidget(image_, 1);
  auto* hint = new QLabel(kind_ == FileKind::dicomImages
                              ? tr("Click a numbered part to keep it alone. Drag a rectangle over what is to become black; a right click "
                                   "on it takes it away. Coloured pixels are orange.")
                              : tr("Drag a rectangle over what is to become black; a right click on it takes it away. Coloured pixels "
                                   "are orange."));
  setLook(hint, Look::quiet);
  hint->setWordWrap(true);
  below->addWidget(hint);
  putBeside(column, {960, 560});
  if (kind_ == FileKind::dicomImages) {
    region_ = new QComboBox;
    region_->setObjectName(QStringLiteral("region"));
    region_->addItem(tr("not chosen"), -1);
    // Regions are told apart by whole sentences: the list is as wide as they are, the field need not be.
    region_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    region_->setMinimumContentsLength(24);
    pixel_ = {lengthBox("pixelX"), lengthBox("pixelY")};
    form.addRow(tr("Part of the image"), region_);
    form.addRow(tr("Size of a pixel"), inRow(pixel_));
    rate_ = new QDoubleSpinBox;
    rate_->setObjectName(QStringLiteral("rate"));
    rate_->setRange(0.0, 10000.0);
    rate_->setSpecialValueText(tr("as the file says"));
    rate_->setToolTip(tr("Of a cine whose file does not say when its images were taken, or says it wrongly"));
    form.addRow(tr("Images a second"), rate_);
    connect(region_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
      const int region = region_->currentData().toInt();
      region_->setToolTip(region_->currentText());
      image_->setChosenPart(region > 0 ? std::optional(static_cast<std::size_t>(region) - 1) : std::nullopt);
    });
    connect(image_, &ImageChooser::partClicked, this, [this](int part) { region_->setCurrentIndex(region_->findData(part + 1)); });
  }
  colour_ = new QComboBox;
  colour_->setObjectName(QStringLiteral("colour"));
  colour_->addItem(tr("not said"), static_cast<int>(ColourRule::ask));
  colour_->addItem(tr("keep as grey"), static_cast<int>(ColourRule::keepGrey));
  colour_->addItem(tr("drop (black)"), static_cast<int>(ColourRule::dropColour));
  blank_ = new QLineEdit;
  blank_->setObjectName(QStringLiteral("blank"));
  blank_->setPlaceholderText(tr("drawn, or x,y,width,height"));
  blank_->setToolTip(tr("x,y,width,height; more with blanks between them"));
  form.addRow(tr("Coloured pixels"), colour_);
  form.addRow(tr("Make black"), blank_);
  connect(blank_, &QLineEdit::textChanged, this, &FileImportDialog::showBlanked);
  connect(image_, &ImageChooser::drawn, this, &FileImportDialog::blankMore);
  connect(image_, &ImageChooser::blankRemoved, this, &FileImportDialog::blankLess);
  if (kind_ == FileKind::images) return;
  keepText_ = new QCheckBox(tr("Text burned into the images may stay"));
  form.addRow(QString(), keepText_);
}

Result<std::vector<PixelRect>> FileImportDialog::blanked() const {
  std::vector<PixelRect> rects;
  for (const QString& text : blank_->text().split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts)) {
    const auto rect = parsePixelRect(text.toStdString());
    if (!rect) return passOn(rect.error());
    rects.push_back(*rect);
  }
  return rects;
}

void FileImportDialog::showBlanked() {
  if (const auto rects = blanked()) image_->setBlanked(*rects);
}

void FileImportDialog::blankMore(const PixelRect& rect) {
  const QString text = QStringLiteral("%1,%2,%3,%4").arg(rect.x).arg(rect.y).arg(rect.width).arg(rect.height);
  blank_->setText((blank_->text().trimmed() + QLatin1Char(' ') + text).trimmed());
}

void FileImportDialog::blankLess(int number) {
  QStringList all = blank_->text().split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
  if (number >= 0 && number < all.size()) all.removeAt(number);
  blank_->setText(all.join(QLatin1Char(' ')));
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
    if (outcome.error().code != ErrorCode::cancelled) refuse(words(outcome.error().message));
    import_->setEnabled(true);
    return;
  }
  say({}, false);
  const auto show = [](QLabel* label, const std::vector<std::uint8_t>& levels, int width, int height) {
    const QImage image(levels.data(), width, height, width, QImage::Format_Grayscale8);
    label->setPixmap(QPixmap::fromImage(image).scaled(kSlice_px, kSlice_px, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  };
  show(slices_[0], slices.xy, layout.dims.x, layout.dims.y);
  show(slices_[1], slices.xz, layout.dims.x, layout.dims.z);
  show(slices_[2], slices.yz, layout.dims.y, layout.dims.z);
}

void FileImportDialog::look() {
  auto found = std::make_shared<std::optional<ImportPreview>>();
  const QPointer<FileImportDialog> here(this);
  job_ = jobs_.start(
      tr("Reading %1").arg(QFileInfo(file_).fileName()),
      [found, file = pathOf(file_), kind = kind_](Progress& progress) -> Result<void> {
        auto preview = previewImport(file, kind, progress);
        if (!preview) return passOn(preview.error());
        *found = std::move(*preview);
        return {};
      },
      [here, found](const Result<void>& outcome) {
        FileImportDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->job_ = 0;
        if (outcome && *found)
          dialog->takeLook(**found);
        else if (!outcome && outcome.error().code != ErrorCode::cancelled)
          dialog->refuse(words(outcome.error().message));
      });
}

void FileImportDialog::takeLook(const ImportPreview& preview) {
  if (image_ != nullptr && preview.image.width > 0) image_->setImage(preview.image, preview.coloured);
  if (timeStep_ != nullptr && preview.volumes > 0) {
    const int volumes = static_cast<int>(std::min<std::uint64_t>(preview.volumes, 100000));
    timeStep_->setMaximum(volumes);
    timeStep_->setSpecialValueText(volumes == 1 ? tr("the only one") : tr("1 to %1, not chosen").arg(volumes));
    timeStep_->setEnabled(volumes > 1);
  }
  if (kind_ == FileKind::volume && preview.spacing_mm)
    for (std::size_t axis = 0; axis < 3; ++axis)
      spacing_[axis]->setSpecialValueText(tr("%1 mm").arg(QLocale().toString((*preview.spacing_mm)[static_cast<int>(axis)], 'g', 4)));
  if (!preview.dicom) return;
  const DicomSummary& summary = *preview.dicom;
  if (region_ != nullptr) {
    std::vector<PixelRect> parts;
    for (std::size_t n = 0; n < summary.regions.size(); ++n) {
      region_->addItem(words(summary.regions[n].describe(n + 1)), static_cast<int>(n) + 1);
      parts.push_back(summary.regions[n].rect);
    }
    region_->addItem(tr("the whole image, %1 x %2 pixels").arg(summary.columns).arg(summary.rows), 0);
    for (int n = 0; n < region_->count(); ++n) region_->setItemData(n, region_->itemText(n), Qt::ToolTipRole);
    image_->setParts(std::move(parts));
  }
  QStringList lines;
  for (const Message& sentence : sentencesOf(summary.identifying)) lines << words(sentence);
  removed_->setText(lines.join(QLatin1Char('\n')));
  grow();
}

Result<ImportAnswers> FileImportDialog::answers() const {
  ImportAnswers answers;
  if (region_ != nullptr && region_->currentData().toInt() >= 0) answers.region = region_->currentData().toInt();
  if (pixel_[0] != nullptr && pixel_[0]->value() > 0.0 && pixel_[1]->value() > 0.0)
    answers.pixel_mm = glm::dvec2(pixel_[0]->value(), pixel_[1]->value());
  if (rate_ != nullptr && rate_->value() > 0.0) answers.rate_hz = rate_->value();
  if (colour_ != nullptr) answers.colour = static_cast<ColourRule>(colour_->currentData().toInt());
  if (keepText_ != nullptr) answers.keepText = keepText_->isChecked();
  if (mirrored_ != nullptr) answers.mirrored = mirrored_->isChecked();
  if (timeStep_ != nullptr && timeStep_->value() > 0) answers.timeStep = timeStep_->value();
  if (blank_ != nullptr) {
    auto rects = blanked();
    if (!rects) return passOn(rects.error());
    answers.blank = std::move(*rects);
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

void FileImportDialog::refuse(const QString& why) { say(why, true); }

/// What a file became: a volume ready to be scanned, or images without a place.
struct FileImportDialog::Made {
  FileImportResult file;
  ScanVoxels voxels;  ///< empty: the images are no volume
};

void FileImportDialog::start(bool acceptsSmall) {
  auto given = answers();
  if (!given) return refuse(words(given.error().message));
  given->acceptsSmall = acceptsSmall;
  if (job_ != 0) jobs_.cancel(job_);
  import_->setEnabled(false);
  auto made = std::make_shared<Made>();
  const QPointer<FileImportDialog> here(this);
  job_ = jobs_.start(
      tr("Importing %1").arg(QFileInfo(file_).fileName()),
      [made, file = pathOf(file_), chosen = *given](Progress& progress) -> Result<void> {
        PartOfProgress most(progress, 0.0, 0.95), rest(progress, 0.95, 1.0);
        auto read = importFile(file, chosen, most);
        if (!read) return passOn(read.error());
        made->file = std::move(*read);
        if (!made->file.volume) return {};
        auto voxels = ScanVoxels::of(std::make_shared<const Volume>(std::move(*made->file.volume)), rest);
        if (!voxels) return passOn(voxels.error());
        made->voxels = std::move(*voxels);
        return {};
      },
      [here, made](const Result<void>& outcome) {
        FileImportDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->job_ = 0;
        dialog->import_->setEnabled(true);
        if (outcome)
          dialog->take(made);
        else if (askedFor(outcome.error()) == "accept-small")
          dialog->askSmall(words(outcome.error().message));
        else if (outcome.error().code != ErrorCode::cancelled)
          dialog->refuse(words(outcome.error().message));
      });
}

void FileImportDialog::askSmall(const QString& sentence) {
  const QPointer<FileImportDialog> here(this);
  const bool accepted = askAcceptsSmall(this, sentence);
  if (!here) return;
  if (accepted)
    start(true);
  else
    refuse(sentence);
}

void FileImportDialog::take(const std::shared_ptr<Made>& made) {
  std::vector<Message> notes = made->file.notes;
  for (Message& sentence : sentencesOf(made->file.removed)) notes.push_back(std::move(sentence));
  messages_.forgetWhatIsPast();
  // What makes the result doubtful stands in front, not among the details.
  messages_.showNotes(made->file.warnings.empty()
                          ? tr("%1 was imported; %n notes say what was decided and left out.", nullptr, static_cast<int>(notes.size()))
                                .arg(QFileInfo(file_).fileName())
                          : words(joined(made->file.warnings)),
                      notes, QStringLiteral("open"));
  if (made->voxels.empty()) return saveSequence(made);
  Q_EMIT imported(made->voxels, QFileInfo(file_).fileName());
  close();
}

void FileImportDialog::saveSequence(const std::shared_ptr<Made>& made) {
  // Images without a place are no volume: they are kept as a sequence, and how the probe moved is asked next.
  const QFileInfo info(file_);
  const QString target = askSaveFile(this, {tr("Save the images as a sequence"),
                                            info.path() + QLatin1Char('/') + info.completeBaseName() + QStringLiteral(".igs.mha"),
                                            tr("Sequences (*.igs.mha)"),
                                            {QStringLiteral(".igs.mha"), QStringLiteral(".mha")},
                                            {},
                                            {},
                                            {pathOf(file_)}});
  if (target.isEmpty()) return;
  import_->setEnabled(false);
  jobs_.start(
      tr("Writing %1").arg(QFileInfo(target).fileName()),
      [made, file = pathOf(target)](Progress& progress) {
        return saveTogether(
            {file}, [&](const OutputSet& outputs) { return writeSequence(made->file.images->sequence, outputs.staged(file), progress); });
      },
      [here = QPointer<FileImportDialog>(this), messages = QPointer<MessageBar>(&messages_), target](const Result<void>& outcome) {
        if (FileImportDialog* const dialog = here.data(); dialog != nullptr) {
          dialog->import_->setEnabled(true);
          if (!outcome) return dialog->refuse(words(outcome.error().message));
          Q_EMIT dialog->sequenceSaved(target);
          dialog->close();
        } else if (messages && !outcome && outcome.error().code != ErrorCode::cancelled) {
          messages->showError(outcome.error(), QStringLiteral("save ") + target);
        }
      },
      Jobs::Kind::saving);
}

}  // namespace ew::ui
