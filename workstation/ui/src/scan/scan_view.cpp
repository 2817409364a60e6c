#include "scan/scan_view.h"

#include <QApplication>
#include <QHoverEvent>
#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/figures.h"
#include "ew/widgets/focus_ring.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "scan/colour_on_image.h"
#include "scan/dgc_column.h"
#include "scan/fan_rects.h"
#include "scan/focus_scale.h"
#include "scan/scan_badges.h"
#include "scan/spectrum_on_image.h"
#include "scan/tracking_look.h"
#include "scan/tracking_overlay.h"

namespace ew::ui {
namespace {

constexpr int kLeastMargin_px = 8;  // beside a fan whose corners hold sliders and scale
constexpr int kMostOverImage =
    2;                         // labels of the scale that may reach over the fan's widest place; a rectangle keeps all of them beside it
constexpr int kHint_px = 220;  // what a drag does
constexpr int kSaidLong_ms = 3000;
constexpr int kLeastBesideNumbers_px = 240;
constexpr int kShortestBar_px = 40, kShorterBar_px = 8;

int leftRoom_px() { return DgcColumn::wanted_px(); }
int rightRoom_px() { return 26 + scaled(38); }  // depth scale
int topRoom_px() { return 12 + scaled(44); }    // probe name, reset of the TGC, marker
int lineHeight_px() { return scaled(24); }
int bottomRoom_px() { return 16 + lineHeight_px(); }  // what the image is

/// Of the bar of colours; in a narrow view the image needs the room.
bool hasBarNumbers(const ScanView& view) {
  return !view.isCompact() && view.width() - leftRoom_px() - rightRoom_px() >= scaled(kLeastBesideNumbers_px);
}

/// Distance of labelled ticks so that about 4 to 8 of them fit, from the 1-2-5 series, in mm.
int labelStep_mm(double depth_mm, double height_px) {
  const double most = std::clamp(height_px / scaled(48.0), 2.0, 6.0);
  for (const int step : {10, 20, 50, 100}) {
    if (depth_mm / step <= most) return step;
  }
  return 200;
}

}  // namespace

ScanView::ScanView(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("scanView"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setLayoutDirection(Qt::LeftToRight);  // an image has its sides, whatever is read
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_Hover);  // the sliders of a zoomed image come when the pointer is there
  setAccessibleName(tr("Scan"));
  dgc_ = new DgcColumn(session_, this);
  scale_ = new FocusScale(
      session_, [this](double y) { return depthAt_mm(y); }, this);
  new FocusRing(*this, *this);
  saidLong_.setSingleShot(true);
  saidLong_.setInterval(kSaidLong_ms);
  connect(&saidLong_, &QTimer::timeout, this, [this] {
    said_.clear();
    update();
  });
  session_.frames().setWatched(false);
  const auto changed = [this] {
    arrange();
    update();
  };
  connect(&session_, &Session::imageChanged, this, changed);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, changed);
  connect(&session_.console(), &ScanConsole::sceneChanged, this, changed);
  connect(&session_, &Session::frozenChanged, this, changed);
  connect(&session_.spectrumTrace(), &SpectrumTrace::changed, this, changed);
  connect(&session_, &Session::subjectChanged, this, changed);
  connect(&session_.probeControl(), &ProbeControl::holdChanged, this, [this] {
    if (session_.probeControl().tracked()) update();
  });
  connect(&session_.probeControl(), &ProbeControl::trackingChanged, this, [this] {
    const bool wasLost = std::exchange(isLost_, session_.probeControl().isLost());
    if (isLost_ && !wasLost && soundsLoss_) QApplication::beep();
    update();
  });
}

QRect ScanView::imageRect() const {
  const QRect whole = wholeRect();
  if (mode() != DisplayMode::bMode || share_ >= 1.0) return whole;
  const QSize size(std::max(1, static_cast<int>(std::lround(share_ * whole.width()))),
                   std::max(1, static_cast<int>(std::lround(share_ * whole.height()))));
  return {QPoint(whole.left() + (whole.width() - size.width()) / 2, whole.top()), size};
}

