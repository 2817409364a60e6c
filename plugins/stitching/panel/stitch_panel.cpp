#include "panel/stitch_panel.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QListWidget>
#include <QLocale>
#include <QMimeData>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>
#include <QUrl>

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::kGap_px;

QString wordsOf(const fs::path& path) { return sdk::words(path.string()); }

QString mebibytes(double bytes) {
  const double mib = bytes / (1024.0 * 1024.0);
  return mib < 1024.0 ? QStringLiteral("%1 MiB").arg(mib, 0, 'f', mib < 10.0 ? 1 : 0)
                      : QStringLiteral("%1 GiB").arg(mib / 1024.0, 0, 'f', 1);
}

QString sizeOf(const Grid& grid) { return QStringLiteral("%1 × %2 × %3").arg(grid.dims.x).arg(grid.dims.y).arg(grid.dims.z); }

bool isProject(const fs::path& file) { return file.extension() == ".json"; }

}  // namespace

StitchPanel::StitchPanel(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("stitchPanel"));
  setAcceptDrops(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  auto* add = new QPushButton(tr("Add volumes…"));
  add->setObjectName(QStringLiteral("addFirst"));
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  pages_->addWidget(sdk::emptyState(tr("Join volumes into one"),
                                    tr("Add two or more volumes whose places are known, or drop their files or a stitch project here."),
                                    add));
  pages_->addWidget(makeWorkPage());
  column->addWidget(pages_, 1);
  problem_ = sdk::problemLabel(this);
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setContentsMargins(2 * kGap_px, kGap_px, 2 * kGap_px, kGap_px);
  column->addWidget(problem_);
}

QWidget* StitchPanel::makeWorkPage() {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2 * kGap_px, 2 * kGap_px, 2 * kGap_px, 2 * kGap_px);
  column->setSpacing(kGap_px);

  auto* top = new QHBoxLayout;
  top->addWidget(sdk::headingLabel(tr("Volumes")), 1);
  auto* add = new QPushButton(tr("Add…"));
  add->setProperty("flat", true);
  add->setToolTip(tr("Add volume files or a stitch project"));
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  top->addWidget(add);
  column->addLayout(top);

  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("volumes"));
  list_->setMinimumHeight(12 * kGap_px);
  connect(list_, &QListWidget::currentRowChanged, this, [this] { showSelected(); });
  column->addWidget(list_, 1);
  column->addWidget(makeVolumeBox());
  column->addSpacing(kGap_px);
  column->addWidget(makeResultBox());
  scroll->setWidget(page);
  return scroll;
}

QWidget* StitchPanel::makeVolumeBox() {
  volumeBox_ = new QWidget;
  auto* column = new QVBoxLayout(volumeBox_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  volumeLine_ = sdk::quietLabel({});
  column->addWidget(volumeLine_);
  column->addWidget(sdk::headingLabel(tr("Place")));
  placement_ = new sdk::PlacementFields;
  placement_->onChanged = [this](const glm::dmat4& matrix) {
    if (Entry* entry = selected()) entry->place.toWorld = matrix;
    showForecast();
  };
  column->addWidget(placement_);
  coverageLine_ = sdk::quietLabel({});
  column->addWidget(coverageLine_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap_px);
  const auto button = [&](const QString& text, const QString& hint, void (StitchPanel::*does)()) {
    auto* made = new QPushButton(text);
    made->setToolTip(hint);
    connect(made, &QPushButton::clicked, this, does);
    buttons->addWidget(made);
    return made;
  };
  button(tr("Transform…"), tr("Take the place from a file with 16 numbers, row by row"), &StitchPanel::chooseTransform);
  button(tr("Coverage…"), tr("Say which voxels were measured, from a coverage file"), &StitchPanel::chooseCoverage);
  button(tr("Remove"), tr("Take this volume off the list; its file stays"), &StitchPanel::removeSelected)
      ->setObjectName(QStringLiteral("remove"));
  buttons->addStretch(1);
  column->addLayout(buttons);
  return volumeBox_;
}

QWidget* StitchPanel::makeResultBox() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  column->addWidget(sdk::headingLabel(tr("Result")));
  auto* form = new QFormLayout;
  form->setSpacing(kGap_px);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  spacing_ = new sdk::NumberField(0.0, 20.0, 3, tr("mm"));
  spacing_->setObjectName(QStringLiteral("spacing"));
  spacing_->setSpecialValueText(tr("finest of the volumes"));
  spacing_->setSingleStep(0.1);
  feather_ = new sdk::NumberField(0.0, 200.0, 1, tr("mm"));
  feather_->setObjectName(QStringLiteral("feather"));
  feather_->setSpecialValueText(tr("none: plain mean"));
  feather_->setValue(StitchOptions{}.featherWidth_mm);
  feather_->setToolTip(tr("How far from a volume's border its weight reaches full height"));
  axes_ = new QComboBox;
  axes_->addItem(tr("of the first volume"));
  axes_->addItem(tr("of the body"));
  form->addRow(tr("Voxel spacing"), spacing_);
  form->addRow(tr("Feather"), feather_);
  form->addRow(tr("Axes"), axes_);
  column->addLayout(form);
  for (auto* field : {spacing_, feather_})
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] { showForecast(); });
  connect(axes_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { showForecast(); });

  forecast_ = sdk::quietLabel({});
  forecast_->setObjectName(QStringLiteral("forecast"));
  column->addWidget(forecast_);
  start_ = new QPushButton(tr("Stitch"));
  start_->setObjectName(QStringLiteral("stitch"));
  start_->setProperty("primary", true);
  connect(start_, &QPushButton::clicked, this, &StitchPanel::startStitching);
  column->addWidget(start_);
  outcome_ = sdk::quietLabel({});
  outcome_->setObjectName(QStringLiteral("outcome"));
  column->addWidget(outcome_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap_px);
  save_ = new QPushButton(tr("Save result…"));
  save_->setObjectName(QStringLiteral("saveResult"));
  save_->setVisible(false);
  connect(save_, &QPushButton::clicked, this, &StitchPanel::askWhereToSave);
  buttons->addWidget(save_);
  auto* saveProject = new QPushButton(tr("Save project…"));
  saveProject->setToolTip(tr("Keep the list, the places and the options for later or for the command line"));
  connect(saveProject, &QPushButton::clicked, this, &StitchPanel::askWhereToSaveProject);
  buttons->addWidget(saveProject);
  buttons->addStretch(1);
  column->addLayout(buttons);
  return box;
}

