#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ew/core/figures.h"

namespace ew {

/// How a point or bar is drawn: EchoWeave round and accented, a peer square and grey-brown; hollow for a second kind of pose.
enum class BenchMark { own, ownHollow, peer, peerHollow };

/// One setting of one algorithm: what it costs and how near it comes to the exact answer.
struct BenchPoint {
  std::string label;  ///< drawn beside the point; empty: in its tooltip alone
  std::string name;   ///< whole, for the tooltip
  double time_ms = 0.0;
  double accuracy = 0.0;  ///< on the section's axis
  BenchMark mark = BenchMark::own;
  std::string curve;  ///< points of the same curve are joined in their order; empty: not joined
};

/// What is drawn upwards; more is better.
struct BenchAxis {
  std::string title = "accuracy, PSNR in dB";
  std::string unit = "dB";  ///< behind a value in a tooltip; may be empty
  int decimals = 1;         ///< of a value in a tooltip
  double smallestStep = 5.0;
};

/// One bar of an image of times.
struct BenchBar {
  std::string label;
  double time_ms = 0.0;
  BenchMark mark = BenchMark::own;
};

/// Figures in rows; the first `textColumns` columns are words.
struct BenchTable {
  int textColumns = 1;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A heading, a few words, a chart of accuracy against time, an image of times, a table: each when there is something in it.
struct BenchSection {
  std::string title;
  std::string text;
  std::vector<std::pair<BenchMark, std::string>> legend;
  BenchAxis axis = {};
  std::vector<BenchPoint> points;
  std::vector<BenchBar> bars;
  std::vector<std::pair<double, std::string>> limits_ms;  ///< lines across the bars
  BenchTable table;
};

/// A self-contained page (no network, no script, light and dark). Texts are escaped.
/// @param before the page as it was: its sections stay where they were unless one with the same title takes their place
[[nodiscard]] std::string benchPage(const std::string& title, const std::vector<std::string>& introduction,
                                    const std::vector<BenchSection>& sections, const std::string& before = {});

}  // namespace ew
