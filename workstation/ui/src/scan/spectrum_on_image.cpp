#include "scan/spectrum_on_image.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/imaging/resolved.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "scan/lines_on_image.h"
#include "scan/scan_view.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr double kGateBar_px = 9.0, kFlow_px = 44.0;  // half of a bar at the volume's ends, and of the flow line
constexpr double kAngleError_rad = glm::radians(3.0);
constexpr int kBesideValues_px = 20;  // and the window's edge
constexpr int kValuesShare = 4;       // of the view: no more of its height
constexpr int kValues = 6, kBetweenValues_px = 20;
const QColor kFlow(120, 220, 255);
const QColor kEnvelope(255, 214, 64);

int line_px() { return scaled(18); }
int timeRoom_px() { return 8 + scaled(16); }

/// Where a velocity lies in a strip, from 0 at its upper edge to 1 at its lower one. @param velocity as a share of the Nyquist velocity
double downOf(double velocity, const SpectralDoppler& spectral) {
  const double down = 0.5 * (1.0 + spectral.baseline - velocity);
  return spectral.invert ? 1.0 - down : down;
}

double yOf(double velocity, const QRect& strip, const SpectralDoppler& spectral) {
  return strip.top() + downOf(velocity, spectral) * strip.height();
}

/// From the series 1, 2, 5, so that numbers stay apart.
double labelStep(double range, double height_px) {
  const double least = range / std::max(height_px / scaled(34.0), 1.0);
  double step = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-3))));
  for (const double factor : {2.0, 2.5, 2.0})  // 2, 5, 10
    if (step < least) step *= factor;
  return step;
}

QString velocityText(double velocity_cmPerS, int decimals) {
  return velocity_cmPerS < 0.0 ? signedFigure(velocity_cmPerS, decimals) : figure(velocity_cmPerS, decimals);
}

int widthOfValue_px(const QFontMetrics& metrics) {
  return figuresWidth_px(metrics, ScanView::tr("TAMX %1 ± %2 cm/s").arg(QStringLiteral("−888"), QStringLiteral("88"))) + kBetweenValues_px;
}

/// As many side by side as there is room for, in rows as long as each other.
int valuesInARow(int width_px) {
  const int fitting = std::clamp(width_px / std::max(1, widthOfValue_px(QFontMetrics(smallFont()))), 1, kValues);
  const int rows = (kValues + fitting - 1) / fitting;
  return (kValues + rows - 1) / rows;
}

}  // namespace

std::optional<Knobs> knobsWithGate(const Session& session) {
  Knobs knobs = session.imageKnobs();
  if (knobs.mode != DisplayMode::spectrum || !session.subject() || !session.subject()->showsColour()) return std::nullopt;
  if (session.wide() != nullptr) return std::nullopt;
  if (!knobs.spectral) knobs.spectral.emplace();
  return knobs;
}

GateOutline outlineOfGate(const Probe& probe, const Knobs& knobs, const std::function<QPointF(const glm::dvec2&)>& placeOf) {
  const SpectralGate gate = spectralGateOf(probe, knobs);
  GateOutline outline;
  outline.face = placeOf(gate.face_mm);
  outline.middle = placeOf(gate.middle_mm);
  outline.end = placeOf(gate.face_mm + resolvedDepth_mm(probe, knobs) * gate.direction);
  const auto towards = [&](const glm::dvec2& direction) {
    const QPointF by = placeOf(gate.middle_mm + direction) - outline.middle;
    return std::pair{by, std::hypot(by.x(), by.y())};
  };
  const auto [along, pixelsPerMm] = towards(gate.direction);
  outline.along = along / pixelsPerMm;
  outline.length_px = gate.length_mm * pixelsPerMm;
  for (const double depth_mm : gate.alsoAt_mm) outline.alsoAt.push_back(placeOf(gate.face_mm + depth_mm * gate.direction));
  const auto [flow, flow_px] = towards(gate.flow);
  const double half_px = std::max(scaled(kFlow_px), 0.5 * outline.length_px + scaled(kFlow_px / 2.0));
  outline.flowFrom = outline.middle - half_px / flow_px * flow;
  outline.flowTo = outline.middle + half_px / flow_px * flow;
  return outline;
}

