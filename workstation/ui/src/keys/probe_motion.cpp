#include "keys/probe_motion.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

constexpr int kWidth_px = 64;
constexpr int kHeight_px = 44;
constexpr double kSkin_px = 36.0;  // y of the skin

/// A probe that stands on (0, 0): face, shoulders, handle. @param faceHalf_px half of the width it shows
QPainterPath probeOf(double faceHalf_px) {
  QPainterPath probe;
  const double handle_px = std::min(5.0, faceHalf_px);
  probe.moveTo(-faceHalf_px, 0.0);
  probe.quadTo(0.0, 2.5, faceHalf_px, 0.0);
  probe.lineTo(faceHalf_px, -7.0);
  probe.quadTo(handle_px, -11.0, handle_px, -16.0);
  probe.lineTo(handle_px, -26.0);
  probe.quadTo(0.0, -29.0, -handle_px, -26.0);
  probe.lineTo(-handle_px, -16.0);
  probe.quadTo(-handle_px, -11.0, -faceHalf_px, -7.0);
  probe.closeSubpath();
  return probe;
}

void paintHead(QPainter& painter, const QPointF& tip, double towards_rad) {
  constexpr double kLength_px = 5.0;
  for (const double side : {-1.0, 1.0}) {
    const double angle = towards_rad + M_PI + side * 0.5;
    painter.drawLine(tip, tip + kLength_px * QPointF(std::cos(angle), std::sin(angle)));
  }
}

/// An arc with a head at each end, about a centre. Angles in degrees, counter-clockwise from the right, as QPainter has them.
void paintArc(QPainter& painter, const QPointF& centre, double radius_px, double from_deg, double to_deg) {
  const QRectF box(centre.x() - radius_px, centre.y() - radius_px, 2.0 * radius_px, 2.0 * radius_px);
  QPainterPath arc;
  arc.arcMoveTo(box, from_deg);
  arc.arcTo(box, from_deg, to_deg - from_deg);
  painter.drawPath(arc);
  const auto at = [&](double deg) {
    const double rad = deg * M_PI / 180.0;
    return centre + radius_px * QPointF(std::cos(rad), -std::sin(rad));
  };
  paintHead(painter, at(from_deg), M_PI / 2.0 - from_deg * M_PI / 180.0);
  paintHead(painter, at(to_deg), -M_PI / 2.0 - to_deg * M_PI / 180.0);
}

}  // namespace

ProbeMotionDrawing::ProbeMotionDrawing(ProbeMotion motion, QWidget* parent) : QWidget(parent), motion_(motion) {
  setFixedSize(kWidth_px, kHeight_px);
}

void ProbeMotionDrawing::paintEvent(QPaintEvent*) {
  const Theme& theme = currentTheme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF foot(kWidth_px / 2.0, kSkin_px);
  const QPen outline(theme.quiet, 1.25);
  const QPen arrow(theme.accent, 1.5, Qt::SolidLine, Qt::RoundCap);
  if (motion_ == ProbeMotion::rotate) {  // from above: the face's long side, and the mark at its end
    painter.setPen(outline);
    painter.setBrush(theme.raised);
    const QPointF centre(kWidth_px / 2.0, kHeight_px / 2.0);
    painter.drawRoundedRect(QRectF(centre.x() - 14.0, centre.y() - 5.0, 28.0, 10.0), 5.0, 5.0);
    painter.setBrush(theme.accent);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(centre - QPointF(9.0, 0.0), 2.0, 2.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(arrow);
    paintArc(painter, centre, 18.0, 30.0, 150.0);
    return;
  }
  painter.setPen(QPen(theme.line, 1.5));
  painter.drawLine(QPointF(4.0, kSkin_px + 2.0), QPointF(kWidth_px - 4.0, kSkin_px + 2.0));
  const QPainterPath probe = probeOf(motion_ == ProbeMotion::tilt ? 4.0 : 11.0);
  const auto paintProbe = [&](double x_px, double lean_deg, bool isGhost) {
    painter.save();
    painter.translate(foot + QPointF(x_px, 0.0));
    painter.rotate(lean_deg);
    painter.setPen(isGhost ? QPen(theme.line, 1.0, Qt::DashLine) : outline);
    painter.setBrush(isGhost ? QBrush(Qt::NoBrush) : QBrush(theme.raised));
    painter.drawPath(probe);
    painter.restore();
  };
  if (motion_ == ProbeMotion::slide) {
    paintProbe(0.0, 0.0, false);
    painter.setPen(arrow);
    const double y = kSkin_px - 14.0;
    for (const double side : {-1.0, 1.0}) {
      const QPointF tip = foot + QPointF(side * 27.0, y - foot.y());
      painter.drawLine(foot + QPointF(side * 14.0, y - foot.y()), tip);
      paintHead(painter, tip, side > 0.0 ? 0.0 : M_PI);
    }
    return;
  }
  paintProbe(0.0, -24.0, true);
  paintProbe(0.0, 24.0, true);
  paintProbe(0.0, 0.0, false);
  painter.setPen(arrow);
  painter.setBrush(Qt::NoBrush);
  paintArc(painter, foot, 33.0, 62.0, 118.0);
}

}  // namespace ew::ui
