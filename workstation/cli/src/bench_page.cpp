#include "bench_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace ew {
namespace {

using nlohmann::json;

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

std::string fixedText(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

constexpr double kWidth = 640.0, kHeight = 340.0, kLeft = 64.0, kRight = 172.0, kTop = 18.0, kBottom = 46.0;

/// Maps milliseconds (logarithmic) and decibels to the picture.
struct Axes {
  double low_ms = 0.1, high_ms = 10.0, low_db = 0.0, high_db = 60.0;
  [[nodiscard]] double x(double ms) const { return kLeft + (kWidth - kLeft - kRight) * std::log(ms / low_ms) / std::log(high_ms / low_ms); }
  [[nodiscard]] double y(double db) const { return kHeight - kBottom - (kHeight - kTop - kBottom) * (db - low_db) / (high_db - low_db); }
};

Axes axesFor(const json& results) {
  double low = 1e300, high = 0.0, lowDb = 1e300, highDb = 0.0;
  for (const auto& row : results) {
    low = std::min(low, row["median_us"].get<double>() * 1e-3);
    high = std::max(high, row["median_us"].get<double>() * 1e-3);
    lowDb = std::min(lowDb, row["psnr_db"].get<double>());
    highDb = std::max(highDb, row["psnr_db"].get<double>());
  }
  Axes axes;
  if (high <= 0.0) return axes;
  axes.low_ms = std::pow(10.0, std::floor(std::log10(low)));
  axes.high_ms = std::max(10.0 * axes.low_ms, std::pow(10.0, std::ceil(std::log10(high))));
  axes.low_db = 5.0 * std::floor(lowDb / 5.0 - 0.5);
  axes.high_db = 5.0 * std::ceil(highDb / 5.0 + 0.5);
  return axes;
}

std::string grid(const Axes& axes) {
  std::string svg;
  const std::string bottom = fixedText(kHeight - kBottom, 1);
  for (double decade = axes.low_ms; decade <= axes.high_ms * 1.001; decade *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double ms = decade * step;
      if (ms > axes.high_ms * 1.001) break;
      const std::string x = fixedText(axes.x(ms), 1);
      svg += "<line class='grid' x1='" + x + "' x2='" + x + "' y1='" + fixedText(kTop, 1) + "' y2='" + bottom + "'/>";
      char label[32];
      std::snprintf(label, sizeof label, "%g", ms);
      svg += "<text x='" + x + "' y='" + fixedText(kHeight - kBottom + 16.0, 1) + "' text-anchor='middle'>" + label + "</text>";
    }
  }
  for (double db = axes.low_db; db <= axes.high_db + 0.01; db += 5.0) {
    const std::string y = fixedText(axes.y(db), 1);
    svg += "<line class='grid' x1='" + fixedText(kLeft, 1) + "' x2='" + fixedText(kWidth - kRight, 1) + "' y1='" + y + "' y2='" + y + "'/>";
    svg += "<text x='" + fixedText(kLeft - 8.0, 1) + "' y='" + fixedText(axes.y(db) + 4.0, 1) + "' text-anchor='end'>" + fixedText(db, 0) +
           "</text>";
  }
  svg += "<text x='" + fixedText(0.5 * (kLeft + kWidth - kRight), 1) + "' y='" + fixedText(kHeight - 8.0, 1) +
         "' text-anchor='middle'>median time of a slice, ms (logarithmic)</text>";
  svg += "<text transform='translate(16," + fixedText(0.5 * (kTop + kHeight - kBottom), 1) +
         ") rotate(-90)' text-anchor='middle'>accuracy, PSNR in dB</text>";
  return svg;
}

/// EchoWeave round and accented, the peer square and grey; random poses filled, smooth ones hollow.
std::string mark(const json& row, const Axes& axes) {
  const bool peer = row["peer"].get<bool>();
  const bool smooth = row["pose_kind"] == "smooth";
  const double x = axes.x(row["median_us"].get<double>() * 1e-3), y = axes.y(row["psnr_db"].get<double>());
  const std::string style = std::string("class='") + (peer ? "peer" : "own") + (smooth ? " hollow'" : "'");
  const std::string title = "<title>" + escaped(row["name"].get<std::string>()) + ": " +
                            fixedText(row["median_us"].get<double>() * 1e-3, 3) + " ms, " + fixedText(row["psnr_db"].get<double>(), 1) +
                            " dB</title>";
  std::string svg;
  if (peer)
    svg = "<rect " + style + " x='" + fixedText(x - 5.5, 1) + "' y='" + fixedText(y - 5.5, 1) + "' width='11' height='11'>" + title +
          "</rect>";
  else
    svg = "<circle " + style + " cx='" + fixedText(x, 1) + "' cy='" + fixedText(y, 1) + "' r='6'>" + title + "</circle>";
  if (!smooth) {
    // A name near the right edge would run into the legend.
    const bool atEdge = x > kWidth - kRight - 40.0;
    svg += "<text x='" + fixedText(atEdge ? x + 6.0 : x, 1) + "' y='" + fixedText(y - 12.0, 1) + "' text-anchor='" +
           (atEdge ? "end" : "middle") + "'>" + escaped(row["method"].get<std::string>()) + "</text>";
  }
  return svg;
}

std::string chart(const json& results) {
  const Axes axes = axesFor(results);
  std::string svg = "<svg viewBox='0 0 640 340' role='img' aria-label='accuracy against time'>" + grid(axes);
  for (const auto& row : results) svg += mark(row, axes);
  const double x = kWidth - kRight + 16.0;
  const auto legend = [&](int line, const std::string& symbol, const std::string& text) {
    const double y = kTop + 12.0 + 22.0 * line;
    svg += "<g transform='translate(" + fixedText(x, 1) + "," + fixedText(y, 1) + ")'>" + symbol + "<text x='12' y='4'>" + text +
           "</text></g>";
  };
  legend(0, "<circle class='own' r='6'/>", "EchoWeave, random");
  legend(1, "<circle class='own hollow' r='6'/>", "EchoWeave, smooth");
  legend(2, "<rect class='peer' x='-5.5' y='-5.5' width='11' height='11'/>", "VTK, random");
  legend(3, "<rect class='peer hollow' x='-5.5' y='-5.5' width='11' height='11'/>", "VTK, smooth");
  return svg + "</svg>";
}

/// "6.28 times" for one of our slicers, empty for the peer's.
std::string speedAgainstPeer(const json& row, const json& ratios) {
  if (row["peer"].get<bool>()) return {};
  for (const auto& ratio : ratios)
    if (ratio["volume_side"] == row["volume_side"] && ratio["pose_kind"] == row["pose_kind"] && ratio["quality"] == row["method"])
      return fixedText(ratio["times_faster"].get<double>(), 2) + " times";
  return {};
}

std::string table(const json& results, const json& ratios) {
  std::string html =
      "<table><thead><tr><th>Slicer</th><th>Poses</th><th>Median, ms</th><th>Speed against VTK</th><th>PSNR, dB</th><th>Worst, grey "
      "levels</th></tr></thead><tbody>";
  for (const auto& row : results)
    html += "<tr><td>" + escaped(row["method"].get<std::string>()) + "</td><td>" + escaped(row["pose_kind"].get<std::string>()) +
            "</td><td>" + fixedText(row["median_us"].get<double>() * 1e-3, 3) + "</td><td>" + speedAgainstPeer(row, ratios) + "</td><td>" +
            fixedText(row["psnr_db"].get<double>(), 1) + "</td><td>" + fixedText(row["worst_grey"].get<double>(), 1) + "</td></tr>";
  return html + "</tbody></table>";
}

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --back: #fafafa; --panel: #ffffff; --text: #1d2329; --soft: #5c6670; --line: #dfe3e8; --own: #0b7f93; --peer: #8a5a00; }
@media (prefers-color-scheme: dark) { :root { --back: #14171a; --panel: #1c2024; --text: #e6e9ec; --soft: #9aa4ae; --line: #31373d; --own: #3cc3d8; --peer: #e0a030; } }
body { margin: 0 auto; max-width: 900px; padding: 32px 24px; background: var(--back); color: var(--text); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 24px; font-weight: 600; } h2 { font-size: 18px; font-weight: 600; margin-top: 32px; }
section { background: var(--panel); border: 1px solid var(--line); border-radius: 8px; padding: 16px; }
p, figcaption { color: var(--soft); } svg { width: 100%; height: auto; }
svg text { font: 12px system-ui, sans-serif; fill: var(--text); } .grid { stroke: var(--line); stroke-width: 1; }
.own { fill: var(--own); stroke: var(--own); stroke-width: 2; } .peer { fill: var(--peer); stroke: var(--peer); stroke-width: 2; } .hollow { fill: var(--panel); }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; } th { color: var(--soft); font-weight: 500; text-align: right; }
td { text-align: right; } th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; } th, td { border-top: 1px solid var(--line); padding: 4px 8px; }
)";

}  // namespace

