#include "scan_view.h"

#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "ew/imaging/effects/gain.h"
#include "figures.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kLeft_px = 56;    // DGC curve
constexpr int kRight_px = 64;   // depth scale
constexpr int kTop_px = 56;     // probe name and marker
constexpr int kBottom_px = 40;  // what the picture is

/// Distance of labelled ticks so that about 4 to 8 of them fit, from the 1-2-5 series, in mm.
int labelStep_mm(double depth_mm) {
  for (const int step : {10, 20, 50, 100}) {
    if (depth_mm / step <= 6.0) return step;
  }
  return 200;
}

}  // namespace

ScanView::ScanView(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("scanView"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Scan"));
  connect(&session_, &Session::pictureChanged, this, qOverload<>(&QWidget::update));
  connect(&session_, &Session::knobsChanged, this, qOverload<>(&QWidget::update));
  connect(&session_, &Session::frozenChanged, this, qOverload<>(&QWidget::update));
  connect(&session_, &Session::subjectChanged, this, qOverload<>(&QWidget::update));
}

QRect ScanView::pictureRect() const {
  return {kLeft_px, kTop_px, std::max(1, width() - kLeft_px - kRight_px), std::max(1, height() - kTop_px - kBottom_px)};
}

double ScanView::mmPerWidgetPixel() const {
  const double pixel_mm = session_.geometry().pixel_mm;
  return pixel_mm > 0.0 ? pixel_mm * devicePixelRatioF() : 0.25;
}

double ScanView::yOfDepth(double depth_mm) const {
  const DisplayGeometry& geometry = session_.geometry();
  return pictureRect().top() + (geometry.face_px.y + depth_mm / geometry.pixel_mm) / devicePixelRatioF();
}

void ScanView::resizeEvent(QResizeEvent*) { askForPicture(); }

void ScanView::askForPicture() {
  const QRect box = pictureRect();
  session_.setPictureSize(static_cast<int>(std::lround(box.width() * devicePixelRatioF())),
                          static_cast<int>(std::lround(box.height() * devicePixelRatioF())));
}

void ScanView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const ImageView<const std::uint8_t> picture = session_.picture();
  if (picture.width == 0 || !session_.subject()) {
    painter.setFont(textFont());
    painter.setPen(scanTheme().quiet);
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Nothing to scan yet. Open a case, a volume or a sweep (Ctrl+O), or drop one here."));
    return;
  }
  QImage image(picture.data, picture.width, picture.height, static_cast<int>(picture.stride), QImage::Format_Grayscale8);
  image.setDevicePixelRatio(devicePixelRatioF());
  painter.drawImage(pictureRect().topLeft(), image);
  painter.setRenderHint(QPainter::Antialiasing);
  paintDepthScale(painter);
  paintMarker(painter);
  paintDgcCurve(painter);
  paintWords(painter);
  if (isBesideVolume()) {
    painter.setFont(textFont());
    painter.setPen(scanTheme().quiet);
    painter.drawText(pictureRect(), Qt::AlignCenter | Qt::TextWordWrap,
                     session_.isFrozen() ? tr("The probe is beside the volume.")
                                         : tr("The probe is beside the volume. Slide it back, or press Home for the start."));
  }
}

bool ScanView::isBesideVolume() const {
  // A picture with a single echo in it needs no question; most do.
  const ImageView<const std::uint8_t> picture = session_.picture();
  for (int y = 0; y < picture.height; ++y) {
    if (std::any_of(picture.row(y), picture.row(y) + picture.width, [](std::uint8_t grey) { return grey != 0; })) return false;
  }
  return !session_.seesVolume();
}