GateOutline outlineOfGate(const ScanView& scan, const Probe& probe, const Knobs& knobs) {
  return outlineOfGate(probe, knobs, [&scan](const glm::dvec2& p_mm) { return scan.positionOf({{p_mm.x, p_mm.y, 0.0}}); });
}

double angleOfLine_rad(double across, double along) {
  double degrees = std::round(glm::degrees(std::atan2(across, along)));
  if (degrees > 90.0) degrees -= 180.0;
  if (degrees < -90.0) degrees += 180.0;
  return std::clamp(glm::radians(degrees), -kMostDopplerAngle_rad, kMostDopplerAngle_rad);
}

QString angleText(double angle_rad) { return ScanView::tr("%1°").arg(signedFigure(glm::degrees(angle_rad), 0).remove(QLatin1Char('+'))); }

void paintGate(QPainter& painter, const GateOutline& outline, const Knobs& knobs, const QRect& within) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF half = 0.5 * outline.length_px * outline.along, bar = scaled(kGateBar_px) * QPointF(outline.along.y(), -outline.along.x());
  drawOnImage(painter, kLineOnImage, 1.0, [&] {
    painter.drawLine(outline.face, outline.middle - half);
    painter.drawLine(outline.middle + half, outline.end);
  });
  const auto drawBars = [&](const QPointF& middle) {
    painter.drawLine(middle - half - bar, middle - half + bar);
    painter.drawLine(middle + half - bar, middle + half + bar);
  };
  drawOnImage(painter, kLineOnImage, 2.0, [&] { drawBars(outline.middle); });
  drawOnImage(painter, scanTheme().quiet, 1.0, [&] {
    for (const QPointF& middle : outline.alsoAt) drawBars(middle);
  });
  const double angle_rad = limited(knobs).spectral->angle_rad;
  const QColor colour = angleWarning(angle_rad).isEmpty() ? kFlow : scanTheme().danger;
  drawOnImage(painter, colour, 1.5, [&] { painter.drawLine(outline.flowFrom, outline.flowTo); });
  painter.setPen(QPen(Qt::black, 1.0));
  painter.setBrush(colour);
  for (const QPointF& tip : {outline.flowFrom, outline.flowTo}) painter.drawEllipse(tip, scaled(3.5), scaled(3.5));
  painter.setBrush(Qt::NoBrush);
  painter.setFont(smallFont());
  // Beyond a tip, where the line itself does not run: of the right one, unless it is cut off there.
  const bool isTurned = outline.flowTo.x() < outline.flowFrom.x();
  const QPointF &left = isTurned ? outline.flowTo : outline.flowFrom, &right = isTurned ? outline.flowFrom : outline.flowTo;
  const QString text = angleText(angle_rad);
  const int wide_px = painter.fontMetrics().horizontalAdvance(text) + 8, off_px = scaled(8);
  QRect box(static_cast<int>(right.x()) + off_px, static_cast<int>(right.y()) - line_px() / 2, wide_px, line_px());
  if (box.right() > within.right())
    box = QRect(static_cast<int>(left.x()) - off_px - wide_px, static_cast<int>(left.y()) - line_px() / 2, wide_px, line_px());
  painter.fillRect(box, QColor(0, 0, 0, 150));
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, text);
  painter.restore();
}

QString angleWarning(double angle_rad) {
  if (std::abs(angle_rad) <= kTrustedDopplerAngle_rad + 1e-9) return {};
  const int percent = static_cast<int>(std::lround(100.0 * angleUncertainty(angle_rad, kAngleError_rad)));
  return ScanView::tr("Beyond 60°: an error of 3° changes the velocity by %1 %").arg(percent);
}