void StitchPanel::say(const Error& problem) {
  if (problem.code == ErrorCode::cancelled) return;  // the user knows
  host_.log().warn(problem.sentence);
  sdk::setProblem(problem_, sdk::words(problem.sentence));
}

StitchPanel::Entry* StitchPanel::selected() {
  const int row = list_->currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < entries_.size() ? &entries_[static_cast<std::size_t>(row)] : nullptr;
}

StitchProject StitchPanel::project() const {
  StitchProject project;
  for (const auto& entry : entries_) project.volumes.push_back(entry.place);
  project.settings.join.grid.spacing_mm = spacing_->value();
  project.settings.join.grid.featherWidth_mm = feather_->value();
  project.settings.join.grid.axes = axes_->currentIndex() == 1 ? GridAxes::world : GridAxes::first;
  return project;
}

void StitchPanel::addFiles(const std::vector<fs::path>& files) {
  sdk::setProblem(problem_, {});
  std::vector<ProjectVolume> places;
  for (const auto& file : files) {
    if (isProject(file)) {
      const auto project = readProject(file);
      places.insert(places.end(), project.begin(), project.end());
    } else {
      ProjectVolume place;
      place.file = file;
      place.name = file.filename().string();
      places.push_back(std::move(place));
    }
  }
  if (!places.empty()) readEntries(std::move(places));
}

std::vector<ProjectVolume> StitchPanel::readProject(const fs::path& file) {
  auto text = host_.files().readText(file);
  if (!text) {
    say(text.error());
    return {};
  }
  auto project = parseProject(*text, file.parent_path(), host_.files());
  if (!project) {
    say(project.error());
    return {};
  }
  spacing_->setValue(project->settings.join.grid.spacing_mm);
  feather_->setValue(project->settings.join.grid.featherWidth_mm);
  axes_->setCurrentIndex(project->settings.join.grid.axes == GridAxes::world ? 1 : 0);
  return project->volumes;
}

void StitchPanel::readEntries(std::vector<ProjectVolume> places) {
  // One job for all: the first volume decides about the result's axes, so the order is the user's, not that of the fastest to read.
  auto read = std::make_shared<std::vector<Entry>>();
  auto& volumes = host_.volumes();
  const QPointer<StitchPanel> here(this);
  const QString what = places.size() == 1 ? tr("Reading %1").arg(wordsOf(places.front().file.filename()))
                                          : tr("Reading %n volumes", nullptr, static_cast<int>(places.size()));
  host_.jobs().start(
      what.toStdString(),
      [read, places = std::move(places), &volumes](Progress& progress) -> Result<void> {
        const double share = 1.0 / static_cast<double>(places.size());
        for (const ProjectVolume& place : places) {
          const double from = share * static_cast<double>(&place - places.data());
          PartOfProgress part(progress, from, from + share);
          auto volume = volumes.read(place.file, part);
          if (!volume) return passOn(volume.error());
          if (!place.coverage.empty()) {
            if (auto covered = volumes.readCoverageInto(*volume, place.coverage, part); !covered) return covered;
          }
          read->push_back({place, std::make_shared<Volume>(std::move(*volume))});
        }
        return {};
      },
      [here, read](const Result<void>& outcome) {
        StitchPanel* panel = here.data();
        if (panel == nullptr) return;
        // What could be read before one that could not stays: its file may have taken minutes.
        for (auto& entry : *read) panel->appendEntry(std::move(entry));
        if (!outcome) panel->say(outcome.error());
      });
}

