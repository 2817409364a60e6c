#include "bench/tools/bench_page.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ew/core/chart_axis.h"

namespace ew {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

constexpr double kWidth = 720.0, kHeight = 380.0, kLeft = 64.0, kRight = 24.0, kTop = 18.0, kBottom = 46.0;
constexpr double kShortest_ms = 1e-4;  // no bench can tell less from nothing

std::string textAt(double x, double y, const std::string& anchor, const std::string& text) {
  return "<text x='" + fixedText(x, 1) + "' y='" + fixedText(y, 1) + "' text-anchor='" + anchor + "'>" + escaped(text) + "</text>";
}

/// Time (logarithmic) to the right, accuracy upwards.
struct Axes {
  ChartAxis time_ms, accuracy;
  [[nodiscard]] double x(double ms) const { return time_ms.at(std::max(kShortest_ms, ms), kLeft, kWidth - kRight); }
  [[nodiscard]] double y(double value) const { return accuracy.at(value, kHeight - kBottom, kTop); }
};

Axes axesFor(const std::vector<BenchPoint>& points, const BenchAxis& axis) {
  std::vector<double> times_ms, accuracies;
  for (const BenchPoint& point : points) {
    times_ms.push_back(std::max(kShortest_ms, point.time_ms));
    accuracies.push_back(point.accuracy);
  }
  constexpr double kRoomForNames = 1.15;
  return {logarithmicAxis(times_ms, kRoomForNames),
          linearAxis(accuracies, {.steps = 6, .smallestStep = axis.smallestStep, .below = 0.3, .above = 0.5})};
}

std::string gridOf(const Axes& axes, const BenchAxis& axis) {
  std::string svg;
  const std::string bottom = fixedText(kHeight - kBottom, 1);
  for (const ChartTick& tick : axes.time_ms.ticks) {
    const std::string x = fixedText(axes.x(tick.value), 1);
    svg += "<line class='grid' x1='" + x + "' x2='" + x + "' y1='" + fixedText(kTop, 1) + "' y2='" + bottom + "'/>";
    svg += textAt(axes.x(tick.value), kHeight - kBottom + 16.0, "middle", fixedText(tick.value, tick.decimals));
  }
  for (const ChartTick& tick : axes.accuracy.ticks) {
    const std::string y = fixedText(axes.y(tick.value), 1);
    svg += "<line class='grid' x1='" + fixedText(kLeft, 1) + "' x2='" + fixedText(kWidth - kRight, 1) + "' y1='" + y + "' y2='" + y + "'/>";
    svg += textAt(kLeft - 8.0, axes.y(tick.value) + 4.0, "end", fixedText(tick.value, tick.decimals));
  }
  svg += textAt(0.5 * (kLeft + kWidth - kRight), kHeight - 8.0, "middle", "median time, ms (logarithmic)");
  return svg + "<text transform='translate(16," + fixedText(0.5 * (kTop + kHeight - kBottom), 1) + ") rotate(-90)' text-anchor='middle'>" +
         escaped(axis.title) + "</text>";
}

bool isPeer(BenchMark mark) { return mark == BenchMark::peer || mark == BenchMark::peerHollow; }
bool isHollow(BenchMark mark) { return mark == BenchMark::ownHollow || mark == BenchMark::peerHollow; }

std::string symbol(BenchMark mark, double x, double y, const std::string& title) {
  const std::string style = std::string("class='") + (isPeer(mark) ? "peer" : "own") + (isHollow(mark) ? " hollow'" : "'");
  if (isPeer(mark))
    return "<rect " + style + " x='" + fixedText(x - 5.5, 1) + "' y='" + fixedText(y - 5.5, 1) + "' width='11' height='11'>" + title +
           "</rect>";
  return "<circle " + style + " cx='" + fixedText(x, 1) + "' cy='" + fixedText(y, 1) + "' r='6'>" + title + "</circle>";
}

/// A name beside its point, where it covers no other name or point: above, below, to the right, to the left.
class Names {
 public:
  void occupy(double x, double y, double halfWidth, double halfHeight) { taken_.push_back({x, y, halfWidth, halfHeight}); }
  std::string place(double x, double y, const std::string& text) {
    const double half = 3.4 * static_cast<double>(text.size());
    struct Try {
      double x, y;
    };
    const Try tries[] = {{x, y - 15}, {x, y + 17}, {x + half + 12, y}, {x - half - 12, y}, {x, y - 29}, {x, y + 31}};
    Try best = tries[0];
    for (const Try& each : tries)
      if (isFree(each.x, each.y, half)) {
        best = each;
        break;
      }
    best.x = std::clamp(best.x, kLeft + half, kWidth - half - 2.0);
    occupy(best.x, best.y, half, 7.0);
    return textAt(best.x, best.y + 4.0, "middle", text);
  }

