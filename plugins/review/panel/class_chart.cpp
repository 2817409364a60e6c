#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "ew/core/chart_axis.h"
#include "ew/widgets/chart_card.h"
#include "ew/widgets/theme.h"
#include "panel/class_page.h"
#include "panel/review_words.h"

namespace ew::review {

namespace {

constexpr int kBins = 10;

}  // namespace

DistributionChart::DistributionChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("classChart"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize DistributionChart::sizeHint() const { return {45 * kGrid_px, scaled(190)}; }
QSize DistributionChart::minimumSizeHint() const { return {25 * kGrid_px, scaled(150)}; }

void DistributionChart::show(const Distribution& values, const QString& unit, double lowest, double highest, std::optional<double> level) {
  values_ = values;
  unit_ = unit;
  lowest_ = lowest;
  highest_ = std::max(highest, lowest + 1e-9);
  level_ = level;
  const QLocale locale;
  setAccessibleName(values.values.empty() ? tr("No values")
                                          : tr("%1 values from %2 to %3, median %4")
                                                .arg(values.values.size())
                                                .arg(locale.toString(values.lowest, 'g', 3), locale.toString(values.highest, 'g', 3),
                                                     locale.toString(values.median, 'g', 3)));
  update();
}

double DistributionChart::xOf(double value, const QRectF& box) const {
  return box.left() + (value - lowest_) / (highest_ - lowest_) * box.width();
}

void DistributionChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintChartCard(painter, *this);
  if (values_.values.empty()) return paintEmptyChart(painter, *this, tr("Nobody has a value here yet"));
  const double words = scaled(20);
  const QRectF box(4 * kGrid_px, 2 * kGrid_px, width() - 6.0 * kGrid_px, height() - 2.0 * kGrid_px - words - 4.0);
  const double boxHigh = scaled(28);
  paintBars(painter, box.adjusted(0, 0, 0, -boxHigh - kGrid_px));
  paintBox(painter, QRectF(box.left(), box.bottom() - boxHigh, box.width(), boxHigh));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const ChartAxis axis = linearAxis(std::vector<double>{lowest_, highest_}, {.steps = 4});
  for (const ChartTick& tick : axis.ticks) {
    if (tick.value < lowest_ - 1e-9 || tick.value > highest_ + 1e-9) continue;
    const bool isLast = &tick == &axis.ticks.back() || (&tick)[1].value > highest_ + 1e-9;
    const double x = xOf(tick.value, box);
    painter.drawLine(QPointF(x, box.bottom() + 2), QPointF(x, box.bottom() + 5));
    painter.drawText(QRectF(x - 40, box.bottom() + 5, 80, words), Qt::AlignHCenter | Qt::AlignTop,
                     QLocale().toString(tick.value, 'f', tick.decimals) + (isLast ? QLatin1Char(' ') + unit_ : QString()));
  }
  if (!level_ || *level_ < lowest_ || *level_ > highest_) return;
  const double x = xOf(*level_, box);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5, Qt::DashLine));
  painter.drawLine(QPointF(x, box.top() - 4), QPointF(x, box.bottom()));
  const QString word = tr("pass level");
  const double wide = painter.fontMetrics().horizontalAdvance(word) + 8.0;
  const bool isLeft = x + wide > width();
  painter.drawText(QRectF(isLeft ? x - wide : x + 4, box.top() - 2 * kGrid_px, wide, 2 * kGrid_px),
                   (isLeft ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, word);
}

void DistributionChart::paintBars(QPainter& painter, const QRectF& box) const {
  const auto counts = histogramOf(values_.values, lowest_, highest_, kBins);
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  const double wide = box.width() / kBins;
  for (int n = 0; n < kBins; ++n) {
    const std::size_t count = counts[static_cast<std::size_t>(n)];
    if (count == 0) continue;
    const double high = box.height() * static_cast<double>(count) / static_cast<double>(most);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(Who::trainee, currentTheme().dark));
    const QRectF bar(box.left() + n * wide + 1.0, box.bottom() - high, wide - 2.0, high);
    painter.drawRect(bar);
    painter.setPen(palette().color(QPalette::WindowText));
    const bool fits = high > painter.fontMetrics().height();
    painter.setPen(palette().color(fits ? QPalette::Base : QPalette::WindowText));
    painter.drawText(fits ? bar.adjusted(0, 1, 0, 0) : bar.translated(0, -painter.fontMetrics().height()),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextDontClip, QString::number(count));
  }
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(box.bottomLeft(), box.bottomRight());
}

void DistributionChart::paintBox(QPainter& painter, const QRectF& box) const {
  const double middle = box.center().y();
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1.2));
  painter.setBrush(palette().color(QPalette::Button));
  painter.drawLine(QPointF(xOf(values_.lowest, box), middle), QPointF(xOf(values_.highest, box), middle));
  for (const double end : {values_.lowest, values_.highest})
    painter.drawLine(QPointF(xOf(end, box), middle - 4), QPointF(xOf(end, box), middle + 4));
  const double left = xOf(values_.lowerQuartile, box), right = xOf(values_.upperQuartile, box);
  painter.drawRect(QRectF(left, box.top() + 4, std::max(1.0, right - left), box.height() - 8));
  painter.setPen(QPen(palette().color(QPalette::WindowText), 2.5));
  const double median = xOf(values_.median, box);
  painter.drawLine(QPointF(median, box.top() + 4), QPointF(median, box.bottom() - 4));
}

}  // namespace ew::review
