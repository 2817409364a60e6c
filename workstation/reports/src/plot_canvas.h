#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/reports/report_plot.h"

namespace ew::reports {

inline constexpr double kPlotWidth = 420.0, kTextSize = 13.0;

enum class Anchor { start, middle, end };

/// Of a line: so much drawn, so much left out; 0: a whole line.
struct Dashes {
  double on = 0.0, off = 0.0;
};

/// What plots are drawn on, shape by shape: kPlotWidth wide, y down. Pages and paper have one each, so both show the same.
class PlotCanvas {
 public:
  PlotCanvas(const PlotColours& inColours, const std::function<std::string(const Message&)>& inWords)
      : colours(inColours), words(inWords) {}
  virtual ~PlotCanvas() = default;
  PlotCanvas(const PlotCanvas&) = delete;
  PlotCanvas& operator=(const PlotCanvas&) = delete;

  /// @param y of the base line
  virtual void text(double x, double y, Anchor anchor, const std::string& said, bool isSoft = false) = 0;
  virtual void line(double x1, double y1, double x2, double y2, const std::string& colour, double width = 1.0, Dashes dashes = {}) = 0;
  /// Filled, or hollow with its border alone.
  virtual void rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled = true) = 0;
  virtual void circle(double x, double y, double radius, const std::string& colour, bool isFilled = true) = 0;
  /// From point to point, with round corners.
  virtual void path(const std::vector<glm::dvec2>& points, const std::string& colour, double width, Dashes dashes = {}) = 0;

  void text(double x, double y, Anchor anchor, const Message& said, bool isSoft = false) { text(x, y, anchor, words(said), isSoft); }
  /// No longer than fits between x and `right`, if need be with its end left out.
  void fitted(double x, double y, double right, const Message& said);

  const PlotColours& colours;
  const std::function<std::string(const Message&)>& words;
};

/// About how wide a text is, in units of the plot.
[[nodiscard]] double widthOf(std::string_view text);

[[nodiscard]] double draw(PlotCanvas& canvas, const BarsPlot& plot);  ///< @return its height
[[nodiscard]] double draw(PlotCanvas& canvas, const HistogramPlot& plot);
[[nodiscard]] double draw(PlotCanvas& canvas, const StripPlot& plot);
[[nodiscard]] double draw(PlotCanvas& canvas, const TimeLinePlot& plot);
[[nodiscard]] double draw(PlotCanvas& canvas, const PathPlot& plot);

}  // namespace ew::reports
