#include "svg_canvas.h"

#include <algorithm>

#include "ew/core/word_table.h"
#include "ew/reports/html.h"
#include "report_numbers.h"

namespace ew {
namespace reports {
namespace {

std::string attribute(const char* name, double value) { return " " + std::string(name) + "='" + coordinate(value) + "'"; }

std::string attribute(const char* name, std::string_view value) { return " " + std::string(name) + "='" + std::string(value) + "'"; }

std::string dashing(const Dashes& dashes) {
  return dashes.on > 0.0 ? attribute("stroke-dasharray", coordinate(dashes.on) + " " + coordinate(dashes.off)) : std::string();
}

std::string painting(const std::string& colour, bool isFilled) {
  return attribute("fill", isFilled ? std::string_view(colour) : "none") + attribute("stroke", colour) + attribute("stroke-width", "1.5");
}

constexpr WordTable<Anchor, 3> kAnchorWords{{{"start", Anchor::start}, {"middle", Anchor::middle}, {"end", Anchor::end}}};
const char* wordOf(Anchor anchor) { return wordIn(kAnchorWords, anchor); }

}  // namespace

void SvgCanvas::text(double x, double y, Anchor anchor, const std::string& said, bool isSoft) {
  shapes_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", wordOf(anchor)) +
             attribute("fill", isSoft ? colours.soft : colours.text) + ">" + htmlEscaped(said) + "</text>";
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, const std::string& colour, double width, Dashes dashes) {
  shapes_ += "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) + attribute("stroke", colour) +
             attribute("stroke-width", width) + dashing(dashes) + "/>";
}

void SvgCanvas::rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled) {
  shapes_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", std::max(0.0, width)) +
             attribute("height", std::max(0.0, height)) + painting(colour, isFilled) + "/>";
}

void SvgCanvas::circle(double x, double y, double radius, const std::string& colour, bool isFilled) {
  shapes_ += "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) + painting(colour, isFilled) + "/>";
}

void SvgCanvas::path(const std::vector<glm::dvec2>& points, const std::string& colour, double width, Dashes dashes) {
  std::string d;
  for (const glm::dvec2& point : points) d += (d.empty() ? "M" : "L") + coordinate(point.x) + " " + coordinate(point.y);
  shapes_ += "<path" + attribute("d", d) + attribute("fill", "none") + attribute("stroke", colour) + attribute("stroke-width", width) +
             attribute("stroke-linejoin", "round") + attribute("stroke-linecap", "round") + dashing(dashes) + "/>";
}

std::string SvgCanvas::image(const Message& title, double height) const {
  const std::string name = htmlEscaped(words(title));
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + coordinate(kPlotWidth) + " " + coordinate(height) +
         "' role='img' aria-label='" + name + "' font-family='system-ui, DejaVu Sans, sans-serif' font-size='" + coordinate(kTextSize) +
         "'><title>" + name + "</title>" + shapes_ + "</svg>";
}

}  // namespace reports

PlotColours pageColours() { return {"var(--text)", "var(--soft)", "var(--line)", "var(--own)", "var(--reference)", "var(--panel)"}; }

PlotColours paperColours() { return {"#1d2329", "#4d565f", "#c9cfd6", "#a34700", "#0b5d8f", "#ffffff"}; }

std::string svgOf(const ReportPlot& plot, const PlotColours& colours, const std::function<std::string(const Message&)>& words) {
  reports::SvgCanvas canvas(colours, words);
  const double height = std::visit([&](const auto& data) { return reports::draw(canvas, data); }, plot.data);
  return canvas.image(plot.title, height);
}

}  // namespace ew
