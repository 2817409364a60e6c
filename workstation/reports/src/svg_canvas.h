#pragma once

#include "plot_canvas.h"

namespace ew::reports {

/// A plot as one `svg` element.
class SvgCanvas : public PlotCanvas {
 public:
  using PlotCanvas::PlotCanvas;
  using PlotCanvas::text;

  void text(double x, double y, Anchor anchor, const std::string& said, bool isSoft) override;
  void line(double x1, double y1, double x2, double y2, const std::string& colour, double width, Dashes dashes) override;
  void rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled) override;
  void circle(double x, double y, double radius, const std::string& colour, bool isFilled) override;
  void path(const std::vector<glm::dvec2>& points, const std::string& colour, double width, Dashes dashes) override;
  /// The whole element. @param title for whoever hears the page
  [[nodiscard]] std::string image(const Message& title, double height) const;

 private:
  std::string shapes_;
};

}  // namespace ew::reports