void paintVelocityScale(QPainter& painter, const QRect& strip, int right, const Probe& probe, const Knobs& knobs) {
  const SpectralGate gate = spectralGateOf(probe, knobs);
  const SpectralDoppler spectral = *limited(knobs).spectral;
  const double lowest = gate.shown_mmPerS.first / 10.0, highest = gate.shown_mmPerS.second / 10.0;
  const double nyquist = gate.nyquist_mmPerS * gate.corrected / 10.0, step = labelStep(highest - lowest, strip.height());
  painter.setFont(smallFont());
  painter.setPen(QPen(scanTheme().quiet, 1.0));
  for (auto n = static_cast<int>(std::ceil(2.0 * lowest / step)); n <= static_cast<int>(std::floor(2.0 * highest / step)); ++n) {
    const double velocity = 0.5 * n * step, y = yOf(velocity / nyquist, strip, spectral);
    const bool isLabelled = n % 2 == 0;
    painter.drawLine(QPointF(right - (isLabelled ? 12 : 6), y), QPointF(right, y));
    // Half a line above the strip stands what the numbers are measured in.
    if (isLabelled && y > strip.top() + scaled(4) && y < strip.bottom() - scaled(4))
      drawFigures(painter, QRect(right - 14 - scaled(44), static_cast<int>(y) - 10, scaled(44), 20), Qt::AlignRight,
                  velocityText(velocity, step < 1.0 ? 1 : 0));
  }
  drawFigures(painter, QRect(right - scaled(60), strip.bottom() + 4, scaled(60), scaled(18)), Qt::AlignRight, ScanView::tr("cm/s"));
}

void paintBaseline(QPainter& painter, const QRect& strip, const Knobs& knobs) {
  const double y = yOf(0.0, strip, *limited(knobs).spectral);
  painter.setPen(QPen(QColor(235, 235, 235, 150), 1.0));
  painter.drawLine(QPointF(strip.left(), y), QPointF(strip.right(), y));
}

void paintEnvelope(QPainter& painter, const QRect& strip, double pixelRatio, const MModeStrip& columns, const Knobs& knobs,
                   const SpectrumReading& reading) {
  const SpectralDoppler spectral = *limited(knobs).spectral;
  painter.save();
  painter.setClipRect(strip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(kEnvelope, 1.25));
  QPolygonF line;
  const auto draw = [&] {
    if (line.size() > 1) painter.drawPolyline(line);
    line.clear();
  };
  for (std::size_t n = 0; n < reading.points.size(); ++n) {
    const auto column = columns.columnOf(reading.points[n].time_s);
    if (!column) {
      draw();
      continue;
    }
    const QPointF at(strip.left() + (*column + 0.5) / pixelRatio, yOf(reading.envelope[n], strip, spectral));
    if (!line.isEmpty() && at.x() < line.back().x()) draw();  // around the strip's end
    line << at;
  }
  draw();
  painter.restore();
}

QStringList spectralValues(const WaveformValues& values, const Probe& probe, const Knobs& knobs) {
  const SpectralGate gate = spectralGateOf(probe, knobs);
  const double unit_cmPerS = gate.nyquist_mmPerS * gate.corrected / 10.0;
  const double share = angleUncertainty(limited(knobs).spectral->angle_rad, kAngleError_rad);
  const auto velocity = [&](const QString& pattern, double value) {
    const double velocity_cmPerS = unit_cmPerS * value, error_cmPerS = std::abs(velocity_cmPerS) * share;
    const int decimals = error_cmPerS < 0.95 && std::abs(velocity_cmPerS) < 99.5 ? 1 : 0;
    return pattern.arg(velocityText(velocity_cmPerS, decimals), figure(error_cmPerS, decimals));
  };
  const auto pulsatility = values.pulsatilityIndex();
  return {velocity(ScanView::tr("PSV %1 ± %2 cm/s"), values.peakSystolic),
          velocity(ScanView::tr("EDV %1 ± %2 cm/s"), values.endDiastolic),
          ScanView::tr("RI %1").arg(figure(values.resistiveIndex(), 2)),
          velocity(ScanView::tr("TAMX %1 ± %2 cm/s"), values.timeAverageMaximum),
          pulsatility ? ScanView::tr("PI %1").arg(figure(*pulsatility, 2)) : ScanView::tr("PI –"),
          ScanView::tr("HR %1/min").arg(figure(60.0 / values.heartPeriod_s, 0))};
}

