#include "scan_view.h"

#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "dgc_column.h"
#include "ew/imaging/beam_grid.h"
#include "figures.h"
#include "focus_scale.h"
#include "theme.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr int kLeft_px = DgcColumn::kWidth_px;
constexpr int kRight_px = 64;   // depth scale
constexpr int kTop_px = 56;     // probe name and marker
constexpr int kBottom_px = 40;  // what the picture is
constexpr int kTime_px = 24;    // time ticks under the strip

/// Distance of labelled ticks so that about 4 to 8 of them fit, from the 1-2-5 series, in mm.
int labelStep_mm(double depth_mm, double height_px) {
  const double most = std::clamp(height_px / 48.0, 2.0, 6.0);
  for (const int step : {10, 20, 50, 100}) {
    if (depth_mm / step <= most) return step;
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
  dgc_ = new DgcColumn(session_, this);
  scale_ = new FocusScale(
      session_, [this](double y) { return depthAt_mm(y); }, this);
  session_.setWatched(false);
  const auto changed = [this] {
    arrange();
    update();
  };
  connect(&session_, &Session::pictureChanged, this, changed);
  connect(&session_, &Session::knobsChanged, this, changed);
  connect(&session_, &Session::sceneChanged, this, changed);
  connect(&session_, &Session::frozenChanged, this, changed);
  connect(&session_, &Session::subjectChanged, this, changed);
}

QRect ScanView::pictureRect() const {
  const QRect whole(kLeft_px, kTop_px, std::max(1, width() - kLeft_px - kRight_px), std::max(1, height() - kTop_px - kBottom_px));
  if (mode() == DisplayMode::bMode) return whole;
  if (mode() == DisplayMode::mMode) return whole.adjusted(0, 0, 0, -std::min(kTime_px, whole.height() - 1));
  // Picture and strip have the same size; between them there is room for the picture's lower edge to be seen as one.
  return {whole.left(), whole.top(), whole.width(), std::max(1, (whole.height() - kTime_px - 16) / 2)};
}

QRect ScanView::stripRect() const {
  const QRect picture = pictureRect();
  if (mode() == DisplayMode::bMode) return {};
  return mode() == DisplayMode::mMode ? picture : picture.translated(0, picture.height() + 16);
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
  return pictureRect().top() + (geometry.face_px.y + down * depth_mm / geometry.pixel_mm) / devicePixelRatioF();
}

double ScanView::depthAt_mm(double y) const {
  const double top = yOfDepth(0.0);
  const double perMm = yOfDepth(1.0) - top;
  return perMm != 0.0 ? (y - top) / perMm : 0.0;
}

void ScanView::resizeEvent(QResizeEvent*) { arrange(); }
void ScanView::showEvent(QShowEvent*) { session_.setWatched(true); }
void ScanView::hideEvent(QHideEvent*) { session_.setWatched(false); }
void ScanView::refreshIcons() { dgc_->refreshIcons(); }

void ScanView::arrange() {
  const QRect box = pictureRect();
  session_.setPictureSize(static_cast<int>(std::lround(box.width() * devicePixelRatioF())),
                          static_cast<int>(std::lround(box.height() * devicePixelRatioF())));
  const int head = DgcColumn::kHead_px;
  dgc_->setGeometry(0, box.top() - head, kLeft_px, box.height() + head);
  dgc_->place(yOfDepth(0.0) - dgc_->y(), yOfDepth(session_.geometry().depth_mm) - dgc_->y());
  scale_->setGeometry(width() - kRight_px, box.top(), kRight_px, box.height());
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
  if (mode() != DisplayMode::mMode) {
    QImage image(picture.data, picture.width, picture.height, static_cast<int>(picture.stride), QImage::Format_Grayscale8);
    image.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(pictureRect().topLeft(), image);
  }
  if (mode() != DisplayMode::bMode) paintStrip(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintDepthScale(painter);
  paintFoci(painter);
  if (mode() != DisplayMode::mMode) paintMarker(painter);
  if (mode() == DisplayMode::both) paintMLine(painter);
  paintWords(painter);
  if (mode() != DisplayMode::mMode && isBesideVolume()) {
    painter.setFont(textFont());
    painter.setPen(scanTheme().quiet);
    painter.drawText(pictureRect(), Qt::AlignCenter | Qt::TextWordWrap,
                     session_.isFrozen() ? tr("The probe is beside the volume.")
                                         : tr("The probe is beside the volume. Slide it back, or press Home for the start."));
  }
}

bool ScanView::isBesideVolume() const {
  // A picture with a single echo in it needs no question; most do. Noise is no echo.
  const ImageView<const std::uint8_t> picture = session_.picture();
  if (!session_.pictureScene().noise) {
    for (int y = 0; y < picture.height; ++y) {
      if (std::any_of(picture.row(y), picture.row(y) + picture.width, [](std::uint8_t grey) { return grey != 0; })) return false;
    }
  }
  return !session_.seesVolume();
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
  paintScale(pictureRect(), [this](double mm) { return yOfDepth(mm); });
  if (mode() == DisplayMode::both) {
    const QRect strip = stripRect();
    paintScale(strip, [&](double mm) { return strip.top() + strip.height() * mm / depth_mm; });
  }
  if (pictureRect().height() > 0) drawFigures(painter, QRect(x - 56, height() - 32, 56, 24), Qt::AlignRight, tr("cm"));
}

void ScanView::paintFoci(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRect box = pictureRect();
  const bool isOn = session_.pictureScene().focus.has_value();
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
  const Probe& probe = session_.pictureProbe();
  // The marker stands at the side the probe's +x points to in the picture, a little off the end of the face.
  const double side = geometry.markerLeft ? -1.0 : 1.0;
  const double away = geometry.upsideDown ? 12.0 : -12.0;
  const QRect box = pictureRect();
  const double x = box.left() + (geometry.face_px.x + side * faceHalfWidth_mm(probe) / geometry.pixel_mm) / devicePixelRatioF();
  const double y = yOfDepth(-faceSagitta_mm(probe)) + away;
  const QPointF centre(std::clamp(x, box.left() + 6.0, box.right() - 6.0), std::clamp(y, box.top() - 12.0, box.bottom() + 12.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(scanTheme().accent);
  painter.drawEllipse(centre, 5.0, 5.0);
  painter.setBrush(Qt::NoBrush);
}

void ScanView::paintMLine(QPainter& painter) {
  const DisplayGeometry& geometry = session_.geometry();
  const Knobs& knobs = session_.pictureKnobs();
  const BeamGrid grid = makeBeamGrid(session_.pictureProbe(), knobs, geometry.depth_mm, geometry.depth_mm / 8.0);
  if (grid.lines.empty()) return;
  const auto last = static_cast<double>(grid.lines.size() - 1);
  const auto index = static_cast<std::size_t>(std::lround((std::clamp(knobs.mLine, -1.0, 1.0) + 1.0) / 2.0 * last));
  const BeamGrid::Line& line = grid.lines[index];
  const QRect box = pictureRect();
  const auto at = [&](double depth_mm) {
    const glm::dvec2 p_mm = line.origin_mm + depth_mm * line.direction;
    const double across = geometry.markerLeft ? -1.0 : 1.0;
    return QPointF(box.left() + (geometry.face_px.x + across * p_mm.x / geometry.pixel_mm) / devicePixelRatioF(), yOfDepth(p_mm.y));
  };
  painter.setClipRect(box);
  QColor accent = scanTheme().accent;
  accent.setAlpha(200);
  painter.setPen(QPen(accent, 1.0, Qt::DashLine));
  painter.drawLine(at(0.0), at(geometry.depth_mm));
  painter.setClipping(false);
}

void ScanView::paintStrip(QPainter& painter) {
  const Theme theme = scanTheme();
  const QRect box = stripRect();
  const ImageView<const std::uint8_t> strip = session_.strip();
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(box.left(), box.top() - 8, box.right(), box.top() - 8);
  if (strip.width > 0) {
    QImage image(strip.data, strip.width, strip.height, static_cast<int>(strip.stride), QImage::Format_Grayscale8);
    image.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(box.topLeft(), image);
    const double x = box.left() + session_.stripCursor() / devicePixelRatioF();
    painter.setPen(QPen(theme.accent, 1.0));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  }
  // Seconds across the strip; labels stay apart.
  const double sweep_s = std::max(1.0, session_.pictureKnobs().mSweep_s);
  const int labelled_s = box.width() / sweep_s < 40.0 ? (box.width() / sweep_s < 20.0 ? 4 : 2) : 1;
  painter.setFont(smallFont());
  painter.setPen(QPen(theme.quiet, 1.0));
  for (int second = 0; second <= static_cast<int>(sweep_s + 1e-9); ++second) {
    const int x = box.left() + static_cast<int>(std::lround(second / sweep_s * (box.width() - 1)));
    const bool labelled = second % labelled_s == 0;
    painter.drawLine(x, box.bottom() + 2, x, box.bottom() + (labelled ? 8 : 5));
    if (labelled && second > 0) {
      drawFigures(painter, QRect(x - 40, box.bottom() + 8, 44, 16), Qt::AlignRight, tr("%1 s").arg(second));
    }
  }
}

void ScanView::paintWords(QPainter& painter) {
  const Theme theme = scanTheme();
  painter.setFont(smallFont());
  painter.setPen(theme.quiet);
  const QFontMetrics metrics = painter.fontMetrics();
  const int right = session_.isFrozen() ? width() - 120 : width() - 24;
  painter.drawText(QRect(20, 8, right - 20, 24), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(words(session_.pictureProbe().name), Qt::ElideRight, right - 20));
  if (session_.isFrozen()) {
    painter.setPen(theme.accent);
    painter.drawText(QRect(width() - 144, 8, 120, 24), Qt::AlignRight | Qt::AlignVCenter, tr("Frozen"));
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
