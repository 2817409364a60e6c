#include <algorithm>
#include <cmath>

#include "ew/core/chart_axis.h"
#include "ew/core/figures.h"
#include "ew/reports/distribution.h"
#include "ew/reports/report_document.h"
#include "plot_canvas.h"
#include "report_numbers.h"

namespace ew::reports {
namespace {

constexpr double kLeft = 12.0, kRight = 16.0, kRow = 46.0;
constexpr std::size_t kMostDots = 60;
constexpr int kHighestDot = 7;
constexpr double kDotRadius = 3.0;
constexpr std::size_t kStripParts = 40;

/// Where values are drawn across an image, with its ticks below.
struct Across {
  ChartAxis axis;
  bool isShare = false;
  double left = kLeft + 6.0, right = kPlotWidth - kRight - 6.0;
  [[nodiscard]] double x(double value) const { return axis.at(value, left, right); }
};

Across shareAxis() { return {linearAxis(std::vector<double>{0.0, 1.0}, {.steps = 5}), true}; }

void drawAxis(PlotCanvas& canvas, const Across& across, const Message& name, double top, double bottom) {
  for (const ChartTick& tick : across.axis.ticks) {
    const double x = across.x(tick.value);
    canvas.line(x, top, x, bottom, canvas.colours.line);
    const Message label = across.isShare ? percentText(tick.value) : numeral(fixedText(tick.value, tick.decimals));
    canvas.text(x, bottom + 16.0, Anchor::middle, label, true);
  }
  if (!name.empty()) canvas.text(0.5 * (across.left + across.right), bottom + 34.0, Anchor::middle, name, true);
}

double heightBelowAxis(const Message& name) { return name.empty() ? 24.0 : 42.0; }

/// A level that has to be reached: a dark line across with a foot, told from the grid by its width.
void drawLevel(PlotCanvas& canvas, double x, double top, double bottom) {
  canvas.line(x, top, x, bottom, canvas.colours.text, 2.0, {5.0, 3.0});
}

void drawHistogram(PlotCanvas& canvas, const std::vector<std::size_t>& counts, double left, double right, double top, double bottom) {
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  const double width = (right - left) / static_cast<double>(counts.size());
  for (std::size_t n = 0; n < counts.size(); ++n) {
    if (counts[n] == 0) continue;
    const double height = (bottom - top) * static_cast<double>(counts[n]) / static_cast<double>(most);
    canvas.rectangle(left + width * static_cast<double>(n) + 1.0, bottom - height, width - 2.0, height, canvas.colours.own);
  }
}

/// A value as a dot: those that would lie on each other stand above each other.
struct Dot {
  double x = 0.0;
  int level = 0;
};
std::vector<Dot> dotsOf(const Across& across, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  std::vector<Dot> dots;
  double foot = 0.0;
  for (const double value : values) {
    const double x = across.x(value);
    const bool isOnTheLast = !dots.empty() && x - foot < 2.0 * kDotRadius;
    if (!isOnTheLast) foot = x;
    dots.push_back({x, isOnTheLast ? dots.back().level + 1 : 0});
  }
  return dots;
}
int highestOf(const std::vector<Dot>& dots) {
  int highest = 0;
  for (const Dot& dot : dots) highest = std::max(highest, dot.level);
  return highest;
}
void drawDots(PlotCanvas& canvas, const std::vector<Dot>& dots, double top, double bottom) {
  const double apart = std::min(5.0, (bottom - top - 2.0 * kDotRadius) / std::max(1, highestOf(dots)));
  for (const Dot& dot : dots) canvas.circle(dot.x, bottom - kDotRadius - dot.level * apart, kDotRadius, canvas.colours.own);
}

void drawBox(PlotCanvas& canvas, const Across& across, const FiveNumbers& numbers, double y) {
  const std::string& colour = canvas.colours.text;
  canvas.line(across.x(numbers.lowest), y, across.x(numbers.highest), y, colour, 1.2);
  const double left = across.x(numbers.lowerQuartile), right = across.x(numbers.upperQuartile);
  canvas.rectangle(left, y - 4.0, right - left, 8.0, colour, false);
  canvas.line(across.x(numbers.median), y - 6.0, across.x(numbers.median), y + 6.0, colour, 3.0);
}

Across axisOf(const StripPlot& plot) {
  if (plot.isShare) return shareAxis();
  std::vector<double> all;
  for (const StripPlot::Row& row : plot.rows) {
    all.insert(all.end(), row.values.begin(), row.values.end());
    if (row.level) all.push_back(*row.level);
    if (row.reference) all.push_back(*row.reference);
  }
  return {linearAxis(all, {.steps = 5})};
}

}  // namespace

double draw(PlotCanvas& canvas, const BarsPlot& plot) {
  const Across across = shareAxis();
  const double bottom = kRow * static_cast<double>(plot.bars.size()) + 6.0;
  drawAxis(canvas, across, {}, 2.0, bottom);
  double y = 2.0;
  for (const BarsPlot::Bar& bar : plot.bars) {
    const double end = across.right - widthOf(canvas.words(bar.says));
    canvas.fitted(across.left, y + 14.0, end - 8.0, bar.label);
    canvas.text(across.right, y + 14.0, Anchor::end, bar.says);
    canvas.rectangle(across.left, y + 21.0, across.x(std::clamp(bar.value, 0.0, 1.0)) - across.left, 13.0, canvas.colours.own,
                     bar.isReached);
    if (bar.level) drawLevel(canvas, across.x(*bar.level), y + 18.0, y + 37.0);
    y += kRow;
  }
  return bottom + heightBelowAxis({});
}

double draw(PlotCanvas& canvas, const HistogramPlot& plot) {
  constexpr double kBottom = 140.0, kTop = 22.0;
  Across across = shareAxis();
  if (!plot.isShare) across = {linearAxis(std::vector<double>{plot.low, plot.high}, {.steps = 5})};
  drawAxis(canvas, across, plot.axis, kTop, kBottom);
  if (!plot.counts.empty()) drawHistogram(canvas, plot.counts, across.x(plot.low), across.x(plot.high), kTop, kBottom);
  if (plot.level) drawLevel(canvas, across.x(*plot.level), kTop, kBottom);
  const std::size_t most = plot.counts.empty() ? 0 : *std::max_element(plot.counts.begin(), plot.counts.end());
  canvas.text(across.left + 2.0, kTop - 8.0, Anchor::start, say<"highest bar: %1">(most), true);
  return kBottom + heightBelowAxis(plot.axis);
}

double draw(PlotCanvas& canvas, const StripPlot& plot) {
  constexpr double kStrip = 62.0;
  const Across across = axisOf(plot);
  const double bottom = kStrip * static_cast<double>(plot.rows.size()) + 4.0;
  drawAxis(canvas, across, plot.axis, 2.0, bottom);
  double y = 2.0;
  for (const StripPlot::Row& row : plot.rows) {
    const FiveNumbers numbers = fiveNumbersOf(row.values);
    canvas.fitted(across.left, y + 13.0, across.right, row.label);
    const auto dots = dotsOf(across, row.values);
    if (numbers.count > kMostDots || highestOf(dots) > kHighestDot) {
      const auto counts = countsIn(row.values, across.axis.low, across.axis.high, kStripParts);
      drawHistogram(canvas, counts, across.left, across.right, y + 18.0, y + 42.0);
    } else {
      drawDots(canvas, dots, y + 18.0, y + 42.0);
    }
    if (numbers.count > 0) drawBox(canvas, across, numbers, y + 50.0);
    if (row.level) drawLevel(canvas, across.x(*row.level), y + 18.0, y + 58.0);
    if (row.reference) canvas.line(across.x(*row.reference), y + 18.0, across.x(*row.reference), y + 58.0, canvas.colours.reference, 3.0);
    y += kStrip;
  }
  return bottom + heightBelowAxis(plot.axis);
}

}  // namespace ew::reports