double ScanView::pixelOfWhole_mm() const {
  if (!session_.subject()) return 0.0;
  const QSize size = wholeRect().size() * devicePixelRatioF();
  return fitDisplay(session_.imageProbe(), session_.imageKnobs(), std::max(1, size.width()), std::max(1, size.height())).pixel_mm;
}

void ScanView::setLeastPixel(double pixel_mm) {
  if (pixel_mm == leastPixel_mm_) return;
  leastPixel_mm_ = pixel_mm;
  arrange();
  update();
}

void ScanView::setLabel(const QString& label) {
  if (label == label_) return;
  label_ = label;
  update();
}

QRect ScanView::wholeRect() const {
  const bool isAlone = mode() == DisplayMode::bMode;
  const int left_px = isAlone ? left_px_ : leftMost_px();
  const int right_px = isAlone ? right_px_ : rightRoom_px() + barRoom_px();
  const QRect whole(left_px, topRoom_px(), std::max(1, width() - left_px - right_px),
                    std::max(1, height() - topRoom_px() - bottomRoom_px()));
  if (isAlone) return whole;
  if (mode() == DisplayMode::mMode) return whole.adjusted(0, 0, 0, -std::min(belowStrip_px(*this, mode()), whole.height() - 1));
  // Image and strip have the same size; between them there is room for the image's lower edge to be seen as one.
  return {whole.left(), whole.top(), whole.width(), std::max(1, (whole.height() - belowStrip_px(*this, mode()) - 16) / 2)};
}

std::vector<QRect> ScanView::fanRects() const {
  if (mode() == DisplayMode::mMode || session_.image().isEmpty()) return {};
  if (session_.wide() != nullptr) return {imageRect()};
  return rectsOfFan(session_.seen().spans(), imageRect().topLeft(), devicePixelRatioF());
}

double ScanView::mmPerWidgetPixel() const {
  const double pixel_mm = session_.geometry().pixel_mm;
  return pixel_mm > 0.0 ? pixel_mm * devicePixelRatioF() : 0.25;
}

double ScanView::yOfDepth(double depth_mm) const {
  const DisplayGeometry& geometry = session_.geometry();
  if (geometry.pixel_mm <= 0.0) return 0.0;
  if (mode() == DisplayMode::mMode) return stripRect().top() + stripRect().height() * depth_mm / geometry.depth_mm;
  const double down = geometry.upsideDown ? -1.0 : 1.0;
  return imageRect().top() + (geometry.face_px.y + down * depth_mm / geometry.pixel_mm) / devicePixelRatioF();
}

QPointF ScanView::positionOf(const Point<frame::Probe>& at) const {
  const DisplayGeometry& geometry = session_.geometry();
  const double across = geometry.markerLeft ? -1.0 : 1.0;
  const double down = geometry.upsideDown ? -1.0 : 1.0;
  const double scale = 1.0 / (geometry.pixel_mm * devicePixelRatioF());
  return QPointF(imageRect().topLeft()) + QPointF(geometry.face_px.x, geometry.face_px.y) / devicePixelRatioF() +
         scale * QPointF(across * at.at.x, down * at.at.y);
}

Point<frame::Probe> ScanView::pointAt(const QPointF& position) const {
  const DisplayGeometry& geometry = session_.geometry();
  const QPointF pixel = (position - QPointF(imageRect().topLeft())) * devicePixelRatioF() - QPointF(geometry.face_px.x, geometry.face_px.y);
  return {{(geometry.markerLeft ? -1.0 : 1.0) * geometry.pixel_mm * pixel.x(),
           (geometry.upsideDown ? -1.0 : 1.0) * geometry.pixel_mm * pixel.y(), 0.0}};
}

double ScanView::depthAt_mm(double y) const {
  const double top = yOfDepth(0.0);
  const double perMm = yOfDepth(1.0) - top;
  return perMm != 0.0 ? (y - top) / perMm : 0.0;
}

void ScanView::resizeEvent(QResizeEvent*) { arrange(); }
void ScanView::showEvent(QShowEvent*) { session_.frames().setWatched(true); }
void ScanView::hideEvent(QHideEvent*) { session_.frames().setWatched(false); }
void ScanView::refreshIcons() { dgc_->refreshIcons(); }