int heightOfValues_px(const QSize& view) {
  const int inARow = valuesInARow(view.width());
  const int rows = std::clamp(view.height() / kValuesShare / line_px(), 1, (kValues + inARow - 1) / inARow);
  return (1 + rows) * line_px() + 4;
}

void paintValues(QPainter& painter, const QRect& room, const QStringList& values, const QString& warning) {
  painter.setFont(smallFont());
  painter.setPen(scanTheme().text);
  const int inARow = valuesInARow(room.width()), wide_px = widthOfValue_px(painter.fontMetrics());
  const int rows = room.height() / line_px() - 1;
  for (int n = 0; n < std::min(static_cast<int>(values.size()), rows * inARow); ++n)
    drawFigures(painter, QRect(room.left() + n % inARow * wide_px, room.top() + n / inARow * line_px(), wide_px, line_px()), Qt::AlignLeft,
                values[n]);
  painter.setPen(scanTheme().danger);
  painter.drawText(QRect(room.left(), room.top() + rows * line_px(), room.width(), line_px()), Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(warning, Qt::ElideRight, room.width()));
}

int belowStrip_px(const ScanView& scan, DisplayMode mode) {
  const bool hasValues = mode == DisplayMode::spectrum && !scan.isCompact();
  return timeRoom_px() + (hasValues ? heightOfValues_px(scan.size() - QSize(2 * kBesideValues_px, 0)) : 0);
}

void paintSpectrum(QPainter& painter, const ScanView& scan, Session& session) {
  const auto knobs = knobsWithGate(session);
  if (!knobs) return;
  const Probe& probe = session.imageProbe();
  const QRect image = scan.imageRect(), strip = scan.stripRect();
  painter.save();
  painter.setClipRect(image);
  paintGate(painter, outlineOfGate(scan, probe, *knobs), *knobs, image);
  painter.restore();
  paintVelocityScale(painter, strip, scan.width() - 24, probe, *knobs);
  paintBaseline(painter, strip, *knobs);
  const SpectrumReading* reading = session.spectrumTrace().reading();
  if (reading != nullptr && session.spectrumTrace().isShown())
    paintEnvelope(painter, strip, scan.devicePixelRatioF(), session.seen().mMode(), *knobs, *reading);
  if (scan.isCompact()) return;
  const QSize room = scan.size() - QSize(2 * kBesideValues_px, 0);
  paintValues(painter, QRect(QPoint(kBesideValues_px, strip.bottom() + timeRoom_px() + 2), QSize(room.width(), heightOfValues_px(room))),
              reading != nullptr && reading->values ? spectralValues(*reading->values, probe, *knobs) : QStringList(),
              angleWarning(knobs->spectral->angle_rad));
}

QStringList spectralFigures(const Probe& probe, const Knobs& knobs) {
  const SpectralGate gate = spectralGateOf(probe, knobs);
  return {ScanView::tr("   angle %1").arg(angleText(limited(knobs).spectral->angle_rad)),
          ScanView::tr("   volume %1 mm").arg(figure(gate.length_mm, 1)),
          ScanView::tr("   PRF %1 kHz").arg(figure(gate.prf_hz / 1000.0, 2)),
          ScanView::tr("   filter %1 Hz").arg(figure(limited(knobs).spectral->wallFilter_hz, 0))};
}

}  // namespace ew::ui
