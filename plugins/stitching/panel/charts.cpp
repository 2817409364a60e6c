#include "panel/charts.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ew/widgets/chart_card.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

using registration::ElasticEffort;

/// The shared card, in type for a low chart.
void paintCard(QPainter& painter, const QWidget& on) {
  paintChartCard(painter, on);
  QFont font = painter.font();
  font.setPixelSize(scaled(11));
  painter.setFont(font);
}

constexpr LinearAxisOptions kFewSteps{.steps = 3};  // labels of a low chart

}  // namespace

LevelChart::LevelPlot::LevelPlot(const Levels& levels, const QRectF& in) : box(in), last(static_cast<double>(levels.size()) - 1.0) {
  std::vector<double> correlations{0.0, 0.1};
  for (const auto& level : levels) {
    correlations.push_back(level.correlationBefore);
    correlations.push_back(level.correlationAfter);
  }
  correlation = linearAxis(correlations, kFewSteps);
}

QPointF LevelChart::LevelPlot::at(double level, double value) const {
  const double share = last > 0.0 ? level / last : 0.5;
  return {box.left() + share * box.width(), correlation.at(value, box.bottom(), box.top())};
}

LevelChart::LevelChart(StitchSession& session, QWidget* parent) : QWidget(parent), look_(session.look()), runs_(session.runs()) {
  setObjectName(QStringLiteral("levelChart"));
  const auto look = [this] {
    const bool nothing = runs_.levels(look_.pair()).empty() && runs_.warpLevels(look_.pair()).empty();
    setFixedHeight(scaled(nothing ? 48 : 104));  // a chart of nothing takes no room from what can be done about it
    update();
  };
  connect(&session, &StitchSession::levelsChanged, this, look);
  connect(&session, &StitchSession::changed, this, look);
  look();
}

void LevelChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintCard(painter, *this);
  auto levels = runs_.levels(look_.pair());
  const std::size_t matched = levels.size();
  for (const auto& level : runs_.warpLevels(look_.pair())) levels.push_back(level);
  if (levels.empty())
    return paintEmptyChart(painter, *this,
                           runs_.isRunning() ? tr("The curve grows while the pair is matched") : tr("No levels yet: match the pair"));
  const LevelPlot plot(levels, QRectF(rect()).adjusted(36, 16, -16, -24));
  paintGrid(painter, plot);
  // Matching and bending measure correlation on other images: two curves side by side, not one.
  if (matched > 0 && matched < levels.size()) paintDivide(painter, plot, matched);
  paintSteps(painter, plot, levels);
  paintCurve(painter, plot, levels, 0, matched);
  paintCurve(painter, plot, levels, matched, levels.size());
}

void LevelChart::paintGrid(QPainter& painter, const LevelPlot& plot) const {
  for (const ChartTick& tick : plot.correlation.ticks) {
    const double y = plot.at(0, tick.value).y();
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawLine(QPointF(plot.box.left(), y), QPointF(plot.box.right(), y));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(0, y - 8, 32, 16), Qt::AlignRight | Qt::AlignVCenter, figure(tick.value, tick.decimals));
  }
}

void LevelChart::paintDivide(QPainter& painter, const LevelPlot& plot, std::size_t matched) const {
  const double x = plot.at(static_cast<double>(matched) - 0.5, 0).x();
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DashLine));
  painter.drawLine(QPointF(x, plot.box.top() - 6), QPointF(x, plot.box.bottom() + 4));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(x - 100, 0, 95, 14), Qt::AlignRight | Qt::AlignVCenter, tr("matched"));
  painter.drawText(QRectF(x + 5, 0, 95, 14), Qt::AlignLeft | Qt::AlignVCenter, tr("deformed"));
}

/// From hollow to full: what each level began with, and what it made of it; below, how fine it is.
void LevelChart::paintSteps(QPainter& painter, const LevelPlot& plot, const Levels& levels) const {
  double free = -1e9;
  painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0));
  painter.setBrush(Qt::NoBrush);
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const QPointF before = plot.at(static_cast<double>(n), levels[n].correlationBefore);
    const QPointF after = plot.at(static_cast<double>(n), levels[n].correlationAfter);
    painter.drawLine(before, after);
    painter.drawEllipse(before, 2.5, 2.5);
    // The unit once, at the end: with it at each, the last one found no room beside its neighbour.
    QString word = QLocale().toString(levels[n].voxel_mm, 'g', 2);
    if (n + 1 == levels.size()) word += QStringLiteral(" mm");
    const double wide = painter.fontMetrics().horizontalAdvance(word);
    const double left = std::clamp(after.x() - wide / 2, 4.0, width() - wide - 4.0);
    if (left > free + 6) {
      painter.drawText(QPointF(left, height() - 8.0), word);
      free = left + wide;
    }
  }
}

void LevelChart::paintCurve(QPainter& painter, const LevelPlot& plot, const Levels& levels, std::size_t begin, std::size_t end) const {
  QPolygonF curve;
  for (std::size_t n = begin; n < end; ++n) curve << plot.at(static_cast<double>(n), levels[n].correlationAfter);
  const QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(QPen(accent, 2.0));
  painter.drawPolyline(curve);
  painter.setBrush(accent);
  painter.setPen(Qt::NoPen);
  for (const QPointF& point : curve) painter.drawEllipse(point, 3.5, 3.5);
}

CostChart::CostChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("costChart"));
  setMinimumHeight(112);
}

