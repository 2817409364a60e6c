// The rows of the case panel that lead to publishing: what looks real, what is missing, what is measured, where the volume comes from.
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QRandomGenerator>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ew/library/new_case.h"
#include "ew/library/publishing.h"
#include "ew/library/real_looking.h"
#include "ew/sdk/scan.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/measurements.h"
#include "panel/case_panel.h"
#include "panel/fields.h"
#include "panel/files_dialog.h"
#include "panel/give_volume_dialog.h"
#include "panel/images_field.h"
#include "panel/measurements_field.h"
#include "panel/publish_dialog.h"
#include "panel/section.h"

namespace ew::case_authoring {
namespace {

constexpr int kRowsOfIds = 6;

/// The field of the form that a path is about: "previous_examinations[0].findings" stands in "previous_examinations".
std::string rowOf(const std::string& path) { return path.substr(0, path.find('[')); }

}  // namespace

void CasePanel::addName(QFormLayout* form) {
  auto* invent = new QPushButton(tr("Invent"));
  invent->setObjectName(QStringLiteral("inventName"));
  invent->setToolTip(tr("Invent a name: one that nobody has"));
  addLine(form, "patient.name", fieldAt(&CasePatient::name), tr("Name"), tr("Change the patient's name"), invent);
  connect(invent, &QPushButton::clicked, this, [this] {
    const auto present = host_.cases().current();
    if (!present) return;
    const std::string name =
        inventedName(QRandomGenerator::global()->generate64(), QLocale().name().toStdString().substr(0, 2), present->patient.sex);
    change("patient.name", tr("Invent a name"), [&](Case edited) {
      edited.patient.name = name;
      return edited;
    });
    if (const auto now = host_.cases().current()) fields_["patient.name"].show(*now);
  });
}

void CasePanel::addVolume(QFormLayout* form) {
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  auto* what = new QLabel;
  what->setObjectName(QStringLiteral("volumeOfCase"));
  what->setWordWrap(true);
  column->addWidget(what);
  auto* give = new QPushButton;
  give->setObjectName(QStringLiteral("giveVolume"));
  column->addWidget(give, 0, Qt::AlignLeft);
  connect(give, &QPushButton::clicked, this, &CasePanel::giveVolume);
  cell->setFocusProxy(give);
  const std::string path = "volume.file";
  fields_[path] = {
      [what, give](const Case& shown) {
        const std::string &file = shown.volume.file, &recipe = shown.volume.recipe;
        const bool hasNone = hasNoVolume(shown);
        what->setText(hasNone ? tr("none yet") : file.empty() ? tr("made from the virtual patient %1").arg(words(recipe)) : words(file));
        give->setText(hasNone ? tr("Give the case a volume…") : tr("Another volume…"));
      },
      addRow(form, tr("Volume"), cell, path)};
}

void CasePanel::giveVolume() {
  auto* dialog = new GiveVolumeDialog(host_, this);
  connect(dialog, &QDialog::rejected, dialog, &QObject::deleteLater);
  dialog->open();
}

void CasePanel::addMeasurements() {
  const std::string path = "measurements";
  QFormLayout* form = &addSection(QStringLiteral("measurements"), tr("Expected measurements"))->form();
  auto* field = new MeasurementsField;
  field->onChanged = [this, path](const std::vector<CaseMeasurement>& list) {
    change(path, tr("Change the expected measurements"), [&](Case edited) {
      edited.measurements = list;
      return edited;
    });
  };
  field->onTake = [this](const CaseMeasurement& expected) { return takeCaliper(expected); };
  fields_[path] = {[field](const Case& shown) {
                     field->setPatientKnows(!shown.volume.recipe.empty());
                     field->setValue(shown.measurements);
                   },
                   addRow(form, {}, field, path)};
}

std::optional<CaseMeasurement> CasePanel::takeCaliper(const CaseMeasurement& expected) {
  const auto now = host_.cases().current();
  const auto state = host_.scan().state();
  if (!now || !state || !host_.cases().scan()) {
    setProblem(problem_, tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
    return std::nullopt;
  }
  auto taken = withCaliper(expected, host_.scan().measurements(), inverse(now->volume.fileToWorld) * state->pose.probeToWorld);
  if (taken) return std::move(*taken);
  say(taken.error());
  return std::nullopt;
}

void CasePanel::addIds(QFormLayout* form, const std::string& path, const QString& label, const QString& none, const QString& atStart,
                       const std::vector<std::pair<std::string, std::string>>& known, const CaseTexts& ids) {
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  auto* hint = quietLabel({});
  hint->setObjectName(nameOf(path) + QStringLiteral("_hint"));
  column->addWidget(hint);
  auto* list = new WheelWithFocus<QListWidget>;
  list->setObjectName(nameOf(path));
  list->setAccessibleName(label);
  list->setSelectionMode(QAbstractItemView::SingleSelection);
  list->setWordWrap(true);  // a long name takes two lines, and none is cut
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto add = [list](const std::string& id, const QString& name) {
    auto* item = new QListWidgetItem(name, list);
    item->setData(Qt::UserRole, words(id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
  };
  for (const auto& [id, name] : known) add(id, words(name));
  const int rows = std::clamp(static_cast<int>(known.size()), 1, kRowsOfIds);
  list->setFixedHeight(rows * (list->fontMetrics().lineSpacing() + kGrid_px) + 2 * list->frameWidth());
  column->addWidget(list);
  cell->setFocusProxy(list);
  connect(list, &QListWidget::itemChanged, this, [this, path, ids](QListWidgetItem* item) {
    const std::string id = item->data(Qt::UserRole).toString().toStdString();
    const bool on = item->checkState() == Qt::Checked;
    change(path, on ? tr("Offer: %1").arg(item->text()) : tr("Take out: %1").arg(item->text()), [&](Case edited) {
      auto listed = withListed(ids.of(edited), id, on);
      return ids.with(std::move(edited), std::move(listed));
    });
    if (const auto now = host_.cases().current()) fields_[path].show(*now);
  });
  fields_[path] = {
      [list, hint, none, atStart, add, ids](const Case& shown) {
        const QSignalBlocker quiet(list);
        const auto listed = ids.of(shown);
        const auto itemOf = [list](const std::string& id) -> QListWidgetItem* {
          for (int n = 0; n < list->count(); ++n)
            if (list->item(n)->data(Qt::UserRole).toString().toStdString() == id) return list->item(n);
          return nullptr;
        };
        for (const std::string& id : listed)
          if (itemOf(id) == nullptr) add(id, tr("%1 (unknown)").arg(words(id)));
        for (int n = 0; n < list->count(); ++n) {
          const std::string id = list->item(n)->data(Qt::UserRole).toString().toStdString();
          list->item(n)->setCheckState(std::find(listed.begin(), listed.end(), id) != listed.end() ? Qt::Checked : Qt::Unchecked);
        }
        hint->setText(listed.empty() ? none : atStart.isEmpty() ? QString() : atStart.arg(itemOf(listed.front())->text()));
        hint->setVisible(!hint->text().isEmpty());
      },
      addRow(form, label, cell, path)};
}

void CasePanel::addImagesTo(ExaminationsField& field, std::size_t number) {
  const QStringList chosen =
      QFileDialog::getOpenFileNames(window(), tr("Images of an earlier examination"), QString(), tr("Images (*.png *.jpg *.jpeg)"));
  if (chosen.isEmpty()) return;
  if (const auto own = host_.cases().makeOwn(); !own) {
    if (own.error().code != ErrorCode::cancelled) say(own.error());
    return;
  }
  const std::filesystem::path folder = host_.cases().currentFolder();
  std::vector<std::string> added;
  QStringList problems;
  for (const QString& file : chosen) {
    const auto image = cleanImage(file.toStdString());
    if (!image) {
      problems << words(image.error());
      continue;
    }
    const std::string name = imageName(*image);
    std::error_code failed;
    std::filesystem::create_directories((folder / name).parent_path(), failed);
    if (const auto written = host_.files().writeText(folder / name, image->bytes); !written)
      problems << words(written.error());
    else
      added.push_back(name);
  }
  field.addImages(number, added);
  if (!problems.isEmpty()) setProblem(fields_["previous_examinations"].problem, problems.join(QLatin1Char('\n')));
}

void CasePanel::showWarnings() {
  std::map<std::string, QStringList> warnings;
  if (const auto present = host_.cases().current())
    for (const RealLooking& each : realLooking(*present)) warnings[rowOf(each.field)] << words(each.text);
  for (auto& [path, row] : rows_) {
    QStringList& sentences = warnings[path];
    sentences.removeDuplicates();
    row.warning->setText(sentences.isEmpty() ? QString() : QStringLiteral("⚠ ") + sentences.join(QLatin1Char('\n')));
    row.warning->setVisible(!sentences.isEmpty());
  }
}

void CasePanel::showMissing() {
  const auto present = host_.cases().current();
  std::map<Section*, QStringList> missing;
  std::set<Section*> needed;
  // What a case needs in any event; the marks stand where it is written, whether it is there or not.
  for (const char* path : {"title_for_trainees", "region", "indication", "findings", "diagnosis", "start_pose", "volume.file"})
    if (const auto row = rows_.find(path); row != rows_.end()) needed.insert(row->second.section);
  if (present)
    for (const CheckItem& each : missingForPublishing(*present))
      if (const auto row = rows_.find(rowOf(each.field)); row != rows_.end() && row->second.section != nullptr)
        missing[row->second.section] << (row->second.label.isEmpty() ? words(each.what) : row->second.label);
  for (Section* section : sections_) section->setMissing(missing[section], needed.count(section) > 0 || !missing[section].isEmpty());
}

void CasePanel::showField(const std::string& path) {
  host_.panels().bringToFront("case_authoring");
  if (path == "volume.file_to_world") return host_.panels().bringToFront("placing");
  if (path.starts_with("targets")) return host_.panels().bringToFront("targets");
  if (path.starts_with("parts.lessons")) return host_.panels().bringToFront("lesson_editor");
  if (path == "files") return showFiles();
  const auto row = rows_.find(rowOf(path));
  if (row == rows_.end()) return;
  if (row->second.section != nullptr) row->second.section->setOpen(true);
  scroll_->widget()->layout()->activate();
  // Once the opened section has its place.
  QTimer::singleShot(0, this, [this, editor = QPointer<QWidget>(row->second.editor)] {
    if (!editor) return;
    scroll_->ensureWidgetVisible(editor, 0, 10 * kGrid_px);
    // The list stays in sight; what is typed next is for the field.
    editor->activateWindow();
    editor->setFocus(Qt::OtherFocusReason);
  });
}

void CasePanel::showFiles() {
  if (!host_.cases().current() || host_.cases().isLocked()) return;
  if (!files_) {
    files_ = new FilesDialog(host_, this);
    files_->setAttribute(Qt::WA_DeleteOnClose);
    connect(files_, &FilesDialog::filesChanged, this, [this] {
      if (publishing_) publishing_->checkSoon();
    });
  }
  files_->show();
  files_->raise();
  files_->activateWindow();
}

void CasePanel::publish() {
  if (!host_.cases().current()) return;
  if (!publishing_) {
    publishing_ = new PublishDialog(host_, this);
    publishing_->setAttribute(Qt::WA_DeleteOnClose);
    connect(publishing_, &PublishDialog::fieldAsked, this, [this](const QString& path) { showField(path.toStdString()); });
  }
  publishing_->show();
  publishing_->raise();
  publishing_->activateWindow();
}

}  // namespace ew::case_authoring
