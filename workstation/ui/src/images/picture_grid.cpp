#include "images/picture_grid.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "annotate/annotated_pictures.h"
#include "annotate/body_mark_view.h"
#include "annotate/shown_mark.h"
#include "ew/widgets/theme.h"
#include "images/kept_picture.h"
#include "measure/calipers/calipers.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kFrame_px = 2;  // around a picture, of several

int columnsOf(int count) { return count > 1 ? 2 : 1; }
int rowsOf(int count) { return count > 2 ? 2 : 1; }

}  // namespace

PictureGrid::PictureGrid(const InHand& inHand, QWidget* parent) : QWidget(parent), inHand_(inHand) {
  setObjectName(QStringLiteral("pictureGrid"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  inHand_.scan.setParent(this);
  inHand_.scan.show();
  Session& session = inHand_.session;
  connect(&session, &Session::subjectReplaced, this, &PictureGrid::forget);
  connect(&session, &Session::subjectChanged, this, &PictureGrid::followSubject);
  connect(&session, &Session::pictureChanged, this, &PictureGrid::showNames);
  connect(&session.console(), &ScanConsole::knobsChanged, this, &PictureGrid::fitScale);
  connect(&session.console(), &ScanConsole::probeChanged, this, &PictureGrid::fitScale);
  connect(&session, &Session::frozenChanged, this, &PictureGrid::fitScale);
  connect(&inHand_.mark, &ShownMark::changed, this, [this] {
    for (KeptPicture* each : kept_)
      if (each != nullptr) each->mark().follow(inHand_.mark);
  });
}

PictureGrid::~PictureGrid() = default;

QSize PictureGrid::minimumSizeHint() const {
  const QSize one = inHand_.scan.minimumSizeHint();
  if (count_ == 1) return one;
  return {one.width() + one.width() / 2, count_ == 2 ? one.height() : one.height() + one.height() / 4};
}

QRect PictureGrid::cell(int place) const {
  if (count_ == 1) return rect();
  // All of one size: a picture that goes to another place stays as it is, to the pixel.
  const int columns = columnsOf(count_), rows = rowsOf(count_);
  const QSize size(width() / columns, height() / rows);
  return QRect(QPoint(place % columns * size.width(), place / columns * size.height()), size)
      .adjusted(kFrame_px, kFrame_px, -kFrame_px, -kFrame_px);
}

void PictureGrid::arrange() {
  for (int place = 0; place < kMost; ++place) {
    KeptPicture* picture = kept(place);
    if (picture == nullptr) continue;
    const bool isShown = place < count_;
    if (isShown) {
      picture->setGeometry(cell(place));
      picture->view().setCompact(true);
      if (markView_ != nullptr) picture->setMarkCorner(markView_->corner());
    }
    picture->setVisible(isShown);
  }
  inHand_.scan.setGeometry(cell(active_));
  inHand_.scan.setCompact(count_ > 1);
  fitScale();
  update();
}

void PictureGrid::resizeEvent(QResizeEvent*) { arrange(); }

void PictureGrid::setCount(int pictures) {
  if (pictures == count_ || (pictures != 1 && pictures != 2 && pictures != 4)) return;
  if (!inHand_.session.subject() && pictures != 1) return;
  count_ = pictures;
  if (active_ >= count_) {
    std::swap(kept_[0], kept_[static_cast<std::size_t>(active_)]);
    active_ = 0;
  }
  for (int place = 0; place < count_; ++place) {
    auto& picture = kept_[static_cast<std::size_t>(place)];
    if (place == active_ || picture != nullptr) continue;
    picture = new KeptPicture(inHand_.jobs, this);
    connect(picture, &KeptPicture::asked, this, [this, picture = picture] {
      const auto at = std::find(kept_.begin(), kept_.end(), picture);
      if (at != kept_.end()) take(static_cast<int>(at - kept_.begin()), Then::stands);
    });
  }
  updateGeometry();
  arrange();
  showNames();
  Q_EMIT changed();
}

void PictureGrid::take(int place, Then then) {
  Session& session = inHand_.session;
  if (place < 0 || place >= count_ || place == active_ || !session.subject() || session.picture().isEmpty()) return;
  if (session.isPlaying()) {
    Q_EMIT said(tr("A recording is shown. Close it (Escape) to go to another picture."));
    return;
  }
  if (const QString why = whyNot ? whyNot() : QString(); !why.isEmpty()) {
    Q_EMIT said(why);
    return;
  }
  Q_EMIT leaving();
  KeptPicture& other = *kept(place);
  const bool ran = !session.isFrozen();
  session.setFrozen(true);
  if (other.isEmpty()) {
    other.session().beginLike(session);
    other.mark().beginLike(inHand_.mark);
  }
  std::swap(kept_[static_cast<std::size_t>(active_)], kept_[static_cast<std::size_t>(place)]);
  active_ = place;
  // What lies on the pictures first: when their sessions tell of them, each finds its own.
  inHand_.calipers.exchange(other.calipers());
  inHand_.annotated.exchange(other.annotated());
  inHand_.mark.exchange(other.mark());
  session.exchangePicture(other.session());
  if (ran && then == Then::goesOn) session.setFrozen(false);
  other.showOrHide();
  arrange();
  if (!session.isFrozen()) session.makePictureNow();
  for (Calipers* each : {&inHand_.calipers, &other.calipers()}) each->tellOfAll();
  for (AnnotatedPictures* each : {&inHand_.annotated, &other.annotated()}) each->tellOfAll();
  showNames();
  inHand_.scan.setFocus();
  Q_EMIT changed();
}

void PictureGrid::setSameScale(bool same) {
  if (same == hasSameScale_) return;
  hasSameScale_ = same;
  fitScale();
  Q_EMIT changed();
}

void PictureGrid::fitScale() {
  const std::vector<Shown> all = shown();
  double most_mm = 0.0;
  if (hasSameScale_ && all.size() > 1)
    for (const Shown& each : all) most_mm = std::max(most_mm, each.view->pixelOfWhole_mm());
  inHand_.scan.setLeastPixel(most_mm);
  for (KeptPicture* each : kept_)
    if (each != nullptr) each->view().setLeastPixel(most_mm);
}

PictureGrid::Shown PictureGrid::shownAt(int place) const {
  Shown shown;
  shown.place = place;
  if (place == active_) {
    shown.session = &inHand_.session;
    shown.calipers = &inHand_.calipers;
    shown.annotated = &inHand_.annotated;
    shown.mark = &inHand_.mark;
    shown.view = &inHand_.scan;
  } else if (KeptPicture* picture = kept(place)) {
    shown.session = &picture->session();
    shown.calipers = &picture->calipers();
    shown.annotated = &picture->annotated();
    shown.mark = &picture->mark();
    shown.view = &picture->view();
  }
  if (shown.session == nullptr || !shown.session->subject() || shown.session->picture().isEmpty()) {
    shown.session = nullptr;
    return shown;
  }
  shown.side = bodySideOf(shown.session->shownState().pose, shown.session->geometry().depth_mm);
  if (count_ == 1) return shown;
  shown.name = !shown.side                      ? QString::number(place + 1)
               : *shown.side == BodySide::right ? tr("%1 right", "number of a picture, and the patient's side").arg(place + 1)
                                                : tr("%1 left", "number of a picture, and the patient's side").arg(place + 1);
  return shown;
}

std::vector<PictureGrid::Shown> PictureGrid::shown() const {
  std::vector<Shown> all;
  for (int place = 0; place < count_; ++place)
    if (Shown each = shownAt(place); each.session != nullptr) all.push_back(std::move(each));
  return all;
}

QString PictureGrid::nameOf(std::uint64_t picture) const {
  for (const Shown& each : shown())
    if (each.calipers->picture() == picture) return each.name;
  return {};
}

void PictureGrid::showNames() {
  for (int place = 0; place < kMost; ++place) {
    const Shown each = shownAt(place);
    if (each.view != nullptr) each.view->setLabel(each.name);
  }
}

void PictureGrid::forget() {
  for (KeptPicture* each : kept_)
    if (each != nullptr) each->clear();
  setCount(1);
}

void PictureGrid::followSubject() {
  const auto& subject = inHand_.session.subject();
  if (!subject) return;
  bool isGone = false;
  for (KeptPicture* each : kept_) {
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
  Q_EMIT said(tr("The volume was moved: the other pictures were made where it lay before, and are gone."));
  Q_EMIT changed();
}

void PictureGrid::refreshIcons() {
  for (KeptPicture* each : kept_)
    if (each != nullptr) each->view().refreshIcons();
}

void PictureGrid::paintEvent(QPaintEvent*) {
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