void CostChart::show(const std::array<CostEstimate, 3>& costs, ElasticEffort inUse, std::optional<double> measured_s) {
  costs_ = costs;
  inUse_ = inUse;
  measured_s_ = measured_s;
  std::vector<double> times_s{0.0, measured_s.value_or(0.0)}, errors_mm{0.0};
  for (const CostEstimate& cost : costs) {
    times_s.push_back(cost.seconds);
    errors_mm.push_back(cost.error_mm);
  }
  time_s_ = linearAxis(times_s, kFewSteps);
  error_mm_ = linearAxis(errors_mm, kFewSteps);
  QStringList lines;
  for (const CostEstimate& cost : costs)
    lines << tr("%1: %2 mm in %3").arg(nameOfEffort(cost.effort), figure(cost.error_mm, 2), inSeconds(cost.seconds));
  setAccessibleDescription(lines.join(QStringLiteral("; ")));
  update();
}

void CostChart::clear() {
  costs_.reset();
  update();
}

QRectF CostChart::box() const { return QRectF(rect()).adjusted(40, 26, -24, -24); }

QPointF CostChart::at(double seconds, double error_mm) const {
  const QRectF in = box();
  return {time_s_.at(seconds, in.left(), in.right()), error_mm_.at(error_mm, in.bottom(), in.top())};
}

QPointF CostChart::pointOfEffort(int effort) const {
  if (!costs_ || effort < 0 || effort > 2) return {-1, -1};
  const CostEstimate& cost = (*costs_)[static_cast<std::size_t>(effort)];
  return at(cost.seconds, cost.error_mm);
}

int CostChart::under(const QPointF& place) const {
  int found = -1;
  double nearest = 14.0;
  for (int effort = 0; costs_ && effort < 3; ++effort) {
    const QPointF off = pointOfEffort(effort) - place;
    if (const double apart = std::hypot(off.x(), off.y()); apart < nearest) {
      nearest = apart;
      found = effort;
    }
  }
  return found;
}

void CostChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintCard(painter, *this);
  if (!costs_) return paintEmptyChart(painter, *this, tr("Known once both volumes are read"));
  const QColor quiet = palette().color(QPalette::PlaceholderText);
  const QRectF in = box();
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
  painter.drawLine(in.bottomLeft(), in.bottomRight());
  painter.drawLine(in.topLeft(), in.bottomLeft());
  painter.setPen(quiet);
  painter.drawText(QRectF(4, 2, 32, 16), Qt::AlignRight | Qt::AlignVCenter, tr("mm"));
  for (const ChartTick& tick : error_mm_.ticks)
    painter.drawText(QRectF(0, at(0, tick.value).y() - 8, 36, 16), Qt::AlignRight | Qt::AlignVCenter, figure(tick.value, tick.decimals));
  for (const ChartTick& tick : time_s_.ticks) {
    const QString word = tick.value > 0.0 ? inSeconds(tick.value) : QStringLiteral("0");
    const double wide = painter.fontMetrics().horizontalAdvance(word);
    const double left = std::min(at(tick.value, 0).x() - wide / 2, width() - wide - 4.0);
    painter.drawText(QRectF(left, in.bottom() + 4, wide, 16), Qt::AlignLeft | Qt::AlignVCenter, word);
  }
  QPolygonF curve;
  for (int effort = 0; effort < 3; ++effort) curve << pointOfEffort(effort);
  painter.setPen(QPen(quiet, 1.5));
  painter.drawPolyline(curve);
  const QColor accent = palette().color(QPalette::Highlight);
  for (const CostEstimate& cost : *costs_) {
    const QPointF point = at(cost.seconds, cost.error_mm);
    const bool used = cost.effort == inUse_;
    painter.setPen(Qt::NoPen);
    painter.setBrush(used ? accent : quiet);
    painter.drawEllipse(point, used ? 5.0 : 3.5, used ? 5.0 : 3.5);
    if (!used) continue;
    const QString word = tr("in use: %1 mm, %2").arg(figure(cost.error_mm, 2), inSeconds(cost.seconds));
    painter.setPen(accent);  // above the curve, where no point can lie
    painter.drawText(QRectF(40, 2, width() - 48.0, 16), Qt::AlignRight | Qt::AlignVCenter, word);
  }
  if (measured_s_) {  // how long it was in truth, on the foot of the chart: the error in truth nobody knows
    const QPointF foot = at(*measured_s_, 0.0);
    painter.setPen(QPen(accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(QPolygonF({foot + QPointF(0, -5), foot + QPointF(4, 0), foot + QPointF(0, 5), foot + QPointF(-4, 0)}));
  }
}

void CostChart::mousePressEvent(QMouseEvent* event) {
  const int effort = under(event->localPos());
  if (event->button() == Qt::LeftButton && effort >= 0) Q_EMIT chosen(effort);
}

bool CostChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && costs_) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int effort = under(help->pos());
    if (effort >= 0) {
      const CostEstimate& cost = (*costs_)[static_cast<std::size_t>(effort)];
      QToolTip::showText(help->globalPos(), tr("%1: %2 mm on average, 95 % below %3 mm, in %4. Click to deform this pair so.")
                                                .arg(nameOfEffort(cost.effort), figure(cost.error_mm, 2), figure(cost.error95_mm, 2),
                                                     inSeconds(cost.seconds)));
      return true;
    }
  }
  return QWidget::event(event);
}

QString nameOfEffort(ElasticEffort effort) {
  switch (effort) {
    case ElasticEffort::fast:
      return CostChart::tr("fast");
    case ElasticEffort::balanced:
      return CostChart::tr("balanced");
    case ElasticEffort::accurate:
      return CostChart::tr("accurate");
  }
  return {};
}

}  // namespace ew::stitching