void StitchPanel::appendEntry(Entry entry) {
  auto* item = new QListWidgetItem(QStringLiteral("%1\n%2").arg(sdk::words(entry.place.name), sizeOf(entry.volume->grid)));
  item->setToolTip(wordsOf(entry.place.file));
  entries_.push_back(std::move(entry));
  list_->addItem(item);
  pages_->setCurrentIndex(1);
  list_->setCurrentRow(list_->count() - 1);
  showSelected();
  showForecast();
}

void StitchPanel::removeSelected() {
  const int row = list_->currentRow();
  if (row < 0) return;
  entries_.erase(entries_.begin() + row);
  delete list_->takeItem(row);
  if (entries_.empty()) pages_->setCurrentIndex(0);
  showSelected();
  showForecast();
}

void StitchPanel::chooseTransform() {
  Entry* entry = selected();
  if (entry == nullptr) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Transform of %1").arg(sdk::words(entry->place.name)), {},
                                                    tr("Transforms (*.txt *.tfm);;All files (*)"));
  if (file.isEmpty()) return;
  auto text = host_.files().readText(file.toStdString());
  if (!text) return say(text.error());
  auto matrix = parseTransform(*text, fs::path(file.toStdString()).filename().string());
  if (!matrix) return say(matrix.error());
  sdk::setProblem(problem_, {});
  entry->place.toWorld = *matrix;
  showSelected();
  showForecast();
}

void StitchPanel::chooseCoverage() {
  Entry* entry = selected();
  if (entry == nullptr) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Coverage of %1").arg(sdk::words(entry->place.name)), {},
                                                    tr("Volumes (*.mha *.mhd *.nrrd *.nii *.nii.gz);;All files (*)"));
  if (file.isEmpty()) return;
  sdk::setProblem(problem_, {});
  auto covered = std::make_shared<Volume>();
  auto& volumes = host_.volumes();
  const auto old = entry->volume;
  const fs::path path = file.toStdString();
  const QPointer<StitchPanel> here(this);
  host_.jobs().start(
      tr("Reading %1").arg(wordsOf(path.filename())).toStdString(),
      [covered, old, path, &volumes](Progress& progress) -> Result<void> {
        *covered = *old;
        return volumes.readCoverageInto(*covered, path, progress);
      },
      [here, covered, old, path](const Result<void>& outcome) {
        StitchPanel* panel = here.data();
        if (panel == nullptr) return;
        if (!outcome) return panel->say(outcome.error());
        for (auto& each : panel->entries_)
          if (each.volume == old) {
            each.volume = covered;
            each.place.coverage = path;
          }
        panel->showSelected();
      });
}

void StitchPanel::showSelected() {
  const Entry* entry = selected();
  volumeBox_->setVisible(entry != nullptr);
  if (entry == nullptr) return;
  const Grid& grid = entry->volume->grid;
  volumeLine_->setText(
      tr("%1 voxels of %2 × %3 × %4 mm").arg(sizeOf(grid)).arg(grid.spacing_mm.x).arg(grid.spacing_mm.y).arg(grid.spacing_mm.z));
  coverageLine_->setText(entry->volume->coverage.empty() ? tr("No coverage: every voxel counts as measured")
                         : entry->place.coverage.empty() ? tr("Coverage from the volume's file")
                                                         : tr("Coverage from %1").arg(wordsOf(entry->place.coverage.filename())));
  placement_->setMatrix(entry->place.toWorld);
}

void StitchPanel::showForecast() {
  if (entries_.empty()) return forecast_->clear();
  std::vector<PlacedGrid> grids;
  for (const auto& entry : entries_) grids.push_back({entry.volume->grid, entry.place.toWorld, entry.place.name});
  const auto forecast = forecastStitch(grids, project().settings.join.grid);
  if (!forecast) return forecast_->setText(sdk::words(forecast.error().sentence));
  const Grid& grid = forecast->grid;
  QString text = tr("%1 voxels of %2 × %3 × %4 mm; needs %5")
                     .arg(sizeOf(grid))
                     .arg(grid.spacing_mm.x)
                     .arg(grid.spacing_mm.y)
                     .arg(grid.spacing_mm.z)
                     .arg(mebibytes(static_cast<double>(forecast->bytes)));
  if (const auto free = availableMemory_bytes()) text += tr(" of %1 free").arg(mebibytes(static_cast<double>(*free)));
  forecast_->setText(text);
}