void ScanView::paintDepthScale(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRect box = pictureRect();
  const double depth_mm = session_.geometry().depth_mm;
  const int labelled_mm = labelStep_mm(depth_mm);
  const int ticked_mm = labelled_mm / 5 >= 10 ? labelled_mm / 5 : (labelled_mm >= 50 ? 10 : labelled_mm / 2);
  const int x = width() - 24;
  painter.setFont(smallFont());
  for (int at_mm = 0; at_mm <= depth_mm + 1e-9; at_mm += ticked_mm) {
    const double y = yOfDepth(at_mm);
    if (y < box.top() - 1 || y > box.bottom() + 1) continue;
    const bool labelled = at_mm % labelled_mm == 0;
    painter.setPen(QPen(theme.quiet, 1.0));
    painter.drawLine(QPointF(x - (labelled ? 12 : 6), y), QPointF(x, y));
    if (labelled) drawFigures(painter, QRect(x - 56, static_cast<int>(y) - 10, 38, 20), Qt::AlignRight, QString::number(at_mm / 10));
  }
  if (box.height() > 0) drawFigures(painter, QRect(x - 56, height() - 32, 56, 24), Qt::AlignRight, tr("cm"));

  const double focusY =
      yOfDepth(session_.isFrozen() && session_.pictureKnobs().focus_mm > 0.0 ? session_.pictureKnobs().focus_mm : session_.focus_mm());
  if (focusY >= box.top() && focusY <= box.bottom()) {
    QPainterPath mark;
    mark.moveTo(width() - 18, focusY);
    mark.lineTo(width() - 6, focusY - 6);
    mark.lineTo(width() - 6, focusY + 6);
    mark.closeSubpath();
    painter.fillPath(mark, theme.accent);
  }
}

void ScanView::paintMarker(QPainter& painter) {
  const DisplayGeometry& geometry = session_.geometry();
  const Probe& probe = session_.pictureProbe();
  // The marker stands at the side the probe's +x points to in the picture.
  const double side = geometry.markerLeft ? -1.0 : 1.0;
  const QRect box = pictureRect();
  const double x = box.left() + (geometry.face_px.x + side * faceHalfWidth_mm(probe) / geometry.pixel_mm) / devicePixelRatioF();
  const double y = yOfDepth(-faceSagitta_mm(probe)) - 12.0;
  const QPointF centre(std::clamp(x, box.left() + 6.0, box.right() - 6.0), std::max(y, box.top() - 12.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(scanTheme().accent);
  painter.drawEllipse(centre, 5.0, 5.0);
  painter.setBrush(Qt::NoBrush);
}

void ScanView::paintDgcCurve(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRect box = pictureRect();
  const double top = yOfDepth(0.0);
  const double bottom = yOfDepth(session_.geometry().depth_mm);
  const double middle = 28.0;
  const double reach = 20.0;  // a factor of 0 or 2 lies this far from the neutral line
  painter.setClipRect(QRect(0, box.top(), kLeft_px, box.height()));
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(QPointF(middle, top), QPointF(middle, bottom));
  QPainterPath curve;
  constexpr int kPoints = 96;
  for (int i = 0; i <= kPoints; ++i) {
    const double position = static_cast<double>(i) / kPoints;
    const double factor = dgcAt(session_.pictureKnobs().dgc, position);
    const QPointF at(middle + (std::min(factor, 2.0) - 1.0) * reach, top + (bottom - top) * position);
    if (i == 0) {
      curve.moveTo(at);
    } else {
      curve.lineTo(at);
    }
  }
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawPath(curve);
  painter.setClipping(false);
}

void ScanView::paintWords(QPainter& painter) {
  const Theme theme = scanTheme();
  painter.setFont(smallFont());
  painter.setPen(theme.quiet);
  const QFontMetrics metrics = painter.fontMetrics();
  const int right = session_.isFrozen() ? width() - 120 : width() - 24;
  painter.drawText(QRect(20, 12, right - 20, 24), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(words(session_.pictureProbe().name), Qt::ElideRight, right - 20));
  if (session_.isFrozen()) {
    painter.setPen(theme.accent);
    painter.drawText(QRect(width() - 144, 12, 120, 24), Qt::AlignRight | Qt::AlignVCenter, tr("Frozen"));
    painter.setPen(theme.quiet);
  }
  const Knobs& knobs = session_.pictureKnobs();
  const QString line = tr("depth %1 mm   gain %2 %   zoom %3")
                           .arg(static_cast<int>(std::lround(session_.geometry().depth_mm)))
                           .arg(static_cast<int>(std::lround(knobs.gain * 100.0)))
                           .arg(knobs.zoom, 0, 'f', 1);
  drawFigures(painter, QRect(20, height() - 32, width() - 100, 24), Qt::AlignLeft, line);
}

}  // namespace ew::ui
