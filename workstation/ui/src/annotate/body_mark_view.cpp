#include "annotate/body_mark_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSettings>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "annotate/mark_place.h"
#include "scan/dgc_column.h"
#include "scan/scan_view.h"

namespace ew::ui {
namespace {

const auto kCornerSetting = QStringLiteral("bodyMarkCorner");
constexpr int kMarkMargin_px = 8;
constexpr int kLeastMark_px = 48;  // a probe on a smaller drawing says nothing
constexpr double kGlyphReach_px = 16.0;
constexpr double kTurnPerStep_rad = std::numbers::pi / 12.0;  // 15 degrees for a click of the wheel

}  // namespace

BodyMarkView::BodyMarkView(ImageBodyMark& mark, ScanView& scan)
    : QWidget(&scan), mark_(mark), scan_(scan), corner_(qBound(0, QSettings().value(kCornerSetting, 2).toInt(), 3)) {
  setObjectName(QStringLiteral("bodyMark"));
  resize(kMark_px, kMark_px);
  setAccessibleName(tr("Body mark"));
  setToolTip(tr(
      "Body mark: drag it to another corner. On a frozen image drag the probe on it, turn it with the wheel; a double click lets it follow "
      "the probe again."));
  hide();
  scan.installEventFilter(this);
  connect(&scan, &ScanView::arranged, this, &BodyMarkView::followScan);
  connect(&mark_, &ImageBodyMark::changed, this, &BodyMarkView::showOrHide);
}

void BodyMarkView::placeIn(int corner) {
  corner_ = qBound(0, corner, 3);
  arrange();
}

void BodyMarkView::setCorner(int corner) {
  placeIn(corner);
  QSettings().setValue(kCornerSetting, corner_);
}

void BodyMarkView::showOrHide() {
  followScan();
  update();
}

void BodyMarkView::followScan() {
  // A magnified image and a strip leave no black for it.
  const bool isShown = mark_.mark() != nullptr && !scan_.isZoomed() && scan_.stripRect() != scan_.imageRect();
  if (isShown == isHidden()) setVisible(isShown);
  arrange();
}

void BodyMarkView::arrange() {
  if (movedFrom_) return;
  // Beside the sliders and the depth scale, which keep their room.
  QRect room = scan_.rect().adjusted((scan_.isCompact() ? 0 : DgcColumn::wanted_px()) + kMarkMargin_px, 56, -72, -40 - kMarkMargin_px);
  if (const QRect strip = scan_.stripRect(); !strip.isEmpty()) room.setBottom(std::min(room.bottom(), strip.top() - kMarkMargin_px));
  std::vector<QRect> taken = scan_.fanRects();
  if (const QRect strip = scan_.stripRect(); !strip.isEmpty()) taken.push_back(strip);
  taken.push_back(scan_.resultsRect());
  taken.push_back(scan_.colourBarRect());
  const QRect there = placeOfMark(room, taken, corner_, kMark_px, kLeastMark_px);
  if (there != geometry()) setGeometry(there);
}

bool BodyMarkView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) arrange();
  return QWidget::eventFilter(watched, event);
}

bool BodyMarkView::isOnGlyph(const QPointF& at) const {
  if (!mark_.glyph() || !mark_.standsStill()) return false;
  const glm::dvec2 place = mark_.glyph()->place;
  return std::hypot(at.x() - place.x * width(), at.y() - place.y * height()) <= kGlyphReach_px;
}

void BodyMarkView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  movesGlyph_ = isOnGlyph(event->localPos());
  if (!movesGlyph_) movedFrom_ = event->pos();
  setCursor(Qt::ClosedHandCursor);
}

void BodyMarkView::mouseMoveEvent(QMouseEvent* event) {
  if (movesGlyph_ && mark_.glyph()) {
    annotation::ProbeGlyph glyph = *mark_.glyph();
    glyph.place = {event->localPos().x() / width(), event->localPos().y() / height()};
    mark_.putByHand(glyph);
  } else if (movedFrom_) {
    move(mapToParent(event->pos() - *movedFrom_));
  }
}

void BodyMarkView::mouseReleaseEvent(QMouseEvent* event) {
  mouseMoveEvent(event);  // to where it is let go
  unsetCursor();
  movesGlyph_ = false;
  if (!movedFrom_) return;
  movedFrom_.reset();
  const QPoint middle = geometry().center();
  setCorner((middle.x() > scan_.width() / 2 ? 1 : 0) + (middle.y() > scan_.height() / 2 ? 2 : 0));
}

void BodyMarkView::mouseDoubleClickEvent(QMouseEvent*) { mark_.putByHand(std::nullopt); }

void BodyMarkView::wheelEvent(QWheelEvent* event) {
  if (!mark_.standsStill() || !mark_.glyph()) return event->ignore();
  annotation::ProbeGlyph glyph = *mark_.glyph();
  glyph.angle_rad += kTurnPerStep_rad * event->angleDelta().y() / 120.0;
  mark_.putByHand(glyph);
}

void BodyMarkView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintMark(painter, mark_, QRectF(rect()));
}

}  // namespace ew::ui