void ScanView::enterEvent(QEvent*) { update(); }
void ScanView::leaveEvent(QEvent*) { update(); }

void ScanView::say(const QString& sentence) {
  said_ = sentence;
  saidLong_.start();
  update();
}

/// The narrowest margins at which sliders and scale stand in the corners beside the fan.
void ScanView::fitMargins() {
  if (!session_.subject()) {
    left_px_ = leftRoom_px();
    right_px_ = rightRoom_px();
    besideFan_px_ = leftRoom_px();
    fitted_ = {};
    return;
  }
  // What shapes the fan, but for the zoom: a zoomed image fills the view and lies under them, and the layout stays as it was.
  const Knobs& asked = session_.imageKnobs();
  Knobs whole;
  whole.depth_mm = asked.depth_mm;
  whole.steering_rad = asked.steering_rad;
  whole.trapezoid = asked.trapezoid;
  whole.markerLeft = asked.markerLeft;
  whole.upsideDown = asked.upsideDown;
  if (barRoom_px() > 0) whole.colour.emplace();
  const Fitted wanted{size(), session_.imageProbe().id, whole, isCompact_};
  if (wanted == fitted_) return;
  fitted_ = wanted;
  constexpr int kSteps = 10;
  for (int step = 0; step <= kSteps; ++step) {
    left_px_ = kLeastMargin_px + (leftMost_px() - kLeastMargin_px) * step / kSteps;
    right_px_ = kLeastMargin_px + (rightMost_px() - kLeastMargin_px) * step / kSteps;
    if (fitsBeside(whole)) return;
  }
}

int ScanView::leftMost_px() const { return isCompact_ ? kLeastMargin_px : leftRoom_px(); }
int ScanView::rightMost_px() const { return isCompact_ ? kLeastMargin_px : rightRoom_px() + barRoom_px(); }

int ScanView::barRoom_px() const {
  return !isCompact_ && knobsWithBox(session_) ? sizeOfColourBar(height(), hasBarNumbers(*this)).width() + kLeastMargin_px : 0;
}

/// Beside the sliders and the depth scale.
QRect ScanView::roomOfBar() const {
  return {QPoint(leftMost_px(), topRoom_px()), QPoint(width() - rightRoom_px() - 1, height() - bottomRoom_px() - 1)};
}

void ScanView::placeColourBar() {
  bar_ = {};
  if (!knobsWithBox(session_) || session_.image().isEmpty()) return;
  const QRect room = roomOfBar();
  std::vector<QRect> taken = isZoomed() ? std::vector<QRect>() : fanRects();
  taken.push_back(resultsRect_);
  if (isStripBelow(mode())) taken.push_back(stripRect());
  const bool hasNumbers = hasBarNumbers(*this);
  const QSize usual = sizeOfColourBar(imageRect().height(), hasNumbers);
  const int least_px = hasNumbers ? usual.height() : kShortestBar_px;
  for (QSize size = usual; bar_.isNull() && size.height() >= least_px; size.rheight() -= kShorterBar_px)
    bar_ = placeOfColourBar(room, taken, size);
  if (bar_.isNull() && isZoomed()) bar_ = QRect(QPoint(room.right() + 1 - usual.width(), room.top()), usual);
}

