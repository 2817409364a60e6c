#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ew/core/message.h"

namespace ew {

/// Shares of 1, each beside the level that it has to reach.
struct BarsPlot {
  struct Bar {
    Message label;
    double value = 0.0;           ///< 0..1
    std::optional<double> level;  ///< 0..1
    bool isReached = true;        ///< the bar is filled; false: hollow
    Message says;                 ///< at its end
  };
  std::vector<Bar> bars;
};

/// How many values lie in each of even parts of an axis.
struct HistogramPlot {
  std::vector<std::size_t> counts;  ///< at least one part
  double low = 0.0, high = 1.0;     ///< of the axis, low < high
  bool isShare = false;             ///< the axis is written in per cent
  Message axis;
  std::optional<double> level;  ///< a line across
};

/// Values of several groups along one axis: each one as a dot, or as a histogram where there are many (in one place); quartiles as a box.
struct StripPlot {
  struct Row {
    Message label;
    std::vector<double> values;
    std::optional<double> level;      ///< that counts: the pass level
    std::optional<double> reference;  ///< to compare with: the expert's value
  };
  std::vector<Row> rows;
  bool isShare = false;  ///< from 0 to 1, written in per cent; false: the axis spans the values
  Message axis;
};

/// What happened when.
struct TimeLinePlot {
  struct Span {
    double begin_s = 0.0, end_s = 0.0;
    bool isFilled = true;
  };
  struct Row {
    Message label;
    std::vector<Span> spans;
  };
  std::vector<Row> rows;
  double end_s = 0.0;  ///< of the axis, which begins at 0
};

/// Ways over the body, seen from the front: to the right the patient's left, upwards the head.
struct PathPlot {
  struct Path {
    Message label;
    bool isReference = false;                        ///< drawn dashed and in the reference's colour
    std::vector<std::vector<glm::dvec2>> pieces_mm;  ///< (left, superior) of the world; broken where nobody knew where the probe was
  };
  std::vector<Path> paths;
};

/// @param title what is shown, as a heading and for whoever hears the page
struct ReportPlot {
  Message title;
  std::variant<BarsPlot, HistogramPlot, StripPlot, TimeLinePlot, PathPlot> data;
  bool isSmall = false;  ///< two stand side by side where there is room
};

/// Colours of an image, as SVG writes them.
struct PlotColours {
  std::string text, soft, line, own, reference, back;
};
/// Names of the page's style sheet: they follow light and dark.
[[nodiscard]] PlotColours pageColours();
/// For white paper.
[[nodiscard]] PlotColours paperColours();

/// An image of it: one `svg` element, texts escaped, 420 units wide and as high as it needs. No style sheet, no script, no links: what
/// SVG Tiny 1.2 has.
[[nodiscard]] std::string svgOf(const ReportPlot& plot, const PlotColours& colours,
                                const std::function<std::string(const Message&)>& words);

}  // namespace ew
