#include "scan/cost/cost_chart.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ew/core/chart_axis.h"
#include "ew/widgets/chart_card.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

// Around the curve, for words.
int chartSide_px() { return 12 + scaled(44); }
int chartTop_px() { return 12 + scaled(20); }
int chartBottom_px() { return 10 + scaled(38); }

/// Where values are drawn, while one image of the chart is painted.
struct Plot {
  QRectF box;
  ChartAxis time_ms;
  ChartAxis accuracy_db;

  [[nodiscard]] double x(double ms) const { return time_ms.at(ms, box.left(), box.right()); }
  /// What is exact, and so beyond every axis, lies at the upper edge.
  [[nodiscard]] double y(double db) const { return accuracy_db.at(std::min(db, accuracy_db.high), box.bottom(), box.top()); }
  [[nodiscard]] QPointF at(const CostChart::Point& point) const { return {x(point.frame_ms), y(point.psnr_db)}; }
};

Plot plotOf(const std::vector<CostChart::Point>& points, double wished_db, const QSize& size) {
  constexpr double kRoomForNames = 1.15;
  std::vector<double> times_ms{0.0}, accuracies_db{wished_db};
  for (const CostChart::Point& point : points) {
    times_ms.push_back(kRoomForNames * point.frame_ms);
    if (point.psnr_db < CostOfAccuracy::kExact_db) accuracies_db.push_back(point.psnr_db);
  }
  return {QRectF(chartSide_px(), chartTop_px(), size.width() - 2 * chartSide_px(), size.height() - chartTop_px() - chartBottom_px()),
          linearAxis(times_ms, {.steps = 5}), linearAxis(accuracies_db, {.steps = 8, .smallestStep = 5.0, .below = 0.4, .above = 0.8})};
}

void paintGrid(QPainter& painter, const Plot& plot, const Theme& theme) {
  for (const ChartTick& tick : plot.time_ms.ticks) {
    const double x = plot.x(tick.value);
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(x, plot.box.top()), QPointF(x, plot.box.bottom()));
    painter.setPen(theme.quiet);
    drawFigures(painter, QRect(static_cast<int>(x) - 30, static_cast<int>(plot.box.bottom()) + 4, 60, scaled(18)), Qt::AlignHCenter,
                figure(tick.value, tick.decimals));
  }
  for (const ChartTick& tick : plot.accuracy_db.ticks) {
    const double y = plot.y(tick.value);
    const int middle = static_cast<int>(std::lround(y));
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(plot.box.left(), y), QPointF(plot.box.right(), y));
    painter.setPen(theme.quiet);
    drawFigures(painter, QRect(4, middle - 9, chartSide_px() - 12, 18), Qt::AlignRight, figure(tick.value, tick.decimals));
    const double grey = 255.0 * std::pow(10.0, -tick.value / 20.0);
    drawFigures(painter, QRect(static_cast<int>(plot.box.right()) + 8, middle - 9, chartSide_px() - 12, 18), Qt::AlignLeft,
                figure(grey, grey < 1.0    ? 2
                             : grey < 10.0 ? 1
                                           : 0));
  }
}

void paintTitles(QPainter& painter, const Plot& plot, int width, const Theme& theme) {
  painter.setPen(theme.quiet);
  painter.drawText(QRectF(8, 4, width / 2.0 - 8, scaled(20)), Qt::AlignLeft | Qt::AlignVCenter, CostChart::tr("PSNR, dB"));
  painter.drawText(QRectF(width / 2.0, 4, width / 2.0 - 8, scaled(20)), Qt::AlignRight | Qt::AlignVCenter,
                   CostChart::tr("RMS error, grey levels"));
  painter.drawText(QRectF(plot.box.left(), plot.box.bottom() + 6 + scaled(18), plot.box.width(), scaled(20)), Qt::AlignCenter,
                   CostChart::tr("time of a whole frame, ms"));
}

void paintCurve(QPainter& painter, const Plot& plot, const std::vector<CostChart::Point>& points, const Theme& theme) {
  QPolygonF curve;
  for (const CostChart::Point& point : points) curve << plot.at(point);
  QColor faint = theme.accent;
  faint.setAlpha(110);
  painter.setPen(QPen(faint, 1.5));
  painter.drawPolyline(curve);
}

/// Marks with their names. Points may lie close together; their names step aside.
void paintPoints(QPainter& painter, const Plot& plot, const std::vector<CostChart::Point>& points, int width, const Theme& theme) {
  std::vector<QRectF> taken;
  for (const CostChart::Point& point : points) {
    const QPointF at = plot.at(point);
    painter.setPen(QPen(theme.accent, 2.0));
    painter.setBrush(point.meetsWish ? theme.accent : theme.ground);
    painter.drawEllipse(at, 4.5, 4.5);
    painter.setBrush(Qt::NoBrush);
    if (point.inUse) painter.drawEllipse(at, 9.0, 9.0);
    QString text = point.name + QStringLiteral("  ") + CostChart::tr("%1 ms").arg(figure(point.frame_ms, 2));
    if (point.inUse) text += QStringLiteral("  ") + CostChart::tr("in use");
    const double wide = figuresWidth_px(painter.fontMetrics(), text);
    const double x = at.x() + 14.0 + wide > width - 4.0 ? at.x() - 14.0 - wide : at.x() + 14.0;
    QRectF label(x, std::max(at.y() - 2.0 - scaled(18.0), plot.box.top() + 2.0), wide, scaled(18.0));
    while (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(label); }))
      label.translate(0.0, scaled(18.0));
    taken.push_back(label);
    painter.fillRect(label.adjusted(-4.0, 0.0, 4.0, 0.0), theme.ground);  // lines must not strike it through
    painter.setPen(point.inUse ? theme.text : theme.quiet);
    drawFigures(painter, label.toRect(), Qt::AlignLeft, text);
  }
}

}  // namespace

CostChart::CostChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("costChart"));
  setLayoutDirection(Qt::LeftToRight);  // time and accuracy grow where they do on every chart
  setAccessibleName(tr("Accuracy over time"));
}

QSize CostChart::sizeHint() const { return {scaled(560) + 80, scaled(240) + 80}; }

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
  paintChartCard(painter, *this);
  if (points_.empty()) {
    painter.setFont(textFont());
    return paintEmptyChart(painter, *this, empty_);
  }
  const Plot plot = plotOf(points_, wished_db_, size());
  paintGrid(painter, plot, theme);
  paintTitles(painter, plot, width(), theme);
  // The accuracy that is asked for: what lies above it will do.
  painter.setPen(QPen(theme.text, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(plot.box.left(), plot.y(wished_db_)), QPointF(plot.box.right(), plot.y(wished_db_)));
  paintCurve(painter, plot, points_, theme);
  paintPoints(painter, plot, points_, width(), theme);
}

}  // namespace ew::ui