bool ScanView::fitsBeside(const Knobs& whole) {
  besideFan_px_ = leftRoom_px();
  const int width_px = width() - left_px_ - right_px_;
  const int height_px = height() - topRoom_px() - bottomRoom_px();
  if (width_px < 1 || height_px < 1) return false;
  const DisplayGeometry geometry = fitDisplay(session_.imageProbe(), whole, width_px, height_px);
  const Spans fan = fanSpans(session_.imageProbe(), whole, geometry);
  const int half_px = scaled(10);
  int tooFewLeft = 0, tooFewRight = 0;
  for (int i = 0; i < kDgcSliders; ++i) {
    const double depth_mm = geometry.depth_mm * (i + 0.5) / kDgcSliders;
    const auto row = static_cast<int>(geometry.face_px.y + (geometry.upsideDown ? -1.0 : 1.0) * depth_mm / geometry.pixel_mm);
    // The fan's edge is slanted: what is free counts along the whole height of a slider.
    int left_px = leftRoom_px(), right_px = rightRoom_px();
    for (int at = std::max(0, row - half_px); at <= std::min(height_px - 1, row + half_px); ++at) {
      const auto& runs = fan[static_cast<std::size_t>(at)];
      if (runs.empty()) continue;
      left_px = std::min(left_px, left_px_ + runs[0].begin);
      if (at == row) right_px = right_px_ + width_px - runs[runs.size() - 1].end;
    }
    besideFan_px_ = std::min(besideFan_px_, left_px);
    tooFewLeft += left_px < DgcColumn::least_px() ? 1 : 0;
    tooFewRight += right_px < rightRoom_px() ? 1 : 0;
  }
  const bool hasBar = barRoom_px() == 0 || !placeOfColourBar(roomOfBar(), rectsOfFan(fan, QPoint(left_px_, topRoom_px()), 1.0),
                                                             sizeOfColourBar(height_px, hasBarNumbers(*this)))
                                                .isNull();
  return isCompact_ || (tooFewLeft == 0 && tooFewRight <= kMostOverImage && hasBar);
}

void ScanView::setCompact(bool compact) {
  if (compact == isCompact_) return;
  isCompact_ = compact;
  arrange();
  update();
}

void ScanView::showSliders() {
  const bool isShown = !isCompact_ && (!isZoomed() || isNearSliders_);
  if (isShown == dgc_->isHidden()) dgc_->setVisible(isShown);
}

bool ScanView::event(QEvent* event) {
  const bool isMove = event->type() == QEvent::HoverMove || event->type() == QEvent::HoverEnter;
  if (isMove || event->type() == QEvent::HoverLeave) {
    isNearSliders_ = isMove && static_cast<QHoverEvent*>(event)->pos().x() < leftRoom_px();
    showSliders();
  }
  return QWidget::event(event);
}

void ScanView::arrange() {
  fitMargins();
  share_ = leastPixel_mm_ > 0.0 && session_.subject() ? std::min(1.0, pixelOfWhole_mm() / leastPixel_mm_) : 1.0;
  const QRect box = imageRect();
  session_.setImageSize(static_cast<int>(std::lround(box.width() * devicePixelRatioF())),
                        static_cast<int>(std::lround(box.height() * devicePixelRatioF())));
  const int head = DgcColumn::head_px();
  dgc_->setGeometry(0, box.top() - head, leftRoom_px(), box.height() + head);
  // A zoomed image, a strip and one that is made smaller do not keep the fan's outline.
  const int room_px = mode() == DisplayMode::bMode ? besideFan_px_ : leftRoom_px();
  dgc_->place(yOfDepth(0.0) - dgc_->y(), yOfDepth(session_.geometry().depth_mm) - dgc_->y(), room_px);
  scale_->setGeometry(width() - rightRoom_px(), box.top(), rightRoom_px(), box.height());
  showSliders();
  placeColourBar();
  Q_EMIT arranged();
}

void ScanView::setResultsRect(const QRect& rect) {
  if (resultsRect_ == rect) return;
  resultsRect_ = rect;
  placeColourBar();
  Q_EMIT arranged();
}

void ScanView::setNothing(const QString& sentence) {
  if (nothing_ == sentence) return;
  nothing_ = sentence;
  update();
}