 private:
  struct Box {
    double x, y, halfWidth, halfHeight;
  };
  [[nodiscard]] bool isFree(double x, double y, double half) const {
    if (x - half < kLeft || x + half > kWidth || y < kTop || y > kHeight - kBottom) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box& box) {
      return std::abs(box.x - x) < box.halfWidth + half && std::abs(box.y - y) < box.halfHeight + 7.0;
    });
  }
  std::vector<Box> taken_;
};

std::string chart(const std::vector<BenchPoint>& points, const BenchAxis& axis) {
  const Axes axes = axesFor(points, axis);
  std::string svg = "<svg viewBox='0 0 720 380' role='img' aria-label='accuracy against time'>" + gridOf(axes, axis);
  std::map<std::string, std::string> curves;
  Names names;
  for (const BenchPoint& point : points) {
    const double x = axes.x(point.time_ms), y = axes.y(point.accuracy);
    if (!point.curve.empty()) curves[point.curve] += fixedText(x, 1) + "," + fixedText(y, 1) + " ";
    names.occupy(x, y, 7.0, 7.0);
  }
  for (const auto& [name, line] : curves) svg += "<polyline class='curve' points='" + line + "'/>";
  for (const BenchPoint& point : points) {
    const double x = axes.x(point.time_ms), y = axes.y(point.accuracy);
    svg += symbol(point.mark, x, y,
                  "<title>" + escaped(point.name) + ": " + fixedText(point.time_ms, 3) + " ms, " +
                      fixedText(point.accuracy, axis.decimals) + " " + escaped(axis.unit) + "</title>");
    if (!point.label.empty()) svg += names.place(x, y, point.label);
  }
  return svg + "</svg>";
}

std::string barChart(const std::vector<BenchBar>& bars, const std::vector<std::pair<double, std::string>>& limits_ms) {
  constexpr double kRow = 24.0, kNames = 210.0, kNumbers = 70.0, kAbove = 26.0;
  double longest = 0.0;
  for (const BenchBar& bar : bars) longest = std::max(longest, bar.time_ms);
  for (const auto& [ms, text] : limits_ms) longest = std::max(longest, ms);
  ChartAxis axis;
  axis.high = std::max(1e-9, longest);  // the longest bar takes all the room
  const auto xOf = [&](double ms) { return axis.at(ms, kNames, kWidth - kNumbers); };
  const double height = kAbove + kRow * static_cast<double>(bars.size()) + 8.0;
  std::string svg = "<svg viewBox='0 0 720 " + fixedText(height, 0) + "' role='img' aria-label='times'>";
  double y = kAbove;
  for (const BenchBar& bar : bars) {
    const double length = std::max(1.0, xOf(bar.time_ms) - kNames);
    svg += textAt(kNames - 8.0, y + 16.0, "end", bar.label);
    svg += "<rect class='" + std::string(isPeer(bar.mark) ? "peer" : "own") + "' x='" + fixedText(kNames, 1) + "' y='" +
           fixedText(y + 5.0, 1) + "' width='" + fixedText(length, 1) + "' height='" + fixedText(kRow - 10.0, 1) + "'/>";
    svg += textAt(kNames + length + 6.0, y + 16.0, "start", fixedText(bar.time_ms, 2) + " ms");
    y += kRow;
  }
  for (const auto& [ms, text] : limits_ms) {
    const std::string x = fixedText(xOf(ms), 1);
    svg += "<line class='limit' x1='" + x + "' x2='" + x + "' y1='" + fixedText(kAbove - 6.0, 1) + "' y2='" + fixedText(height, 1) + "'/>";
    svg += textAt(std::min(xOf(ms), kWidth - 40.0), kAbove - 12.0, "middle", text);
  }
  return svg + "</svg>";
}

std::string legendOf(const BenchSection& section) {
  std::string html;
  for (const auto& [mark, text] : section.legend)
    html += "<span><svg viewBox='0 0 16 16'>" + symbol(mark, 8.0, 8.0, "") + "</svg>" + escaped(text) + "</span>";
  return html.empty() ? html : "<p class='legend'>" + html + "</p>";
}

