#include "paper_plot.h"

#include <algorithm>
#include <numbers>

#include "ew/core/contract.h"

namespace ew::reports {
namespace {

constexpr double kBorder = 1.5;

/// A colour as PlotColours writes it: "#1d2329".
Rgb rgbOf(const std::string& colour) {
  EW_EXPECTS(colour.size() == 7 && colour.front() == '#');
  const unsigned long all = std::stoul(colour.substr(1), nullptr, 16);
  return Rgb(all >> 16 & 255u, all >> 8 & 255u, all & 255u);
}

double shareBefore(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return 0.0;
    case Anchor::middle:
      return 0.5;
    case Anchor::end:
      return 1.0;
  }
  return 0.0;
}

void stroke(cairo_t* pen, const Rgb& ink, double width, const Dashes& dashes) {
  const double lengths[] = {dashes.on, dashes.off};
  setInk(pen, ink);
  cairo_set_line_width(pen, width);
  cairo_set_dash(pen, lengths, dashes.on > 0.0 ? 2 : 0, 0.0);
  cairo_stroke(pen);
}

void paint(cairo_t* pen, const Rgb& ink, bool isFilled) {
  setInk(pen, ink);
  if (isFilled) cairo_fill_preserve(pen);
  stroke(pen, ink, kBorder, {});
}

}  // namespace

void PaperCanvas::text(double x, double y, Anchor anchor, const std::string& said, bool isSoft) {
  const PaperText text = pages_.text(said, PaperFont{kTextSize});
  const glm::dvec2 begin(x - shareBefore(anchor) * text.widthOf(0), y);
  shapes_.emplace_back([text, begin, ink = rgbOf(isSoft ? colours.soft : colours.text)](cairo_t* pen) {
    setInk(pen, ink);
    text.show(pen, 0, begin);
  });
}

void PaperCanvas::line(double x1, double y1, double x2, double y2, const std::string& colour, double width, Dashes dashes) {
  shapes_.emplace_back([=, ink = rgbOf(colour)](cairo_t* pen) {
    cairo_set_line_cap(pen, CAIRO_LINE_CAP_BUTT);
    cairo_move_to(pen, x1, y1);
    cairo_line_to(pen, x2, y2);
    stroke(pen, ink, width, dashes);
  });
}

void PaperCanvas::rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled) {
  shapes_.emplace_back([=, ink = rgbOf(colour)](cairo_t* pen) {
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_MITER);
    cairo_rectangle(pen, x, y, std::max(0.0, width), std::max(0.0, height));
    paint(pen, ink, isFilled);
  });
}

void PaperCanvas::circle(double x, double y, double radius, const std::string& colour, bool isFilled) {
  shapes_.emplace_back([=, ink = rgbOf(colour)](cairo_t* pen) {
    cairo_new_path(pen);
    cairo_arc(pen, x, y, radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(pen);
    paint(pen, ink, isFilled);
  });
}

void PaperCanvas::path(const std::vector<glm::dvec2>& points, const std::string& colour, double width, Dashes dashes) {
  shapes_.emplace_back([=, ink = rgbOf(colour)](cairo_t* pen) {
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
    cairo_new_path(pen);
    for (const glm::dvec2& point : points) cairo_line_to(pen, point.x, point.y);
    stroke(pen, ink, width, dashes);
  });
}

std::function<void(cairo_t*)> PaperCanvas::drawing(const glm::dvec2& at, double scale) && {
  return [shapes = std::move(shapes_), at, scale](cairo_t* pen) {
    cairo_translate(pen, at.x, at.y);
    cairo_scale(pen, scale, scale);
    for (const auto& shape : shapes) shape(pen);
  };
}

}  // namespace ew::reports