void ScanView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const DisplayImage& display = session_.image();
  if (display.isEmpty() || !session_.subject()) {
    painter.setFont(textFont());
    painter.setPen(scanTheme().quiet);
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap,
                     nothing_.isEmpty() ? tr("Nothing to scan yet. Open a case, a volume or a sweep, or drop one here.") : nothing_);
    return;
  }
  if (mode() != DisplayMode::mMode) {
    QImage image = session_.probeControl().isLost() ? paled(imageOf(display)) : imageOf(display);
    image.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(imageRect().topLeft(), image);
    if (session_.wide() == nullptr && !isInAir()) {
      veil_.follow(session_, devicePixelRatioF());
      veil_.paint(painter, imageRect(), session_, tr("Nothing recorded here"));
    }
  }
  if (mode() != DisplayMode::bMode) paintStrip(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintDepthScale(painter);
  paintFoci(painter);
  if (mode() != DisplayMode::mMode) paintMarker(painter);
  if (knobsWithBox(session_)) {
    painter.setClipRect(imageRect());
    paintColourBox(painter, outlineOfBox(*this, session_.imageProbe(), session_.imageKnobs()));
    painter.setClipping(false);
    if (!bar_.isNull()) paintColourBar(painter, bar_, session_.imageProbe(), session_.imageKnobs(), hasBarNumbers(*this), isZoomed());
  }
  if (mode() == DisplayMode::both) paintMLine(painter);
  if (mode() == DisplayMode::spectrum) paintSpectrum(painter, *this, session_);
  if (paintOver && mode() != DisplayMode::mMode) {
    painter.save();
    painter.setClipRect(imageRect());
    paintOver(painter);
    painter.restore();
  }
  paintWords(painter);
  if (session_.isFrozen()) paintFrozenBadge(painter, width(), tr("Frozen"));
  if (recorded_s_) paintRecordingTime(painter, width() - 24, session_.isFrozen() ? 14 + badgeHeight_px() : 8, *recorded_s_);
  if (session_.probeControl().isLost()) return paintLost(painter);
  if (!said_.isEmpty()) return paintSaid(painter);
  if (paintTracked(painter)) return;
  if (mode() != DisplayMode::mMode && session_.wide() == nullptr && isBesideVolume()) {
    painter.setFont(textFont());
    painter.setPen(scanTheme().quiet);
    painter.drawText(imageRect(), Qt::AlignCenter | Qt::TextWordWrap,
                     session_.isFrozen() || session_.probeControl().mover() == ProbeControl::Mover::tracker
                         ? tr("The probe is outside the volume.")
                         : tr("The probe is outside the volume. Slide it back, or press Home for the start."));
  }
}

/// Of a tracked probe in the air nothing is missing that was not recorded: there is nothing to see.
bool ScanView::isInAir() const {
  const auto face = session_.probeControl().face();
  return face && (face->how == FaceOnSkin::inAir || face->how == FaceOnSkin::looksAway);
}

/// Border and words over all that would be live: in B- and M-mode over both.
void ScanView::paintLost(QPainter& painter) {
  const QRect shown = mode() == DisplayMode::bMode ? imageRect() : imageRect().united(stripRect());
  paintLoss(painter, shown, session_.probeControl().tracking(), !session_.probeControl().handRests());
  if (!said_.isEmpty()) paintSaid(painter);
}

/// Who has the probe while the tracker has not, and how a tracked one lies on the skin.
/// @return whether something was said
bool ScanView::paintTracked(QPainter& painter) {
  if (session_.isFrozen() || session_.isPlaying() || session_.wide() != nullptr) return false;
  if (session_.probeControl().mover() == ProbeControl::Mover::handMeanwhile) {
    const TrackingState state = session_.probeControl().tracking().state;
    const TrackingLook look = lookOf(state, scanTheme());
    paintTrackingNote(painter, imageRect(), look.icon, lossColour(state), tr("The mouse has the probe. Tracker: %1.").arg(look.word));
    return true;
  }
  const auto face = session_.probeControl().face();
  if (!face || face->how == FaceOnSkin::touches) return false;
  const bool isWrong = face->how == FaceOnSkin::tooDeep;
  paintTrackingNote(painter, imageRect(), isWrong ? QStringLiteral("tracking-invalid") : QStringLiteral("tracking-live"),
                    isWrong ? scanTheme().danger : scanTheme().quiet, words(faceSentence(*face)));
  return true;
}

bool ScanView::isBesideVolume() const {
  // An image with a single echo in it needs no question; most do. Noise is no echo.
  const ImageView<const std::uint8_t> display = session_.image().grey;
  if (!session_.imageScene().noise) {
    for (int y = 0; y < display.height; ++y) {
      if (std::any_of(display.row(y), display.row(y) + display.width, [](std::uint8_t grey) { return grey != 0; })) return false;
    }
  }
  return !session_.seesVolume();
}

