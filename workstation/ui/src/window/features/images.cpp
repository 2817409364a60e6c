#include "window/features/images.h"

#include <QActionGroup>
#include <QDateTime>
#include <QMenu>
#include <algorithm>

#include "ew/core/ending.h"
#include "ew/export/dicom_image.h"
#include "ew/sdk/person.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "images/saved_image.h"
#include "window/features/storing.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

const QString kSavingImage = QStringLiteral("save image");  ///< topic of messages: of two about it only the later one is true

}  // namespace

void Images::addMenu(QMenu& images) {
  Commands& commands = *parts_.commands;
  auto* counts = new QActionGroup(this);
  const std::pair<const char*, int> offered[] = {{"pictures.one", 1}, {"pictures.two", 2}, {"pictures.four", 4}};
  for (const auto& [command, count] : offered) {
    QAction* action = commands.add(images, command, [this, count = count] {
      if (parts_.workspaces->showsScan()) parts_.imageGrid->setCount(count);
      show();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    action->setData(count);
    counts->addAction(action);
    counts_.push_back(action);
  }
  images.addSeparator();
  commands.add(images, "pictures.count", [this] {
    if (parts_.workspaces->showsScan()) parts_.imageGrid->stepCount();
  });
  next_ = commands.add(images, "pictures.next", [this] {
    if (parts_.workspaces->showsScan()) parts_.imageGrid->takeNext();
  });
  sameScale_ = commands.add(images, "pictures.sameScale", [this] { parts_.imageGrid->setSameScale(sameScale_->isChecked()); });
  sameScale_->setCheckable(true);
}

void Images::connectParts() {
  WindowParts& p = parts_;
  connect(p.imageGrid, &ImageGrid::changed, this, &Images::show);
  connect(&p.session, &Session::frozenChanged, this, &Images::show);  // the side it shows is its own now
  connect(p.imageGrid, &ImageGrid::said, p.scanView, &ScanView::say);
  connect(p.imageGrid, &ImageGrid::leaving, this, [this] {
    parts_.annotationLayer->finish();
    parts_.calipers.hold();  // what plays stands still
  });
  connect(p.measurePage, &MeasurePage::imageAsked, p.imageGrid,
          [grid = p.imageGrid](int place) { grid->take(place, ImageGrid::Then::stands); });
  p.imageGrid->whyNot = [&p] {
    const KeyMap& keys = p.keys;
    if (p.recorder.isRecording())
      return tr("A recording runs, and it is of one image. End it (%1) to go to another.").arg(keys.words("record"));
    if (p.session.wide() != nullptr || p.wide.state() == WideScan::State::growing)
      return tr("A wide image is at work. Close it (%1) to go to another image.").arg(keys.words("wide"));
    return QString();
  };
  p.worksheets.nameOfImage = [&p](std::uint64_t image) { return p.imageGrid->nameOf(image); };
  p.worksheets.whyNotSide = [&p](const std::string& side) -> QString {
    if (side.empty() || p.imageGrid->count() == 1) return {};
    for (const ImageGrid::Shown& each : p.imageGrid->shown())
      if (each.place == p.imageGrid->active() && each.side && (*each.side == BodySide::left) != (side == "left"))
        return *each.side == BodySide::left ? tr("This image shows the patient's left side.")
                                            : tr("This image shows the patient's right side.");
    return {};
  };
  show();
}

std::vector<SnapshotPart> Images::shownParts() const {
  const ImageGrid& grid = *parts_.imageGrid;
  std::vector<SnapshotPart> all;
  for (const ImageGrid::Shown& each : grid.shown()) {
    SnapshotPart part{each.session, {each.calipers, each.annotated, each.mark}, each.name, each.place == grid.active()};
    part.on.person = QString::fromStdString(sdk::personWhoLearns());
    all.push_back(std::move(part));
  }
  return all;
}

int Images::columns() const { return std::min(2, parts_.imageGrid->count()); }

void Images::show() {
  WindowParts& p = parts_;
  const int count = p.imageGrid->count();
  for (QAction* action : counts_) action->setChecked(action->data().toInt() == count);
  next_->setEnabled(count > 1);
  sameScale_->setEnabled(count > 1);
  sameScale_->setChecked(p.imageGrid->hasSameScale());
  QString own;
  std::vector<MeasurePage::OfImage> others;
  for (const ImageGrid::Shown& each : p.imageGrid->shown()) {
    if (each.place == p.imageGrid->active())
      own = each.name;
    else
      others.push_back({each.place, each.name, each.calipers->lines()});
  }
  p.measurePage->setImages(own, others);
  p.undo->refresh();
}

void Images::addSaveAction(QMenu& file) {
  save_ = parts_.commands->add(file, "save.picture", [this] { save(); });
}

void Images::refresh() { save_->setEnabled(parts_.session.subject().has_value()); }

void Images::save() {
  if (parts_.session.image().isEmpty() || !parts_.session.subject()) return;
  const QString file = askSaveFile(&parts_.window, dated({tr("Save the image"),
                                                          words(parts_.session.subject()->title) + QStringLiteral(".png"),
                                                          tr("Images (*.png *.mha);;DICOM images (*.dcm)"),
                                                          {QStringLiteral(".png"), QStringLiteral(".mha"), QStringLiteral(".dcm")}}));
  if (file.isEmpty()) return;
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    const QDateTime now = QDateTime::currentDateTime();
    const std::vector<SnapshotPart> parts = shownParts();
    if (!hasEnding(pathOf(file), ".dcm")) return writeShownImages(parts, columns(), now, outputs.staged(pathOf(file)));
    const auto still = storedStill(parts, savedImages(parts, columns(), now), 1, now);
    auto object = writeDicomImage(still.still, still.options, parts_.storing->studyNow(), outputs.staged(pathOf(file)));
    return object ? Result<void>() : passOn(object.error());
  });
  if (written) {
    parts_.messages->showNote(tr("Saved to %1.").arg(file), kSavingImage);
  } else {
    parts_.messages->showError(written.error(), kSavingImage);
  }
}

}  // namespace ew::ui