std::string tableOf(const BenchTable& table) {
  if (table.rows.empty()) return {};
  const auto cell = [&](const char* tag, std::size_t column, const std::string& text) {
    const std::string style = static_cast<int>(column) < table.textColumns ? " class='words'" : "";
    return "<" + std::string(tag) + style + ">" + escaped(text) + "</" + tag + ">";
  };
  std::string html = "<div class='wide'><table><thead><tr>";
  for (std::size_t n = 0; n < table.columns.size(); ++n) html += cell("th", n, table.columns[n]);
  html += "</tr></thead><tbody>";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t n = 0; n < row.size(); ++n) html += cell("td", n, row[n]);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --back: #fafafa; --panel: #ffffff; --text: #1d2329; --soft: #5c6670; --line: #dfe3e8; --own: #0b7f93; --peer: #8a5a00; }
@media (prefers-color-scheme: dark) { :root { --back: #14171a; --panel: #1c2024; --text: #e6e9ec; --soft: #9aa4ae; --line: #31373d; --own: #3cc3d8; --peer: #e0a030; } }
body { margin: 0 auto; max-width: 900px; padding: 32px 24px; background: var(--back); color: var(--text); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 24px; font-weight: 600; } h2 { font-size: 18px; font-weight: 600; margin-top: 32px; }
section { background: var(--panel); border: 1px solid var(--line); border-radius: 8px; padding: 16px; }
p { color: var(--soft); } section p:first-child { margin-top: 0; } svg { width: 100%; height: auto; display: block; }
svg text { font: 12px system-ui, sans-serif; fill: var(--text); } .grid { stroke: var(--line); stroke-width: 1; }
.own { fill: var(--own); stroke: var(--own); stroke-width: 2; } .peer { fill: var(--peer); stroke: var(--peer); stroke-width: 2; } .hollow { fill: var(--panel); }
.curve { fill: none; stroke: var(--own); stroke-width: 1.5; opacity: 0.5; } .limit { stroke: var(--text); stroke-width: 1; stroke-dasharray: 4 3; }
.legend span { display: inline-flex; align-items: center; gap: 6px; margin-right: 20px; } .legend svg { width: 16px; height: 16px; }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; } th { color: var(--soft); font-weight: 500; }
th, td { border-top: 1px solid var(--line); padding: 4px 8px; text-align: right; } .words { text-align: left; }
)";

const std::string kHeading = "<h2>", kHeadingEnd = "</h2>", kPageEnd = "</body></html>\n";

std::string headingOf(const BenchSection& section) { return kHeading + escaped(section.title) + kHeadingEnd; }

std::string htmlOf(const BenchSection& section) {
  std::string html = headingOf(section) + "<section>";
  if (!section.text.empty()) html += "<p>" + escaped(section.text) + "</p>";
  html += legendOf(section);
  if (!section.points.empty()) html += chart(section.points, section.axis);
  if (!section.bars.empty()) html += barChart(section.bars, section.limits_ms);
  return html + tableOf(section.table) + "</section>";
}

/// The sections of a page that benchPage made, as they stand there. None of another page.
std::vector<std::string> sectionsOfPage(const std::string& page) {
  std::vector<std::string> sections;
  const std::size_t end = page.rfind(kPageEnd);
  if (end == std::string::npos) return sections;
  for (std::size_t from = page.find(kHeading); from < end;) {
    const std::size_t next = std::min(page.find(kHeading, from + 1), end);
    sections.push_back(page.substr(from, next - from));
    from = next;
  }
  return sections;
}

}  // namespace

std::string benchPage(const std::string& title, const std::vector<std::string>& introduction, const std::vector<BenchSection>& sections,
                      const std::string& before) {
  std::string html =
      "<!doctype html><html lang='en'><head><meta charset='utf-8'><meta name='viewport' content='width=device-width'><title>" +
      escaped(title) + "</title><style>" + kStyle + "</style></head><body><h1>" + escaped(title) + "</h1>";
  for (const auto& paragraph : introduction) html += "<p>" + escaped(paragraph) + "</p>";
  std::vector<BenchSection> left = sections;
  const auto take = [&](const std::string& heading) {
    const auto at = std::find_if(left.begin(), left.end(), [&](const BenchSection& section) { return headingOf(section) == heading; });
    if (at == left.end()) return false;
    html += htmlOf(*at);
    left.erase(at);
    return true;
  };
  for (const std::string& kept : sectionsOfPage(before))
    if (!take(kept.substr(0, kept.find(kHeadingEnd) + kHeadingEnd.size()))) html += kept;
  for (const BenchSection& section : left) html += htmlOf(section);
  return html + kPageEnd;
}

}  // namespace ew
