#include "scan/zoom/zoom_overview.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPointer>
#include <algorithm>
#include <cmath>

#include "ew/imaging/box_zoom.h"
#include "ew/scanning/scanner.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/theme.h"
#include "scan/scan_view.h"

namespace ew::ui {
namespace {

constexpr int kFormedEvery_ms = 180;
constexpr int kWidestOverview_px = 176, kHighestOverview_px = 128;
constexpr int kBesideScale_px = 64;  // the depth scale stands to the right of it
constexpr int kFromCorner_px = 8;

QPointF placeOnWhole(const DisplayGeometry& shown, const glm::dvec2& p_mm, double ratio) {
  const glm::dvec2 at =
      shown.face_px + glm::dvec2(shown.markerLeft ? -p_mm.x : p_mm.x, shown.upsideDown ? -p_mm.y : p_mm.y) / shown.pixel_mm;
  return QPointF(at.x + 0.5, at.y + 0.5) / ratio;
}

glm::dvec2 pointSeenAt(const DisplayGeometry& shown, const glm::dvec2& at_px) {
  const glm::dvec2 from_mm = (at_px - shown.face_px) * shown.pixel_mm;
  return {shown.markerLeft ? -from_mm.x : from_mm.x, shown.upsideDown ? -from_mm.y : from_mm.y};
}

}  // namespace

struct ZoomOverview::Former {
  Scanner scanner{1};
};

ZoomOverview::ZoomOverview(Session& session, ScanView& scan)
    : QWidget(&scan), session_(session), scan_(scan), former_(std::make_shared<Former>()) {
  setObjectName(QStringLiteral("zoomOverview"));
  setAccessibleName(tr("The whole image, with the part that is shown"));
  setToolTip(tr("The whole image: drag the box to move the detail"));
  setCursor(Qt::OpenHandCursor);
  hide();
  scan.installEventFilter(this);
  soon_.setSingleShot(true);
  soon_.setInterval(kFormedEvery_ms);
  connect(&soon_, &QTimer::timeout, this, &ZoomOverview::form);
  connect(&session_, &Session::imageChanged, this, &ZoomOverview::follow);
  const auto taken = [this] {
    formed_.reset();
    if (!session_.subject()) return;
    worker_.add([former = former_, subject = *session_.subject()] { former->scanner.show(subject); });
  };
  connect(&session_, &Session::subjectChanged, this, taken);
  taken();
}

ZoomOverview::~ZoomOverview() = default;

const DisplayGeometry& ZoomOverview::geometryOfWhole() const {
  return session_.wide() != nullptr ? session_.wide()->wholeGeometry : geometry_;
}

ScanState ZoomOverview::wanted() const {
  ScanState state = session_.shownState();
  state.knobs.zoom = 1.0;
  state.pan = {};
  state.knobs.persistence = 0.0;
  state.knobs.mode = DisplayMode::bMode;
  return state;
}

bool ZoomOverview::isUpToDate() const { return session_.wide() != nullptr || (formed_ && *formed_ == wanted()); }

void ZoomOverview::follow() {
  const bool isZoomed = session_.subject() && session_.console().detail().zoom > 1.0 && session_.imageKnobs().mode != DisplayMode::mMode;
  if (!isZoomed) {
    isDragged_ = false;
    return hide();
  }
  place();
  if (isHidden()) {
    show();
    raise();
  }
  if (session_.wide() != nullptr) return update();
  if (!isForming_ && !soon_.isActive() && !isUpToDate()) form();
  update();
}

void ZoomOverview::place() {
  const QRect image = scan_.imageRect();
  const double share =
      std::min({static_cast<double>(kWidestOverview_px) / image.width(), static_cast<double>(kHighestOverview_px) / image.height(), 0.3});
  const int wide = std::max(1, static_cast<int>(std::lround(share * image.width())));
  const int high = std::max(1, static_cast<int>(std::lround(share * image.height())));
  const int right = std::min(image.right() + 1, scan_.width() - scaled(kBesideScale_px)) - kFromCorner_px;
  const QRect there(right - wide, image.bottom() + 1 - kFromCorner_px - high, wide, high);
  if (geometry() != there) setGeometry(there);
}

void ZoomOverview::form() {
  if (isHidden() || isForming_ || session_.wide() != nullptr || !session_.subject()) return;
  ScanState state = wanted();
  if (formed_ == state) return;
  isForming_ = true;
  const double ratio = devicePixelRatioF();
  const int wide = std::max(1, static_cast<int>(std::lround(width() * ratio))),
            high = std::max(1, static_cast<int>(std::lround(height() * ratio)));
  worker_.add([self = this, former = former_, state = std::move(state), wide, high] {
    if (!former->scanner.subject()) return;
    const DisplayImage made = former->scanner.make(state, wide, high);
    QMetaObject::invokeMethod(
        self,
        [self, state, image = imageOf(made).copy(), geometry = former->scanner.geometry()] {
          self->isForming_ = false;
          self->image_ = image;
          self->geometry_ = geometry;
          self->formed_ = state;
          self->update();
          if (!self->isUpToDate()) self->soon_.start();
        },
        Qt::QueuedConnection);
  });
}

QRectF ZoomOverview::box() const {
  const DisplayGeometry& whole = geometryOfWhole();
  const DisplayGeometry& shown = session_.geometry();
  if (!(whole.pixel_mm > 0.0) || !(shown.pixel_mm > 0.0)) return {};
  // Both lie the same way round, except for a moment after an inversion.
  const double ratio = devicePixelRatioF();
  return QRectF(placeOnWhole(whole, pointSeenAt(shown, {-0.5, -0.5}), ratio),
                placeOnWhole(whole, pointSeenAt(shown, {shown.width - 0.5, shown.height - 0.5}), ratio))
      .normalized();
}

void ZoomOverview::moveTo(const QPointF& at) {
  const DisplayGeometry& whole = geometryOfWhole();
  if (!(whole.pixel_mm > 0.0)) return;
  const double ratio = devicePixelRatioF();
  // From the whole image, not from what is shown: that may be an image behind a drag.
  const glm::dvec2 p_mm = pointSeenAt(whole, glm::dvec2(at.x() * ratio - 0.5, at.y() * ratio - 0.5));
  const Detail detail = detailAround(whole, {session_.console().detail().zoom, {}}, p_mm);
  session_.console().setDetail(
      detail.zoom, session_.wide() != nullptr ? detail.pan : panWithinFan(session_.imageProbe(), session_.imageKnobs(), detail.pan));
}

void ZoomOverview::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || session_.isPlaying()) return event->ignore();
  isDragged_ = true;
  setCursor(Qt::ClosedHandCursor);
  moveTo(event->localPos());
}

void ZoomOverview::mouseMoveEvent(QMouseEvent* event) {
  if (isDragged_) moveTo(event->localPos());
}

void ZoomOverview::mouseReleaseEvent(QMouseEvent*) {
  isDragged_ = false;
  setCursor(Qt::OpenHandCursor);
}

bool ZoomOverview::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && !isHidden()) place();
  return QWidget::eventFilter(watched, event);
}

void ZoomOverview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const QImage whole = session_.wide() != nullptr ? imageOf(viewOf(session_.wide()->whole)) : image_;
  if (!whole.isNull()) painter.drawImage(QRectF(rect()), whole);
  const Theme theme = scanTheme();
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawRect(box().intersected(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75)));
}

}  // namespace ew::ui