std::string slicingPage(const json& report) {
  const int side = report["slice_side"].get<int>();
  std::string html =
      "<!doctype html><html lang='en'><head><meta charset='utf-8'><meta name='viewport' content='width=device-width'>"
      "<title>EchoWeave: what accuracy costs in slicing</title><style>" +
      std::string(kStyle) + "</style></head><body><h1>What accuracy costs in slicing</h1><p>A slice of " + std::to_string(side) + " x " +
      std::to_string(side) +
      " pixels, one voxel a pixel, one thread. Times are processor time, medians of interleaved repetitions; accuracy is measured against "
      "an analytic band-limited field, so its ceiling is the rounding to 256 grey levels. Random poses pass near the middle in any "
      "direction; smooth ones rock and slide like a hand. VTK's vtkImageReslice reads the same voxels in the same memory, on one thread, "
      "with its optimisation on. Up and to the left is better.</p><p>Machine: " +
      escaped(report["machine"].get<std::string>()) + "</p>";
  std::set<int> sides;
  for (const auto& row : report["results"]) sides.insert(row["volume_side"].get<int>());
  for (const int volumeSide : sides) {
    json results = json::array();
    for (const auto& row : report["results"])
      if (row["volume_side"] == volumeSide) results.push_back(row);
    const std::string cubed = std::to_string(volumeSide) + "&sup3;";
    html += "<h2>Volume of " + cubed + " voxels</h2><section>" + chart(results) + table(results, report["ratios"]) + "</section>";
  }
  return html + "</body></html>\n";
}

}  // namespace ew