void StitchPanel::startStitching() {
  if (entries_.empty() || stitching_) return;
  sdk::setProblem(problem_, {});
  const StitchProject asked = project();
  std::vector<std::shared_ptr<const Volume>> held;
  for (const auto& entry : entries_) held.push_back(entry.volume);
  StitchOptions options = asked.settings.join.grid;
  // The machine's own memory is the limit that counts here: swapping would freeze the window.
  if (const auto free = availableMemory_bytes()) options.maxBytes = std::min(options.maxBytes, *free);
  auto made = std::make_shared<Finished>();
  made->project = asked;
  stitching_ = true;
  start_->setText(tr("Stitching…"));
  const QPointer<StitchPanel> here(this);
  host_.jobs().start(
      tr("Stitching %n volume(s)", nullptr, static_cast<int>(held.size())).toStdString(),
      [made, held, options](Progress& progress) -> Result<void> {
        std::vector<PlacedView> inputs;
        for (std::size_t n = 0; n < held.size(); ++n)
          inputs.push_back({held[n].get(), made->project.volumes[n].toWorld, made->project.volumes[n].name});
        auto result = stitch(inputs, options, progress);
        if (!result) return passOn(result.error());
        made->result = std::move(*result);
        return {};
      },
      [here, made](const Result<void>& outcome) {
        StitchPanel* panel = here.data();
        if (panel == nullptr) return;
        panel->stitching_ = false;
        panel->start_->setText(tr("Stitch"));
        if (!outcome) return panel->say(outcome.error());
        panel->finished_ = made;
        panel->showFinished();
      });
}

void StitchPanel::showFinished() {
  const StitchResult& result = finished_->result;
  QString text = tr("Done in %1 s.").arg(result.seconds, 0, 'f', 2);
  if (result.overlapShare > 0.0)
    text += tr(" %1 % of the covered voxels overlap; there the volumes differ by %2 grey levels.")
                .arg(100.0 * result.overlapShare, 0, 'f', 1)
                .arg(result.disagreementRms, 0, 'f', 1);
  for (const auto& note : result.notes) text += QStringLiteral(" ") + sdk::words(note);
  outcome_->setText(text);
  save_->setVisible(true);
  host_.volumes().show(result.volume, tr("Stitched volume").toStdString());
}

void StitchPanel::saveResult(const fs::path& folder) {
  if (!finished_) return;
  sdk::setProblem(problem_, {});
  const QPointer<StitchPanel> here(this);
  host_.jobs().start(
      tr("Saving the stitched volume").toStdString(),
      [finished = finished_, folder, &volumes = host_.volumes(), &files = host_.files()](Progress& progress) -> Result<void> {
        auto written = writeStitch(finished->result, finished->project, folder, volumes, files, progress);
        if (!written) return passOn(written.error());
        return {};
      },
      [here, folder](const Result<void>& outcome) {
        StitchPanel* panel = here.data();
        if (panel == nullptr) return;
        if (!outcome) return panel->say(outcome.error());
        panel->outcome_->setText(tr("Saved in %1: volume.mha, coverage.mha, source.mha and provenance.json.").arg(wordsOf(folder)));
      });
}

void StitchPanel::askForFiles() {
  const QStringList chosen = QFileDialog::getOpenFileNames(
      this, tr("Add volumes"), {}, tr("Volumes and stitch projects (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;All files (*)"));
  std::vector<fs::path> files;
  for (const auto& each : chosen) files.emplace_back(each.toStdString());
  addFiles(files);
}

void StitchPanel::askWhereToSave() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the stitched volume"));
  if (!folder.isEmpty()) saveResult(folder.toStdString());
}

void StitchPanel::askWhereToSaveProject() {
  QString chosen = QFileDialog::getSaveFileName(this, tr("Save the stitch project"), {}, tr("Stitch projects (*.json)"));
  if (chosen.isEmpty()) return;
  if (!chosen.endsWith(QLatin1String(".json"))) chosen += QLatin1String(".json");
  const fs::path file = chosen.toStdString();
  if (auto written = host_.files().writeText(file, projectText(project(), file.parent_path())); !written) return say(written.error());
  outcome_->setText(tr("The project was saved as %1.").arg(wordsOf(file.filename())));
}

void StitchPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StitchPanel::dropEvent(QDropEvent* event) {
  std::vector<fs::path> files;
  for (const auto& url : event->mimeData()->urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  if (files.empty()) return;
  event->acceptProposedAction();
  addFiles(files);
}

}  // namespace ew::stitching
