#include "images/image_grid.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "annotate/body_mark_view.h"
#include "annotate/image_annotations.h"
#include "annotate/image_body_mark.h"
#include "ew/widgets/theme.h"
#include "images/image_tile.h"
#include "measure/calipers/calipers.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kFrame_px = 2;  // around an image, of several

int columnsOf(int count) { return count > 1 ? 2 : 1; }
int rowsOf(int count) { return count > 2 ? 2 : 1; }

}  // namespace

ImageGrid::ImageGrid(const InHand& inHand, QWidget* parent) : QWidget(parent), inHand_(inHand) {
  setObjectName(QStringLiteral("pictureGrid"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  inHand_.scan.setParent(this);
  inHand_.scan.show();
  Session& session = inHand_.session;
  connect(&session, &Session::subjectReplaced, this, &ImageGrid::forget);
  connect(&session, &Session::subjectChanged, this, &ImageGrid::followSubject);
  connect(&session, &Session::imageChanged, this, &ImageGrid::showNames);
  connect(&session.console(), &ScanConsole::knobsChanged, this, &ImageGrid::fitScale);
  connect(&session.console(), &ScanConsole::probeChanged, this, &ImageGrid::fitScale);
  connect(&session, &Session::frozenChanged, this, &ImageGrid::fitScale);
  connect(&inHand_.mark, &ImageBodyMark::changed, this, [this] {
    for (ImageTile* each : kept_)
      if (each != nullptr) each->mark().follow(inHand_.mark);
  });
}

ImageGrid::~ImageGrid() = default;

QSize ImageGrid::minimumSizeHint() const {
  const QSize one = inHand_.scan.minimumSizeHint();
  if (count_ == 1) return one;
  return {one.width() + one.width() / 2, count_ == 2 ? one.height() : one.height() + one.height() / 4};
}

QRect ImageGrid::cell(int place) const {
  if (count_ == 1) return rect();
  // All of one size: an image that goes to another place stays as it is, to the pixel.
  const int columns = columnsOf(count_), rows = rowsOf(count_);
  const QSize size(width() / columns, height() / rows);
  return QRect(QPoint(place % columns * size.width(), place / columns * size.height()), size)
      .adjusted(kFrame_px, kFrame_px, -kFrame_px, -kFrame_px);
}

void ImageGrid::arrange() {
  for (int place = 0; place < kMost; ++place) {
    ImageTile* image = kept(place);
    if (image == nullptr) continue;
    const bool isShown = place < count_;
    if (isShown) {
      image->setGeometry(cell(place));
      image->view().setCompact(true);
      if (markView_ != nullptr) image->setMarkCorner(markView_->corner());
    }
    image->setVisible(isShown);
  }
  inHand_.scan.setGeometry(cell(active_));
  inHand_.scan.setCompact(count_ > 1);
  fitScale();
  update();
}

void ImageGrid::resizeEvent(QResizeEvent*) { arrange(); }

void ImageGrid::setCount(int images) {
  if (images == count_ || (images != 1 && images != 2 && images != 4)) return;
  if (!inHand_.session.subject() && images != 1) return;
  count_ = images;
  if (active_ >= count_) {
    std::swap(kept_[0], kept_[static_cast<std::size_t>(active_)]);
    active_ = 0;
  }
  for (int place = 0; place < count_; ++place) {
    auto& image = kept_[static_cast<std::size_t>(place)];
    if (place == active_ || image != nullptr) continue;
    image = new ImageTile(inHand_.jobs, this);
    connect(image, &ImageTile::asked, this, [this, image = image] {
      const auto at = std::find(kept_.begin(), kept_.end(), image);
      if (at != kept_.end()) take(static_cast<int>(at - kept_.begin()), Then::stands);
    });
  }
  updateGeometry();
  arrange();
  showNames();
  Q_EMIT changed();
}

void ImageGrid::take(int place, Then then) {
  Session& session = inHand_.session;
  if (place < 0 || place >= count_ || place == active_ || !session.subject() || session.image().isEmpty()) return;
  if (session.isPlaying()) {
    Q_EMIT said(tr("A recording is shown. Close it (Escape) to go to another image."));
    return;
  }
  if (const QString why = whyNot ? whyNot() : QString(); !why.isEmpty()) {
    Q_EMIT said(why);
    return;
  }
  Q_EMIT leaving();
  ImageTile& other = *kept(place);
  const bool ran = !session.isFrozen();
  session.setFrozen(true);
  if (other.isEmpty()) {
    other.session().beginLike(session);
    other.mark().beginLike(inHand_.mark);
  }
  std::swap(kept_[static_cast<std::size_t>(active_)], kept_[static_cast<std::size_t>(place)]);
  active_ = place;
  // What lies on the images first: when their sessions tell of them, each finds its own.
  inHand_.calipers.exchange(other.calipers());
  inHand_.annotated.exchange(other.annotated());
  inHand_.mark.exchange(other.mark());
  session.exchangeImage(other.session());
  if (ran && then == Then::goesOn) session.setFrozen(false);
  other.showOrHide();
  arrange();
  if (!session.isFrozen()) session.makeImageNow();
  for (Calipers* each : {&inHand_.calipers, &other.calipers()}) each->tellOfAll();
  for (ImageAnnotations* each : {&inHand_.annotated, &other.annotated()}) each->tellOfAll();
  showNames();
  inHand_.scan.setFocus();
  Q_EMIT changed();
}

void ImageGrid::setSameScale(bool same) {
  if (same == hasSameScale_) return;
  hasSameScale_ = same;
  fitScale();
  Q_EMIT changed();
}

void ImageGrid::fitScale() {
  const std::vector<Shown> all = shown();
  double most_mm = 0.0;
  if (hasSameScale_ && all.size() > 1)
    for (const Shown& each : all) most_mm = std::max(most_mm, each.view->pixelOfWhole_mm());
  inHand_.scan.setLeastPixel(most_mm);
  for (ImageTile* each : kept_)
    if (each != nullptr) each->view().setLeastPixel(most_mm);
}

ImageGrid::Shown ImageGrid::shownAt(int place) const {
  Shown shown;
  shown.place = place;
  if (place == active_) {
    shown.session = &inHand_.session;
    shown.calipers = &inHand_.calipers;
    shown.annotated = &inHand_.annotated;
    shown.mark = &inHand_.mark;
    shown.view = &inHand_.scan;
  } else if (ImageTile* image = kept(place)) {
    shown.session = &image->session();
    shown.calipers = &image->calipers();
    shown.annotated = &image->annotated();
    shown.mark = &image->mark();
    shown.view = &image->view();
  }
  if (shown.session == nullptr || !shown.session->subject() || shown.session->image().isEmpty()) {
    shown.session = nullptr;
    return shown;
  }
  shown.side = bodySideOf(shown.session->shownState().pose, shown.session->geometry().depth_mm);
  if (count_ == 1) return shown;
  shown.name = !shown.side                      ? QString::number(place + 1)
               : *shown.side == BodySide::right ? tr("%1 right", "number of an image, and the patient's side").arg(place + 1)
                                                : tr("%1 left", "number of an image, and the patient's side").arg(place + 1);
  return shown;
}

std::vector<ImageGrid::Shown> ImageGrid::shown() const {
  std::vector<Shown> all;
  for (int place = 0; place < count_; ++place)
    if (Shown each = shownAt(place); each.session != nullptr) all.push_back(std::move(each));
  return all;
}

QString ImageGrid::nameOf(std::uint64_t image) const {
  for (const Shown& each : shown())
    if (each.calipers->image() == image) return each.name;
  return {};
}

void ImageGrid::showNames() {
  for (int place = 0; place < kMost; ++place) {
    const Shown each = shownAt(place);
    if (each.view != nullptr) each.view->setLabel(each.name);
  }
}

void ImageGrid::forget() {
  for (ImageTile* each : kept_)
    if (each != nullptr) each->clear();
  setCount(1);
}

void ImageGrid::followSubject() {
  const auto& subject = inHand_.session.subject();
  if (!subject) return;
  bool isGone = false;
  for (ImageTile* each : kept_) {
    if (each == nullptr || each->isEmpty()) continue;
    // It could not be formed again from voxels that lie elsewhere now. One of the draft keeps that until it is taken in hand.
    if (each->session().subject()->placedGrid == subject->placedGrid || each->session().subject()->isDraft) {
      each->session().setTitle(subject->title);
    } else {
      each->clear();
      isGone = true;
    }
  }
  if (!isGone) return;
  Q_EMIT said(tr("The volume was moved: the other images were made where it lay before, and are gone."));
  Q_EMIT changed();
}

void ImageGrid::refreshIcons() {
  for (ImageTile* each : kept_)
    if (each != nullptr) each->view().refreshIcons();
}

void ImageGrid::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (count_ == 1) return;
  const Theme theme = scanTheme();
  for (int place = 0; place < count_; ++place) {
    if (place == active_) continue;
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawRect(cell(place).adjusted(-1, -1, 0, 0));
  }
  painter.fillRect(cell(active_).adjusted(-kFrame_px, -kFrame_px, kFrame_px, kFrame_px), theme.accent);
}

}  // namespace ew::ui