/// Where data end below the middle of the face: from here on a row of dots runs along the scale.
void ScanView::paintEndOfData(QPainter& painter, double end_mm) {
  const QRect box = imageRect();
  const double x = width() - 24;
  const auto within = [&](double y) { return std::clamp(y, static_cast<double>(box.top()), static_cast<double>(box.bottom())); };
  const double from = within(yOfDepth(end_mm)), to = within(yOfDepth(session_.geometry().depth_mm));
  if (std::abs(to - from) < 4.0) return;
  const QColor colour(112, 136, 164);
  painter.setPen(QPen(colour, 2.0));
  painter.drawLine(QPointF(x - 14.0, from), QPointF(x + 4.0, from));
  painter.setPen(QPen(colour, 2.0, Qt::DotLine));
  painter.drawLine(QPointF(x + 3.0, from), QPointF(x + 3.0, to));
}

void ScanView::paintDepthScale(QPainter& painter) {
  const Theme theme = scanTheme();
  const int x = width() - 24;
  const double depth_mm = session_.geometry().depth_mm;
  painter.setFont(smallFont());
  const auto paintScale = [&](const QRect& box, auto&& yOf) {
    const int labelled_mm = labelStep_mm(depth_mm, box.height());
    const int ticked_mm = labelled_mm / 5 >= 10 ? labelled_mm / 5 : (labelled_mm >= 50 ? 10 : labelled_mm / 2);
    for (int at_mm = 0; at_mm <= depth_mm + 1e-9; at_mm += ticked_mm) {
      const double y = yOf(at_mm);
      if (y < box.top() - 1 || y > box.bottom() + 2) continue;
      const bool labelled = at_mm % labelled_mm == 0;
      painter.setPen(QPen(theme.quiet, 1.0));
      painter.drawLine(QPointF(x - (labelled ? 12 : 6), y), QPointF(x, y));
      if (labelled) drawFigures(painter, QRect(x - 56, static_cast<int>(y) - 10, 38, 20), Qt::AlignRight, QString::number(at_mm / 10));
    }
  };
  paintScale(imageRect(), [this](double mm) { return yOfDepth(mm); });
  if (mode() != DisplayMode::mMode && session_.wide() == nullptr && veil_.end_mm() && !isInAir()) paintEndOfData(painter, *veil_.end_mm());
  if (mode() == DisplayMode::both) {
    const QRect strip = stripRect();
    paintScale(strip, [&](double mm) { return strip.top() + strip.height() * mm / depth_mm; });
  }
  if (imageRect().height() > 0)
    drawFigures(painter, QRect(x - 56, height() - 8 - lineHeight_px(), 56, lineHeight_px()), Qt::AlignRight, tr("cm"));
}

void ScanView::paintFoci(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRect box = imageRect();
  const bool isOn = session_.imageScene().focus.has_value();
  for (const double focus_mm : fociOf(session_)) {
    const double y = yOfDepth(focus_mm);
    if (y < box.top() || y > box.bottom()) continue;
    QPainterPath mark;
    mark.moveTo(width() - 18, y);
    mark.lineTo(width() - 6, y - 6);
    mark.lineTo(width() - 6, y + 6);
    mark.closeSubpath();
    if (isOn) {
      painter.fillPath(mark, theme.accent);
    } else {
      painter.setPen(QPen(theme.line, 1.0));
      painter.drawPath(mark);
    }
  }
}

