#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ew/core/message.h"
#include "ew/reports/report_plot.h"

namespace ew::reports {

inline constexpr double kPlotWidth = 420.0, kTextSize = 13.0;

enum class Anchor { start, middle, end };

/// Puts shapes into a picture, one after another.
class SvgCanvas {
 public:
  SvgCanvas(const PlotColours& inColours, const std::function<std::string(const Message&)>& inWords) : colours(inColours), words(inWords) {}

  void text(double x, double y, Anchor anchor, const std::string& said, bool isSoft = false);
  void text(double x, double y, Anchor anchor, const Message& said, bool isSoft = false) { text(x, y, anchor, words(said), isSoft); }
  /// No longer than fits between x and `right`, if need be with its end left out.
  void fitted(double x, double y, double right, const Message& said);
  /// @param dashes "4 3"; empty: none
  void line(double x1, double y1, double x2, double y2, const std::string& colour, double width = 1.0, std::string_view dashes = {});
  /// Filled, or hollow with its border alone.
  void rectangle(double x, double y, double width, double height, const std::string& colour, bool isFilled = true);
  void circle(double x, double y, double radius, const std::string& colour, bool isFilled = true);
  /// @param d as in SVG's path
  void path(const std::string& d, const std::string& colour, double width, std::string_view dashes = {});
  /// The whole element. @param title for whoever hears the page
  [[nodiscard]] std::string picture(const Message& title, double height) const;

  const PlotColours& colours;
  const std::function<std::string(const Message&)>& words;

 private:
  std::string shapes_;
};

/// About how wide a text is, in units of the picture.
[[nodiscard]] double widthOf(std::string_view text);

[[nodiscard]] double draw(SvgCanvas& canvas, const BarsPlot& plot);  ///< @return its height
[[nodiscard]] double draw(SvgCanvas& canvas, const HistogramPlot& plot);
[[nodiscard]] double draw(SvgCanvas& canvas, const StripPlot& plot);
[[nodiscard]] double draw(SvgCanvas& canvas, const TimeLinePlot& plot);
[[nodiscard]] double draw(SvgCanvas& canvas, const PathPlot& plot);

}  // namespace ew::reports
