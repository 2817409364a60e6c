// Two and four pictures at once: their menu, and who hears of them.
#include <algorithm>

#include "ew/sdk/person.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {

void MainWindow::addPicturesMenu(QMenu& menu) {
  Parts& p = *parts_;
  const auto isThere = [this] { return parts_->pages->currentWidget() == parts_->workspacePage && parts_->keepsScan(); };
  auto* counts = new QActionGroup(this);
  const std::pair<const char*, int> offered[] = {{"pictures.one", 1}, {"pictures.two", 2}, {"pictures.four", 4}};
  for (const auto& [command, count] : offered) {
    QAction* action = addMenuAction(menu, command, [this, isThere, count = count] {
      if (isThere()) parts_->pictures->setCount(count);
      showPictures();  // an action checks itself, whatever came of it
    });
    action->setCheckable(true);
    action->setData(count);
    counts->addAction(action);
    p.pictureCounts.push_back(action);
  }
  menu.addSeparator();
  addMenuAction(menu, "pictures.count", [this, isThere] {
    if (isThere()) parts_->pictures->stepCount();
  });
  p.nextPictureAction = addMenuAction(menu, "pictures.next", [this, isThere] {
    if (isThere()) parts_->pictures->takeNext();
  });
  p.sameScaleAction =
      addMenuAction(menu, "pictures.sameScale", [this] { parts_->pictures->setSameScale(parts_->sameScaleAction->isChecked()); });
  p.sameScaleAction->setCheckable(true);
}

void MainWindow::connectPictures() {
  Parts& p = *parts_;
  connect(p.pictures, &PictureGrid::changed, this, &MainWindow::showPictures);
  connect(&p.session, &Session::frozenChanged, this, &MainWindow::showPictures);  // the side it shows is its own now
  connect(p.pictures, &PictureGrid::said, p.scanView, &ScanView::say);
  connect(p.pictures, &PictureGrid::leaving, this, [this] {
    parts_->annotationLayer->finish();
    parts_->calipers.hold();  // what plays stands still
  });
  connect(p.measurePage, &MeasurePage::pictureAsked, p.pictures,
          [this](int place) { parts_->pictures->take(place, PictureGrid::Then::stands); });
  p.pictures->whyNot = [this] {
    const KeyMap& keys = parts_->keys;
    if (parts_->recorder.isRecording())
      return tr("A recording runs, and it is of one picture. End it (%1) to go to another.").arg(keys.words("record"));
    if (parts_->session.wide() != nullptr || parts_->wide.state() == WideScan::State::growing)
      return tr("A wide image is at work. Close it (%1) to go to another picture.").arg(keys.words("wide"));
    return QString();
  };
  p.worksheets.nameOfPicture = [this](std::uint64_t picture) { return parts_->pictures->nameOf(picture); };
  p.worksheets.whyNotSide = [this](const std::string& side) -> QString {
    if (side.empty() || parts_->pictures->count() == 1) return {};
    for (const PictureGrid::Shown& each : parts_->pictures->shown())
      if (each.place == parts_->pictures->active() && each.side && (*each.side == BodySide::left) != (side == "left"))
        return *each.side == BodySide::left ? tr("This picture shows the patient's left side.")
                                            : tr("This picture shows the patient's right side.");
    return {};
  };
  showPictures();
}

std::vector<SavedPart> MainWindow::shownParts() const {
  const PictureGrid& grid = *parts_->pictures;
  std::vector<SavedPart> all;
  for (const PictureGrid::Shown& each : grid.shown()) {
    SavedPart part{each.session, {each.calipers, each.annotated, each.mark}, each.name, each.place == grid.active()};
    part.on.person = QString::fromStdString(sdk::personWhoLearns());
    all.push_back(std::move(part));
  }
  return all;
}

int MainWindow::pictureColumns() const { return std::min(2, parts_->pictures->count()); }

void MainWindow::showPictures() {
  Parts& p = *parts_;
  const int count = p.pictures->count();
  for (QAction* action : p.pictureCounts) action->setChecked(action->data().toInt() == count);
  p.nextPictureAction->setEnabled(count > 1);
  p.sameScaleAction->setEnabled(count > 1);
  p.sameScaleAction->setChecked(p.pictures->hasSameScale());
  QString own;
  std::vector<MeasurePage::OfPicture> others;
  for (const PictureGrid::Shown& each : p.pictures->shown()) {
    if (each.place == p.pictures->active())
      own = each.name;
    else
      others.push_back({each.place, each.name, each.calipers->lines()});
  }
  p.measurePage->setPictures(own, others);
  showHistory();
}

}  // namespace ew::ui
