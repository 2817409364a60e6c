#include <algorithm>
#include <array>
#include <limits>

#include "ew/core/chart_axis.h"
#include "ew/core/figures.h"
#include "plot_canvas.h"
#include "report_numbers.h"

namespace ew::reports {
namespace {

constexpr double kEdge = 18.0;
constexpr double kHighestPath = 300.0;
constexpr Dashes kDashed{6.0, 4.0};

struct Extent {
  glm::dvec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
  void hold(const glm::dvec2& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
};

Extent extentOf(const PathPlot& plot) {
  Extent extent;
  for (const PathPlot::Path& path : plot.paths)
    for (const auto& piece : path.pieces_mm)
      for (const glm::dvec2& point : piece) extent.hold(point);
  return extent;
}

/// From mm of the body to the image, both axes alike.
struct BodyScale {
  BodyScale(const Extent& extent, double top, double bottom) {
    constexpr double kSmallest_mm = 20.0;  // a probe that rests is no image of a tremor
    const glm::dvec2 size = glm::max(extent.high - extent.low, glm::dvec2(kSmallest_mm));
    perMm = std::min((kPlotWidth - 2.0 * kEdge - 30.0) / size.x, (bottom - top) / size.y);
    centre_mm = 0.5 * (extent.low + extent.high);
    centre = {0.5 * kPlotWidth, 0.5 * (top + bottom)};
  }
  [[nodiscard]] glm::dvec2 at(const glm::dvec2& point_mm) const {
    const glm::dvec2 off = (point_mm - centre_mm) * perMm;
    return {centre.x + off.x, centre.y - off.y};
  }
  double perMm = 1.0;
  glm::dvec2 centre_mm{0.0}, centre{0.0};
};

/// Points that are drawn less than a unit apart are one.
std::vector<glm::dvec2> lineThrough(const std::vector<glm::dvec2>& points_mm, const BodyScale& scale) {
  std::vector<glm::dvec2> line;
  for (std::size_t n = 0; n < points_mm.size(); ++n) {
    const glm::dvec2 at = scale.at(points_mm[n]);
    const bool isEnd = n == 0 || n + 1 == points_mm.size();
    if (isEnd || glm::distance(at, line.back()) >= 1.0) line.push_back(at);
  }
  return line;
}

void drawScaleBar(PlotCanvas& canvas, double perMm, double y) {
  constexpr std::array<double, 7> kLengths_mm = {200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0};
  const auto fits = std::find_if(kLengths_mm.begin(), kLengths_mm.end(), [&](double length) { return length * perMm <= 130.0; });
  const double length_mm = fits == kLengths_mm.end() ? kLengths_mm.back() : *fits;
  canvas.line(kEdge, y, kEdge + length_mm * perMm, y, canvas.colours.text, 3.0);
  canvas.text(kEdge + length_mm * perMm + 8.0, y + 4.0, Anchor::start, joined({numeral(fixedText(length_mm, 0)), verbatim("mm")}));
}

void drawPath(PlotCanvas& canvas, const PathPlot::Path& path, const BodyScale& scale) {
  const std::string& colour = path.isReference ? canvas.colours.reference : canvas.colours.own;
  for (const auto& piece : path.pieces_mm) canvas.path(lineThrough(piece, scale), colour, 2.0, path.isReference ? kDashed : Dashes());
  if (path.pieces_mm.empty()) return;
  const glm::dvec2 begin = scale.at(path.pieces_mm.front().front()), end = scale.at(path.pieces_mm.back().back());
  canvas.circle(begin.x, begin.y, 5.0, colour, false);
  canvas.rectangle(end.x - 4.0, end.y - 4.0, 8.0, 8.0, colour);
}

double drawLegend(PlotCanvas& canvas, const PathPlot& plot, double y) {
  for (const PathPlot::Path& path : plot.paths) {
    const std::string& colour = path.isReference ? canvas.colours.reference : canvas.colours.own;
    canvas.line(kEdge, y - 4.0, kEdge + 30.0, y - 4.0, colour, 2.0, path.isReference ? kDashed : Dashes());
    canvas.fitted(kEdge + 38.0, y, kPlotWidth - kEdge, path.label);
    y += 20.0;
  }
  canvas.text(kEdge, y, Anchor::start, say<"Seen from the front; ring: beginning, square: end.">(), true);
  return y + 8.0;
}

}  // namespace

double draw(PlotCanvas& canvas, const PathPlot& plot) {
  const Extent extent = extentOf(plot);
  if (extent.empty()) return drawLegend(canvas, plot, 20.0);
  const glm::dvec2 size = extent.high - extent.low;
  const double wanted = size.x > 0.0 ? size.y / size.x * (kPlotWidth - 2.0 * kEdge - 30.0) : kHighestPath;
  const double top = 34.0, bottom = top + std::clamp(wanted, 120.0, kHighestPath);
  const BodyScale scale(extent, top, bottom);
  canvas.text(0.5 * kPlotWidth, 16.0, Anchor::middle, say<"head">(), true);
  canvas.text(2.0, 0.5 * (top + bottom), Anchor::start, say<"R">(), true);
  canvas.text(kPlotWidth - 2.0, 0.5 * (top + bottom), Anchor::end, say<"L">(), true);
  for (const bool isReference : {true, false})
    for (const PathPlot::Path& path : plot.paths)
      if (path.isReference == isReference) drawPath(canvas, path, scale);
  drawScaleBar(canvas, scale.perMm, bottom + 22.0);
  return drawLegend(canvas, plot, bottom + 46.0);
}

double draw(PlotCanvas& canvas, const TimeLinePlot& plot) {
  constexpr double kRow = 44.0;
  const double bottom = kRow * static_cast<double>(plot.rows.size()) + 4.0;
  const double minutes = plot.end_s / 60.0;
  const bool inMinutes = minutes >= 2.0;
  const ChartAxis axis = linearAxis(std::vector<double>{0.0, inMinutes ? minutes : plot.end_s}, {.steps = 6});
  const auto x = [&](double time_s) { return axis.at(inMinutes ? time_s / 60.0 : time_s, kEdge, kPlotWidth - kEdge); };
  for (const ChartTick& tick : axis.ticks) {
    const double at = axis.at(tick.value, kEdge, kPlotWidth - kEdge);
    canvas.line(at, 2.0, at, bottom, canvas.colours.line);
    canvas.text(at, bottom + 16.0, Anchor::middle, numeral(fixedText(tick.value, tick.decimals)), true);
  }
  double y = 2.0;
  for (const TimeLinePlot::Row& row : plot.rows) {
    canvas.fitted(kEdge, y + 13.0, kPlotWidth - kEdge, row.label);
    for (const TimeLinePlot::Span& span : row.spans)
      canvas.rectangle(x(span.begin_s), y + 19.0, std::max(2.0, x(span.end_s) - x(span.begin_s)), 14.0, canvas.colours.own, span.isFilled);
    y += kRow;
  }
  canvas.text(0.5 * kPlotWidth, bottom + 34.0, Anchor::middle,
              inMinutes ? say<"minutes since the start">() : say<"seconds since the start">(), true);
  return bottom + 42.0;
}

}  // namespace ew::reports
