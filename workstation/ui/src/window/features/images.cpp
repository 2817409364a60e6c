#include "window/features/images.h"

#include <QActionGroup>
#include <QDateTime>
#include <QMenu>
#include <algorithm>

#include "ew/core/ending.h"
#include "ew/export/dicom_picture.h"
#include "ew/sdk/person.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "images/saved_picture.h"
#include "window/features/storing.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

const QString kSavingPicture = QStringLiteral("save picture");  ///< topic of messages: of two about it only the later one is true

}  // namespace

void Images::addMenu(QMenu& images) {
  Commands& commands = *parts_.commands;
  auto* counts = new QActionGroup(this);
  const std::pair<const char*, int> offered[] = {{"pictures.one", 1}, {"pictures.two", 2}, {"pictures.four", 4}};
  for (const auto& [command, count] : offered) {
    QAction* action = commands.add(images, command, [this, count = count] {
      if (parts_.workspaces->showsScan()) parts_.pictures->setCount(count);
      show();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    action->setData(count);
    counts->addAction(action);
    counts_.push_back(action);
  }
  images.addSeparator();
  commands.add(images, "pictures.count", [this] {
    if (parts_.workspaces->showsScan()) parts_.pictures->stepCount();
  });
  next_ = commands.add(images, "pictures.next", [this] {
    if (parts_.workspaces->showsScan()) parts_.pictures->takeNext();
  });
  sameScale_ = commands.add(images, "pictures.sameScale", [this] { parts_.pictures->setSameScale(sameScale_->isChecked()); });
  sameScale_->setCheckable(true);
}

void Images::connectParts() {
  WindowParts& p = parts_;
  connect(p.pictures, &PictureGrid::changed, this, &Images::show);
  connect(&p.session, &Session::frozenChanged, this, &Images::show);  // the side it shows is its own now
  connect(p.pictures, &PictureGrid::said, p.scanView, &ScanView::say);
  connect(p.pictures, &PictureGrid::leaving, this, [this] {
    parts_.annotationLayer->finish();
    parts_.calipers.hold();  // what plays stands still
  });
  connect(p.measurePage, &MeasurePage::pictureAsked, p.pictures,
          [grid = p.pictures](int place) { grid->take(place, PictureGrid::Then::stands); });
  p.pictures->whyNot = [&p] {
    const KeyMap& keys = p.keys;
    if (p.recorder.isRecording())
      return tr("A recording runs, and it is of one picture. End it (%1) to go to another.").arg(keys.words("record"));
    if (p.session.wide() != nullptr || p.wide.state() == WideScan::State::growing)
      return tr("A wide image is at work. Close it (%1) to go to another picture.").arg(keys.words("wide"));
    return QString();
  };
  p.worksheets.nameOfPicture = [&p](std::uint64_t picture) { return p.pictures->nameOf(picture); };
  p.worksheets.whyNotSide = [&p](const std::string& side) -> QString {
    if (side.empty() || p.pictures->count() == 1) return {};
    for (const PictureGrid::Shown& each : p.pictures->shown())
      if (each.place == p.pictures->active() && each.side && (*each.side == BodySide::left) != (side == "left"))
        return *each.side == BodySide::left ? tr("This picture shows the patient's left side.")
                                            : tr("This picture shows the patient's right side.");
    return {};
  };
  show();
}

std::vector<SavedPart> Images::shownParts() const {
  const PictureGrid& grid = *parts_.pictures;
  std::vector<SavedPart> all;
  for (const PictureGrid::Shown& each : grid.shown()) {
    SavedPart part{each.session, {each.calipers, each.annotated, each.mark}, each.name, each.place == grid.active()};
    part.on.person = QString::fromStdString(sdk::personWhoLearns());
    all.push_back(std::move(part));
  }
  return all;
}

int Images::columns() const { return std::min(2, parts_.pictures->count()); }

void Images::show() {
  WindowParts& p = parts_;
  const int count = p.pictures->count();
  for (QAction* action : counts_) action->setChecked(action->data().toInt() == count);
  next_->setEnabled(count > 1);
  sameScale_->setEnabled(count > 1);
  sameScale_->setChecked(p.pictures->hasSameScale());
  QString own;
  std::vector<MeasurePage::OfPicture> others;
  for (const PictureGrid::Shown& each : p.pictures->shown()) {
    if (each.place == p.pictures->active())
      own = each.name;
    else
      others.push_back({each.place, each.name, each.calipers->lines()});
  }
  p.measurePage->setPictures(own, others);
  p.undo->refresh();
}

void Images::addSaveAction(QMenu& file) {
  save_ = parts_.commands->add(file, "save.picture", [this] { save(); });
}

void Images::refresh() { save_->setEnabled(parts_.session.subject().has_value()); }

void Images::save() {
  if (parts_.session.picture().isEmpty() || !parts_.session.subject()) return;
  const QString file = askSaveFile(&parts_.window, dated({tr("Save the image"),
                                                          words(parts_.session.subject()->title) + QStringLiteral(".png"),
                                                          tr("Images (*.png *.mha);;DICOM images (*.dcm)"),
                                                          {QStringLiteral(".png"), QStringLiteral(".mha"), QStringLiteral(".dcm")}}));
  if (file.isEmpty()) return;
  const auto written = saveTogether({pathOf(file)}, [&](const OutputSet& outputs) {
    const QDateTime now = QDateTime::currentDateTime();
    const std::vector<SavedPart> parts = shownParts();
    if (!hasEnding(pathOf(file), ".dcm")) return writeShownPictures(parts, columns(), now, outputs.staged(pathOf(file)));
    const auto still = storedStill(parts, savedPictures(parts, columns(), now), 1, now);
    auto object = writeDicomPicture(still.still, still.options, parts_.storing->studyNow(), outputs.staged(pathOf(file)));
    return object ? Result<void>() : passOn(object.error());
  });
  if (written) {
    parts_.messages->showNote(tr("Saved to %1.").arg(file), kSavingPicture);
  } else {
    parts_.messages->showError(written.error(), kSavingPicture);
  }
}

}  // namespace ew::ui
