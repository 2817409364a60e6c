#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ew/paper/paper_pages.h"
#include "plot_canvas.h"

namespace ew::reports {

/// A plot for paper: shapes and letters, so that its words are found by a search. Kept until the pages are drawn.
class PaperCanvas : public PlotCanvas {
 public:
  /// @param pages whose fonts it has
  PaperCanvas(const PaperPages& pages, const PlotColours& inColours, const std::function<std::string(const Message&)>& inWords)
      : PlotCanvas(inColours, inWords), pages_(pages) {}
  using PlotCanvas::text;

  void text(double x, double y, Anchor anchor, const std::string& said, bool isSoft) override;
  void line(double x1, double y1, double x2, double y2, const std::string& colour, double width, Dashes dashes) override;
  void rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled) override;
  void circle(double x, double y, double radius, const std::string& colour, bool isFilled) override;
  void path(const std::vector<glm::dvec2>& points, const std::string& colour, double width, Dashes dashes) override;
  /// All of it, for PaperPages::draw. @param at its upper left corner @param scale points for a unit of the plot
  [[nodiscard]] std::function<void(cairo_t*)> drawing(const glm::dvec2& at, double scale) &&;

 private:
  const PaperPages& pages_;
  std::vector<std::function<void(cairo_t*)>> shapes_;
};

}  // namespace ew::reports
