#include "ew/reports/report_plot.h"

#include "ew/reports/report_document.h"
#include "reports/reports_world.h"

namespace ew {
namespace {

using test::countOf;
using test::holds;

std::string drawn(const ReportPlot& plot) {
  return svgOf(plot, paperColours(), [](const Message& message) { return message.english(); });
}

TEST(PlotOfBars, FillsWhatIsReachedAndLeavesTheRestHollow) {
  const std::string svg = drawn(
      {verbatim("t"), BarsPlot{{{verbatim("a"), 1.0, 0.7, true, verbatim("100 %")}, {verbatim("b"), 0.5, 0.7, false, verbatim("50 %")}}}});
  EXPECT_TRUE(holds(svg, "width='380'")) << "1 is as long as the axis: " << svg;
  EXPECT_TRUE(holds(svg, "width='190' height='13' fill='none'")) << svg;
  EXPECT_EQ(countOf(svg, "stroke-dasharray='5 3'"), 2u) << "a pass level each";
}

TEST(PlotOfValues, HasADotForEachOfFewAndBarsForMany) {
  StripPlot plot{{{verbatim("few"), {0.1, 0.2, 0.3}, {}, {}}}, true, {}};
  EXPECT_EQ(countOf(drawn({verbatim("t"), plot}), "<circle"), 3u);
  plot.rows[0].values.assign(1000, 0.5);
  const std::string many = drawn({verbatim("t"), plot});
  EXPECT_EQ(countOf(many, "<circle"), 0u);
  EXPECT_LT(many.size(), 5000u);
}

TEST(PlotOfValues, HidesNoDotBehindAnother) {
  StripPlot plot{{{verbatim("a"), std::vector<double>(8, 0.5), {}, {}}}, true, {}};
  const std::string svg = drawn({verbatim("t"), plot});
  std::set<std::string> places;
  for (std::size_t at = svg.find("cy='"); at != std::string::npos; at = svg.find("cy='", at + 1)) places.insert(svg.substr(at, 10));
  EXPECT_EQ(places.size(), 8u);
  plot.rows[0].values.assign(9, 0.5);
  EXPECT_EQ(countOf(drawn({verbatim("t"), plot}), "<circle"), 0u) << "a bar says it better";
}

TEST(PlotOfPaths, KeepsBothAxesAlikeWithTheHeadUpAndTheLeftToTheRight) {
  const PathPlot plot{{{verbatim("a"), false, {{{0.0, 0.0}, {40.0, 0.0}, {40.0, 40.0}}}}}};
  const std::string svg = drawn({verbatim("t"), plot});
  const std::size_t at = svg.find("d='M") + 4;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "%lf %lfL%lf %lfL%lf %lf", &x0, &y0, &x1, &y1, &x2, &y2), 6) << svg;
  EXPECT_GT(x1, x0);
  EXPECT_LT(y2, y1);
  EXPECT_NEAR(x1 - x0, y1 - y2, 0.11);
}

TEST(PlotOfNothing, IsAnImageAllTheSame) {
  for (const ReportPlot& plot :
       {ReportPlot{verbatim("t"), BarsPlot{}}, ReportPlot{verbatim("t"), HistogramPlot{{0}, 0.0, 1.0, true, {}, {}}},
        ReportPlot{verbatim("t"), StripPlot{{{verbatim("a"), {}, {}, {}}}, false, {}}}, ReportPlot{verbatim("t"), TimeLinePlot{}},
        ReportPlot{verbatim("t"), PathPlot{}}}) {
    const std::string svg = drawn(plot);
    EXPECT_TRUE(svg.ends_with("</svg>"));
    EXPECT_FALSE(holds(svg, "nan")) << svg;
    EXPECT_FALSE(holds(svg, "inf")) << svg;
  }
}

TEST(PlotsTexts, AreCutBetweenLettersWhereTheyAreTooLong) {
  std::string name;
  for (int n = 0; n < 200; ++n) name += "ä";
  const std::string svg = drawn({verbatim("t"), BarsPlot{{{verbatim(name), 0.5, {}, true, verbatim("x")}}}});
  EXPECT_TRUE(holds(svg, "ä…</text>"));
}

TEST(FigureTexts, HaveTheDecimalsTheyDeserve) {
  EXPECT_EQ(figureText(4.234, "mm").english(), "4.23 mm");
  EXPECT_EQ(figureText(12.34, "deg").english(), "12.3 °");
  EXPECT_EQ(figureText(310.4, "ml").english(), "310 ml");
  EXPECT_EQ(figureText(99.96, "s").english(), "100 s");
  EXPECT_EQ(figureText(3.0, "").english(), "3");
  EXPECT_EQ(figureText(-0.001, "mm").english(), "0.00 mm");
  EXPECT_EQ(percentText(0.825).english(), "82 %");
  EXPECT_EQ(scoreText(0.698, 0.7).english(), "69.8 %") << "not passed, and it shows";
  EXPECT_EQ(scoreText(0.6999999, 0.7).english(), "69.9 %");
  EXPECT_EQ(scoreText(0.7, 0.7).english(), "70 %");
  EXPECT_EQ(scoreText(0.41, 0.7).english(), "41 %");
  EXPECT_EQ(durationText(12.5).english(), "12.5 s");
  EXPECT_EQ(durationText(185.2).english(), "3 min 5 s");
  EXPECT_EQ(durationText(7325.0).english(), "2 h 2 min");
}

}  // namespace
}  // namespace ew