void ScanView::paintMarker(QPainter& painter) {
  const DisplayGeometry& geometry = session_.geometry();
  const Probe& probe = session_.imageProbe();
  // The marker stands at the side the probe's +x points to in the image, a little off the end of the face.
  const double side = geometry.markerLeft ? -1.0 : 1.0;
  const double away = geometry.upsideDown ? 12.0 : -12.0;
  const QRect box = imageRect();
  const double x = box.left() + (geometry.face_px.x + side * faceHalfWidth_mm(probe) / geometry.pixel_mm) / devicePixelRatioF();
  const double y = yOfDepth(-faceSagitta_mm(probe)) + away;
  const QPointF centre(std::clamp(x, box.left() + 6.0, box.right() - 6.0), std::clamp(y, box.top() - 12.0, box.bottom() + 12.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(scanTheme().accent);
  painter.drawEllipse(centre, 5.0, 5.0);
  painter.setBrush(Qt::NoBrush);
}

void ScanView::paintWords(QPainter& painter) {
  const Theme theme = scanTheme();
  painter.setFont(smallFont());
  painter.setPen(theme.quiet);
  const QFontMetrics metrics = painter.fontMetrics();
  const int right = width() - 24 - scaled(session_.isFrozen() ? 120 : recorded_s_ ? 72 : 0);
  painter.drawText(QRect(20, 8, right - 20, lineHeight_px()), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(label_.isEmpty() ? nameOfProbe(session_.imageProbe().name)
                                                       : label_ + QStringLiteral("   ") + nameOfProbe(session_.imageProbe().name),
                                      Qt::ElideRight, right - 20));
  const Knobs& knobs = session_.imageKnobs();
  const QString depth_cm = figure(session_.geometry().depth_mm / 10.0, 1);
  QString line = resolvedGainLaw(knobs, session_.imageScene()) == GainLaw::decibel
                     ? tr("depth %1 cm   gain %2 dB").arg(depth_cm, signedFigure(knobs.gain_db, 1))
                     : tr("depth %1 cm   gain %2 %").arg(depth_cm).arg(static_cast<int>(std::lround(knobs.gain * 100.0)));
  if (knobs.zoom > 1.0) line += tr("   zoom %1").arg(figure(knobs.zoom, 1));
  const int lineTop = height() - 8 - lineHeight_px(), lineRoom_px = width() - 24 - scaled(76);
  const auto gated = knobsWithGate(session_);
  if (gated || knobsWithBox(session_))
    line += figuresThatFit(painter, gated ? spectralFigures(session_.imageProbe(), *gated) : colourFigures(session_.imageProbe(), knobs),
                           lineRoom_px - figuresWidth_px(metrics, line));
  drawFigures(painter, QRect(20, lineTop, lineRoom_px, lineHeight_px()), Qt::AlignLeft, line);
  // What a drag would do, as long as the pointer is here and there is room beside the figures.
  const int hint_px = lineRoom_px - figuresWidth_px(metrics, line) - 48;
  const bool looksBack = session_.isFrozen() && session_.cineLoop().frame() && session_.cineLoop().ring().frameCount() > 1;
  if (underMouse() && (!session_.probeControl().handRests() || looksBack || knobs.zoom > 1.0 || !dragHint_.isEmpty()) &&
      !session_.isPlaying() && hint_px >= scaled(kHint_px)) {
    painter.drawText(QRect(20 + lineRoom_px - hint_px, lineTop, hint_px, lineHeight_px()), Qt::AlignRight | Qt::AlignVCenter,
                     !dragHint_.isEmpty() ? dragHint_
                     : knobs.zoom > 1.0   ? tr("drag: move the detail")
                     : looksBack          ? tr("wheel: step through what was scanned")
                                          : tr("drag: slide the probe"));
  }
}

void ScanView::setDragHint(const QString& hint) {
  if (hint == dragHint_) return;
  dragHint_ = hint;
  update();
}

void ScanView::setControlsEnabled(bool enabled) {
  dgc_->setEnabled(enabled);
  scale_->setEnabled(enabled);
}

void ScanView::setRecording(std::optional<double> length_s) {
  if (length_s == recorded_s_) return;
  recorded_s_ = length_s;
  update();
}

void ScanView::paintSaid(QPainter& painter) {
  painter.setFont(textFont());
  QRect room = imageRect().adjusted(16, 16, -16, -16);
  constexpr int kFromMark_px = 20;
  // Beside the body mark, which lies on top of what is painted here.
  if (const auto* mark = findChild<QWidget*>(QStringLiteral("bodyMark"));
      mark != nullptr && mark->isVisible() && mark->geometry().bottom() > room.bottom() - mark->height()) {
    if (mark->geometry().center().x() < width() / 2)
      room.setLeft(std::max(room.left(), mark->geometry().right() + kFromMark_px));
    else
      room.setRight(std::min(room.right(), mark->geometry().left() - kFromMark_px));
  }
  const QRect box = painter.boundingRect(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, said_);
  QColor veil(Qt::black);
  veil.setAlpha(200);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawRoundedRect(box.adjusted(-12, -6, 12, 6), 4.0, 4.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(scanTheme().text);
  painter.drawText(room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, said_);
}

}  // namespace ew::ui
