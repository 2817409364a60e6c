// The M-mode and the spectrum of the scan view: line and sample volume on the image, and the strip.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ew/imaging/beam_grid.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/theme.h"
#include "scan/scan_view.h"
#include "scan/spectrum_on_image.h"
#include "scan/tracking_overlay.h"

namespace ew::ui {
namespace {

/// Across a strip; labels stay apart.
void paintSeconds(QPainter& painter, const QRect& box, double sweep_s) {
  const int labelled_s = box.width() / sweep_s < scaled(40.0) ? (box.width() / sweep_s < scaled(20.0) ? 4 : 2) : 1;
  painter.setFont(smallFont());
  painter.setPen(QPen(scanTheme().quiet, 1.0));
  for (int second = 0; second <= static_cast<int>(sweep_s + 1e-9); ++second) {
    const int x = box.left() + static_cast<int>(std::lround(second / sweep_s * (box.width() - 1)));
    const bool labelled = second % labelled_s == 0;
    painter.drawLine(x, box.bottom() + 2, x, box.bottom() + (labelled ? 8 : 5));
    if (labelled && second > 0) {
      drawFigures(painter, QRect(x - 40, box.bottom() + 8, 44, scaled(16)), Qt::AlignRight, ScanView::tr("%1 s").arg(second));
    }
  }
}

}  // namespace

DisplayMode ScanView::mode() const {
  const DisplayMode asked = session_.imageKnobs().mode;
  return asked == DisplayMode::spectrum && !knobsWithGate(session_) ? DisplayMode::bMode : asked;
}

QRect ScanView::stripRect() const {
  const QRect display = imageRect();
  if (mode() == DisplayMode::bMode) return {};
  return mode() == DisplayMode::mMode ? display : display.translated(0, display.height() + 16);
}

void ScanView::paintMLine(QPainter& painter) {
  const DisplayGeometry& geometry = session_.geometry();
  const Knobs& knobs = session_.imageKnobs();
  const BeamGrid grid = makeBeamGrid(session_.imageProbe(), knobs, geometry.depth_mm, geometry.depth_mm / 8.0);
  if (grid.lines.empty()) return;
  const auto last = static_cast<double>(grid.lines.size() - 1);
  const auto index = static_cast<std::size_t>(std::lround((std::clamp(knobs.mLine, -1.0, 1.0) + 1.0) / 2.0 * last));
  const BeamGrid::Line& line = grid.lines[index];
  const QRect box = imageRect();
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
  const ImageView<const std::uint8_t> strip = session_.seen().strip();
  painter.setPen(QPen(theme.line, 1.0));
  painter.drawLine(box.left(), box.top() - 8, box.right(), box.top() - 8);
  if (strip.width > 0) {
    QImage image = session_.probeControl().isLost() ? paled(imageOf(strip)) : imageOf(strip);
    image.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(box.topLeft(), image);
    const double x = box.left() + session_.seen().stripCursor() / devicePixelRatioF();
    painter.setPen(QPen(theme.accent, 1.0));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  }
  paintSeconds(painter, box, std::max(1.0, session_.imageKnobs().mSweep_s));
}

}  // namespace ew::ui
