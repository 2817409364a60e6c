#include "cost_chart.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ew/imaging/cost_of_accuracy.h"
#include "figures.h"
#include "theme.h"

namespace ew::ui {
namespace {

constexpr int kChartLeft_px = 56;
constexpr int kChartRight_px = 56;
constexpr int kChartTop_px = 32;
constexpr int kChartBottom_px = 48;

/// A step of the 1-2-5 series so that about `count` of them fill the range.
double niceStep(double range, int count) {
  const double rough = std::max(range / count, 1e-6);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

CostChart::CostChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("costChart"));
  setAccessibleName(tr("Accuracy over time"));
}

void CostChart::show(std::vector<Point> points, double wished_db, const QString& empty) {
  points_ = std::move(points);
  wished_db_ = wished_db;
  empty_ = empty;
  QStringList spoken;
  for (const Point& point : points_) {
    spoken << tr("%1: %2 ms, %3 dB").arg(point.name).arg(figure(point.frame_ms, 2)).arg(figure(point.psnr_db, 1));
  }
  setAccessibleDescription(spoken.join(QStringLiteral("; ")));
  update();
}

void CostChart::paintEvent(QPaintEvent*) {
  const Theme& theme = currentTheme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.ground);
  painter.drawRoundedRect(rect(), 6, 6);
  painter.setBrush(Qt::NoBrush);
  if (points_.empty()) {
    painter.setFont(textFont());
    painter.setPen(theme.quiet);
    painter.drawText(rect().adjusted(40, 24, -40, -24), Qt::AlignCenter | Qt::TextWordWrap, empty_);
    return;
  }
  const QRectF box(kChartLeft_px, kChartTop_px, width() - kChartLeft_px - kChartRight_px, height() - kChartTop_px - kChartBottom_px);
  double slowest_ms = 0.0, lowest_db = wished_db_, highest_db = wished_db_;
  for (const Point& point : points_) {
    slowest_ms = std::max(slowest_ms, point.frame_ms);
    lowest_db = std::min(lowest_db, point.psnr_db);
    if (point.psnr_db < CostOfAccuracy::kExact_db) highest_db = std::max(highest_db, point.psnr_db);
  }
  const double step_ms = niceStep(slowest_ms * 1.15, 5);
  const double most_ms = step_ms * std::ceil(slowest_ms * 1.15 / step_ms);
  constexpr double kStep_db = 5.0;
  const double bottom_db = kStep_db * std::floor((lowest_db - 2.0) / kStep_db);
  const double top_db = kStep_db * std::ceil((highest_db + 4.0) / kStep_db);
  const auto xOf = [&](double ms) { return box.left() + box.width() * ms / most_ms; };
  const auto yOf = [&](double db) { return box.bottom() - box.height() * (std::min(db, top_db) - bottom_db) / (top_db - bottom_db); };

  painter.setFont(smallFont());
  for (double ms = 0.0; ms <= most_ms + 1e-9; ms += step_ms) {
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(xOf(ms), box.top()), QPointF(xOf(ms), box.bottom()));
    painter.setPen(theme.quiet);
    drawFigures(painter, QRect(static_cast<int>(xOf(ms)) - 30, static_cast<int>(box.bottom()) + 4, 60, 18), Qt::AlignHCenter,
                QString::number(ms, 'g', 3));
  }
  const double labelled_db = top_db - bottom_db > 40.0 ? 2.0 * kStep_db : kStep_db;
  for (double db = bottom_db; db <= top_db + 1e-9; db += labelled_db) {
    const int y = static_cast<int>(std::lround(yOf(db)));
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(box.left(), yOf(db)), QPointF(box.right(), yOf(db)));
    painter.setPen(theme.quiet);
    drawFigures(painter, QRect(4, y - 9, kChartLeft_px - 12, 18), Qt::AlignRight, QString::number(db, 'f', 0));
    const double grey = 255.0 * std::pow(10.0, -db / 20.0);
    drawFigures(painter, QRect(static_cast<int>(box.right()) + 8, y - 9, kChartRight_px - 12, 18), Qt::AlignLeft,
                QString::number(grey, 'f', grey < 10.0 ? (grey < 1.0 ? 2 : 1) : 0));
  }
  painter.setPen(theme.quiet);
  painter.drawText(QRectF(8, 4, width() / 2.0 - 8, 20), Qt::AlignLeft | Qt::AlignVCenter, tr("PSNR, dB"));
  painter.drawText(QRectF(width() / 2.0, 4, width() / 2.0 - 8, 20), Qt::AlignRight | Qt::AlignVCenter, tr("RMS error, grey levels"));
  painter.drawText(QRectF(box.left(), box.bottom() + 24, box.width(), 20), Qt::AlignCenter, tr("time of a whole frame, ms"));

  // The accuracy that is asked for: what lies above it will do.
  painter.setPen(QPen(theme.text, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(box.left(), yOf(wished_db_)), QPointF(box.right(), yOf(wished_db_)));

  QPainterPath curve;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF at(xOf(points_[i].frame_ms), yOf(points_[i].psnr_db));
    if (i == 0) {
      curve.moveTo(at);
    } else {
      curve.lineTo(at);
    }
  }
  QColor faint = theme.accent;
  faint.setAlpha(110);
  painter.setPen(QPen(faint, 1.5));
  painter.drawPath(curve);
  std::vector<QRectF> taken;
  for (const Point& point : points_) {
    const QPointF at(xOf(point.frame_ms), yOf(point.psnr_db));
    painter.setPen(QPen(theme.accent, 2.0));
    painter.setBrush(point.meetsWish ? theme.accent : theme.ground);
    painter.drawEllipse(at, 4.5, 4.5);
    painter.setBrush(Qt::NoBrush);
    if (point.inUse) painter.drawEllipse(at, 9.0, 9.0);
    QString text = point.name + QStringLiteral("  ") + tr("%1 ms").arg(figure(point.frame_ms, 2));
    if (point.inUse) text += QStringLiteral("  ") + tr("in use");
    const double wide = figuresWidth_px(painter.fontMetrics(), text);
    const double x = at.x() + 14.0 + wide > width() - 4.0 ? at.x() - 14.0 - wide : at.x() + 14.0;
    QRectF label(x, std::max(at.y() - 20.0, box.top() + 2.0), wide, 18.0);
    // Points may lie close together; their labels step aside.
    while (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(label); }))
      label.translate(0.0, 18.0);
    taken.push_back(label);
    painter.fillRect(label.adjusted(-4.0, 0.0, 4.0, 0.0), theme.ground);  // lines must not strike it through
    painter.setPen(point.inUse ? theme.text : theme.quiet);
    drawFigures(painter, label.toRect(), Qt::AlignLeft, text);
  }
}

}  // namespace ew::ui
